#pragma once
#include "scene/scene.h"

#include <vector>

namespace rb {

/// What the settings of radiosity{}, or one number in their place, come to. docs/radiosity.md has the table.
struct GatherQuality {
    std::vector<int> rays;       ///< of one gather, by depth
    std::vector<double> bounds;  ///< error up to which a record is used, by depth
    // Of records at depth 0, in distances from the eye; doubled with each bounce.
    double minimum_radius = 0;
    double maximum_radius = 0;
    double minimum_reach = 0;  ///< as far as any record is used: as in POV-Ray, whose bounds are looser

    /// `smooth`: gathers make records that are smoothed, and can do with fewer rays. `error`: RMSE that is
    /// aimed at, in shares of white; 0: as the settings say.
    GatherQuality(const RadiositySettings& settings, bool smooth, double error);
};

}  // namespace rb
