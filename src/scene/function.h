#pragma once
#include "math/interval_slope.h"

#include <memory>
#include <span>

namespace rb {

/// A user function of the scene language: `function(a, b) { ... }`, or one made of a pattern, pigment,
/// transform or spline. Immutable and shared.
class Function {
public:
    virtual ~Function() = default;
    virtual int parameter_count() const = 0;
    /// 1 for a float function, 2..5 for the vector valued kinds.
    virtual int result_count() const = 0;
    virtual void evaluate(std::span<const double> arguments, std::span<double> result) const = 0;

    /// The first result for many rows of arguments, bit for bit as evaluate() gives it: parameter k of row i
    /// is `arguments[k][i]`.
    virtual void evaluate_rows(std::span<const double* const> arguments, std::span<double> results) const;

    /// All results for many rows, bit for bit as evaluate() gives them: those of row i begin at
    /// `results[i * result_count()]`.
    virtual void evaluate_all_rows(std::span<const double* const> arguments, std::span<double> results) const;

    /// Holds result `component` for all arguments within the given intervals.
    virtual Interval bound(std::span<const Interval> arguments, int component) const;

    /// Values and slope of result `component` over an interval of one variable that the arguments are
    /// functions of.
    virtual IntervalSlope bound_slope(std::span<const IntervalSlope> arguments, int component) const;
};
using FunctionPtr = std::shared_ptr<const Function>;

}  // namespace rb
