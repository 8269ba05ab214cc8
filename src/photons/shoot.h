#pragma once
#include "photons/gathering.h"
#include "shade/shading_program.h"

#include <atomic>

namespace rb {

struct PhotonCounters {
    uint64_t shot = 0;
    uint64_t on_surfaces = 0;
    uint64_t in_media = 0;
};

/// Loads the photons of a world, or shoots them, and saves them if that is asked for. The result does not
/// depend on the number of threads (0: all). Null if there are none, or if `stop` was set. Throws SceneError
/// if there would be too many, and if a file cannot be read or written.
std::shared_ptr<const PhotonMaps> photon_light(const ShadingProgram& program, int threads, uint64_t seed,
                                               const std::atomic<bool>& stop, PhotonCounters& counters);

}  // namespace rb
