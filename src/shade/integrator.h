#pragma once
#include "compile/geometry.h"
#include "shade/area_density.h"
#include "shade/indirect_light.h"

#include <memory>

namespace rb {

class PhotonLight;
struct ShadingProgram;

/// What a camera ray brings back: light, and how much of the background shows through (1 = all), both in the
/// scene's working space, unclamped.
struct Radiance {
    Rgb rgb{0.0f};
    float transmit = 0;
};

struct CameraRay {
    Ray ray;
    bool exists =
        true;  ///< false where the camera makes no ray (outside a fisheye's circle): black, transmit 1
    uint64_t seed =
        0;  ///< decides every random draw along this ray's path; a function of pixel and sample only
    float share = 1;  ///< of a pixel that it tells, about: of less it may tell less exactly
};

struct ShadingOptions {
    /// False: keep interior lists, surface coordinates and both kinds of shadow rays although nothing in the
    /// scene asks for them; same picture.
    bool skip_unneeded = true;
    int quality = 9;            ///< +Q, 0..9
    bool alpha_output = false;  ///< +UA
    AreaLightMode area_lights = AreaLightMode::as_written;
    bool indirect_light = true;  ///< the scene's radiosity{} is in force
};

struct RayCounters {
    uint64_t camera = 0;
    uint64_t reflected = 0;
    uint64_t refracted = 0;
    uint64_t shadow = 0;
    // Shadow rays that were not needed: to lights that do not reach a place, and where nothing is in between.
    uint64_t unreached = 0;
    uint64_t unhindered = 0;

    RayCounters& operator+=(const RayCounters& other) {
        camera += other.camera;
        reflected += other.reflected;
        refracted += other.refracted;
        shadow += other.shadow;
        unreached += other.unreached;
        unhindered += other.unhindered;
        return *this;
    }
};

/// Follows batches of camera rays through a world: Whitted-style, without recursion. The result for one ray
/// does not depend on the batch it came in, nor on the thread.
class Integrator {
public:
    Integrator(const World& world, const ShadingOptions& options);
    ~Integrator();

    /// `out[i]` becomes what `rays[i]` sees. Safe to call from many threads at once. `indirect`: asked for
    /// the indirect light of surfaces; null where there is none.
    void trace(std::span<const CameraRay> rays, std::span<Radiance> out, RayCounters& counters,
               const IndirectLight* indirect = nullptr) const;

    /// What it shades with; the same address for as long as the integrator lives.
    const ShadingProgram& program() const;
    /// Surfaces and media show these photons from now on. Not while tracing.
    void show(std::shared_ptr<const PhotonLight> photons);

private:
    struct Program;
    std::unique_ptr<Program> program_;
};

}  // namespace rb
