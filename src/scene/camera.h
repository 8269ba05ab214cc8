#pragma once
#include "base/source.h"
#include "math/transform.h"
#include "scene/shape.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

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

/// One mesh of a mesh_camera: its triangles, shared with the object that the scene declared.
struct CameraMesh {
    std::shared_ptr<const TriangleMesh> triangles;
    std::shared_ptr<const std::vector<Vec2>> uvs;
    /// Parallel to the faces, or empty: (0, 0) everywhere.
    std::shared_ptr<const std::vector<std::array<uint32_t, 3>>> face_uvs;
    Transform world_from_mesh;
};

/// How pixels of a mesh_camera find their faces (spec: geometry 18.4).
enum class RayDistribution {
    mesh_per_ray,     ///< 0: ray k of a pixel starts on mesh k
    one_after_other,  ///< 1: the faces of all meshes in a row
    side_by_side,     ///< 2: each mesh fills its part of the picture's width
    by_uv             ///< 3: the picture is the uv square of the first mesh
};

/// `mesh_camera { ... }`: rays leave the faces of meshes along their normals.
struct MeshCamera {
    int rays_per_pixel = 1;
    RayDistribution distribution = RayDistribution::mesh_per_ray;
    double max_distance = 0;  ///< beyond it nothing is seen; 0: no limit
    bool smooth = false;      ///< interpolated normals
    std::vector<CameraMesh> meshes;
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
    std::shared_ptr<const MeshCamera> mesh;  ///< of a mesh_camera
    NormalPtr normal;                        ///< disturbs the rays' directions; null: nothing does
    PigmentPtr bokeh;  ///< how much of the light each place of the lens lets in; null: all
};

}  // namespace rb
