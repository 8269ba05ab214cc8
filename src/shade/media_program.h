#pragma once
#include "compile/world.h"
#include "patterns/pigment_program.h"

namespace rb {

/// What media do at one place, per unit of length.
struct MediaSample {
    Rgb emission{0.0f};
    Rgb extinction{0.0f};
    Rgb scattering{0.0f};
};

/// A medium with what its formulas need worked out once.
class MediumProgram {
public:
    MediumProgram(MediaPtr media, const PatternSettings& settings);

    const Media& media() const { return *media_; }
    bool is_constant() const { return fields_.empty(); }
    bool scatters() const { return media_->scattering.color != Rgb(0.0f); }
    /// How much goes off the way, for the cosine between the ray and the way to a light.
    float phase(double cosine) const;
    /// Adds what it does at `points`; those do not matter to a constant one.
    void add(std::span<const Vec3> points, std::span<MediaSample> out) const;
    /// Of `count` samples: below what variance of their mean no more are taken.
    double variance_limit(int count) const;

private:
    MediaPtr media_;
    MediaSample full_;  ///< where the patterned densities are 1
    std::vector<PigmentProgram> fields_;
    std::vector<double> variance_limits_;  ///< of 1, 2, ... samples
};

/// All media on the way of one ray, which add up.
class MediaMix {
public:
    void clear() { media_.clear(); }
    void add(const MediumProgram& medium);

    bool empty() const { return media_.empty(); }
    bool is_constant() const { return is_constant_; }
    bool scatters() const { return scatters_; }
    bool collects() const { return collects_; }  ///< photons, any of them
    /// The one with the most intervals, which decides how the way is sampled.
    const MediumProgram& leading() const { return *leading_; }
    float aa_threshold() const { return aa_threshold_; }
    /// Mean over the media, whether they scatter or not (as the reference has it).
    float phase(double cosine) const;
    void evaluate(std::span<const Vec3> points, std::span<MediaSample> out) const;

private:
    std::vector<const MediumProgram*> media_;
    const MediumProgram* leading_ = nullptr;
    bool is_constant_ = true;
    bool scatters_ = false;
    bool collects_ = false;
    float aa_threshold_ = 0;
};

/// The media of a world: those of its interiors, and those of its air.
class MediaProgram {
public:
    /// Without `enabled` (quality below 9) there are none.
    MediaProgram(const World& world, const PatternSettings& settings, bool enabled);

    bool fills_interiors() const { return fills_interiors_; }
    bool fills_air() const { return !air_.empty(); }
    /// Makes `mix` what fills all of these interiors.
    void mix_of(std::span<const uint32_t> interiors, MediaMix& mix) const;
    void mix_of_air(MediaMix& mix) const;

private:
    std::vector<MediumProgram> programs_;
    std::vector<std::vector<uint32_t>> interiors_;  ///< for each interior, indices into programs_
    std::vector<uint32_t> air_;
    bool fills_interiors_ = false;
};

}  // namespace rb
