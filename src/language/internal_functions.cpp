#include "language/internal_functions.h"

#include "language/function_code.h"
#include "patterns/line_bound.h"
#include "patterns/noise.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace rb {

namespace {

bool are_points(std::span<const Interval> a) {
    return std::ranges::all_of(a, [](const Interval& v) { return v.is_point(); });
}
bool are_points(std::span<const IntervalSlope> a) {
    return std::ranges::all_of(a, [](const IntervalSlope& v) { return v.value.is_point(); });
}

class Surface final : public Function {
public:
    explicit Surface(const InternalKind& kind) : kind_(kind) {}
    int parameter_count() const override { return kind_.parameters + 3; }
    int result_count() const override { return 1; }
    void evaluate(std::span<const double> a, std::span<double> result) const override {
        InternalPoint<double> at(a);
        result[0] = kind_.value(at);
    }
    Interval bound(std::span<const Interval> a, int) const override {
        if (!are_points(a.subspan(3))) return Interval::everything();
        InternalPoint<Interval> at(a);
        return kind_.bound(at);
    }
    IntervalSlope bound_slope(std::span<const IntervalSlope> a, int) const override {
        if (!are_points(a.subspan(3))) return IntervalSlope::everything();
        InternalPoint<IntervalSlope> at(a);
        return kind_.bound_slope(at);
    }

private:
    const InternalKind& kind_;
};

/// Generator numbers 1, 2, 3; 0 behaves as 1.
int generator_of(double number) {
    const int generator = static_cast<int>(std::trunc(number)) & 3;
    return generator == 0 ? 1 : generator;
}

template <class T>
struct Place3 {
    T x, y, z;
    Place3 times(const T& f) const { return {x * f, y * f, z * f}; }
};
double noise_at(const Place3<double>& p, int generator) { return noise(Vec3{p.x, p.y, p.z}, generator); }
IntervalSlope noise_at(const Place3<IntervalSlope>& p, int generator) {
    return bound_noise({p.x, p.y, p.z}, generator);
}
Interval noise_at(const Place3<Interval>& p, int generator) {
    return bound_noise({{{p.x, 0.0}, {p.y, 0.0}, {p.z, 0.0}}}, generator).value;
}
template <class T>
T signed_noise(const Place3<T>& p, int generator) {
    return 2 * noise_at(p, generator) - 1;
}

using std::abs;
using std::max;
using std::min;
using std::pow;

template <class T>
T hetero_mf(Place3<T> p, const T* P) {
    const int generator = generator_of(known(P[5]));
    T sum = signed_noise(p, generator) + P[3];
    p = p.times(P[1]);
    const T e = pow(P[1], -P[0]);
    T k = e;
    for (int i = 1; i < known(P[2]); ++i) {
        T increment = (signed_noise(p, generator) + P[3]) * k;
        for (int n = 0; n < static_cast<int>(known(P[4])); ++n) increment *= sum;
        sum += increment;
        p = p.times(P[1]);
        k *= e;
    }
    const double rest = known(P[2]) - std::trunc(known(P[2]));
    if (rest != 0) sum += rest * (signed_noise(p, generator) + P[3]) * k * sum;
    return sum;
}

template <class T>
T ridge(const Place3<T>& p, const T* P) {
    const int generator = generator_of(known(P[5]));
    const T ridge_scale = 1 / max(P[4], 1 - P[4]);
    const T offset_scale = 1 / max(P[3], 1 - P[3]);
    const int octaves = static_cast<int>(known(P[1]));
    const auto value = [&](const Place3<T>& q) { return abs(noise_at(q, generator) - P[4]) * ridge_scale; };
    T sum = value(p) - P[3];
    T total = 1;
    T lambda = P[0];
    T omega = P[2];
    const auto add = [&](double weight) {
        sum += weight * omega * (value(p.times(lambda)) - P[3]);
        total += weight * omega;
    };
    for (int i = 2; i <= octaves; ++i) {
        add(1);
        lambda *= P[0];
        omega *= P[2];
    }
    const double rest = known(P[1]) - octaves;
    if (rest != 0) add(rest);
    return sum * offset_scale / total;
}

class FractalNoise final : public Function {
public:
    explicit FractalNoise(int number) : number_(number) {}
    int parameter_count() const override { return 9; }
    int result_count() const override { return 1; }
    void evaluate(std::span<const double> a, std::span<double> result) const override {
        result[0] = value(a);
    }
    /// Counts as a call, see ridged_mf().
    Interval bound(std::span<const Interval> a, int) const override {
        return are_points(a.subspan(3)) ? value(a) : Interval::everything();
    }
    IntervalSlope bound_slope(std::span<const IntervalSlope> a, int) const override {
        return are_points(a.subspan(3)) ? value(a) : IntervalSlope::everything();
    }

private:
    template <class T>
    T value(std::span<const T> a) const {
        const Place3<T> p{a[0], a[1], a[2]};
        const T* parameters = a.data() + 3;
        if (number_ == 29) return hetero_mf(p, parameters);
        if (number_ == 58) return ridge(p, parameters);
        return ridged_mf(p, parameters);
    }
    /// The weights come from the first call of this function and stay (as in the reference).
    template <class T>
    T ridged_mf(Place3<T> p, const T* P) const {
        std::call_once(once_, [&] {
            const int count = static_cast<int>(std::clamp(known(P[2]), 0.0, 1000.0));
            for (int i = 0; i <= count; ++i) weights_.push_back(pow(pow(known(P[1]), i), -known(P[0])));
        });
        const int generator = generator_of(known(P[5]));
        const auto sample = [&] { return square(P[3] - abs(signed_noise(p, generator))); };
        T s = sample();
        T sum = s;
        for (size_t i = 1; static_cast<double>(i) < known(P[2]); ++i) {
            p = p.times(P[1]);
            const T weight = min(max(s * P[4], T(0)), T(1));
            s = sample() * weight;
            sum += s * (i < weights_.size() ? weights_[i] : 0.0);
        }
        return sum;
    }

    int number_;
    mutable std::once_flag once_;
    mutable std::vector<double> weights_;
};

class Noise final : public Function {
public:
    Noise(int parameters, std::shared_ptr<const int> generator)
        : parameters_(parameters), scene_generator_(std::move(generator)) {}
    int parameter_count() const override { return 3 + parameters_; }
    int result_count() const override { return 1; }
    void evaluate(std::span<const double> a, std::span<double> result) const override {
        const int generator = parameters_ == 1 ? generator_of(a[3]) : *scene_generator_;
        result[0] = noise(Vec3{a[0], a[1], a[2]}, generator);
    }
    Interval bound(std::span<const Interval> a, int) const override {
        if (parameters_ == 1 && !a[3].is_point()) return {0, 1};
        const int generator = parameters_ == 1 ? generator_of(a[3].lo) : *scene_generator_;
        return noise_at(Place3<Interval>{a[0], a[1], a[2]}, generator);
    }
    IntervalSlope bound_slope(std::span<const IntervalSlope> a, int) const override {
        if (!are_points(a.subspan(3))) return IntervalSlope::everything();
        return noise_at(Place3<IntervalSlope>{a[0], a[1], a[2]},
                        parameters_ == 1 ? generator_of(known(a[3])) : *scene_generator_);
    }

private:
    int parameters_;
    std::shared_ptr<const int> scene_generator_;
};

class Nothing final : public Function {
public:
    int parameter_count() const override { return 3; }
    int result_count() const override { return 1; }
    void evaluate(std::span<const double>, std::span<double> result) const override { result[0] = 0; }
    Interval bound(std::span<const Interval>, int) const override { return 0; }
};

}  // namespace

Interval within(const Interval& v, const Interval& limit) {
    const Interval cut{within(v.lo, limit.lo), within(v.hi, limit.lo)};
    return v.maybe_nan ? hull(cut, -limit.lo) : cut;
}

IntervalSlope within(const IntervalSlope& v, const IntervalSlope& limit) {
    const Interval cut = within(v.value, limit.value);
    const bool as_it_is = cut.lo == v.value.lo && cut.hi == v.value.hi;
    return {cut, as_it_is ? v.slope : hull(v.slope, 0)};
}

void keep_from_axis(Interval& x, const Interval& z, double small) {
    if (x.holds(0) && z.holds(0)) x = hull(x, small);
}

void keep_from_axis(IntervalSlope& x, const IntervalSlope& z, double small) {
    if (!x.value.holds(0) || !z.value.holds(0)) return;
    keep_from_axis(x.value, z.value, small);
    x.slope = Interval::everything();
}

void keep_from_zero(Interval& z) {
    if (z.lo < 0.2 && z.hi > -0.2) z = z.lo > -0.2 && z.hi < 0.2 ? Interval(0.2) : hull(z, 0.2);
    // Nothing between is left.
    if (z.lo > -0.2 && z.lo < 0.2) z.lo = 0.2;
}

void keep_from_zero(IntervalSlope& z) {
    if (!(z.value.lo < 0.2 && z.value.hi > -0.2)) return;
    keep_from_zero(z.value);
    z.slope = Interval::everything();
}

FunctionPtr internal_function(int number, std::shared_ptr<const int> noise_generator) {
    if (number == 29 || number == 58 || number == 59) return std::make_shared<FractalNoise>(number);
    if (number == 76) return std::make_shared<Noise>(0, std::move(noise_generator));
    if (number == 77) return std::make_shared<Nothing>();
    if (number == 78) return std::make_shared<Noise>(1, std::move(noise_generator));
    for (const auto kinds : {algebraic_surfaces(), shaped_surfaces()}) {
        for (const InternalKind& kind : kinds) {
            if (kind.number == number) return std::make_shared<Surface>(kind);
        }
    }
    return nullptr;
}

}  // namespace rb
