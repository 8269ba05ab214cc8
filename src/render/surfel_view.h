#pragma once
#include "render/camera_rays.h"
#include "render/render.h"

namespace rb {

/// What radiosity has learned before the picture (`--gi-view surfels`): each pixel shows the light of the
/// smallest surfel known where it looks, and dark blue where none is.
void view_surfels(const Radiosity& radiosity, const CameraRays& rays, const RenderOptions& options,
                  const std::atomic<bool>& stop, Film& film);

}  // namespace rb
