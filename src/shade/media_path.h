#pragma once
#include "shade/fog.h"
#include "shade/media_program.h"

namespace rb {

/// A part of a ray's way through media: between two lights' edges, or all of it.
struct MediaPiece {
    double from = 0;
    double to = 0;
    bool lit = false;
};

/// What lights add to the emission of media.
class MediaLighting {
public:
    virtual ~MediaLighting() = default;
    /// Adds to `emission` of samples at these distances along the ray.
    virtual void add(std::span<const double> distances, std::span<const Vec3> points,
                     std::span<MediaSample> samples) = 0;
    /// True if it adds light outside of the lit pieces, too.
    virtual bool is_everywhere() const = 0;
};

/// Integrates media along a ray by the reference's methods (spec: shading 11). Where those draw random
/// numbers, method 1 takes the points of an additive recurrence (steps of the golden ratio from a random
/// start), so that samples spread evenly over every interval.
class MediaPath {
public:
    /// `lighting`: null where nothing scatters, and for shadow rays.
    MediaPath(const MediaMix& mix, const Ray& ray, uint64_t seed, MediaLighting* lighting)
        : mix_(mix), ray_(ray), seed_(seed), lighting_(lighting) {}

    /// What the eye sees at the beginning of the ray. `pieces` cover the way without gaps.
    AirEffect seen(std::span<const MediaPiece> pieces);
    /// What is left of light that takes the ray.
    Rgb attenuation(double length);

private:
    struct Interval {
        double from;
        double length;
        bool lit;
    };
    /// Over a whole interval, if all of it were like the place that was looked at.
    struct Sample {
        Rgb emitted{0.0f};
        Rgb depth{0.0f};
    };
    struct Range;

    const Media& leading() const { return mix_.leading().media(); }
    bool is_lit(const Interval& interval) const {
        return lighting_ && (interval.lit || lighting_->is_everywhere());
    }
    void pass(const MediaPiece& piece, int intervals, bool may_add_samples);
    Sample integral(const Interval& interval, bool may_add_samples);
    Sample constant(const Interval& interval);
    Sample spread(const Interval& interval, bool may_add_samples);
    Sample refined(const Interval& interval);
    double middle_of(const Range& range);
    void refine(const Interval& interval, std::span<Range> ranges, int depth);
    void look_between(const Interval& interval, std::span<Range> ranges);
    void look(const Interval& interval, std::span<const double> places, std::span<Sample> out);
    double random() { return unit_draw(draws_++); }
    double unit_draw(uint64_t purpose) const;
    double next_place();

    const MediaMix& mix_;
    const Ray& ray_;
    uint64_t seed_;
    MediaLighting* lighting_;
    uint64_t draws_ = 0;
    bool wants_emission_ = true;
    AirEffect effect_;
    Rgb depth_{0.0f};  ///< from the beginning of the ray
};

}  // namespace rb
