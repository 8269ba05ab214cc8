#include "shade/integrator.h"

#include "shade/ray_stream.h"

#include <algorithm>

namespace rb {

namespace {

/// Rays that travel together: enough to fill batches, few enough for their state to stay in the second level
/// cache.
constexpr size_t stream_size = 512;

}  // namespace

struct Integrator::Program {
    ShadingProgram shading;
};

Integrator::Integrator(const World& world, const ShadingOptions& options)
    : program_(new Program{ShadingProgram(world, options)}) {}

Integrator::~Integrator() = default;

const ShadingProgram& Integrator::program() const { return program_->shading; }

void Integrator::show(std::shared_ptr<const PhotonLight> photons) {
    program_->shading.photons = std::move(photons);
}

void Integrator::trace(std::span<const CameraRay> rays, std::span<Radiance> out, RayCounters& counters,
                       const IndirectLight* indirect) const {
    thread_local StreamState state;
    state.indirect = indirect;
    state.wants_light = !indirect || indirect->wants_light();
    for (size_t begin = 0; begin < rays.size(); begin += stream_size) {
        const size_t count = std::min(stream_size, rays.size() - begin);
        RayStream(program_->shading, state).trace(rays.subspan(begin, count), out.subspan(begin, count));
        counters += state.counters;
    }
}

}  // namespace rb
