#pragma once
#include "base/source.h"
#include "grammar/token.h"
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
    SourceRange where;  ///< loop
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
    SourceRange where;       ///< of the sum or prod whose body this is

    void run(double* variable, double* stack_base, double& result) const;

    /// Rows that are computed together.
    static constexpr size_t batch = 64;
    /// The same for up to `batch` rows: variable k of row i is `variable[k * batch + i]`, the stack likewise.
    void run_rows(size_t rows, double* variable, double* stack_base, std::span<double> results) const;

    /// Holds the result for all variables within the given intervals.
    Interval bound(std::span<Interval> variable) const;
    /// The same with slopes.
    IntervalSlope bound_slope(std::span<IntervalSlope> variable) const;
};

/// min, max or select of `count` values.
double call_many(Keyword f, const double* a, size_t count);
/// sum or prod: the body for variable number `variable` = from, from + 1, ... while it is <= to. Throws a
/// SceneError where that takes more than 100 million steps, those of sums within a sum counted together.
double run_loop(const FunctionCode& body, bool is_sum, uint32_t variable, double* variables, double from,
                double to);
/// Result `component` of a call: 255 the only one, 254 its grey value.
double call_component(const Function& f, std::span<const double> arguments, uint8_t component);

FunctionCode compile(const FunctionNode& body, uint32_t parameters, uint32_t variables);

/// function (a, b, ...) { expression }
class UserFunction final : public Function {
public:
    UserFunction(FunctionCode code, int parameters) : code_(std::move(code)), parameters_(parameters) {}
    int parameter_count() const override { return parameters_; }
    int result_count() const override { return 1; }
    void evaluate(std::span<const double> arguments, std::span<double> result) const override;
    void evaluate_rows(std::span<const double* const> arguments, std::span<double> results) const override;
    Interval bound(std::span<const Interval> arguments, int component) const override;
    IntervalSlope bound_slope(std::span<const IntervalSlope> arguments, int component) const override;
    const FunctionCode& code() const { return code_; }

private:
    FunctionCode code_;
    int parameters_;
};

/// `internal(number)`: the built-in surfaces of functions.inc. Null if there is no such number. The scene's
/// noise generator may still change.
FunctionPtr internal_function(int number, std::shared_ptr<const int> noise_generator);

}  // namespace rb
