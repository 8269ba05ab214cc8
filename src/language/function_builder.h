#pragma once
#include "language/function_code.h"
#include "language/parser.h"

#include <vector>

namespace rb {

/// Builds user functions while their text is parsed; functions may nest (a pigment in one may hold another).
class FunctionBuilder {
public:
    explicit FunctionBuilder(Session& session) : session_(session) {}

    void begin(SourceRange where);
    void begin_parameters() {
        open().explicit_parameters = true;
        open().words.clear();
    }
    void add_parameter(const Produced& token);

    void push_number(double value);
    /// The parameter's node if the token names one.
    bool push_parameter(const Produced& token);
    void push_operand(const Operand& operand);
    void negate();
    void close_group();
    void chain(char level, char op);
    void open_call(const Produced& word) { open().calls.push_back({open().nodes.size(), word, {}}); }
    void close_call();
    void open_value_call(const Operand& callee) { open().calls.push_back({open().nodes.size(), {}, callee}); }
    void close_value_call();
    void take_component(const Produced& name);
    void add_loop_variable(const Produced& token);
    void close_loop();

    void set_internal(const Operand& number);
    void set_expression();
    void set_function(FunctionPtr function) { open().result = std::move(function); }
    FunctionPtr finish(SourceRange where);
    SourceRange place() const { return open_.back().where; }

private:
    struct Call {
        size_t base = 0;
        Produced word;
        Operand callee;
    };
    struct Open {
        SourceRange where;
        bool explicit_parameters = false;
        std::vector<uint32_t> words;  ///< by slot; parameters, then the loop variables in scope
        size_t parameters = 0;
        size_t variables = 0;
        std::vector<FunctionNode> nodes;
        std::vector<Call> calls;
        FunctionPtr result;
    };
    Open& open() { return open_.back(); }
    FunctionNode pop();

    Session& session_;
    std::vector<Open> open_;
};

}  // namespace rb
