#pragma once
#include "radiosity/gather_quality.h"
#include "radiosity/gradient.h"
#include "radiosity/outlook.h"

#include <atomic>

namespace rb {

/// What arrives at a place.
struct Gathered {
    Rgb mean{0.0f};       ///< mean radiance, weighted by the cosine; brightness and gray_threshold applied
    double distance = 0;  ///< harmonic mean of the distances to what is seen; infinite if there is nothing
    double variance = 0;  ///< of the mean, by chance; mean over the channels
    double nearest = 0;   ///< distance of the nearest of it
    /// How the mean changes with the normal turned about an axis, and with the place moved in its tangent
    /// plane (Ward and Heckbert 1992, "Irradiance Gradients").
    Gradient rotation;
    Gradient translation;
};

/// How places gather.
struct GatherTask {
    int depth = 0;  ///< diffuse surfaces between the places and the eye
    const HemisphereGrid* grid = nullptr;
    const IndirectLight* next = nullptr;  ///< asked by what the rays meet; null at the last bounce
    bool gradients = false;
    const SurfelLight* known = nullptr;     ///< what the rays need not shade; may be null
    std::vector<Surfel>* fresh = nullptr;   ///< takes what they shaded; may be null
    const Outlooks* outlooks = nullptr;     ///< say where more than one ray of a cell is needed; may be null
    std::vector<Outlook>* views = nullptr;  ///< takes those that they lack; may be null
};

/// Gathers light at places by rays over the hemisphere.
class RayGather {
public:
    /// `world` must outlive it, and have radiosity settings. `photons`: what surfaces show of them, or null.
    RayGather(const World& world, const ShadingOptions& options, GatherQuality quality,
              std::shared_ptr<const PhotonLight> photons);

    const RadiositySettings& settings() const { return *program_.world.settings.radiosity; }

    const ShadingProgram& program() const { return program_; }
    const GatherQuality& quality() const { return quality_; }

    /// The directions that they want at that depth.
    const HemisphereGrid& grid_at(int depth) const { return grids_[static_cast<size_t>(depth)]; }

    /// Of places that matter to a pixel or two: their noise shows less than that of a record that many use.
    const HemisphereGrid& pixel_grid() const { return pixel_grid_; }
    /// Of places that matter to a part of a pixel.
    const HemisphereGrid& part_grid() const { return part_grid_; }
    /// A few directions, for places of which many are seen by one that gathers.
    const HemisphereGrid& coarse_grid() const { return coarse_grid_; }

    /// Safe to call from many threads.
    void gather(std::span<const IndirectPlace> places, const GatherTask& task, std::span<Gathered> out) const;

    /// Tells scenes apart by how many surfaces and looks they have.
    uint64_t scene_hash() const;

    uint64_t gather_count() const { return gathers_.load(); }
    uint64_t ray_count() const { return rays_.load(); }
    uint64_t shadow_ray_count() const { return shadow_rays_.load(); }

private:
    struct Batch;
    struct Cells;
    void trace(Batch& batch, const GatherTask& task) const;
    Gathered summed(const Cells& cells, bool gradients) const;
    Rgb limited(const Rgb& light) const;
    Rgb toned(const Rgb& mean) const;

    ShadingProgram program_;
    GatherQuality quality_;
    std::vector<HemisphereGrid> grids_;  ///< by depth
    HemisphereGrid pixel_grid_;
    HemisphereGrid part_grid_;
    HemisphereGrid coarse_grid_;
    mutable std::atomic<uint64_t> gathers_{0};
    mutable std::atomic<uint64_t> rays_{0};
    mutable std::atomic<uint64_t> shadow_rays_{0};
};

}  // namespace rb
