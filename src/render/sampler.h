#pragma once
#include "math/random.h"
#include "render/lens.h"

#include <bit>
#include <span>

namespace rb {

/// Traces samples in batches at continuous picture positions.
class Sampler {
public:
    /// `seed`: another one changes all random draws. `indirect`: as Integrator::trace() takes it.
    Sampler(const Integrator& integrator, const CameraRays& rays, const Lens& lens, uint64_t seed,
            RayCounters& counters, const IndirectLight* indirect = nullptr)
        : integrator_(integrator),
          rays_(rays),
          lens_(lens),
          seed_(seed),
          counters_(counters),
          indirect_(indirect) {}

    /// What decides the random draws of a sample at a picture position.
    uint64_t seed_at(const Vec2& position) const {
        return mixed(mixed(seed_, std::bit_cast<uint64_t>(position.x)), std::bit_cast<uint64_t>(position.y));
    }

    bool has_open_lens() const { return lens_.is_open(); }

    /// Through an open lens as many rays for each position as the camera asks for. `share`: as
    /// CameraRay::share.
    void sample(std::span<const Vec2> positions, std::span<Radiance> out, float share = 1.0f);
    /// One ray for each position, through a place of the open lens in [0, 1)^2.
    void sample(std::span<const Vec2> positions, std::span<const Vec2> lens_places, std::span<Radiance> out,
                float share);

private:
    void sample_several(std::span<const Vec2> positions, std::span<Radiance> out, float share);
    void sample_through_lens(std::span<const Vec2> positions, std::span<Radiance> out, float share);

    const Integrator& integrator_;
    const CameraRays& rays_;
    const Lens& lens_;
    uint64_t seed_;
    RayCounters& counters_;
    const IndirectLight* indirect_;
};

}  // namespace rb
