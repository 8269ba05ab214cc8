#pragma once
#include "scene/function.h"

#include <array>
#include <memory>
#include <string_view>
#include <vector>

namespace rb {

enum class SplineKind { linear, quadratic, cubic, natural };

/// A spline of the language: values of 2 to 5 terms over one parameter (spec: language 12).
class Spline final : public Function {
public:
    using Point = std::array<double, 5>;

    SplineKind kind = SplineKind::linear;

    /// Keeps entries sorted; an equal parameter replaces, except the largest.
    void add(double parameter, const double* value, int terms);
    bool empty() const { return parameters_.empty(); }

    Point at(double t, SplineKind as) const;

    int parameter_count() const override { return 1; }
    int result_count() const override { return terms_; }
    void evaluate(std::span<const double> arguments, std::span<double> result) const override;

private:
    Point linear(size_t i, double t) const;
    Point quadratic(size_t i, double t) const;
    Point cubic(double t) const;
    Point natural(size_t i, double t) const;

    std::vector<double> parameters_;
    std::vector<Point> values_;
    Point last_parsed_{};
    int terms_ = 2;
};
using SplinePtr = std::shared_ptr<const Spline>;

}  // namespace rb
