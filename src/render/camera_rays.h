#pragma once
#include "math/ray.h"
#include "patterns/normal_program.h"
#include "render/mesh_rays.h"
#include "shade/integrator.h"

#include <optional>
#include <span>

namespace rb {

/// A ray of a camera before its normal disturbs it.
struct CameraView {
    Vec3 origin{0.0};
    Vec3 direction{0.0};  ///< any length
    Vec2 place{0.0};      ///< where the camera's normal is evaluated
};

/// Makes the rays of a camera for a picture of a given size (geometry spec 18.3 to 18.5).
class CameraRays {
public:
    CameraRays(const Camera& camera, const PatternSettings& patterns, int width, int height);

    /// How many rays a picture position stands for: their mean is seen there. More than one only for a
    /// mesh_camera.
    int rays_per_position() const { return mesh_ ? camera_.mesh->rays_per_pixel : 1; }

    /// Ray `index` through the continuous picture position (x, y): (0, 0) is the centre of the top left
    /// pixel, x grows to the right, y downward. False where this kind of camera makes no ray. The direction
    /// is unit length.
    bool at(double x, double y, int index, Ray& ray) const {
        if (camera_.kind != CameraKind::perspective || normal_) return other_at(x, y, index, ray);
        ray.origin = camera_.location;
        ray.direction = glm::normalize(flat_direction({x, y}));
        return true;
    }

    /// Ray 0 of many positions; leaves the seeds alone.
    void at(std::span<const Vec2> positions, std::span<CameraRay> out) const;

    /// A single one before the normal acts; absent where there is none.
    std::optional<CameraView> view(double x, double y, int index) const;

    /// Lets the camera's normal, if it has one, act on a unit direction.
    void disturb(const Vec2& place, Vec3& direction) const;

private:
    /// Of a perspective camera, before it is made unit length.
    Vec3 flat_direction(const Vec2& p) const {
        return camera_.direction + across(p.x) * camera_.right + upward(p.y) * camera_.up;
    }
    double across(double x) const { return (x + 0.5) / width_ - 0.5; }
    double upward(double y) const { return 0.5 - (y + 0.5) / height_; }
    /// For all but a plain perspective camera.
    bool other_at(double x, double y, int index, Ray& ray) const;
    Vec3 in_frame(double right, double up, double forward) const {
        return right * unit_right_ + up * unit_up_ + forward * unit_direction_;
    }
    std::optional<CameraView> fisheye(double x0, double y0) const;
    std::optional<CameraView> omnimax(double x0, double y0) const;
    CameraView panoramic(double x0, double y0) const;
    CameraView cylinder(double x0, double y0) const;
    CameraView spherical(double x0, double y0) const;

    Camera camera_;
    double width_;
    double height_;
    Vec3 unit_right_;
    Vec3 unit_up_;
    Vec3 unit_direction_;
    double right_length_;
    double up_length_;
    double angle_;  ///< radians
    std::optional<MeshRays> mesh_;
    std::optional<NormalProgram> normal_;
};

}  // namespace rb
