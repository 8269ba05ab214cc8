#include "app/statistics.h"

#include "base/diagnostics.h"
#include "compile/geometry.h"

#include <cstdio>
#include <fstream>
#include <numeric>
#include <sys/resource.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rb {

namespace {

rusage usage() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage;
}

double seconds(const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

/// Nothing in scenes without photons.
std::string photon_text(const PhotonCounters& photons) {
    if (photons.shot + photons.on_surfaces + photons.in_media == 0) return {};
    return fmt::format("Photons Shot: {:>12}\nOn Surfaces:  {:>12}\nIn Media:     {:>12}\n", photons.shot,
                       photons.on_surfaces, photons.in_media);
}

/// Nothing in scenes without radiosity.
std::string radiosity_text(const std::optional<RadiosityReport>& report) {
    if (!report) return {};
    const auto sum = [](const std::vector<size_t>& parts) {
        return std::accumulate(parts.begin(), parts.end(), size_t{0});
    };
    const uint64_t asked = report->interpolations + report->gaps[0] + report->gaps[1];
    const double share =
        asked == 0 ? 0.0 : 100.0 * static_cast<double>(report->interpolations) / static_cast<double>(asked);
    return fmt::format("Gathers:      {:>12}  by {} rays, {} shadow rays\n", report->gathers, report->rays,
                       report->shadow_rays) +
           fmt::format("Interpolations:{:>11}  ({:.1f} %) from {} records; error where not trusted {:.4f}\n",
                       report->interpolations, share, sum(report->records), report->error_estimate) +
           fmt::format("Without record:{:>11}  seen by the eye, {} by gathers: gathered on the spot\n",
                       report->gaps[0], report->gaps[1]) +
           fmt::format("Surfels:      {:>12}  in {} cells, {} bytes\n", sum(report->surfels),
                       sum(report->cells), report->surfel_bytes);
}

}  // namespace

double cpu_seconds() {
    const rusage used = usage();
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

long peak_memory() { return usage().ru_maxrss; }

std::string statistics_text(const Statistics& statistics, const World& world, const RenderResult& result) {
    const RayCounters& rays = result.counters;
    return fmt::format(
        "Surfaces:     {:>12}\nLight Sources:{:>12}\nCamera Rays:  {:>12}\nReflected:    {:>12}\n"
        "Refracted:    {:>12}\nShadow Rays:  {:>12}\n{}{}Parse Time:   {:.3f} seconds\nBounding Time:{:.3f} "
        "seconds\n"
        "Trace Time:   {:.3f} seconds\n",
        world.geometry->leaves().size(), world.lights.size(), rays.camera, rays.reflected, rays.refracted,
        rays.shadow, photon_text(result.photons), radiosity_text(result.radiosity), statistics.parse_seconds,
        statistics.compile_seconds, statistics.render_seconds);
}

namespace {

nlohmann::ordered_json to_json(const RadiosityReport& report) {
    return {{"records", report.records},
            {"surfels", report.surfels},
            {"cells", report.cells},
            {"surfel_bytes", report.surfel_bytes},
            {"interpolations", report.interpolations},
            {"error_estimate", report.error_estimate},
            {"gathers", report.gathers},
            {"gaps", report.gaps},
            {"rays", report.rays},
            {"shadow_rays", report.shadow_rays}};
}

}  // namespace

void write_statistics(const Statistics& statistics, const World& world, const RenderResult& result,
                      const Settings& settings) {
    nlohmann::ordered_json json{{"scene", settings.input_file},
                                {"width", settings.width},
                                {"height", settings.height},
                                {"seconds",
                                 {{"parse", statistics.parse_seconds},
                                  {"parse_cpu", statistics.parse_cpu_seconds},
                                  {"compile", statistics.compile_seconds},
                                  {"render", statistics.render_seconds},
                                  {"write", statistics.write_seconds},
                                  {"cpu", cpu_seconds()}}},
                                {"world",
                                 {{"leaves", world.geometry->leaves().size()},
                                  {"surfaces", world.surfaces.size()},
                                  {"lights", world.lights.size()}}},
                                {"rays",
                                 {{"camera", result.counters.camera},
                                  {"reflected", result.counters.reflected},
                                  {"refracted", result.counters.refracted},
                                  {"shadow", result.counters.shadow}}},
                                {"photons",
                                 {{"shot", result.photons.shot},
                                  {"on_surfaces", result.photons.on_surfaces},
                                  {"in_media", result.photons.in_media}}},
                                {"parse_peak_memory_kib", statistics.parse_peak_memory},
                                {"peak_memory_kib", peak_memory()},
                                {"complete", result.complete}};
    if (result.radiosity) json["radiosity"] = to_json(*result.radiosity);
    const std::string text = json.dump(2) + "\n";
    if (*settings.stats_file == "-") {
        std::fwrite(text.data(), 1, text.size(), stderr);
        return;
    }
    std::ofstream out(*settings.stats_file);
    if (!(out << text)) throw IoError(fmt::format("cannot write '{}'", *settings.stats_file));
}

}  // namespace rb
