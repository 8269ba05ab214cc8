#pragma once
#include "app/animation.h"
#include "app/console.h"
#include "language/load.h"

namespace rb {

/// How to read the scene of one frame. `settings`, `console` and `oracle` must outlive the reading; "-" is
/// read from standard input here.
LoadOptions load_options(const Settings& settings, const AnimationFrame& frame, Console& console,
                         GeometryOracle& oracle);

}  // namespace rb
