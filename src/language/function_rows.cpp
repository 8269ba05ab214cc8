// User functions over batches: one instruction for all rows, then the next.
#include "language/float_functions.h"
#include "language/function_code.h"

#include <algorithm>
#include <array>
#include <vector>

namespace rb {

namespace {

using Op = FunctionCode::Op;
constexpr size_t batch = FunctionCode::batch;

template <class F>
void each(size_t rows, double* left, const double* right, F f) {
    for (size_t i = 0; i < rows; ++i) left[i] = f(left[i], right[i]);
}

/// left = left op right; the same operations as FunctionCode::run.
void operate(Op op, size_t rows, double* left, const double* right) {
    switch (op) {
        case Op::add:
            return each(rows, left, right, [](double a, double b) { return a + b; });
        case Op::subtract:
            return each(rows, left, right, [](double a, double b) { return a - b; });
        case Op::multiply:
            return each(rows, left, right, [](double a, double b) { return a * b; });
        case Op::divide:
            return each(rows, left, right, [](double a, double b) { return a / b; });
        case Op::less:
            return each(rows, left, right, [](double a, double b) { return a < b; });
        case Op::less_equal:
            return each(rows, left, right, [](double a, double b) { return a <= b; });
        case Op::equal:
            return each(rows, left, right, [](double a, double b) { return a == b; });
        case Op::unequal:
            return each(rows, left, right, [](double a, double b) { return a != b; });
        case Op::greater_equal:
            return each(rows, left, right, [](double a, double b) { return !(a < b); });
        case Op::greater:
            return each(rows, left, right, [](double a, double b) { return !(a <= b); });
        case Op::both:
            return each(rows, left, right, [](double a, double b) { return a != 0 && b != 0; });
        default:
            return each(rows, left, right, [](double a, double b) { return a != 0 || b != 0; });
    }
}

/// min, max and select, row by row.
void call_list(const FunctionCode::Instruction& i, size_t rows, double* first) {
    std::vector<double> arguments(i.count);
    for (size_t row = 0; row < rows; ++row) {
        for (size_t k = 0; k < i.count; ++k) arguments[k] = first[k * batch + row];
        first[row] = call_many(static_cast<Keyword>(i.index), arguments.data(), i.count);
    }
}

void call_function(const FunctionCode& code, const FunctionCode::Instruction& i, size_t rows, double* first) {
    const Function& f = *code.functions[i.index];
    std::vector<const double*> columns(i.count);
    for (size_t k = 0; k < i.count; ++k) columns[k] = first + k * batch;
    if (i.component == 255 || i.component == 0) {
        std::array<double, batch> out;
        f.evaluate_rows(columns, {out.data(), rows});
        std::copy_n(out.data(), rows, first);
        return;
    }
    std::vector<double> arguments(i.count);
    for (size_t row = 0; row < rows; ++row) {
        for (size_t k = 0; k < i.count; ++k) arguments[k] = columns[k][row];
        first[row] = call_component(f, arguments, i.component);
    }
}

/// sum and prod run from and to different numbers in each row.
void loop(const FunctionCode& code, const FunctionCode::Instruction& i, size_t rows, const double* variable,
          double* from, const double* to) {
    std::vector<double> own(code.variables);
    for (size_t row = 0; row < rows; ++row) {
        for (size_t k = 0; k < own.size(); ++k) own[k] = variable[k * batch + row];
        from[row] = run_loop(code.bodies[i.count], i.op == Op::sum, i.index, own.data(), from[row], to[row]);
    }
}

}  // namespace

void FunctionCode::run_rows(size_t rows, double* variable, double* stack_base,
                            std::span<double> results) const {
    double* top = stack_base - batch;
    for (const Instruction& i : instructions) {
        const auto keyword = static_cast<Keyword>(i.index);
        switch (i.op) {
            case Op::constant:
                top += batch;
                std::fill_n(top, rows, i.value);
                break;
            case Op::variable:
                top += batch;
                std::copy_n(variable + i.index * batch, rows, top);
                break;
            case Op::negate:
                std::transform(top, top + rows, top, [](double v) { return -v; });
                break;
            case Op::call1:
                std::transform(top, top + rows, top,
                               [&](double v) { return float_function(keyword, v).value_or(0); });
                break;
            case Op::call2:
                top -= batch;
                each(rows, top, top + batch,
                     [&](double a, double b) { return float_function(keyword, a, b).value_or(0); });
                break;
            case Op::call3:
            case Op::call4:
            case Op::min_max:
                top -= (i.count - 1) * batch;
                call_list(i, rows, top);
                break;
            case Op::function:
                top -= i.count * batch;
                top += batch;
                call_function(*this, i, rows, top);
                break;
            case Op::sum:
            case Op::product:
                top -= batch;
                loop(*this, i, rows, variable, top, top + batch);
                break;
            default:
                top -= batch;
                operate(i.op, rows, top, top + batch);
                break;
        }
    }
    std::copy_n(top, rows, results.data());
}

void UserFunction::evaluate_rows(std::span<const double* const> arguments, std::span<double> results) const {
    std::vector<double> memory((code_.variables + code_.stack + 1) * batch);
    for (size_t at = 0; at < results.size(); at += batch) {
        const size_t rows = std::min(batch, results.size() - at);
        for (size_t k = 0; k < arguments.size(); ++k)
            std::copy_n(arguments[k] + at, rows, memory.data() + k * batch);
        code_.run_rows(rows, memory.data(), memory.data() + code_.variables * batch,
                       results.subspan(at, rows));
    }
}

}  // namespace rb
