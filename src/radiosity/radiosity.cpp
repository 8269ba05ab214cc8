#include "radiosity/radiosity.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>

namespace rb {

void BruteLight::gather(std::span<const IndirectPlace> places, int depth, std::span<Rgb> mean) const {
    const bool goes_on = depth + 1 < rays_.settings().recursion_limit;
    const GatherTask task{depth, &rays_.grid_at(depth), goes_on ? this : nullptr};
    // What is gathered is more than what is asked for: a few places at a time.
    constexpr size_t together = 64;
    std::array<Gathered, together> found;
    for (size_t begin = 0; begin < places.size(); begin += together) {
        const auto some = places.subspan(begin, std::min(together, places.size() - begin));
        rays_.gather(some, task, std::span(found).first(some.size()));
        for (size_t i = 0; i < some.size(); ++i) mean[begin + i] = found[i].mean;
    }
}

Radiosity::Radiosity(const World& world, const ShadingOptions& options, GiMode mode, double error,
                     std::shared_ptr<const PhotonLight> photons)
    : rays_(world, options, {*world.settings.radiosity, mode != GiMode::brute, error}, std::move(photons)),
      brute_(rays_) {
    if (mode != GiMode::brute)
        cached_ = std::make_unique<CachedLight>(rays_, world.camera.location, mode != GiMode::cache);
}

const IndirectLight& Radiosity::light() const {
    if (cached_) return *cached_;
    return brute_;
}

bool Radiosity::find_surfel(const Ray& ray, Rgb& light) const {
    if (!cached_ || cached_->surfels().empty()) return false;
    const ShadingProgram& program = rays_.program();
    RayQuery query;
    query.ray = ray;
    Hit hit;
    if (!program.geometry.closest(query, hit)) return false;
    const bool from_inside = glm::dot(hit.normal, ray.direction) > 0.0;
    const SurfaceProgram& surface = program.surface_of(hit);
    Surfel surfel{hit.point, from_inside ? -hit.normal : hit.normal, hit.leaf, hit.crossing.member,
                  from_inside ? surface.interior_look : surface.look};
    // Cells have sizes of powers of two; beyond the distance to the eye there are hardly any.
    constexpr int sizes = 24;
    for (int k = sizes; k >= 0; --k) {
        surfel.size = std::ldexp(hit.t, -k);
        if (cached_->surfels().front().find(surfel, light)) return true;
    }
    return false;
}

RadiosityReport Radiosity::report() const {
    RadiosityReport report;
    if (cached_) {
        for (int depth = 0; depth < rays_.settings().recursion_limit; ++depth) {
            report.records.push_back(cached_->record_count(depth));
        }
        report.gaps = cached_->gap_counts();
        report.interpolations = cached_->interpolation_count();
        report.error_estimate = cached_->error_estimate();
        report.surfels.assign(cached_->surfel_counts().begin(), cached_->surfel_counts().end());
        for (const SurfelGrid& grid : cached_->surfels()) {
            report.cells.push_back(grid.cell_count());
            report.surfel_bytes += grid.byte_count();
        }
    }
    report.gathers = rays_.gather_count();
    report.rays = rays_.ray_count();
    report.shadow_rays = rays_.shadow_ray_count();
    return report;
}

void Radiosity::prepare(const PictureSurvey& survey, int longer_side, int threads,
                        const std::atomic<bool>& stop, const RadiosityFiles& files) {
    if (!cached_) return;
    if (!files.load.empty()) load(files.load);
    if (files.load.empty() || !files.save.empty()) learn(survey, longer_side, threads, stop);
    if (files.save.empty() || stop.load(std::memory_order_relaxed)) return;
    write_light(files.save, cached_->stored());
}

void Radiosity::load(const std::string& path) {
    if (cached_->restore(read_light(path))) return;
    throw IoError("The radiosity file " + path + " was made for another scene or with other settings.");
}

void Radiosity::learn(const PictureSurvey& survey, int longer_side, int threads,
                      const std::atomic<bool>& stop) {
    constexpr int finest = 2;
    const double widest = rays_.settings().pretrace_start * longer_side;
    const int first = std::max(finest, static_cast<int>(widest));
    // Some ten thousand places, however large the picture is.
    const int coarse = std::max(std::min(first, 8), longer_side / 256);
    if (rays_.settings().recursion_limit > 1)
        learn_later_bounces(survey(coarse, nullptr, Coverage::any), threads, stop);
    const auto learn = [&](int step, Coverage coverage) {
        cached_->learn(survey(step, cached_.get(), coverage), 0, coverage, threads, stop);
    };
    for (int step = first; step >= finest; step /= 2) learn(step, Coverage::ample);
    // What no record was found for is for a pixel or two.
    learn(1, Coverage::any);
    cached_->smooth(threads);
}

/// From the last bounce to the second, so that each can ask the one after it.
void Radiosity::learn_later_bounces(std::vector<IndirectPlace> places, int threads,
                                    const std::atomic<bool>& stop) {
    std::vector<std::vector<IndirectPlace>> places_at{std::move(places)};
    for (int depth = 1; depth < rays_.settings().recursion_limit; ++depth) {
        places_at.push_back(met_from(places_at.back(), depth - 1, threads, stop));
    }
    for (int depth = rays_.settings().recursion_limit - 1; depth > 0; --depth) {
        cached_->learn(places_at[static_cast<size_t>(depth)], depth, Coverage::ample, threads, stop);
    }
}

/// Where rays from places of one bounce ask for the next.
std::vector<IndirectPlace> Radiosity::met_from(std::span<const IndirectPlace> places, int depth, int threads,
                                               const std::atomic<bool>& stop) const {
    constexpr size_t wanted = 16384;
    constexpr size_t chunk = 16;
    if (places.empty()) return {};
    const HemisphereGrid grid(static_cast<int>(std::clamp<size_t>(wanted / places.size(), 1, 16)));
    const size_t stride = std::max<size_t>(1, places.size() / wanted);
    const size_t used = places.size() / stride;
    std::vector<std::vector<IndirectPlace>> parts((used + chunk - 1) / chunk);
    parallel_for(parts.size(), threads, stop, [&](size_t c) {
        const PlaceCollector collector(nullptr, Coverage::any, parts[c]);
        const GatherTask task{depth, &grid, &collector};
        Gathered ignored;
        for (size_t i = c * chunk; i < std::min(used, (c + 1) * chunk); ++i) {
            rays_.gather(places.subspan(i * stride, 1), task, {&ignored, 1});
        }
    });
    std::vector<IndirectPlace> met;
    for (const auto& part : parts) met.insert(met.end(), part.begin(), part.end());
    return met;
}

}  // namespace rb
