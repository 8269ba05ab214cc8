#pragma once
#include "math/ray.h"
#include "scene/camera.h"

#include <optional>

namespace rb {

/// Makes the rays of a camera for a picture of a given size (geometry spec 18.3, 18.4).
class CameraRays {
public:
    CameraRays(const Camera& camera, int width, int height);

    /// The ray through the continuous picture position (x, y): (0, 0) is the centre of the top left pixel, x
    /// grows to the right, y downward. False where this kind of camera makes no ray. The direction is unit
    /// length.
    bool at(double x, double y, Ray& ray) const;

    /// Its direction before it is made unit length; absent where there is none.
    std::optional<Vec3> direction(double x, double y) const {
        return curved_direction((x + 0.5) / width_ - 0.5, 0.5 - (y + 0.5) / height_);
    }

private:
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
