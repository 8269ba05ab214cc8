#pragma once
#include "math/ray.h"
#include "scene/camera.h"
#include "shade/integrator.h"

#include <optional>
#include <span>

namespace rb {

/// Makes the rays of a camera for a picture of a given size (geometry spec 18.3, 18.4).
class CameraRays {
public:
    CameraRays(const Camera& camera, int width, int height);

    /// The ray through the continuous picture position (x, y): (0, 0) is the centre of the top left pixel, x
    /// grows to the right, y downward. False where this kind of camera makes no ray. The direction is unit
    /// length.
    bool at(double x, double y, Ray& ray) const {
        if (camera_.kind != CameraKind::perspective)
            return other_at((x + 0.5) / width_ - 0.5, 0.5 - (y + 0.5) / height_, ray);
        ray.origin = camera_.location;
        ray.direction = glm::normalize(flat_direction({x, y}));
        return true;
    }

    /// The same for many positions; leaves the seeds alone.
    void at(std::span<const Vec2> positions, std::span<CameraRay> out) const;

    /// Its direction before it is made unit length; absent where there is none.
    std::optional<Vec3> direction(double x, double y) const {
        return curved_direction((x + 0.5) / width_ - 0.5, 0.5 - (y + 0.5) / height_);
    }

private:
    /// Of a perspective camera, before it is made unit length.
    Vec3 flat_direction(const Vec2& p) const {
        const double x0 = (p.x + 0.5) / width_ - 0.5;
        const double y0 = 0.5 - (p.y + 0.5) / height_;
        return camera_.direction + x0 * camera_.right + y0 * camera_.up;
    }
    /// For the kinds other than perspective.
    bool other_at(double x0, double y0, Ray& ray) const;
    /// For the kinds whose rays follow a curve.
    std::optional<Vec3> curved_direction(double x0, double y0) const;
    Vec3 origin(double x0, double y0) const;

    Camera camera_;
    double width_;
    double height_;
    Vec3 unit_right_;
    Vec3 unit_up_;
    Vec3 unit_direction_;
    double right_length_;
    double up_length_;
    double angle_;  ///< radians
};

}  // namespace rb
