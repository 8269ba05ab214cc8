#include "language/internal_functions.h"

#include "language/function_code.h"
#include "patterns/noise.h"

#include <cmath>
#include <mutex>

namespace rb {

namespace {

class Surface final : public Function {
public:
    explicit Surface(const InternalKind& kind) : kind_(kind) {}
    int parameter_count() const override { return kind_.parameters + 3; }
    int result_count() const override { return 1; }
    void evaluate(std::span<const double> a, std::span<double> result) const override {
        InternalPoint at{a[0], a[1], a[2], a[0] * a[0], a[1] * a[1], a[2] * a[2], a.data() + 3};
        result[0] = kind_.value(at);
    }

private:
    const InternalKind& kind_;
};

/// Generator numbers 1, 2, 3; 0 behaves as 1.
int generator_of(double number) {
    const int generator = static_cast<int>(std::trunc(number)) & 3;
    return generator == 0 ? 1 : generator;
}
double signed_noise(const Vec3& p, int generator) { return 2 * noise(p, generator) - 1; }

double hetero_mf(const Vec3& start, const double* P) {
    const int generator = generator_of(P[5]);
    Vec3 p = start;
    double sum = signed_noise(p, generator) + P[3];
    p *= P[1];
    const double e = std::pow(P[1], -P[0]);
    double k = e;
    for (int i = 1; i < P[2]; ++i) {
        double increment = (signed_noise(p, generator) + P[3]) * k;
        for (int n = 0; n < static_cast<int>(P[4]); ++n) increment *= sum;
        sum += increment;
        p *= P[1];
        k *= e;
    }
    const double rest = P[2] - std::trunc(P[2]);
    if (rest != 0) sum += rest * (signed_noise(p, generator) + P[3]) * k * sum;
    return sum;
}

double ridge(const Vec3& p, const double* P) {
    const int generator = generator_of(P[5]);
    const double ridge_scale = 1 / std::max(P[4], 1 - P[4]);
    const double offset_scale = 1 / std::max(P[3], 1 - P[3]);
    const int octaves = static_cast<int>(P[1]);
    const auto value = [&](const Vec3& q) { return std::abs(noise(q, generator) - P[4]) * ridge_scale; };
    double sum = value(p) - P[3];
    double total = 1;
    double lambda = P[0];
    double omega = P[2];
    const auto add = [&](double weight) {
        sum += weight * omega * (value(lambda * p) - P[3]);
        total += weight * omega;
    };
    for (int i = 2; i <= octaves; ++i) {
        add(1);
        lambda *= P[0];
        omega *= P[2];
    }
    const double rest = P[1] - octaves;
    if (rest != 0) add(rest);
    return sum * offset_scale / total;
}

class FractalNoise final : public Function {
public:
    explicit FractalNoise(int number) : number_(number) {}
    int parameter_count() const override { return 9; }
    int result_count() const override { return 1; }
    void evaluate(std::span<const double> a, std::span<double> result) const override {
        const Vec3 p{a[0], a[1], a[2]};
        const double* parameters = a.data() + 3;
        if (number_ == 29) {
            result[0] = hetero_mf(p, parameters);
        } else if (number_ == 58) {
            result[0] = ridge(p, parameters);
        } else {
            result[0] = ridged_mf(p, parameters);
        }
    }

private:
    /// The weights come from the first call of this function and stay (as in the reference).
    double ridged_mf(const Vec3& start, const double* P) const {
        std::call_once(once_, [&] {
            const int count = static_cast<int>(std::clamp(P[2], 0.0, 1000.0));
            for (int i = 0; i <= count; ++i) weights_.push_back(std::pow(std::pow(P[1], i), -P[0]));
        });
        const int generator = generator_of(P[5]);
        Vec3 p = start;
        const auto sample = [&] {
            const double s = P[3] - std::abs(signed_noise(p, generator));
            return s * s;
        };
        double s = sample();
        double sum = s;
        for (size_t i = 1; static_cast<double>(i) < P[2]; ++i) {
            p *= P[1];
            const double weight = std::clamp(s * P[4], 0.0, 1.0);
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
        result[0] = noise({a[0], a[1], a[2]}, generator);
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
};

}  // namespace

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
