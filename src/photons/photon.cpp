#include "photons/photon.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

constexpr double steps = 32767.0;

double sign_of(double x) { return x < 0.0 ? -1.0 : 1.0; }

}  // namespace

PackedDirection::PackedDirection(const Vec3& unit) {
    const double sum = std::abs(unit.x) + std::abs(unit.y) + std::abs(unit.z);
    double u = unit.x / sum;
    double v = unit.y / sum;
    if (unit.z < 0.0) {
        const double folded = (1.0 - std::abs(v)) * sign_of(u);
        v = (1.0 - std::abs(u)) * sign_of(v);
        u = folded;
    }
    const auto packed = [](double x) {
        return static_cast<int16_t>(std::lround(std::clamp(x, -1.0, 1.0) * steps));
    };
    place_ = {packed(u), packed(v)};
}

Vec3 PackedDirection::unpacked() const {
    const double u = place_[0] / steps;
    const double v = place_[1] / steps;
    Vec3 d{u, v, 1.0 - std::abs(u) - std::abs(v)};
    if (d.z < 0.0) {
        d.x = (1.0 - std::abs(v)) * sign_of(u);
        d.y = (1.0 - std::abs(u)) * sign_of(v);
    }
    return glm::normalize(d);
}

}  // namespace rb
