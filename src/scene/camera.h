#pragma once
#include "base/source.h"
#include "math/transform.h"

#include <optional>
#include <string>

namespace rb {

enum class CameraKind {
    perspective,
    orthographic,
    fisheye,
    ultra_wide_angle,
    omnimax,
    panoramic,
    cylinder,
    spherical,
    mesh_camera
};

/// A camera with its vectors resolved (look_at, angle, transformations applied), ready to make rays (spec:
/// geometry 18).
struct Camera {
    SourceRange where;
    CameraKind kind = CameraKind::perspective;
    int cylinder_type = 1;
    Vec3 location{0.0};
    Vec3 direction{0.0, 0.0, 1.0};
    Vec3 up{0.0, 1.0, 0.0};
    Vec3 right{1.33, 0.0, 0.0};
    double angle_deg = 90;            ///< fisheye, ultra_wide_angle, cylinder; horizontal angle of spherical
    double vertical_angle_deg = 180;  ///< spherical
    double aperture = 0;
    int blur_samples = 0;
    int blur_samples_min = 0;
    double confidence = 0.9;
    double variance = 1e-4;
    double focal_distance = 1;
};

}  // namespace rb
