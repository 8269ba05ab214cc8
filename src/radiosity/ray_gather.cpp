#include "radiosity/ray_gather.h"

#include "math/random.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

namespace rb {

namespace {

/// Rays that travel together, about.
constexpr size_t stream_size = 512;

/// Gathers are nested: the surfaces that their rays meet gather in their turn. Each depth has its own state.
StreamState& state_at(int depth) {
    thread_local std::vector<std::unique_ptr<StreamState>> states;
    const auto index = static_cast<size_t>(depth);
    if (states.size() <= index) states.resize(index + 1);
    if (!states[index]) states[index] = std::make_unique<StreamState>();
    return *states[index];
}

/// The noise of very many rays is small, and what they saw would take much memory.
bool uses_outlooks(const GatherTask& task) {
    constexpr size_t most_cells = 4096;
    return task.outlooks && task.grid->size() <= most_cells;
}

/// Rays of a gather whose error hardly shows.
constexpr int few_rays = 5;

/// Of a gather that matters to a pixel or two, where records have so many.
int rays_for_pixel(int rays_of_record) {
    constexpr int enough = 64;
    return std::max(std::min(rays_of_record, enough), rays_of_record / 2);
}

}  // namespace

/// What came from the cells of a hemisphere.
struct RayGather::Cells {
    const Hemisphere& hemisphere;
    std::span<const GatheredLight> light;  ///< distance 0 where nothing was sent

    Gradient rotation(const Rgb& mean) const;
    Gradient translation() const;
    double variance() const;

private:
    std::span<const GatheredLight> ring(int index) const {
        const auto sectors = static_cast<size_t>(hemisphere.grid().sectors());
        return light.subspan(static_cast<size_t>(index) * sectors, sectors);
    }
};

/// What the normal turns to counts more. `mean`: of the light; the same from everywhere would change nothing.
Gradient RayGather::Cells::rotation(const Rgb& mean) const {
    constexpr double least_cosine = 0.02;
    Gradient gradient;
    for (size_t k = 0; k < light.size(); ++k) {
        const Vec3 direction = hemisphere.direction(k);
        const double cosine = std::max(glm::dot(direction, hemisphere.normal()), least_cosine);
        gradient.add(direction / (cosine * static_cast<double>(light.size())), light[k].rgb - mean);
    }
    gradient.turn_about(hemisphere.normal());
    return gradient;
}

/// Light moves into a place's view over the edges between cells, as far as what is nearer moves.
Gradient RayGather::Cells::translation() const {
    const auto sines = hemisphere.grid().edge_sines();
    const auto cosines = hemisphere.grid().edge_cosines();
    const int sectors = hemisphere.grid().sectors();
    const auto change = [](const GatheredLight& a, const GatheredLight& b, double weight) {
        const double distance = std::min(a.distance, b.distance);
        return static_cast<float>(weight / distance) * (a.rgb - b.rgb);
    };
    Gradient gradient;
    for (int sector = 0; sector < sectors; ++sector) {
        const auto k = static_cast<size_t>(sector);
        const size_t before = sector > 0 ? k - 1 : static_cast<size_t>(sectors) - 1;
        Rgb outward(0.0f);
        Rgb around(0.0f);
        for (int j = 0; j < hemisphere.grid().rings(); ++j) {
            const auto edge = static_cast<size_t>(j);
            const GatheredLight& here = ring(j)[k];
            if (j > 0) outward += change(here, ring(j - 1)[k], sines[edge] * cosines[edge] * cosines[edge]);
            around += change(here, ring(j)[before], sines[edge + 1] - sines[edge]);
        }
        gradient.add(hemisphere.tangent(sector + 0.5), outward * (2.0f / static_cast<float>(sectors)));
        gradient.add(hemisphere.tangent(sector + 0.25 * sectors), around / static_cast<float>(pi));
    }
    return gradient;
}

/// Of the mean: what a cell has by chance shows in how it differs from the next one of its ring.
double RayGather::Cells::variance() const {
    const int sectors = hemisphere.grid().sectors();
    double sum = 0;
    size_t cells = 0;
    for (int j = 0; j < hemisphere.grid().rings(); ++j) {
        for (int sector = 0; sector < sectors; ++sector) {
            const GatheredLight& here = ring(j)[static_cast<size_t>(sector)];
            const GatheredLight& next = ring(j)[static_cast<size_t>((sector + 1) % sectors)];
            const GatheredLight& before = ring(j)[static_cast<size_t>((sector + sectors - 1) % sectors)];
            if (here.distance == 0.0 || next.distance == 0.0 || before.distance == 0.0) continue;
            const Rgb apart = here.rgb - 0.5f * (before.rgb + next.rgb);
            sum += static_cast<double>(glm::dot(apart, apart));
            ++cells;
        }
    }
    constexpr double channels = 3.0;
    return cells == 0 ? 0.0 : 2.0 / 3.0 / channels * sum / std::pow(static_cast<double>(cells), 2);
}

RayGather::RayGather(const World& world, const ShadingOptions& options, GatherQuality quality,
                     std::shared_ptr<const PhotonLight> photons)
    : program_(world, options, RayPurpose::gather),
      quality_(std::move(quality)),
      pixel_grid_(rays_for_pixel(quality_.rays.front())),
      part_grid_(std::max(few_rays, quality_.rays.front() / 2 / 4)),
      coarse_grid_(few_rays) {
    program_.photons = std::move(photons);
    for (const int rays : quality_.rays) grids_.emplace_back(rays);
}

uint64_t RayGather::scene_hash() const {
    return mixed(mixed(program_.leaf_surfaces.size(), program_.looks.size()), program_.textures.size());
}

Rgb RayGather::limited(const Rgb& light) const {
    const float brightest = std::max({light.x, light.y, light.z});
    const float limit = settings().max_sample;
    return limit <= 0.0f || brightest <= limit ? light : light * (limit / brightest);
}

Rgb RayGather::toned(const Rgb& mean) const {
    const float greyness = settings().gray_threshold;
    return settings().brightness * ((1.0f - greyness) * mean + Rgb(greyness * grey(mean)));
}

/// The rays of a few places, and what they bring.
struct RayGather::Batch {
    Batch(std::span<const IndirectPlace> places, const GatherTask& task, Scratch::Scope& memory)
        : places_(places),
          hemispheres(memory.take<Hemisphere>(places.size())),
          ray_counts(memory.take<uint8_t>(places.size() * task.grid->size(), uint8_t{1})),
          light(memory.take<GatheredLight>(ray_counts.size(), GatheredLight{})) {
        for (size_t i = 0; i < places.size(); ++i) {
            hemispheres[i] = Hemisphere(*task.grid, places[i].normal, places[i].seed);
            if (!uses_outlooks(task)) continue;
            if (const Outlook* outlook = task.outlooks->nearest(places[i].point, places[i].normal))
                outlook->count_rays(places[i].point, hemispheres[i], of(ray_counts, i));
        }
        const size_t most = std::accumulate(ray_counts.begin(), ray_counts.end(), size_t{0});
        rays = memory.take<GatherRay>(most);
        cell_of_ray = memory.take<uint32_t>(most);
        for (size_t i = 0; i < places.size(); ++i) add_rays(i);
    }

    /// The cells of one place.
    template <class T>
    std::span<T> of(std::span<T> by_cell, size_t place) const {
        const size_t cells = by_cell.size() / places_.size();
        return by_cell.subspan(place * cells, cells);
    }

    /// Means over the rays of each cell.
    void take(std::span<const GatheredLight> found) {
        for (size_t i = 0; i < found.size();) {
            const size_t begin = i;
            Rgb sum(0.0f);
            double inverse_distances = 0;
            for (; i < found.size() && cell_of_ray[i] == cell_of_ray[begin]; ++i) {
                sum += found[i].rgb;
                inverse_distances += 1.0 / found[i].distance;
            }
            const auto count = static_cast<double>(i - begin);
            light[cell_of_ray[begin]] = {sum / static_cast<float>(count), count / inverse_distances};
        }
    }

private:
    void add_rays(size_t i) {
        const IndirectPlace& place = places_[i];
        const auto counts = of(ray_counts, i);
        uint64_t purpose = 2;
        for (size_t k = 0; k < counts.size(); ++k) {
            for (int number = 0; number < counts[k]; ++number) {
                const Vec3 direction =
                    number == 0 ? hemispheres[i].direction(k) : hemispheres[i].further(k, number);
                ++purpose;
                if (!(glm::dot(direction, place.surface) > 0.0)) continue;
                cell_of_ray[ray_count] = static_cast<uint32_t>(i * counts.size() + k);
                rays[ray_count++] = {
                    {place.point, direction},  place.leaf, place.part, place.member, place.error,
                    mixed(place.seed, purpose)};
            }
        }
    }

    std::span<const IndirectPlace> places_;

public:
    std::span<Hemisphere> hemispheres;
    std::span<uint8_t> ray_counts;   ///< by cell of all places
    std::span<GatheredLight> light;  ///< likewise; distance 0 where nothing was sent
    std::span<GatherRay> rays;
    std::span<uint32_t> cell_of_ray;
    size_t ray_count = 0;
};

void RayGather::gather(std::span<const IndirectPlace> places, const GatherTask& task,
                       std::span<Gathered> out) const {
    const HemisphereGrid& grid = *task.grid;
    const size_t together = std::max<size_t>(1, stream_size / grid.size());
    gathers_.fetch_add(places.size(), std::memory_order_relaxed);
    for (size_t begin = 0; begin < places.size(); begin += together) {
        Scratch::Scope memory(thread_scratch());
        const auto some = places.subspan(begin, std::min(together, places.size() - begin));
        Batch batch(some, task, memory);
        trace(batch, task);
        for (size_t i = 0; i < some.size(); ++i) {
            const auto light = batch.of(batch.light, i);
            out[begin + i] = summed({batch.hemispheres[i], light}, task.gradients);
            if (!task.views || !uses_outlooks(task)) continue;
            Outlook view(some[i].point, batch.hemispheres[i], light);
            if (task.outlooks->lack(view)) task.views->push_back(std::move(view));
        }
    }
}

void RayGather::trace(Batch& batch, const GatherTask& task) const {
    const int depth = task.depth + 1;
    StreamState& state = state_at(depth);
    state.indirect = task.next;
    state.wants_light = !task.next || task.next->wants_light();
    const double spread = std::sqrt(pi / static_cast<double>(task.grid->size()));
    // What is in the air differs from ray to ray.
    const bool clear_air = !program_.has_air() && !program_.media.fills_interiors();
    const SurfelUse surfels{task.known, spread, task.fresh};
    Scratch::Scope memory(thread_scratch());
    const auto found = memory.take<GatheredLight>(batch.ray_count);
    RayStream(program_, state)
        .gather(batch.rays.first(batch.ray_count), depth, task.known && clear_air ? &surfels : nullptr,
                found);
    for (GatheredLight& light : found) light.rgb = limited(light.rgb);
    batch.take(found);
    rays_.fetch_add(batch.ray_count, std::memory_order_relaxed);
    shadow_rays_.fetch_add(state.counters.shadow, std::memory_order_relaxed);
}

Gathered RayGather::summed(const Cells& cells, bool gradients) const {
    Gathered sum;
    sum.nearest = infinity;
    double inverse_distances = 0;
    size_t count = 0;
    for (const GatheredLight& light : cells.light) {
        if (light.distance == 0.0) continue;
        ++count;
        sum.mean += light.rgb;
        inverse_distances += 1.0 / light.distance;
        sum.nearest = std::min(sum.nearest, light.distance);
    }
    if (count == 0) return {};
    const Rgb mean = sum.mean / static_cast<float>(count);
    sum.mean = toned(mean);
    sum.distance = inverse_distances > 0.0 ? static_cast<double>(count) / inverse_distances : infinity;
    if (!gradients) return sum;
    sum.variance = std::pow(settings().brightness, 2) * cells.variance();
    // Where directions are missing nothing is known of what moves in or out.
    if (count < cells.light.size()) return sum;
    sum.rotation = cells.rotation(mean);
    sum.translation = cells.translation();
    for (Gradient* gradient : {&sum.rotation, &sum.translation}) {
        for (Rgb& change : gradient->per_axis) change = toned(change);
    }
    return sum;
}

}  // namespace rb
