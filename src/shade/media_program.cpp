#include "shade/media_program.h"

#include "base/scratch.h"
#include "math/chi_square.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace rb {

namespace {

constexpr int most_limits = 4096;

/// Spec: shading 11.6. `limit_of_last` is chi-square of max_samples - 1.
double limit_of(const Media& media, int count) {
    if (media.max_samples < 2) return 0.0;
    const double below = std::clamp(1.0 - media.confidence, 1e-12, 1.0 - 1e-12);
    return media.variance / chi_square_quantile(media.max_samples - 1, below) *
           chi_square_quantile(count, below);
}

float power(float x, int doublings) {
    for (int i = 0; i < doublings; ++i) x *= x;
    return x;
}

}  // namespace

MediumProgram::MediumProgram(MediaPtr media, const PatternSettings& settings) : media_(std::move(media)) {
    Rgb factor(1.0f);
    for (const DensityPtr& density : media_->densities) {
        PigmentProgram program(*density, settings);
        if (program.is_constant()) {
            factor *= program.constant().rgb();
        } else {
            fields_.push_back(std::move(program));
        }
    }
    const Scattering& scattering = media_->scattering;
    full_.emission = factor * media_->emission;
    full_.extinction = factor * (media_->absorption + scattering.extinction * scattering.color);
    full_.scattering = factor * scattering.color;
    if (media_->max_samples <= media_->min_samples) return;
    for (int n = 1; n <= std::min(media_->max_samples, most_limits); ++n) {
        variance_limits_.push_back(limit_of(*media_, n));
    }
}

double MediumProgram::variance_limit(int count) const {
    const auto known = static_cast<int>(variance_limits_.size());
    return count <= known ? variance_limits_[static_cast<size_t>(count - 1)] : limit_of(*media_, count);
}

float MediumProgram::phase(double cosine) const {
    if (!scatters()) return 1.0f;
    const auto c = static_cast<float>(cosine);
    const auto g = static_cast<float>(media_->scattering.eccentricity);
    const float forward = 0.5f * (1.0f + c);
    switch (media_->scattering.type) {
        case 2:
            return 0.576655375f * (1.0f + 9.0f * power(forward, 3));
        case 3:
            return 0.495714547f * (1.0f + 50.0f * power(forward, 5));
        case 4:
            return 0.799372013f * (1.0f + c * c);
        case 5:
            return (1.0f - g * g) / std::pow(1.0f + g * g - 2.0f * g * c, 1.5f);
        default:
            return 1.0f;
    }
}

void MediumProgram::add(std::span<const Vec3> points, std::span<MediaSample> out) const {
    Scratch::Scope memory(thread_scratch());
    const auto density = memory.take<Rgb>(out.size(), Rgb(1.0f));
    if (!fields_.empty()) {
        const auto colors = memory.take<Color>(out.size());
        for (const PigmentProgram& field : fields_) {
            field.evaluate({points, nullptr, {}}, colors);
            for (size_t i = 0; i < out.size(); ++i) density[i] *= colors[i].rgb();
        }
    }
    for (size_t i = 0; i < out.size(); ++i) {
        out[i].emission += density[i] * full_.emission;
        out[i].extinction += density[i] * full_.extinction;
        out[i].scattering += density[i] * full_.scattering;
    }
}

void MediaMix::add(const MediumProgram& medium) {
    const Media& media = medium.media();
    const auto threshold = static_cast<float>(media.aa_threshold);
    const bool first = media_.empty();
    media_.push_back(&medium);
    if (first || media.intervals > leading_->media().intervals) leading_ = &medium;
    is_constant_ = (first || is_constant_) && medium.is_constant();
    scatters_ = (!first && scatters_) || medium.scatters();
    collects_ = (!first && collects_) || media.collect;
    aa_threshold_ = first ? threshold : std::min(aa_threshold_, threshold);
}

float MediaMix::phase(double cosine) const {
    float sum = 0;
    for (const MediumProgram* medium : media_) sum += medium->phase(cosine);
    return sum / static_cast<float>(media_.size());
}

void MediaMix::evaluate(std::span<const Vec3> points, std::span<MediaSample> out) const {
    std::ranges::fill(out, MediaSample{});
    for (const MediumProgram* medium : media_) medium->add(points, out);
}

MediaProgram::MediaProgram(const World& world, const PatternSettings& settings, bool enabled) {
    if (!enabled) return;
    std::unordered_map<const Media*, uint32_t> known;
    const auto compiled = [&](const std::vector<MediaPtr>& media) {
        std::vector<uint32_t> list;
        for (const MediaPtr& m : media) {
            const auto [entry, is_new] = known.try_emplace(m.get(), static_cast<uint32_t>(programs_.size()));
            if (is_new) programs_.emplace_back(m, settings);
            list.push_back(entry->second);
        }
        return list;
    };
    air_ = compiled(world.atmosphere);
    const auto has_media = [](const WorldInterior& i) { return !i.interior.media.empty(); };
    fills_interiors_ = std::ranges::any_of(world.interiors, has_media);
    if (!fills_interiors_) return;
    for (const WorldInterior& interior : world.interiors) {
        interiors_.push_back(compiled(interior.interior.media));
    }
}

void MediaProgram::mix_of(std::span<const uint32_t> interiors, MediaMix& mix) const {
    mix.clear();
    for (const uint32_t interior : interiors) {
        for (const uint32_t medium : interiors_[interior]) mix.add(programs_[medium]);
    }
}

void MediaProgram::mix_of_air(MediaMix& mix) const {
    mix.clear();
    for (const uint32_t medium : air_) mix.add(programs_[medium]);
}

}  // namespace rb
