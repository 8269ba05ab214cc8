#pragma once
#include "base/diagnostics.h"
#include "scene/scene.h"

namespace rb {

/// Reports what the scene really uses and the renderer does not do yet: patterns, focal blur and the
/// like. Declared but unused things are not reported.
void report_unsupported(const Scene& scene, Diagnostics& diagnostics);

}  // namespace rb
