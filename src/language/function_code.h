#pragma once
#include "scene/function.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace rb {

/// The tree of a user function's body, before constants are folded.
struct FunctionNode {
    enum class Kind { constant, variable, negated, group, chain, call, loop, function };
    Kind kind = Kind::constant;
    double value = 0;             ///< constant
    uint32_t index = 0;           ///< variable's slot; call: its Keyword; function: component, or 255
    char level = 0;               ///< chain: '+', '*', '<', '&', '|'
    std::vector<char> operators;  ///< chain: + - * / < l = ! g > & |
    std::vector<FunctionNode> parts;
    FunctionPtr function;
};

/// Carries out what the language's compiler does with constants, its defect included (spec: language 14.3).
/// False if a non-constant is divided by the constant 0.
bool fold(FunctionNode& node);

/// Straight code for a stack machine.
struct FunctionCode {
    enum class Op : uint8_t {
        constant,
        variable,
        negate,
        add,
        subtract,
        multiply,
        divide,
        less,
        less_equal,
        equal,
        unequal,
        greater_equal,
        greater,
        both,
        either,
        call1,  ///< index: Keyword
        call2,
        call3,
        call4,
        min_max,  ///< index: Keyword, count
        function,
        sum,
        product
    };
    struct Instruction {
        Op op = Op::constant;
        uint8_t component = 255;
        uint16_t count = 0;
        uint32_t index = 0;
        double value = 0;
    };
    std::vector<Instruction> instructions;
    std::vector<FunctionCode> bodies;  ///< of sum and prod
    std::vector<FunctionPtr> functions;
    uint32_t variables = 0;  ///< parameters and loop variables
    uint32_t stack = 0;      ///< deepest

    void run(double* variable, double* stack_base, double& result) const;
};

FunctionCode compile(const FunctionNode& body, uint32_t parameters, uint32_t variables);

/// function (a, b, ...) { expression }
class UserFunction final : public Function {
public:
    UserFunction(FunctionCode code, int parameters) : code_(std::move(code)), parameters_(parameters) {}
    int parameter_count() const override { return parameters_; }
    int result_count() const override { return 1; }
    void evaluate(std::span<const double> arguments, std::span<double> result) const override;
    const FunctionCode& code() const { return code_; }

private:
    FunctionCode code_;
    int parameters_;
};

/// `internal(number)`: the built-in surfaces of functions.inc. Null if there is no such number. The scene's
/// noise generator may still change.
FunctionPtr internal_function(int number, std::shared_ptr<const int> noise_generator);

}  // namespace rb
