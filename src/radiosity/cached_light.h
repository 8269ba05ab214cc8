#pragma once
#include "radiosity/light_file.h"
#include "radiosity/ray_gather.h"
#include "radiosity/surfel_grid.h"

#include <vector>

namespace rb {

/// When a place counts as known: with as many records near it as `nearest_count` asks for, or with any.
enum class Coverage { ample, any };

/// Interpolates between places where light was gathered before: one cache for each bounce. What is not known
/// well enough is gathered on the spot, and not kept, so that answers never depend on what was asked before.
class CachedLight final : public IndirectLight {
public:
    /// `with_surfels`: what gathers meet is shaded once for all that see it about as large.
    CachedLight(const RayGather& rays, const Vec3& eye, bool with_surfels);

    void gather(std::span<const IndirectPlace> places, int depth, std::span<Rgb> mean) const override;

    bool knows(const IndirectPlace& place, int depth, Coverage coverage) const;

    /// Gathers at places that are not known yet, in an order that depends on their number only. Under
    /// Coverage::any what is missing is for a pixel or two: by fewer rays.
    void learn(std::span<const IndirectPlace> places, int depth, Coverage coverage, int threads,
               const std::atomic<bool>& stop);

    /// What is known of places seen by the eye has less noise from then on (see smoothed()).
    void smooth(int threads);

    /// All that it has learned.
    StoredLight stored() const;
    /// Puts it in before anything is learned; false if that was learned of another scene (by its numbers of
    /// surfaces) or with other settings.
    bool restore(const StoredLight& light);

    /// Places so far at which nothing was known: those seen by the eye, and those seen by gathers.
    std::array<uint64_t, 2> gap_counts() const { return {gaps_[0].load(), gaps_[1].load()}; }
    size_t record_count(int depth) const { return caches_[static_cast<size_t>(depth)].size(); }

    uint64_t interpolation_count() const { return interpolations_.load(); }
    /// By depth of those who look at them; none if they are not used.
    std::span<const SurfelGrid> surfels() const { return surfels_; }
    /// How many were shaded to be kept.
    std::span<const size_t> surfel_counts() const { return surfel_counts_; }
    /// RMS of what interpolation would have been wrong by where it was not trusted, in units of the light: an
    /// upper bound, about, of its error where it is.
    double error_estimate() const;

private:
    void fill(std::span<const IndirectPlace> places, std::span<const uint32_t> gaps, int depth,
              const HemisphereGrid& grid, std::span<Rgb> mean) const;
    uint64_t made_for() const;
    void compare(std::span<const IrradianceRecord> records);
    const SurfelGrid* surfels_at(int depth) const;
    IrradianceRecord record_of(const IndirectPlace& place, int depth, const Gathered& gathered) const;
    std::vector<IrradianceRecord> gathered(std::span<const IndirectPlace> places, int depth,
                                           const HemisphereGrid& grid, int threads,
                                           const std::atomic<bool>& stop);
    const IndirectLight* next(int depth) const;
    bool is_enough(double weight, Coverage coverage) const;

    const RayGather& rays_;
    Vec3 eye_;
    std::vector<IrradianceCache> caches_;  ///< by depth
    std::vector<SurfelGrid> surfels_;
    Outlooks outlooks_;  ///< of places seen by the eye
    std::vector<size_t> surfel_counts_;
    double error_squares_ = 0;
    size_t compared_ = 0;
    mutable std::atomic<uint64_t> interpolations_{0};
    mutable std::array<std::atomic<uint64_t>, 2> gaps_{};
};

/// Takes note of the places that ask; serves one thread. It answers with darkness.
class PlaceCollector final : public IndirectLight {
public:
    /// `known`: whose places are left out, if they are covered so well; or null.
    PlaceCollector(const CachedLight* known, Coverage coverage, std::vector<IndirectPlace>& out)
        : known_(known), coverage_(coverage), out_(out) {}

    void gather(std::span<const IndirectPlace> places, int depth, std::span<Rgb> mean) const override;
    bool wants_light() const override { return false; }

private:
    const CachedLight* known_;
    Coverage coverage_;
    std::vector<IndirectPlace>& out_;
};

}  // namespace rb
