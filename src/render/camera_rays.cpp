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

/// The angle of (x, y) from the x axis, in [-pi/2, 3/2 pi) as in the reference: a camera's normal sees it.
double angle_of(double x, double y, double radius) {
    if (!(radius > 0.0)) return 0.0;
    const double rising = std::asin(std::clamp(y / radius, -1.0, 1.0));
    return x < 0.0 ? pi - rising : rising;
}

}  // namespace

CameraRays::CameraRays(const Camera& camera, const PatternSettings& patterns, int width, int height)
    : camera_(camera),
      width_(width),
      height_(height),
      unit_right_(unit_or_zero(camera.right)),
      unit_up_(unit_or_zero(camera.up)),
      unit_direction_(unit_or_zero(camera.direction)),
      right_length_(glm::length(camera.right)),
      up_length_(glm::length(camera.up)),
      angle_(camera.angle_deg * pi / 180.0) {
    if (camera.mesh) mesh_.emplace(camera, width, height);
    if (camera.normal && (camera.normal->pattern || camera.normal->average))
        normal_.emplace(*camera.normal, patterns);
}

void CameraRays::at(std::span<const Vec2> positions, std::span<CameraRay> out) const {
    if (camera_.kind != CameraKind::perspective || normal_) {
        for (size_t i = 0; i < positions.size(); ++i)
            out[i].exists = at(positions[i].x, positions[i].y, 0, out[i].ray);
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

bool CameraRays::other_at(double x, double y, int index, Ray& ray) const {
    const auto found = view(x, y, index);
    if (!found) return false;
    ray = {found->origin, glm::normalize(found->direction)};
    disturb(found->place, ray.direction);
    return true;
}

void CameraRays::disturb(const Vec2& place, Vec3& direction) const {
    if (!normal_) return;
    const Vec3 point{place, 0.0};
    const Vec2 no_uv{0.0};
    const uint32_t row = 0;
    const SurfaceSamples surface{{&point, 1}, {&direction, 1}, {&direction, 1}, {&no_uv, 1}};
    Vec3 turned = direction;
    normal_->perturb({{&point, 1}, &surface, {&row, 1}}, {&turned, 1});
    direction = glm::normalize(turned);
}

std::optional<CameraView> CameraRays::view(double x, double y, int index) const {
    const double x0 = across(x);
    const double y0 = upward(y);
    const auto from_location = [&](const Vec3& direction) {
        return CameraView{camera_.location, direction, {x0, y0}};
    };
    switch (camera_.kind) {
        case CameraKind::perspective:
            return from_location(camera_.direction + x0 * camera_.right + y0 * camera_.up);
        case CameraKind::orthographic:
            return CameraView{
                camera_.location + x0 * camera_.right + y0 * camera_.up, camera_.direction, {x0, y0}};
        case CameraKind::fisheye:
            return fisheye(x0, y0);
        case CameraKind::ultra_wide_angle: {
            const double a = x0 * angle_;
            const double b = y0 * angle_ * up_length_ / right_length_;
            return CameraView{
                camera_.location, in_frame(std::sin(a), std::sin(b), std::cos(a) * std::cos(b)), {a, b}};
        }
        case CameraKind::omnimax:
            return omnimax(x0, y0);
        case CameraKind::panoramic:
            return panoramic(x0, y0);
        case CameraKind::cylinder:
            return cylinder(x0, y0);
        case CameraKind::spherical:
            return spherical(x0, y0);
        case CameraKind::mesh_camera: {
            const auto ray = mesh_->at(x, y, index);
            if (!ray) return std::nullopt;
            return CameraView{ray->origin, ray->direction, {0.0, 0.0}};
        }
    }
    return std::nullopt;
}

std::optional<CameraView> CameraRays::fisheye(double x0, double y0) const {
    const double x = 2.0 * x0 * right_length_;
    const double y = 2.0 * y0 * up_length_;
    const double rho = std::hypot(x, y);
    if (rho > 1.0) return std::nullopt;
    const double phi = angle_of(x, y, rho);
    const double theta = rho * angle_ / 2.0;
    return CameraView{
        camera_.location,
        in_frame(std::cos(phi) * std::sin(theta), std::sin(phi) * std::sin(theta), std::cos(theta)),
        {phi, theta}};
}

std::optional<CameraView> CameraRays::omnimax(double x0, double y0) const {
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
    const double phi = angle_of(x, y, rho);
    const double theta = 1.411269 * rho - 0.09439 * std::pow(rho, 3) + 0.25674 * std::pow(rho, 5);
    if (std::sin(phi) * std::sin(theta) < std::tan(135.0 * pi / 180.0) * std::cos(theta)) return std::nullopt;
    return CameraView{
        camera_.location,
        in_frame(std::cos(phi) * std::sin(theta), std::sin(phi) * std::sin(theta), std::cos(theta)),
        {phi, theta}};
}

CameraView CameraRays::panoramic(double x0, double y0) const {
    const double a = (0.5 - x0) * pi;
    const double b = y0 * pi;
    const double slope = std::abs(pi / 2.0 - std::abs(b)) < 1e-10 ? std::copysign(2e10, b) : std::tan(b);
    return {camera_.location,
            std::cos(a) * camera_.right + slope * camera_.up + std::sin(a) * camera_.direction,
            {a, b}};
}

CameraView CameraRays::cylinder(double x0, double y0) const {
    const bool upright = camera_.cylinder_type == 1 || camera_.cylinder_type == 3;
    const double x = x0 * (upright ? angle_ : right_length_);
    const double y = y0 * (upright ? up_length_ : angle_);
    const double sine = std::sin(upright ? x : y);
    const double cosine = std::cos(upright ? x : y);
    CameraView view{camera_.location, {}, {x, y}};
    switch (camera_.cylinder_type) {
        case 1:
            view.direction = in_frame(sine, y, cosine);
            break;
        case 2:
            view.direction = in_frame(x, sine, cosine);
            break;
        case 3:
            view.origin += y * unit_up_;
            view.direction = in_frame(sine, 0.0, cosine);
            break;
        default:
            view.origin += x * unit_right_;
            view.direction = in_frame(0.0, sine, cosine);
            break;
    }
    return view;
}

CameraView CameraRays::spherical(double x0, double y0) const {
    const double across = x0 * angle_;
    const double upward = y0 * camera_.vertical_angle_deg * pi / 180.0;
    const Vec3 tilted = rotate_about(camera_.direction, unit_right_, -upward);
    return {camera_.location, rotate_about(tilted, unit_up_, across), {across, upward}};
}

}  // namespace rb
