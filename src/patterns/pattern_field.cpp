#include "patterns/pattern_field.h"

#include "patterns/formula.h"
#include "patterns/line_bound.h"
#include "patterns/sine.h"
#include "patterns/warps.h"

#include <algorithm>

namespace rb {

namespace {

/// The value_period is not 1, so that a value of exactly 1 stays 1; patterns without bounds drift by this
/// much.
constexpr double value_period = 1.00001;

}  // namespace

PatternField::PatternField(PatternPtr pattern, const PatternModifiers& modifiers,
                           const PatternSettings& settings)
    : pattern_(std::move(pattern)), modifiers_(modifiers), settings_(settings) {
    warp_count_ = modifiers_.warps.size();
    const TurbulenceWarp* classic = modifiers_.classic_turbulence();
    if (classic) {
        const bool moves = !(pattern_ && pattern_->keeps_turbulence()) && classic->amount != Vec3{0.0};
        if (!moves) --warp_count_;
    }
    if (modifiers_.noise_generator != 0) settings_.noise_generator = modifiers_.noise_generator;
}

void PatternField::carry(std::span<Vec3> points) const {
    for (size_t i = 0; i < warp_count_; ++i) warp_points(modifiers_.warps[i], points);
    if (warp_count_ > 0) limit_coordinates(points);
}

PatternContext PatternField::context(const PatternSamples& samples) const {
    return {modifiers_, settings_.noise_generator, settings_.number_of_waves, samples.surface, samples.rows};
}

void PatternField::values(const PatternSamples& carried, std::span<double> out) const {
    pattern_->evaluate(context(carried), carried.points, out);
    shape(out);
}

bool PatternField::perturb(const PatternSamples& carried, float amount, std::span<Vec3> normals) const {
    return pattern_->perturb(context(carried), amount, carried.points, normals);
}

void PatternField::shape(std::span<double> values) const {
    const double frequency = modifiers_.frequency;
    const double phase = modifiers_.phase;
    for (double& v : values) {
        if (frequency != 0.0) {
            v = v * frequency + phase;
            if (std::abs(v) >= value_period) v = std::fmod(v, value_period);
        }
        if (v < 0.0) v -= std::floor(v);
    }
    switch (modifiers_.wave) {
        case Wave::ramp:
            break;
        case Wave::triangle:
            for (double& v : values) v = triangle(v);
            break;
        case Wave::sine:
            for (double& v : values) v *= 2.0 * pi;
            sines(values);
            for (double& v : values) v = (1.0 + v) * 0.5;
            break;
        case Wave::scallop:
            for (double& v : values) v *= 0.5 * (2.0 * pi);
            sines(values);
            for (double& v : values) v = std::abs(v);
            break;
        case Wave::cubic:
            for (double& v : values) v = v * v * (3.0 - 2.0 * v);
            break;
        case Wave::poly:
            for (double& v : values) v = std::pow(v, static_cast<double>(modifiers_.poly_exponent));
            break;
    }
}

IntervalSlope PatternField::bound(LinePlace place) const {
    const auto is_far = [](const IntervalSlope& v) {
        return v.value.maybe_nan || !(v.value.lo > -coordinate_limit && v.value.hi < coordinate_limit);
    };
    if (std::ranges::any_of(place, is_far)) return IntervalSlope::everything();
    for (size_t i = 0; i < warp_count_; ++i) {
        const auto* map = std::get_if<Transform>(&modifiers_.warps[i]);
        if (map) place = carried(place, map->backward);
        if (map && std::ranges::none_of(place, is_far)) continue;
        place.fill(somewhere_in(-coordinate_limit, coordinate_limit));
        break;
    }
    return shaped(pattern_->bound(context({}), place));
}

/// What shape() makes of it.
IntervalSlope PatternField::shaped(IntervalSlope v) const {
    if (v.value.maybe_nan) return IntervalSlope::everything();
    const double frequency = modifiers_.frequency;
    const double phase = modifiers_.phase;
    if (frequency != 0.0 && v.value.has_infinity()) {
        v = somewhere_in(-value_period, value_period);
    } else if (frequency != 0.0) {
        const bool rises = v.value.lo >= 0.0 && frequency > 0.0 && phase >= 0.0;
        v = v * frequency + phase;
        if (rises) v = not_negative(v);
        if (!(v.value.lo > -value_period && v.value.hi < value_period)) v = fmod(v, value_period);
    }
    if (v.value.lo < 0.0) {
        const Interval below_one{0.0, std::max(1.0, v.value.hi)};
        v = v.value.hi < 0.0 ? fraction(v) : IntervalSlope::jumping(below_one);
    }
    switch (modifiers_.wave) {
        case Wave::ramp:
            return v;
        case Wave::triangle:
            return triangle(v);
        case Wave::sine:
            return (1.0 + sin(v * (2.0 * pi))) * 0.5;
        case Wave::scallop:
            return abs(sin(v * (0.5 * (2.0 * pi))));
        case Wave::cubic:
            return square(v) * (3.0 - 2.0 * v);
        case Wave::poly:
            return pow(v, double{modifiers_.poly_exponent});
    }
    return IntervalSlope::everything();
}

MapPlace find_in_map(std::span<const float> positions, bool sorted, double value) {
    const auto last = static_cast<uint32_t>(positions.size() - 1);
    // A value that is no number falls on the last entry.
    if (!(value < static_cast<double>(positions[last]))) return {last, last, 0.0};
    const auto reaches = [value](float position) { return value <= static_cast<double>(position); };
    uint32_t current = 0;
    if (sorted && positions.size() > 16) {
        current =
            static_cast<uint32_t>(std::partition_point(positions.begin(), positions.end(),
                                                       [&](float position) { return !reaches(position); }) -
                                  positions.begin());
    } else if (sorted) {
        // Counted to the end: where to stop is nothing that a processor could foresee.
        for (const float position : positions) current += reaches(position) ? 0 : 1;
    } else {
        while (!reaches(positions[current])) ++current;
    }
    const double end = positions[current];
    if (current == 0 || value == end) return {current, current, 0.0};
    const double start = positions[current - 1];
    return {current - 1, current, (value - start) / (end - start)};
}

}  // namespace rb
