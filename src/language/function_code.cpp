#include "language/function_code.h"

#include "base/diagnostics.h"
#include "grammar/token.h"
#include "language/float_functions.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rb {

namespace {

using Op = FunctionCode::Op;

class Compiler {
public:
    Compiler(FunctionCode& out) : out_(out) {}

    void add(const FunctionNode& node) {
        using Kind = FunctionNode::Kind;
        switch (node.kind) {
            case Kind::constant:
                emit({Op::constant, 255, 0, 0, node.value}, 1);
                return;
            case Kind::variable:
                emit({Op::variable, 255, 0, node.index, 0}, 1);
                return;
            case Kind::negated:
                add(node.parts[0]);
                emit({Op::negate, 255, 0, 0, 0}, 0);
                return;
            case Kind::group:
                add(node.parts[0]);
                return;
            case Kind::chain:
                add_chain(node);
                return;
            case Kind::call:
                add_call(node);
                return;
            case Kind::loop:
                add_loop(node);
                return;
            case Kind::function:
                for (const FunctionNode& part : node.parts) add(part);
                out_.functions.push_back(node.function);
                emit(
                    {Op::function, static_cast<uint8_t>(node.index), static_cast<uint16_t>(node.parts.size()),
                     static_cast<uint32_t>(out_.functions.size() - 1), 0},
                    1 - static_cast<int>(node.parts.size()));
                return;
        }
    }

private:
    void emit(FunctionCode::Instruction instruction, int growth) {
        out_.instructions.push_back(instruction);
        depth_ += growth;
        out_.stack = std::max(out_.stack, static_cast<uint32_t>(std::max(depth_, 1)));
    }
    void add_chain(const FunctionNode& node) {
        add(node.parts[0]);
        for (size_t i = 1; i < node.parts.size(); ++i) {
            add(node.parts[i]);
            emit({op_of(node.operators[i - 1]), 255, 0, 0, 0}, -1);
        }
    }
    static Op op_of(char sign) {
        switch (sign) {
            case '+':
                return Op::add;
            case '-':
                return Op::subtract;
            case '*':
                return Op::multiply;
            case '/':
                return Op::divide;
            case '<':
                return Op::less;
            case 'l':
                return Op::less_equal;
            case '=':
                return Op::equal;
            case '!':
                return Op::unequal;
            case 'g':
                return Op::greater_equal;
            case '>':
                return Op::greater;
            case '&':
                return Op::both;
            default:
                return Op::either;
        }
    }
    void add_call(const FunctionNode& node) {
        const auto count = node.parts.size();
        const auto keyword = static_cast<Keyword>(node.index);
        for (const FunctionNode& part : node.parts) add(part);
        Op op = count == 1 ? Op::call1 : count == 2 ? Op::call2 : count == 3 ? Op::call3 : Op::call4;
        if (keyword == Keyword::min || keyword == Keyword::max) op = Op::min_max;
        emit({op, 255, static_cast<uint16_t>(count), node.index, 0}, 1 - static_cast<int>(count));
    }
    void add_loop(const FunctionNode& node) {
        add(node.parts[0]);
        add(node.parts[1]);
        FunctionCode body;
        Compiler(body).add(node.parts[2]);
        body.where = node.where;
        out_.bodies.push_back(std::move(body));
        const bool is_sum = node.level == '+';
        emit({is_sum ? Op::sum : Op::product, 255, static_cast<uint16_t>(out_.bodies.size() - 1), node.index,
              0},
             -1);
    }

    FunctionCode& out_;
    int depth_ = 0;
};

}  // namespace

FunctionCode compile(const FunctionNode& body, uint32_t parameters, uint32_t variables) {
    FunctionCode code;
    Compiler(code).add(body);
    code.variables = std::max(parameters, variables);
    return code;
}

double call_many(Keyword f, const double* a, size_t count) {
    if (f == Keyword::select) {
        if (count == 3) return a[0] < 0 ? a[1] : a[2];
        return a[0] < 0 ? a[1] : a[0] == 0 ? a[2] : a[3];
    }
    double best = a[0];
    // The order of the operands decides what becomes of nan.
    for (size_t i = 1; i < count; ++i) best = f == Keyword::min ? std::min(a[i], best) : std::max(best, a[i]);
    return best;
}

namespace {

/// Counts the steps of a loop and of those inside it, so that a slip in its ends is an error and not a
/// program that never ends.
class LoopSteps {
public:
    LoopSteps() {
        if (depth++ == 0) left = most;
    }
    LoopSteps(const LoopSteps&) = delete;
    LoopSteps& operator=(const LoopSteps&) = delete;
    ~LoopSteps() { --depth; }

    void take(SourceRange where) const {
        if (left-- == 0) throw SceneError(where, "This sum or prod takes more than 100 million steps.");
    }

private:
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
    static constexpr uint64_t most = 10'000;
#else
    static constexpr uint64_t most = 100'000'000;
#endif
    static thread_local int depth;
    static thread_local uint64_t left;
};

thread_local int LoopSteps::depth = 0;
thread_local uint64_t LoopSteps::left = 0;

}  // namespace

double run_loop(const FunctionCode& body, bool is_sum, uint32_t variable, double* variables, double from,
                double to) {
    std::vector<double> stack(body.stack + 1);
    const LoopSteps steps;
    double total = is_sum ? 0 : 1;
    for (double i = from; i <= to; i += 1) {
        steps.take(body.where);
        variables[variable] = i;
        double value = 0;
        body.run(variables, stack.data(), value);
        total = is_sum ? total + value : total * value;
        if (i + 1 == i) break;
    }
    return total;
}

double call_component(const Function& f, std::span<const double> arguments, uint8_t component) {
    std::array<double, 5> out{};
    f.evaluate(arguments, {out.data(), static_cast<size_t>(f.result_count())});
    if (component == 254) return 0.297 * out[0] + 0.589 * out[1] + 0.114 * out[2];
    return out[component == 255 ? 0 : component];
}

void FunctionCode::run(double* variable, double* stack_base, double& result) const {
    // The uppermost value stands apart, in a register; below it, from stack_base[1] on, are the others.
    double* below = stack_base - 1;
    double top = 0.0;
    const auto push = [&](double value) {
        *++below = top;
        top = value;
    };
    // For functions that take `count` values in a row.
    const auto arguments = [&](size_t count) {
        *++below = top;
        below -= count;
        return below + 1;
    };
    for (const Instruction& i : instructions) {
        switch (i.op) {
            case Op::constant:
                push(i.value);
                break;
            case Op::variable:
                push(variable[i.index]);
                break;
            case Op::negate:
                top = -top;
                break;
            case Op::add:
                top = *below-- + top;
                break;
            case Op::subtract:
                top = *below-- - top;
                break;
            case Op::multiply:
                top = *below-- * top;
                break;
            case Op::divide:
                top = *below-- / top;
                break;
            case Op::less:
                top = *below-- < top;
                break;
            case Op::less_equal:
                top = *below-- <= top;
                break;
            case Op::equal:
                top = *below-- == top;
                break;
            case Op::unequal:
                top = *below-- != top;
                break;
            case Op::greater_equal:  // true for nan, as in the reference
                top = !(*below-- < top);
                break;
            case Op::greater:
                top = !(*below-- <= top);
                break;
            case Op::both:
                top = *below-- != 0 && top != 0;
                break;
            case Op::either:
                top = *below-- != 0 || top != 0;
                break;
            case Op::call1:
                top = float_function(static_cast<Keyword>(i.index), top).value_or(0);
                break;
            case Op::call2:
                top = float_function(static_cast<Keyword>(i.index), *below--, top).value_or(0);
                break;
            case Op::call3:
            case Op::call4:
            case Op::min_max:
                top = call_many(static_cast<Keyword>(i.index), arguments(i.count), i.count);
                break;
            case Op::function:
                top = call_component(*functions[i.index], {arguments(i.count), i.count}, i.component);
                break;
            case Op::sum:
            case Op::product: {
                const double from = *below--;
                top = run_loop(bodies[i.count], i.op == Op::sum, i.index, variable, from, top);
                break;
            }
        }
    }
    result = top;
}

void UserFunction::evaluate(std::span<const double> arguments, std::span<double> result) const {
    constexpr size_t room = 64;
    if (code_.variables + code_.stack + 1 <= room) {
        std::array<double, room> memory;
        std::copy(arguments.begin(), arguments.end(), memory.begin());
        code_.run(memory.data(), memory.data() + code_.variables, result[0]);
        return;
    }
    std::vector<double> memory(code_.variables + code_.stack + 1);
    std::copy(arguments.begin(), arguments.end(), memory.begin());
    code_.run(memory.data(), memory.data() + code_.variables, result[0]);
}

}  // namespace rb
