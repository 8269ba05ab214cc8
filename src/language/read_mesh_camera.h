#pragma once
#include "block/reader.h"
#include "scene/camera.h"

namespace rb {

/// A mesh_camera block of a camera. What the reference refuses is an error here, too.
std::shared_ptr<const MeshCamera> read_mesh_camera(const Block& block, const ReadContext& context);

}  // namespace rb
