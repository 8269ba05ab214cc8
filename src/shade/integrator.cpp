#include "shade/integrator.h"

#include "shade/ray_stream.h"

namespace rb {

struct Integrator::Program {
    ShadingProgram shading;
};

Integrator::Integrator(const World& world, const ShadingOptions& options)
    : program_(new Program{ShadingProgram(world, options)}) {}

Integrator::~Integrator() = default;

void Integrator::trace(std::span<const CameraRay> rays, std::span<Radiance> out,
                       RayCounters& counters) const {
    thread_local StreamState state;
    RayStream(program_->shading, state).trace(rays, out);
    counters.camera += state.counters.camera;
    counters.reflected += state.counters.reflected;
    counters.refracted += state.counters.refracted;
    counters.shadow += state.counters.shadow;
}

}  // namespace rb
