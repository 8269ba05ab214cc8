#include "radiosity/cached_light.h"

#include "base/parallel.h"
#include "base/scratch.h"
#include "math/random.h"
#include "radiosity/smooth.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace rb {

namespace {

/// A fixed order of `count` things in which every part is spread over the whole.
std::vector<uint32_t> spread_order(size_t count) {
    std::vector<uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    for (size_t i = count; i > 1; --i) std::swap(order[i - 1], order[mixed(0, i) % i]);
    return order;
}

/// Of a pixel: what matters to no more may be gathered by fewer rays.
constexpr float small_part = 0.3f;

}  // namespace

CachedLight::CachedLight(const RayGather& rays, const Vec3& eye, bool with_surfels) : rays_(rays), eye_(eye) {
    const GatherQuality& quality = rays.quality();
    for (const double bound : quality.bounds) caches_.emplace_back(bound);
    surfel_counts_.resize(caches_.size());
    if (with_surfels) surfels_.resize(caches_.size(), SurfelGrid(eye, quality.minimum_radius));
}

const SurfelGrid* CachedLight::surfels_at(int depth) const {
    return surfels_.empty() ? nullptr : &surfels_[static_cast<size_t>(depth)];
}

const IndirectLight* CachedLight::next(int depth) const {
    return depth + 1 < rays_.settings().recursion_limit ? this : nullptr;
}

void CachedLight::gather(std::span<const IndirectPlace> places, int depth, std::span<Rgb> mean) const {
    const IrradianceCache& cache = caches_[static_cast<size_t>(depth)];
    const Coverage coverage = rays_.settings().always_sample && depth == 0 ? Coverage::ample : Coverage::any;
    Scratch::Scope memory(thread_scratch());
    const auto gaps = memory.take<uint32_t>(places.size());
    size_t gap_count = 0;
    for (size_t i = 0; i < places.size(); ++i) {
        const auto found = cache.look_up(places[i].point, places[i].normal);
        if (is_enough(found.weight, coverage)) {
            mean[i] = found.mean;
        } else {
            gaps[gap_count++] = static_cast<uint32_t>(i);
        }
    }
    const auto missing = gaps.first(gap_count);
    if (depth == 0) {
        const auto middle = std::partition(missing.begin(), missing.end(),
                                           [&](uint32_t i) { return places[i].share > small_part; });
        const auto large = static_cast<size_t>(middle - missing.begin());
        fill(places, missing.first(large), depth, rays_.pixel_grid(), mean);
        fill(places, missing.subspan(large), depth, rays_.part_grid(), mean);
    } else {
        fill(places, missing, depth, rays_.coarse_grid(), mean);
    }
    interpolations_.fetch_add(places.size() - gap_count, std::memory_order_relaxed);
    gaps_[depth == 0 ? 0 : 1].fetch_add(gap_count, std::memory_order_relaxed);
}

/// Gathers at those of the places that are not known.
void CachedLight::fill(std::span<const IndirectPlace> places, std::span<const uint32_t> gaps, int depth,
                       const HemisphereGrid& grid, std::span<Rgb> mean) const {
    if (gaps.empty()) return;
    GatherTask task{depth, &grid, next(depth), false, surfels_at(depth)};
    if (depth == 0) task.outlooks = &outlooks_;
    Scratch::Scope memory(thread_scratch());
    const auto unknown = memory.take<IndirectPlace>(gaps.size());
    const auto fresh = memory.take<Gathered>(gaps.size(), Gathered{});
    for (size_t k = 0; k < gaps.size(); ++k) unknown[k] = places[gaps[k]];
    rays_.gather(unknown, task, fresh);
    for (size_t k = 0; k < gaps.size(); ++k) mean[gaps[k]] = fresh[k].mean;
}

bool CachedLight::is_enough(double weight, Coverage coverage) const {
    return coverage == Coverage::any ? weight > 0.0 : 4.0 * weight >= rays_.settings().nearest_count;
}

bool CachedLight::knows(const IndirectPlace& place, int depth, Coverage coverage) const {
    return is_enough(caches_[static_cast<size_t>(depth)].look_up(place.point, place.normal).weight, coverage);
}

void CachedLight::learn(std::span<const IndirectPlace> places, int depth, Coverage coverage, int threads,
                        const std::atomic<bool>& stop) {
    const HemisphereGrid& grid = coverage == Coverage::any ? rays_.pixel_grid() : rays_.grid_at(depth);
    constexpr size_t least_together = 64;
    const auto order = spread_order(places.size());
    IrradianceCache& cache = caches_[static_cast<size_t>(depth)];
    std::vector<IndirectPlace> unknown;
    for (size_t i = 0; i < order.size() && !stop.load(std::memory_order_relaxed);) {
        // Those of one round do not know of each other.
        const size_t together = std::max(least_together, cache.size() / 4);
        unknown.clear();
        for (; i < order.size() && unknown.size() < together; ++i) {
            if (!knows(places[order[i]], depth, coverage)) unknown.push_back(places[order[i]]);
        }
        // The first look around, lest the records that reach farthest are those that nothing has guided.
        if (depth == 0 && cache.size() == 0) gathered(unknown, depth, grid, threads, stop);
        const auto records = gathered(unknown, depth, grid, threads, stop);
        if (depth == 0) compare(records);
        for (const IrradianceRecord& record : records) cache.insert(record);
    }
}

void CachedLight::smooth(int threads) {
    // Later bounces gain nothing: the gathers that ask them even out their noise.
    IrradianceCache& cache = caches_.front();
    cache.relight(smoothed(cache.records(), rays_.quality().bounds.front(), threads));
}

/// What would have been said of places without the records that they are going to have.
void CachedLight::compare(std::span<const IrradianceRecord> records) {
    for (const IrradianceRecord& record : records) {
        const auto found = caches_.front().look_up(record.point, record.normal);
        if (found.weight == 0.0) continue;
        const double apart = static_cast<double>(grey(found.mean - record.mean));
        error_squares_ += apart * apart;
        ++compared_;
    }
}

double CachedLight::error_estimate() const {
    return compared_ == 0 ? 0.0 : std::sqrt(error_squares_ / static_cast<double>(compared_));
}

std::vector<IrradianceRecord> CachedLight::gathered(std::span<const IndirectPlace> places, int depth,
                                                    const HemisphereGrid& grid, int threads,
                                                    const std::atomic<bool>& stop) {
    constexpr size_t chunk = 8;
    std::vector<IrradianceRecord> records(places.size());
    std::vector<std::vector<Surfel>> fresh((places.size() + chunk - 1) / chunk);
    std::vector<std::vector<Outlook>> views(fresh.size());
    parallel_for(fresh.size(), threads, stop, [&](size_t c) {
        const auto some = places.subspan(c * chunk, std::min(chunk, places.size() - c * chunk));
        GatherTask task{depth, &grid, next(depth), true, surfels_at(depth)};
        if (task.known) task.fresh = &fresh[c];
        // Later bounces gain nothing: the gathers that ask them even out their noise.
        if (depth == 0) task.outlooks = &outlooks_;
        if (depth == 0) task.views = &views[c];
        std::array<Gathered, chunk> found;
        rays_.gather(some, task, std::span(found).first(some.size()));
        for (size_t i = 0; i < some.size(); ++i) records[c * chunk + i] = record_of(some[i], depth, found[i]);
    });
    for (const auto& some : fresh) {
        for (const Surfel& surfel : some) surfels_[static_cast<size_t>(depth)].insert(surfel);
        surfel_counts_[static_cast<size_t>(depth)] += some.size();
    }
    for (auto& some : views) {
        for (Outlook& view : some) outlooks_.insert(std::move(view));
    }
    return records;
}

IrradianceRecord CachedLight::record_of(const IndirectPlace& place, int depth,
                                        const Gathered& gathered) const {
    const GatherQuality& quality = rays_.quality();
    const double scale = std::ldexp(glm::length(place.point - eye_), depth);
    IrradianceRecord record;
    record.point = place.point;
    record.normal = place.normal;
    record.mean = gathered.mean;
    record.rotation = gathered.rotation;
    record.translation = gathered.translation;
    // Where everything would change over a distance no record is good for more.
    const double change = record.translation.steepness();
    const double steady = change > 0.0 ? grey(gathered.mean) / change : gathered.distance;
    // Nor does one reach farther than half way to what is nearest: at corners it would say what its own view
    // is.
    const double near = 0.5 * gathered.nearest / quality.bounds[static_cast<size_t>(depth)];
    const double least = std::max(quality.minimum_radius, quality.minimum_reach / quality.bounds.front());
    const auto radius = [&](double wanted) {
        return std::clamp(wanted, least * scale, std::max(least, quality.maximum_radius) * scale);
    };
    record.wide_radius = radius(std::min(gathered.distance, steady));
    record.radius = std::min(record.wide_radius, radius(near));
    record.variance = gathered.variance;
    return record;
}

uint64_t CachedLight::made_for() const {
    const GatherQuality& quality = rays_.quality();
    uint64_t hash = rays_.scene_hash();
    for (const int rays : quality.rays) hash = mixed(hash, static_cast<uint64_t>(rays));
    for (const double x : quality.bounds) hash = mixed(hash, std::bit_cast<uint64_t>(x));
    for (const double x : {quality.minimum_radius, quality.maximum_radius})
        hash = mixed(hash, std::bit_cast<uint64_t>(x));
    return mixed(hash, surfels_.size());
}

StoredLight CachedLight::stored() const {
    StoredLight light{made_for(), {}, {}, outlooks_.all()};
    for (const IrradianceCache& cache : caches_) light.records.push_back(cache.records());
    for (const SurfelGrid& grid : surfels_) light.surfels.push_back(grid.cells());
    return light;
}

bool CachedLight::restore(const StoredLight& light) {
    if (light.made_for != made_for()) return false;
    if (light.records.size() != caches_.size() || light.surfels.size() != surfels_.size()) return false;
    for (size_t depth = 0; depth < caches_.size(); ++depth) {
        for (const IrradianceRecord& record : light.records[depth]) caches_[depth].insert(record);
    }
    for (size_t depth = 0; depth < surfels_.size(); ++depth) surfels_[depth].restore(light.surfels[depth]);
    outlooks_ = Outlooks(light.outlooks);
    return true;
}

void PlaceCollector::gather(std::span<const IndirectPlace> places, int depth, std::span<Rgb> mean) const {
    for (size_t i = 0; i < places.size(); ++i) {
        mean[i] = Rgb(0.0f);
        if (!known_ || !known_->knows(places[i], depth, coverage_)) out_.push_back(places[i]);
    }
}

}  // namespace rb
