#pragma once
#include "app/settings.h"

namespace rb {

/// Wall-clock seconds of each phase.
struct Statistics {
    double parse_seconds = 0;
    double compile_seconds = 0;
    double render_seconds = 0;
    double write_seconds = 0;
};

/// JSON with stable keys: phases, counts, rays, peak memory. To standard error or a file (`--stats`).
void write_statistics(const Statistics& statistics, const World& world, const RenderResult& result,
                      const Settings& settings);

}  // namespace rb
