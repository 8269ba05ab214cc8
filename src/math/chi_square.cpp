#include "math/chi_square.h"

#include "math/vec.h"

#include <cmath>

namespace rb {

namespace {

/// Probability to stay below x: regularised gamma function of degrees / 2, by recurrence from 1/2 or 1
/// (Abramowitz and Stegun 26.4.4 and 26.4.5).
double below(int degrees, double x) {
    if (!(x > 0.0)) return 0.0;
    const double half = 0.5 * x;
    double above = degrees % 2 == 1 ? std::erfc(std::sqrt(half)) : std::exp(-half);
    double a = degrees % 2 == 1 ? 0.5 : 1.0;
    double term = degrees % 2 == 1 ? std::sqrt(half / pi) * 2.0 * std::exp(-half) : half * std::exp(-half);
    for (; 2.0 * a < degrees; a += 1.0) {
        above += term;
        term *= half / (a + 1.0);
    }
    return 1.0 - above;
}

}  // namespace

double chi_square_quantile(int degrees, double p) {
    double lo = 0.0;
    double hi = degrees;
    while (below(degrees, hi) < p) hi *= 2.0;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (lo + hi);
        if (!(middle > lo && middle < hi)) break;
        (below(degrees, middle) < p ? lo : hi) = middle;
    }
    return 0.5 * (lo + hi);
}

}  // namespace rb
