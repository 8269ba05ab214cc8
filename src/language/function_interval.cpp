// User functions over intervals: every instruction of FunctionCode::run on sets of numbers.
#include "language/float_functions.h"
#include "language/function_code.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <new>
#include <type_traits>
#include <vector>

namespace rb {

namespace {

using Op = FunctionCode::Op;

constexpr Interval yes{1, 1};
constexpr Interval no{0, 0};
constexpr Interval either_way{0, 1};

Interval truth(bool always, bool never) { return always ? yes : never ? no : either_way; }

Interval compare(Op op, const Interval& a, const Interval& b) {
    if (a.maybe_nan || b.maybe_nan) return either_way;
    const bool apart = a.hi < b.lo || b.hi < a.lo;
    const bool same = a.is_point() && b.is_point() && a.lo == b.lo;
    switch (op) {
        case Op::less:
            return truth(a.hi < b.lo, a.lo >= b.hi);
        case Op::less_equal:
            return truth(a.hi <= b.lo, a.lo > b.hi);
        case Op::equal:
            return truth(same, apart);
        case Op::unequal:
            return truth(apart, same);
        case Op::greater_equal:
            return truth(a.lo >= b.hi, a.hi < b.lo);
        default:
            return truth(a.lo > b.hi, a.hi <= b.lo);
    }
}

/// Whether it counts as true; nan does.
Interval is_set(const Interval& v) { return truth(!v.holds(0), v.is_point() && v.lo == 0); }

/// What has no slope of its own may jump.
Interval jumping(const Interval&, const Interval& value) { return value; }
IntervalSlope jumping(const IntervalSlope&, const Interval& value) { return IntervalSlope::jumping(value); }

const Interval& value_of(const Interval& v) { return v; }
const Interval& value_of(const IntervalSlope& v) { return v.value; }

Interval decide(Op op, const Interval& a, const Interval& b) {
    switch (op) {
        case Op::both:
            return {std::min(is_set(a).lo, is_set(b).lo), std::min(is_set(a).hi, is_set(b).hi)};
        case Op::either:
            return {std::max(is_set(a).lo, is_set(b).lo), std::max(is_set(a).hi, is_set(b).hi)};
        default:
            return compare(op, a, b);
    }
}

/// whole_part(): through a 32-bit integer.
Interval whole(const Interval& v) {
    constexpr double limit = 2147483648.0;
    const Interval inside = trunc(Interval{std::clamp(v.lo, -limit, limit), std::clamp(v.hi, -limit, limit)});
    const bool fits = !v.maybe_nan && v.lo > -limit && v.hi < limit;
    return fits ? inside : hull(inside, -limit);
}

Interval call_without_slope(Keyword word, const Interval& a) {
    switch (word) {
        case Keyword::ceil:
            return ceil(a);
        case Keyword::floor:
            return floor(a);
        case Keyword::int_:
            return whole(a);
        case Keyword::log:
            return log10(a);
        case Keyword::asin:
            return asin(a);
        case Keyword::acos:
            return acos(a);
        case Keyword::sinh:
            return sinh(a);
        case Keyword::cosh:
            return cosh(a);
        case Keyword::tanh:
            return tanh(a);
        case Keyword::asinh:
            return asinh(a);
        case Keyword::acosh:
            return acosh(a);
        case Keyword::atanh:
            return atanh(a);
        default:
            return Interval::everything();
    }
}

template <class T>
T call(Keyword word, const T& a) {
    switch (word) {
        case Keyword::abs:
            return abs(a);
        case Keyword::exp:
            return exp(a);
        case Keyword::ln:
            return log(a);
        case Keyword::sqrt:
            return sqrt(a);
        case Keyword::sin:
            return sin(a);
        case Keyword::cos:
            return cos(a);
        case Keyword::tan:
            return tan(a);
        case Keyword::atan:
            return atan(a);
        case Keyword::degrees:
            return a * 180 / 3.14159265358979323846;
        case Keyword::radians:
            return a * 3.14159265358979323846 / 180;
        default:
            return jumping(a, call_without_slope(word, value_of(a)));
    }
}

template <class T>
T call(Keyword word, const T& a, const T& b) {
    switch (word) {
        case Keyword::atan2:
            return atan2(a, b);
        case Keyword::mod:
            return fmod(a, b);
        case Keyword::pow:
            return pow(a, b);
        case Keyword::div:
            return jumping(a, whole(value_of(a) / value_of(b)));
        default:
            return jumping(a, Interval::everything());
    }
}

Interval choose(std::span<const Interval> a) {
    const Interval& test = a[0];
    const bool negative = test.lo < 0;
    const bool zero = test.holds(0);
    const bool positive = test.hi > 0 || test.maybe_nan;
    Interval out = a.back();
    bool any = false;
    const auto add = [&](bool possible, const Interval& v) {
        if (possible) out = any ? hull(out, v) : v;
        any = any || possible;
    };
    add(negative, a[1]);
    add(zero, a[2]);
    add(positive, a.size() == 3 ? a[2] : a[3]);
    return out;
}

IntervalSlope choose(std::span<const IntervalSlope> a) {
    std::vector<Interval> values;
    for (const IntervalSlope& v : a) values.push_back(v.value);
    const Interval& test = values[0];
    const bool always_below = test.hi < 0 && !test.maybe_nan;
    const bool always_above = test.lo > 0 && !test.maybe_nan;
    if (always_below) return a[1];
    if (always_above) return a.back();
    return IntervalSlope::jumping(choose(values));
}

template <class T>
T call_list(Keyword word, std::span<const T> a) {
    if (word == Keyword::select) return choose(a);
    T best = a[0];
    for (size_t i = 1; i < a.size(); ++i) best = word == Keyword::min ? min(best, a[i]) : max(best, a[i]);
    return best;
}

Interval bound_of(const Function& f, std::span<const Interval> a, int component) {
    return f.bound(a, component);
}
IntervalSlope bound_of(const Function& f, std::span<const IntervalSlope> a, int component) {
    return f.bound_slope(a, component);
}

template <class T>
T call_function(const Function& f, std::span<const T> a, uint8_t component) {
    if (component != 254) return bound_of(f, a, component == 255 ? 0 : component);
    return 0.297 * bound_of(f, a, 0) + 0.589 * bound_of(f, a, 1) + 0.114 * bound_of(f, a, 2);
}

Interval run(const FunctionCode& code, std::span<Interval> variable) { return code.bound(variable); }
IntervalSlope run(const FunctionCode& code, std::span<IntervalSlope> variable) {
    return code.bound_slope(variable);
}

/// Loops whose ends are not known, or are far apart, may give anything.
template <class T>
T loop(const FunctionCode& body, bool is_sum, uint32_t variable, std::span<T> variables, const Interval& from,
       const Interval& to) {
    constexpr double most = 1000;
    if (!from.is_point() || !to.is_point() || !(to.lo - from.lo < most)) return T::everything();
    T total = is_sum ? 0 : 1;
    for (double i = from.lo; i <= to.lo; i += 1) {
        variables[variable] = i;
        const T value = run(body, variables);
        total = is_sum ? total + value : total * value;
        if (i + 1 == i) break;
    }
    return total;
}

/// The stack holds the addresses of values: of variables, and of what the instructions make, each in its own
/// place of `made`. So nothing is copied, which would wait for what has only just been stored in other
/// pieces, and a variable times itself is known as its square.
template <class T>
const T& bound_on(const FunctionCode& code, std::span<T> variable, T* made, const T** stack) {
    size_t size = 0;
    for (const FunctionCode::Instruction& i : code.instructions) {
        const auto keyword = static_cast<Keyword>(i.index);
        if (i.op == Op::variable) {
            stack[size++] = &variable[i.index];
            continue;
        }
        const size_t taken =
            i.op == Op::constant                                                                    ? 0
            : i.op == Op::negate || i.op == Op::call1                                               ? 1
            : i.op == Op::call3 || i.op == Op::call4 || i.op == Op::min_max || i.op == Op::function ? i.count
                                                                                                    : 2;
        size -= taken;
        const T* const* a = stack + size;
        const auto list = [&] {
            for (size_t k = 0; k < taken; ++k) new (made + 1 + k) T(*a[k]);
            return std::span<const T>(made + 1, taken);
        };
        switch (i.op) {
            case Op::constant:
                new (made) T(i.value);
                break;
            case Op::negate:
                new (made) T(-*a[0]);
                break;
            case Op::call1:
                new (made) T(call(keyword, *a[0]));
                break;
            case Op::call2:
                new (made) T(call(keyword, *a[0], *a[1]));
                break;
            case Op::call3:
            case Op::call4:
            case Op::min_max:
                new (made) T(call_list<T>(keyword, list()));
                break;
            case Op::function:
                new (made) T(call_function<T>(*code.functions[i.index], list(), i.component));
                break;
            case Op::sum:
            case Op::product:
                new (made) T(loop<T>(code.bodies[i.count], i.op == Op::sum, i.index, variable,
                                     value_of(*a[0]), value_of(*a[1])));
                break;
            case Op::add:
                new (made) T(*a[0] + *a[1]);
                break;
            case Op::subtract:
                new (made) T(*a[0] - *a[1]);
                break;
            case Op::multiply:
                new (made) T(a[0] == a[1] ? square(*a[0]) : *a[0] * *a[1]);
                break;
            case Op::divide:
                new (made) T(*a[0] / *a[1]);
                break;
            default:
                new (made) T(jumping(*a[0], decide(i.op, value_of(*a[0]), value_of(*a[1]))));
        }
        stack[size++] = made++;
    }
    return *stack[0];
}

template <class T>
T bound_with_stack(const FunctionCode& code, std::span<T> variable) {
    static_assert(std::is_trivially_destructible_v<T>);
    constexpr size_t room = 40;
    // The arguments of a call stand in a row behind its result.
    const size_t needed = code.instructions.size() + code.stack;
    if (needed <= room) {
        std::array<const T*, room> stack;
        alignas(T) std::array<std::byte, room * sizeof(T)> made;
        return bound_on<T>(code, variable, reinterpret_cast<T*>(made.data()), stack.data());
    }
    std::vector<const T*> stack(code.stack + 1);
    std::vector<T> made(needed);
    return bound_on<T>(code, variable, made.data(), stack.data());
}

template <class T>
T bound_for(const FunctionCode& code, std::span<const T> arguments) {
    constexpr size_t room = 8;
    if (code.variables <= room) {
        std::array<T, room> variables;
        std::copy(arguments.begin(), arguments.end(), variables.begin());
        return run(code, std::span<T>(variables.data(), code.variables));
    }
    std::vector<T> variables(code.variables);
    std::copy(arguments.begin(), arguments.end(), variables.begin());
    return run(code, std::span<T>(variables));
}

}  // namespace

Interval FunctionCode::bound(std::span<Interval> variable) const { return bound_with_stack(*this, variable); }
IntervalSlope FunctionCode::bound_slope(std::span<IntervalSlope> variable) const {
    return bound_with_stack(*this, variable);
}

Interval UserFunction::bound(std::span<const Interval> arguments, int) const {
    return bound_for(code_, arguments);
}
IntervalSlope UserFunction::bound_slope(std::span<const IntervalSlope> arguments, int) const {
    return bound_for(code_, arguments);
}

}  // namespace rb
