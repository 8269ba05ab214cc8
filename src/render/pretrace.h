#pragma once
#include "radiosity/radiosity.h"
#include "render/camera_rays.h"

namespace rb {

/// What radiosity wants to know of a whole picture before it is rendered: where diffuse surfaces are seen,
/// also in mirrors and through glass.
PictureSurvey survey_of(const Integrator& integrator, const CameraRays& rays, int width, int height,
                        int threads);

}  // namespace rb
