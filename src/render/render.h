#pragma once
#include "base/huge_pages.h"
#include "photons/shoot.h"
#include "radiosity/radiosity.h"
#include "render/antialias.h"
#include "shade/needs.h"

#include <atomic>
#include <functional>
#include <vector>

namespace rb {

/// The finished light of a picture, before gamma and quantisation.
struct Film {
    int width = 0;
    int height = 0;
    /// Rows top to bottom; pixels that were not rendered are black, transmit 0.
    std::vector<Radiance, HugePages<Radiance>> pixels;

    Radiance& at(int x, int y) {
        return pixels[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
    }
    const Radiance& at(int x, int y) const {
        return pixels[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
    }
};

struct RenderOptions {
    int width = 160;
    int height = 120;
    PixelBlock region{0, 0, 160, 120};  ///< what to render
    int block_size = 32;
    int threads = 0;  ///< 0: all cores that this process may use
    AntialiasOptions antialias;
    ShadingOptions shading;
    uint64_t seed = 0;  ///< another one changes all random draws
    GiMode gi = GiMode::automatic;
    RadiosityFiles radiosity_files;
    bool view_surfels = false;  ///< instead of the picture what radiosity knows of its surfaces
    double gi_error = 0;        ///< in shares of white; 0: as the scene's settings say
};

struct RenderResult {
    Film film;
    RayCounters counters;
    Needs needs;
    std::optional<RadiosityReport> radiosity;
    PhotonCounters photons;
    bool complete = true;  ///< false if `stop` ended it early; finished blocks are in the film
};

/// Takes note of finished blocks, and knows some from before. Calls come one at a time.
class BlockLog {
public:
    virtual ~BlockLog() = default;
    /// Fills in a block that is known; false if it is not.
    virtual bool restore(const PixelBlock& block, Film& film) = 0;
    virtual void finished(const PixelBlock& block, const Film& film) = 0;
};

/// Renders a world. `progress(done, total)` counts pixels, is called from any thread, one call at a time.
/// `stop` may be set by a signal handler: blocks that have begun are finished. `log` may be null.
RenderResult render(const World& world, const RenderOptions& options, const std::atomic<bool>& stop,
                    const std::function<void(size_t done, size_t total)>& progress, BlockLog* log = nullptr);

}  // namespace rb
