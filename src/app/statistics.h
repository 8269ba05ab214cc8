#pragma once
#include "app/settings.h"

namespace rb {

/// Wall-clock seconds of each phase; what reading took of the processor and of memory.
struct Statistics {
    double parse_seconds = 0;
    double parse_cpu_seconds = 0;
    long parse_peak_memory = 0;  ///< KiB, of the process when the scene was read
    double compile_seconds = 0;
    double render_seconds = 0;
    double write_seconds = 0;
};

/// CPU seconds of the whole process so far, and the most memory that it has held, in KiB.
double cpu_seconds();
long peak_memory();

/// The same for people, for Statistic_File.
std::string statistics_text(const Statistics& statistics, const World& world, const RenderResult& result);

/// JSON with stable keys: phases, counts, rays, peak memory. To standard error or a file (`--stats`).
void write_statistics(const Statistics& statistics, const World& world, const RenderResult& result,
                      const Settings& settings);

}  // namespace rb
