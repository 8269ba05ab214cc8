#pragma once
#include "math/interval_slope.h"

namespace rb {

/// (a^p + b^p)^(1/p) for a, b >= 0: convex for p >= 1, where it is a norm; concave for p <= 1.
class PNorm {
public:
    /// p > 0, infinity allowed.
    explicit PNorm(double p);

    double p() const { return p_; }
    /// The value and how it grows with a and b.
    struct Growth {
        double value;
        double by_a;
        double by_b;
    };
    double operator()(double a, double b) const;
    Growth growth(double a, double b) const;
    /// For a and b that do not become negative.
    IntervalSlope operator()(const IntervalSlope& a, const IntervalSlope& b) const;

private:
    double power(double base) const;
    double root(double base) const;

    double p_;
    double root_;      ///< 1 / p
    int whole_ = 0;    ///< p, if it is a small whole number
    int squares_ = 0;  ///< k, if p is 2^k with a small k > 0: its root is k square roots
};

}  // namespace rb
