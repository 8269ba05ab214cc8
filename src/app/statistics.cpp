#include "app/statistics.h"

#include "base/diagnostics.h"
#include "compile/geometry.h"

#include <cstdio>
#include <fstream>
#include <sys/resource.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rb {

void write_statistics(const Statistics& statistics, const World& world, const RenderResult& result,
                      const Settings& settings) {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    const nlohmann::ordered_json json{{"scene", settings.input_file},
                                      {"width", settings.width},
                                      {"height", settings.height},
                                      {"seconds",
                                       {{"parse", statistics.parse_seconds},
                                        {"compile", statistics.compile_seconds},
                                        {"render", statistics.render_seconds},
                                        {"write", statistics.write_seconds},
                                        {"cpu", seconds(usage.ru_utime) + seconds(usage.ru_stime)}}},
                                      {"world",
                                       {{"leaves", world.geometry->leaves().size()},
                                        {"surfaces", world.surfaces.size()},
                                        {"lights", world.lights.size()}}},
                                      {"rays",
                                       {{"camera", result.counters.camera},
                                        {"reflected", result.counters.reflected},
                                        {"refracted", result.counters.refracted},
                                        {"shadow", result.counters.shadow}}},
                                      {"peak_memory_kib", usage.ru_maxrss},
                                      {"complete", result.complete}};
    const std::string text = json.dump(2) + "\n";
    if (*settings.stats_file == "-") {
        std::fwrite(text.data(), 1, text.size(), stderr);
        return;
    }
    std::ofstream out(*settings.stats_file);
    if (!(out << text)) throw IoError(fmt::format("cannot write '{}'", *settings.stats_file));
}

}  // namespace rb
