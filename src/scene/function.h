#pragma once
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
};
using FunctionPtr = std::shared_ptr<const Function>;

}  // namespace rb
