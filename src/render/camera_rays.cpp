#include "render/camera_rays.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rb {

namespace {

Vec3 unit_or_zero(const Vec3& v) {
    const double length = glm::length(v);
    return length > 0.0 ? v / length : Vec3{0.0};
}

/// Left-handed rotation of `p` about the unit axis `a` (geometry spec 2.2).
Vec3 rotate_about(const Vec3& p, const Vec3& a, double angle) {
    const double c = std::cos(angle);
    return p * c + glm::cross(a, p) * std::sin(angle) + a * (glm::dot(a, p) * (1.0 - c));
}

}  // namespace

CameraRays::CameraRays(const Camera& camera, int width, int height)
    : camera_(camera),
      width_(width),
      height_(height),
      unit_right_(unit_or_zero(camera.right)),
      unit_up_(unit_or_zero(camera.up)),
      unit_direction_(unit_or_zero(camera.direction)),
      right_length_(glm::length(camera.right)),
      up_length_(glm::length(camera.up)),
      angle_(camera.angle_deg * pi / 180.0) {}

void CameraRays::at(std::span<const Vec2> positions, std::span<CameraRay> out) const {
    if (camera_.kind != CameraKind::perspective) {
        for (size_t i = 0; i < positions.size(); ++i)
            out[i].exists = at(positions[i].x, positions[i].y, out[i].ray);
        return;
    }
    // Roots and divisions of a few directions at once; otherwise they are most of the work.
    constexpr size_t few = 32;
    std::array<double, few> scales;
    for (size_t begin = 0; begin < positions.size(); begin += few) {
        const size_t count = std::min(few, positions.size() - begin);
        scales.fill(1.0);
        for (size_t i = 0; i < count; ++i) {
            CameraRay& to = out[begin + i];
            to.exists = true;
            to.ray.origin = camera_.location;
            to.ray.direction = flat_direction(positions[begin + i]);
            scales[i] = glm::dot(to.ray.direction, to.ray.direction);
        }
        for (double& scale : scales) scale = 1.0 / std::sqrt(scale);
        for (size_t i = 0; i < count; ++i) out[begin + i].ray.direction *= scales[i];
    }
}

bool CameraRays::other_at(double x0, double y0, Ray& ray) const {
    const auto direction = curved_direction(x0, y0);
    if (!direction) return false;
    ray = {origin(x0, y0), glm::normalize(*direction)};
    return true;
}

Vec3 CameraRays::origin(double x0, double y0) const {
    if (camera_.kind == CameraKind::orthographic)
        return camera_.location + x0 * camera_.right + y0 * camera_.up;
    if (camera_.kind != CameraKind::cylinder) return camera_.location;
    if (camera_.cylinder_type == 3) return camera_.location + y0 * up_length_ * unit_up_;
    if (camera_.cylinder_type == 4) return camera_.location + x0 * right_length_ * unit_right_;
    return camera_.location;
}

std::optional<Vec3> CameraRays::curved_direction(double x0, double y0) const {
    const auto in_frame = [&](double r, double u, double d) {
        return r * unit_right_ + u * unit_up_ + d * unit_direction_;
    };
    switch (camera_.kind) {
        case CameraKind::perspective:
            return camera_.direction + x0 * camera_.right + y0 * camera_.up;
        case CameraKind::orthographic:
            return camera_.direction;
        case CameraKind::fisheye: {
            const double x = 2.0 * x0 * right_length_;
            const double y = 2.0 * y0 * up_length_;
            const double rho = std::hypot(x, y);
            if (rho > 1.0) return std::nullopt;
            const double phi = rho > 0.0 ? std::atan2(y, x) : 0.0;
            const double theta = rho * angle_ / 2.0;
            return in_frame(std::cos(phi) * std::sin(theta), std::sin(phi) * std::sin(theta),
                            std::cos(theta));
        }
        case CameraKind::ultra_wide_angle: {
            const double a = x0 * angle_;
            const double b = y0 * angle_ * up_length_ / right_length_;
            return in_frame(std::sin(a), std::sin(b), std::cos(a) * std::cos(b));
        }
        case CameraKind::omnimax: {
            constexpr double widest = 1.283458;
            const double s = right_length_ / up_length_;
            double x = 2.0 * x0;
            double y = 2.0 * y0;
            if (s > widest) {
                x *= s / widest;
                y = (y - 1.0) / widest + 1.0;
            } else if (s > 1.0) {
                y = (y - 1.0) / s + 1.0;
            } else {
                y /= s;
            }
            const double rho = std::hypot(x, y);
            if (rho > 1.0) return std::nullopt;
            const double phi = rho > 0.0 ? std::atan2(y, x) : 0.0;
            const double theta = 1.411269 * rho - 0.09439 * std::pow(rho, 3) + 0.25674 * std::pow(rho, 5);
            if (std::sin(phi) * std::sin(theta) < std::tan(135.0 * pi / 180.0) * std::cos(theta))
                return std::nullopt;
            return in_frame(std::cos(phi) * std::sin(theta), std::sin(phi) * std::sin(theta),
                            std::cos(theta));
        }
        case CameraKind::panoramic: {
            const double a = (0.5 - x0) * pi;
            const double b = y0 * pi;
            const double slope =
                std::abs(pi / 2.0 - std::abs(b)) < 1e-10 ? std::copysign(2e10, b) : std::tan(b);
            return std::cos(a) * camera_.right + slope * camera_.up + std::sin(a) * camera_.direction;
        }
        case CameraKind::cylinder: {
            const bool vertical = camera_.cylinder_type == 1 || camera_.cylinder_type == 3;
            const double a = (vertical ? x0 : y0) * angle_;
            switch (camera_.cylinder_type) {
                case 1:
                    return in_frame(std::sin(a), y0 * up_length_, std::cos(a));
                case 2:
                    return in_frame(x0 * right_length_, std::sin(a), std::cos(a));
                case 3:
                    return in_frame(std::sin(a), 0.0, std::cos(a));
                default:
                    return in_frame(0.0, std::sin(a), std::cos(a));
            }
        }
        case CameraKind::spherical: {
            const double vertical = camera_.vertical_angle_deg * pi / 180.0;
            const Vec3 tilted = rotate_about(camera_.direction, unit_right_, -y0 * vertical);
            return rotate_about(tilted, unit_up_, x0 * angle_);
        }
        case CameraKind::mesh_camera:
            return std::nullopt;
    }
    return std::nullopt;
}

}  // namespace rb
