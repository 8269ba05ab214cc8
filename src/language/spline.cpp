#include "language/spline.h"

#include <algorithm>

namespace rb {

void Spline::add(double parameter, const double* value, int terms) {
    Point point = last_parsed_;
    terms_ = std::max(terms_, terms);
    for (size_t k = 0; k < static_cast<size_t>(terms); ++k) point[k] = value[k];
    last_parsed_ = point;
    if (!parameters_.empty() && parameter == parameters_.back() && parameters_.size() > 1) return;
    const auto at = std::lower_bound(parameters_.begin(), parameters_.end(), parameter);
    const auto index = at - parameters_.begin();
    if (at != parameters_.end() && *at == parameter) {
        values_[static_cast<size_t>(index)] = point;
        return;
    }
    parameters_.insert(at, parameter);
    values_.insert(values_.begin() + index, point);
}

void Spline::evaluate(std::span<const double> arguments, std::span<double> result) const {
    const Point point = at(arguments[0], kind);
    for (size_t k = 0; k < result.size(); ++k) result[k] = point[k];
}

Spline::Point Spline::at(double t, SplineKind as) const {
    const size_t n = parameters_.size();
    if (n == 1) return values_[0];
    if (as == SplineKind::cubic) return cubic(t);
    if (t <= parameters_.front()) return values_.front();
    if (t >= parameters_.back()) return values_.back();
    const auto above = std::lower_bound(parameters_.begin(), parameters_.end(), t);
    const auto i = static_cast<size_t>(above - parameters_.begin()) - 1;
    if (as == SplineKind::linear || n == 2) return linear(i, t);
    return as == SplineKind::quadratic ? quadratic(i, t) : natural(i, t);
}

Spline::Point Spline::linear(size_t i, double t) const {
    Point out{};
    const double w = (t - parameters_[i]) / (parameters_[i + 1] - parameters_[i]);
    for (size_t k = 0; k < out.size(); ++k) out[k] = values_[i][k] + w * (values_[i + 1][k] - values_[i][k]);
    return out;
}

Spline::Point Spline::quadratic(size_t i, double t) const {
    const size_t a = i == 0 ? 0 : i - 1;
    const double p0 = parameters_[a];
    const double p1 = parameters_[a + 1];
    const double p2 = parameters_[a + 2];
    const double w0 = (t - p1) * (t - p2) / ((p0 - p1) * (p0 - p2));
    const double w1 = (t - p0) * (t - p2) / ((p1 - p0) * (p1 - p2));
    const double w2 = (t - p0) * (t - p1) / ((p2 - p0) * (p2 - p1));
    Point out{};
    for (size_t k = 0; k < out.size(); ++k) {
        out[k] = w0 * values_[a][k] + w1 * values_[a + 1][k] + w2 * values_[a + 2][k];
    }
    return out;
}

Spline::Point Spline::cubic(double t) const {
    const size_t n = parameters_.size();
    Point out{};
    if (n == 2) {
        for (size_t k = 0; k < out.size(); ++k) out[k] = 0.5 * (values_[0][k] + values_[1][k]);
        return out;
    }
    // The end points only steer.
    if (t <= parameters_[1]) return values_[1];
    if (t > parameters_[n - 2]) return values_[n - 2];
    const auto above = std::lower_bound(parameters_.begin(), parameters_.end(), t);
    const auto i = static_cast<size_t>(above - parameters_.begin()) - 1;
    const double h = parameters_[i + 1] - parameters_[i];
    const double w = (t - parameters_[i]) / h;
    const auto slope = [&](size_t j, size_t k) {
        return (values_[j + 1][k] - values_[j][k]) / (parameters_[j + 1] - parameters_[j]);
    };
    const double w2 = w * w;
    const double w3 = w2 * w;
    for (size_t k = 0; k < out.size(); ++k) {
        const double m0 = h * (slope(i - 1, k) + slope(i, k)) / 2;
        const double m1 = h * (slope(i, k) + slope(i + 1, k)) / 2;
        out[k] = values_[i][k] * (2 * w3 - 3 * w2 + 1) + values_[i + 1][k] * (3 * w2 - 2 * w3) +
                 m0 * (w3 - 2 * w2 + w) + m1 * (w3 - w2);
    }
    return out;
}

Spline::Point Spline::natural(size_t i, double t) const {
    const size_t n = parameters_.size();
    Point out{};
    for (size_t k = 0; k < out.size(); ++k) {
        // Second derivatives by the tridiagonal system, both ends 0.
        std::vector<double> second(n, 0.0);
        std::vector<double> upper(n, 0.0);
        for (size_t j = 1; j + 1 < n; ++j) {
            const double h0 = parameters_[j] - parameters_[j - 1];
            const double h1 = parameters_[j + 1] - parameters_[j];
            const double right =
                6 * ((values_[j + 1][k] - values_[j][k]) / h1 - (values_[j][k] - values_[j - 1][k]) / h0);
            const double pivot = 2 * (h0 + h1) - h0 * upper[j - 1];
            upper[j] = h1 / pivot;
            second[j] = (right - h0 * second[j - 1]) / pivot;
        }
        for (size_t j = n - 1; j-- > 1;) second[j] -= upper[j] * second[j + 1];
        const double h = parameters_[i + 1] - parameters_[i];
        const double a = (parameters_[i + 1] - t) / h;
        const double b = (t - parameters_[i]) / h;
        out[k] = a * values_[i][k] + b * values_[i + 1][k] +
                 ((a * a * a - a) * second[i] + (b * b * b - b) * second[i + 1]) * h * h / 6;
    }
    return out;
}

}  // namespace rb
