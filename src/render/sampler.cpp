#include "render/sampler.h"

#include "base/scratch.h"

#include <algorithm>

namespace rb {

namespace {

/// Over the rays that exist; where none does, what any of them shows.
Radiance mean(std::span<const CameraRay> rays, std::span<const Radiance> lights) {
    Radiance sum;
    int count = 0;
    for (size_t k = 0; k < rays.size(); ++k) {
        if (!rays[k].exists) continue;
        sum.rgb += lights[k].rgb;
        sum.transmit += lights[k].transmit;
        ++count;
    }
    if (count == 0) return lights.front();
    const float scale = 1.0f / static_cast<float>(count);
    return {sum.rgb * scale, sum.transmit * scale};
}

}  // namespace

void Sampler::sample(std::span<const Vec2> positions, std::span<Radiance> out, float share) {
    if (lens_.is_open()) return sample_through_lens(positions, out, share);
    if (rays_.rays_per_position() > 1) return sample_several(positions, out, share);
    Scratch::Scope memory(thread_scratch());
    const auto batch = memory.take<CameraRay>(positions.size());
    rays_.at(positions, batch);
    for (size_t i = 0; i < positions.size(); ++i) {
        batch[i].seed = seed_at(positions[i]);
        batch[i].share = share;
    }
    integrator_.trace(batch, out, counters_, indirect_);
}

void Sampler::sample(std::span<const Vec2> positions, std::span<const Vec2> lens_places,
                     std::span<Radiance> out, float share) {
    Scratch::Scope memory(thread_scratch());
    const auto batch = memory.take<CameraRay>(positions.size());
    for (size_t i = 0; i < positions.size(); ++i) {
        batch[i].exists = lens_.ray(rays_, positions[i], lens_places[i], batch[i].ray);
        batch[i].seed = seed_at(positions[i]);
        batch[i].share = share;
    }
    integrator_.trace(batch, out, counters_, indirect_);
}

/// The mean over those rays of a position that exist; as many positions at once as fill a batch.
void Sampler::sample_several(std::span<const Vec2> positions, std::span<Radiance> out, float share) {
    constexpr size_t usual_batch = 1024;
    const auto several = static_cast<size_t>(rays_.rays_per_position());
    const size_t at_once = std::max<size_t>(usual_batch / several, 1);
    Scratch::Scope memory(thread_scratch());
    const auto batch = memory.take<CameraRay>(at_once * several);
    const auto lights = memory.take<Radiance>(batch.size());
    for (size_t begin = 0; begin < positions.size(); begin += at_once) {
        const auto places = positions.subspan(begin, std::min(at_once, positions.size() - begin));
        const size_t count = places.size() * several;
        for (size_t i = 0; i < count; ++i) {
            const Vec2& p = places[i / several];
            const size_t k = i % several;
            batch[i].exists = rays_.at(p.x, p.y, static_cast<int>(k), batch[i].ray);
            batch[i].seed = mixed(seed_at(p), k);
            batch[i].share = share / static_cast<float>(several);
        }
        integrator_.trace(batch.first(count), lights.first(count), counters_, indirect_);
        for (size_t i = 0; i < places.size(); ++i) {
            out[begin + i] = mean(batch.subspan(i * several, several), lights.subspan(i * several, several));
        }
    }
}

/// Chunk by chunk over all positions that want more samples still.
void Sampler::sample_through_lens(std::span<const Vec2> positions, std::span<Radiance> out, float share) {
    std::vector<CameraRay> batch;
    std::vector<LensSum> sums(positions.size());
    std::vector<size_t> open(positions.size());
    for (size_t i = 0; i < open.size(); ++i) open[i] = i;
    std::vector<Radiance> lights;
    while (!open.empty()) {
        batch.clear();
        for (const size_t i : open) {
            const int first = sums[i].count;
            const int count = first + lens_.next_chunk(first);
            for (int k = first; k < count; ++k) {
                CameraRay& ray = batch.emplace_back();
                ray.share = share / static_cast<float>(count);
                ray.exists = lens_.ray(rays_, positions[i].x, positions[i].y, k, ray.ray);
                ray.seed = mixed(seed_at(positions[i]), static_cast<uint64_t>(k));
            }
        }
        lights.resize(batch.size());
        integrator_.trace(batch, lights, counters_, indirect_);
        size_t next = 0;
        std::erase_if(open, [&](size_t i) {
            const int last = sums[i].count + lens_.next_chunk(sums[i].count);
            for (; sums[i].count < last; ++next) lens_.add(sums[i], batch[next], lights[next]);
            return lens_.is_settled(sums[i]);
        });
    }
    for (size_t i = 0; i < out.size(); ++i) {
        const float scale = 1.0f / static_cast<float>(sums[i].count);
        out[i] = {sums[i].light.rgb * scale, sums[i].light.transmit * scale};
    }
}

}  // namespace rb
