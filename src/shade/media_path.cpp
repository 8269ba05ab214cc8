#include "shade/media_path.h"

#include "base/scratch.h"
#include "math/random.h"
#include "math/recurrence.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

constexpr size_t batch = 64;

Rgb exp_of(const Rgb& x) { return {std::exp(x.x), std::exp(x.y), std::exp(x.z)}; }

float sum_of_differences(const Rgb& a, const Rgb& b) {
    return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z);
}

template <class Function>
Rgb per_channel(const Rgb& x, Function function) {
    return {function(x.x), function(x.y), function(x.z)};
}

/// Mean of exp(-x u) for u in [0, 1].
float mean_attenuation(float x) { return std::abs(x) < 1e-6f ? 1.0f - 0.5f * x : -std::expm1(-x) / x; }

/// Mean of exp(-x k / n) for k = 0 .. n - 1.
float mean_of_steps(float x, float n) {
    return std::abs(x) < 1e-6f ? 1.0f : std::expm1(-x) / (n * std::expm1(-x / n));
}

/// How many steps method 3 makes for so many samples.
int steps_of(const Media& media) { return std::max(2, media.min_samples / 2 + 1); }

}  // namespace

/// A part of an interval that method 3 looks at more closely.
struct MediaPath::Range {
    double from;
    double to;
    Sample first{};
    Sample middle{};
    Sample last{};
    Sample mean{};  ///< result
    uint32_t owner = 0;
};

double MediaPath::unit_draw(uint64_t purpose) const { return unit_random(mixed(seed_, purpose)); }

double MediaPath::next_place() {
    constexpr uint64_t start = ~uint64_t{0};
    return fraction(unit_draw(start) + golden_step * static_cast<double>(draws_++));
}

Rgb MediaPath::attenuation(double length) {
    wants_emission_ = false;
    const MediaPiece all{0.0, length, false};
    pass(all, mix_.is_constant() ? 1 : leading().intervals, false);
    return exp_of(-depth_);
}

AirEffect MediaPath::seen(std::span<const MediaPiece> pieces) {
    const int wanted = std::max(leading().intervals, static_cast<int>(pieces.size()));
    if (pieces.size() == 1) {
        const bool alike = !pieces.front().lit && leading().densities.empty();
        pass(pieces.front(), alike ? 1 : wanted, true);
    } else {
        double total = 0;
        const auto weight = [&](const MediaPiece& p) {
            return p.lit ? leading().ratio : 1 - leading().ratio;
        };
        for (const MediaPiece& piece : pieces) total += weight(piece);
        int remaining = wanted;
        for (size_t i = 0; i < pieces.size(); ++i) {
            const double share = weight(pieces[i]) / total * wanted;
            const int own = share < wanted ? static_cast<int>(share) + 1 : wanted;
            const int left = remaining - static_cast<int>(pieces.size()) + static_cast<int>(i) + 1;
            const int count = std::max(1, std::min(own, left));
            pass(pieces[i], count, true);
            remaining -= count;
        }
    }
    effect_.attenuation = exp_of(-depth_);
    return effect_;
}

/// The way from `piece.from` to `piece.to` in equal intervals, after what was passed before.
void MediaPath::pass(const MediaPiece& piece, int intervals, bool may_add_samples) {
    const double length = (piece.to - piece.from) / intervals;
    for (int i = 0; i < intervals; ++i) {
        const Sample mean = integral({piece.from + i * length, length, piece.lit}, may_add_samples);
        if (wants_emission_) effect_.added += mean.emitted * exp_of(-depth_);
        depth_ += mean.depth;
    }
}

MediaPath::Sample MediaPath::integral(const Interval& interval, bool may_add_samples) {
    if (mix_.is_constant() && !is_lit(interval) && leading().method != 2) return constant(interval);
    return leading().method == 3 ? refined(interval) : spread(interval, may_add_samples);
}

/// The same everywhere: what the methods' sums come to.
MediaPath::Sample MediaPath::constant(const Interval& interval) {
    constexpr double anywhere = 0.0;
    Sample sample;
    look(interval, {&anywhere, 1}, {&sample, 1});
    if (!wants_emission_) return sample;
    if (leading().method == 3) {
        const auto steps = static_cast<float>(steps_of(leading()));
        sample.emitted *= per_channel(sample.depth, [&](float x) { return mean_of_steps(x, steps); });
    } else {
        sample.emitted *= per_channel(sample.depth, mean_attenuation);
    }
    return sample;
}

/// Methods 1 and 2.
MediaPath::Sample MediaPath::spread(const Interval& interval, bool may_add_samples) {
    const Media& media = leading();
    Rgb emitted(0.0f);
    Rgb squares(0.0f);
    Rgb depth(0.0f);
    int count = 0;
    std::array<double, batch> places;
    std::array<Sample, batch> samples;
    const auto take = [&](size_t n) {
        look(interval, std::span(places).first(n), std::span(samples).first(n));
        for (size_t i = 0; i < n; ++i) {
            const Rgb dimmed = samples[i].emitted * exp_of(samples[i].depth * static_cast<float>(-places[i]));
            emitted += dimmed;
            squares += dimmed * dimmed;
            depth += samples[i].depth;
        }
        count += static_cast<int>(n);
    };
    while (count < media.min_samples) {
        const auto n = std::min(batch, static_cast<size_t>(media.min_samples - count));
        for (size_t i = 0; i < n; ++i) {
            const double stratum = count + static_cast<double>(i) + 0.5;
            places[i] =
                media.method == 1
                    ? next_place()
                    : (stratum + (media.jitter != 0.0 ? random() * media.jitter : 0.0)) / media.min_samples;
        }
        take(n);
    }
    if (may_add_samples && media.max_samples > media.min_samples) {
        const auto is_unsure = [&] {
            const auto n = static_cast<float>(count);
            const Rgb mean = emitted / n;
            const Rgb variance = (squares / n - mean * mean) / n;
            return static_cast<double>(max_component(Vec3(variance))) >= mix_.leading().variance_limit(count);
        };
        while (count <= media.max_samples && is_unsure()) {
            places[0] = next_place();
            take(1);
        }
    }
    const auto n = static_cast<float>(count);
    return {emitted / n, depth / n};
}

/// Method 3: ever finer where neighbours differ. The last of its steps is never looked at; so it is in the
/// reference.
MediaPath::Sample MediaPath::refined(const Interval& interval) {
    const Media& media = leading();
    const int steps = steps_of(media);
    const double step = 1.0 / (steps + 1);
    // Steps' ends, the one before the first among them, then what lies between.
    std::array<double, 2 * batch + 1> places;
    std::array<Sample, 2 * batch + 1> samples;
    std::array<Range, batch> ranges;
    const auto place = [&](int j) {
        return j * step + (media.jitter != 0.0 ? step * media.jitter * (random() - 0.5) : 0.0);
    };
    Sample sum;
    for (int begin = 1; begin <= steps; begin += static_cast<int>(batch)) {
        const auto n = std::min(batch, static_cast<size_t>(steps - begin + 1));
        const size_t known = begin == 1 ? 0 : 1;
        if (known == 0) places[0] = place(0);
        for (size_t i = 0; i < n; ++i) {
            const int j = begin + static_cast<int>(i);
            places[i + 1] = place(j);
            ranges[i] = {(j - 1) * step, j * step};
        }
        for (size_t i = 0; i < n; ++i) places[n + 1 + i] = middle_of(ranges[i]);
        const size_t count = 2 * n + 1 - known;
        look(interval, std::span(places).subspan(known, count), std::span(samples).subspan(known, count));
        for (size_t i = 0; i < n; ++i) {
            ranges[i].first = samples[i];
            ranges[i].middle = samples[n + 1 + i];
            ranges[i].last = samples[i + 1];
        }
        refine(interval, std::span(ranges).first(n), media.aa_level - 1);
        samples[0] = samples[n];
        for (size_t i = 0; i < n; ++i) {
            if (wants_emission_)
                sum.emitted += ranges[i].mean.emitted * exp_of(sum.depth / static_cast<float>(-steps));
            sum.depth += ranges[i].mean.depth;
        }
    }
    const auto n = static_cast<float>(steps);
    return {sum.emitted / n, sum.depth / n};
}

/// Where to look between the ends of a range.
double MediaPath::middle_of(const Range& range) {
    const double jitter = leading().jitter;
    const double middle = 0.5 * (range.from + range.to);
    return jitter != 0.0 ? middle + jitter * (range.to - range.from) * (random() - 0.5) : middle;
}

void MediaPath::refine(const Interval& interval, std::span<Range> ranges, int depth) {
    Scratch::Scope memory(thread_scratch());
    const auto halves = memory.take<Range>(2 * ranges.size());
    size_t count = 0;
    const auto add_half = [&](uint32_t owner, double from, double to, const Sample& a, const Sample& b) {
        halves[count++] = {from, to, a, {}, b, {}, owner};
    };
    for (uint32_t i = 0; i < ranges.size(); ++i) {
        Range& r = ranges[i];
        const Sample& m = r.middle;
        const double middle = 0.5 * (r.from + r.to);
        if (depth <= 0 || !(r.from < middle && middle < r.to)) {
            r.mean.emitted = (r.first.emitted + m.emitted + r.last.emitted) / 3.0f;
            r.mean.depth = (r.first.depth + m.depth + r.last.depth) / 3.0f;
            continue;
        }
        r.mean = {};
        const auto take_end = [&](const Sample& end, double from, double to, bool is_first) {
            if (sum_of_differences(end.emitted, m.emitted) > mix_.aa_threshold()) {
                add_half(i, from, to, is_first ? end : m, is_first ? m : end);
                return;
            }
            r.mean.emitted += end.emitted / 3.0f + m.emitted / 6.0f;
            r.mean.depth += end.depth / 3.0f + m.depth / 6.0f;
        };
        take_end(r.first, r.from, middle, true);
        take_end(r.last, middle, r.to, false);
    }
    for (size_t begin = 0; begin < count; begin += batch) {
        const auto part = halves.subspan(begin, std::min(batch, count - begin));
        look_between(interval, part);
        refine(interval, part, depth - 1);
        for (const Range& half : part) {
            ranges[half.owner].mean.emitted += 0.5f * half.mean.emitted;
            ranges[half.owner].mean.depth += 0.5f * half.mean.depth;
        }
    }
}

/// At the middle of each range.
void MediaPath::look_between(const Interval& interval, std::span<Range> ranges) {
    std::array<double, batch> places;
    std::array<Sample, batch> samples;
    for (size_t i = 0; i < ranges.size(); ++i) places[i] = middle_of(ranges[i]);
    look(interval, std::span(places).first(ranges.size()), std::span(samples).first(ranges.size()));
    for (size_t i = 0; i < ranges.size(); ++i) ranges[i].middle = samples[i];
}

/// `places`: fractions of the interval.
void MediaPath::look(const Interval& interval, std::span<const double> places, std::span<Sample> out) {
    Scratch::Scope memory(thread_scratch());
    const auto distances = memory.take<double>(places.size());
    const auto points = memory.take<Vec3>(places.size());
    const auto found = memory.take<MediaSample>(places.size());
    for (size_t i = 0; i < places.size(); ++i) {
        distances[i] = interval.from + places[i] * interval.length;
        points[i] = ray_.at(distances[i]);
    }
    mix_.evaluate(points, found);
    if (is_lit(interval)) lighting_->add(distances, points, found);
    const auto length = static_cast<float>(interval.length);
    for (size_t i = 0; i < places.size(); ++i) {
        out[i] = {found[i].emission * length, found[i].extinction * length};
    }
}

}  // namespace rb
