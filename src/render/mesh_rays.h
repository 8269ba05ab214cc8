#pragma once
#include "math/ray.h"
#include "render/uv_grid.h"
#include "scene/camera.h"

#include <optional>

namespace rb {

/// The rays of a mesh_camera: from faces of its meshes, along their normals (geometry spec 18.4).
class MeshRays {
public:
    /// `camera` must be a mesh_camera.
    MeshRays(const Camera& camera, int width, int height);

    /// Ray `index` of the picture position (x, y), as for CameraRays::at; the direction is unit length.
    std::optional<Ray> at(double x, double y, int index) const;

private:
    struct Face {
        const CameraMesh* mesh;
        uint32_t index;
    };
    std::optional<Face> face_of(double x, double y, int index) const;
    std::optional<Ray> by_uv(double x, double y) const;
    Ray leaving(const Face& face, const Vec3& weights) const;

    std::shared_ptr<const MeshCamera> camera_;
    std::optional<UvGrid> uv_grid_;  ///< of the first mesh, for rays by_uv
    double offset_;                  ///< from the face along its normal
    bool turned_;                    ///< rays leave against the normal
    int width_;
    int height_;
};

}  // namespace rb
