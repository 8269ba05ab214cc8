#pragma once
#include "render/camera_rays.h"
#include "render/render.h"

namespace rb {

/// What radiosity wants to know of a whole picture before it is rendered: where diffuse surfaces are seen,
/// also in mirrors and through glass. `middles`: pixels are seen in their middles only. What is referred to
/// must outlive it.
PictureSurvey survey_of(const Integrator& integrator, const CameraRays& rays, const RenderOptions& options,
                        bool middles, const std::atomic<bool>& stop);

}  // namespace rb
