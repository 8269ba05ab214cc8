#include "patterns/image_field.h"

#include "patterns/formula.h"
#include "patterns/noise.h"
#include "scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace rb {

namespace {

/// The angle around the y axis as a share of the full turn; 0 on the axis.
double turn_share(double x, double z) { return x == 0.0 && z == 0.0 ? 0.0 : turn(x, z) / (2.0 * pi); }

double wrapped(double v, double size) {
    v = std::fmod(v, size);
    if (v < 0.0) v += size;
    return v >= size ? 0.0 : v;
}

bool beyond_unit(double v) { return v < 0.0 || v > 1.0; }

/// Catmull and Rom's cubic between the second and third of four values.
std::array<double, 4> cubic_weights(double p) {
    const double r = 1.0 - p;
    return {-0.5 * p * r * r, 0.5 * r * (r * (3.0 * p + 1.0) + 1.0), 0.5 * p * (p * (3.0 * r + 1.0) + 1.0),
            -0.5 * r * p * p};
}

std::array<double, 4> distance_weights(double p, double q) {
    const double p1 = (1.0 - p) * (1.0 - p);
    const double q1 = (1.0 - q) * (1.0 - q);
    const double p0 = p * p;
    const double q0 = q * q;
    // A place on a pixel is that pixel.
    constexpr double least = 1e-20;
    std::array<double, 4> weights{p1 + q1, p0 + q1, p1 + q0, p0 + q0};
    double sum = 0;
    for (double& w : weights) sum += w = 1.0 / std::max(w, least);
    for (double& w : weights) w /= sum;
    return weights;
}

/// Sums in double precision.
class ColorSum {
public:
    void add(const Color& c, double weight) {
        sums_[0] += weight * static_cast<double>(c.red);
        sums_[1] += weight * static_cast<double>(c.green);
        sums_[2] += weight * static_cast<double>(c.blue);
        sums_[3] += weight * static_cast<double>(c.filter);
        sums_[4] += weight * static_cast<double>(c.transmit);
    }
    Color color() const {
        const auto narrow = [&](size_t k) { return static_cast<float>(sums_[k]); };
        return {narrow(0), narrow(1), narrow(2), narrow(3), narrow(4)};
    }

private:
    std::array<double, 5> sums_{};
};

}  // namespace

std::optional<Vec2> ImageField::unrolled(const Vec3& p) const {
    const double width = texels_.width() * options_.repeat.x;
    const double height = texels_.height() * options_.repeat.y;
    switch (options_.mapping) {
        case ImageMapping::planar:
            if (options_.once && (beyond_unit(p.x) || beyond_unit(p.y))) return std::nullopt;
            return Vec2{std::fmod(p.x * width, width), std::fmod(p.y * height, height)};
        case ImageMapping::spherical: {
            const double length = glm::length(p);
            if (length == 0.0) return std::nullopt;
            const double up = std::clamp(p.y / length, -1.0, 1.0);
            return Vec2{turn_share(p.x, p.z) * width, (0.5 + std::asin(up) / pi) * height};
        }
        case ImageMapping::cylindrical:
            if ((options_.once && beyond_unit(p.y)) || (p.x == 0.0 && p.z == 0.0)) return std::nullopt;
            return Vec2{turn_share(p.x, p.z) * width, std::fmod(p.y * height, height)};
        case ImageMapping::toroidal: {
            if (p.x == 0.0 && p.z == 0.0) return std::nullopt;
            const double x = std::sqrt(p.x * p.x + p.z * p.z) - 1.0;
            const double length = std::sqrt(x * x + p.y * p.y);
            double around = length == 0.0 ? 0.0 : std::acos(std::clamp(-x / length, -1.0, 1.0));
            if (p.y > 0.0) around = 2.0 * pi - around;
            return Vec2{turn_share(p.x, p.z) * width, around / (2.0 * pi) * height};
        }
    }
    return std::nullopt;
}

std::optional<Vec2> ImageField::place(const Vec3& p) const {
    const std::optional<Vec2> at = unrolled(p);
    if (!at) return std::nullopt;
    const double width = texels_.width();
    const double height = texels_.height();
    const double a = at->x - options_.offset.x * width + tiny;
    const double b = at->y - options_.offset.y * height + tiny;
    if (options_.once && (a < 0.0 || a >= width || b < 0.0 || b >= height)) return std::nullopt;
    if (!std::isfinite(a) || !std::isfinite(b)) return std::nullopt;
    return Vec2{wrapped(a, width), wrapped(-b, height)};
}

/// What lies beyond an edge is the other side, or with `once` the edge.
std::pair<int, int> ImageField::within(int x, int y) const {
    const auto limited = [&](int v, int size) {
        return options_.once ? std::clamp(v, 0, size - 1) : ((v % size) + size) % size;
    };
    return {limited(x, texels_.width()), limited(y, texels_.height())};
}

Color ImageField::pixel(int x, int y) const {
    const auto [i, j] = within(x, y);
    return texels_.at(i, j);
}

Color ImageField::color(const Vec2& place) const {
    if (options_.interpolation == Interpolation::none)
        return texels_.divided(pixel(static_cast<int>(place.x), static_cast<int>(place.y)));
    const int i = static_cast<int>(place.x + 0.5);
    const int j = static_cast<int>(place.y + 0.5);
    const double p = place.x + 0.5 - i;
    const double q = place.y + 0.5 - j;
    ColorSum sum;
    if (options_.interpolation == Interpolation::bicubic) {
        const auto across = cubic_weights(p);
        const auto down = cubic_weights(q);
        for (int n = 0; n < 4; ++n) {
            for (int m = 0; m < 4; ++m)
                sum.add(pixel(i + m - 2, j + n - 2),
                        across[static_cast<size_t>(m)] * down[static_cast<size_t>(n)]);
        }
    } else {
        const std::array<double, 4> weights =
            options_.interpolation == Interpolation::bilinear
                ? std::array<double, 4>{p * q, (1.0 - p) * q, p * (1.0 - q), (1.0 - p) * (1.0 - q)}
                : distance_weights(p, q);
        sum.add(pixel(i, j), weights[0]);
        sum.add(pixel(i - 1, j), weights[1]);
        sum.add(pixel(i, j - 1), weights[2]);
        sum.add(pixel(i - 1, j - 1), weights[3]);
    }
    return texels_.divided(sum.color());
}

uint32_t ImageField::index(const Vec2& place) const {
    const auto [i, j] = within(static_cast<int>(place.x), static_cast<int>(place.y));
    return texels_.index(i, j);
}

namespace {

Texels::Decoding decoding_of(const ReadContext& context, bool is_color) {
    Texels::Decoding decoding;
    decoding.is_color = is_color;
    const auto& gamma = context.settings->assumed_gamma;
    decoding.guesses_srgb = context.effective_version >= 370;
    decoding.converts = decoding.guesses_srgb || gamma.has_value();
    if (gamma) decoding.working = Curve(*gamma);
    return decoding;
}

/// `filter all v`, `filter 3, v`.
void take_passing(BlockReader& in, bool filter, Texels& texels) {
    if (in.take_word("all")) {
        const auto v = static_cast<float>(in.number());
        filter ? texels.filter_all(v) : texels.transmit_all(v);
        return;
    }
    const SourceRange at = in.where();
    const int entry = in.integer();
    const auto v = static_cast<float>(in.number());
    const std::string_view word = filter ? "filter" : "transmit";
    if (!texels.has_palette()) {
        in.fail_at(at, fmt::format("Keyword '{}' cannot be used with non color-mapped image.", word));
    }
    if (entry < 0 || static_cast<size_t>(entry) >= texels.palette_size()) {
        in.fail_at(at, fmt::format("{} color register value out of range.", filter ? "FILTER" : "TRANSMIT"));
    }
    filter ? texels.set_filter(static_cast<size_t>(entry), v)
           : texels.set_transmit(static_cast<size_t>(entry), v);
}

void take_mapping(BlockReader& in, bool is_color, ImageOptions& options) {
    const SourceRange at = in.where();
    const int kind = in.integer();
    const bool known = kind == 0 || kind == 1 || kind == 2 || kind == 5;
    if (!known && is_color) in.fail_at(at, "Invalid map_type value.");
    options.mapping = known ? static_cast<ImageMapping>(kind) : ImageMapping::planar;
}

void take_interpolation(BlockReader& in, bool is_color, ImageOptions& options) {
    const SourceRange at = in.where();
    const int kind = in.integer();
    const bool known = kind >= 2 && kind <= 4;
    if (!known && is_color) in.fail_at(at, "Invalid interpolate value.");
    options.interpolation = known ? static_cast<Interpolation>(kind) : Interpolation::none;
}

bool take_option(BlockReader& in, Texels& texels, ImageOptions& options) {
    const bool is_color = in.keyword() == "image_map";
    if (in.take_word("once")) {
        options.once = true;
    } else if (in.take_word("map_type")) {
        take_mapping(in, is_color, options);
    } else if (in.take_word("interpolate")) {
        take_interpolation(in, is_color, options);
    } else if (in.take_word("use_index")) {
        options.use_index = true;
    } else if (in.take_word("use_color") || in.take_word("use_colour")) {
        options.use_index = false;
    } else if (in.keyword() == "image_pattern" && in.take_word("use_alpha")) {
        options.use_alpha = true;
    } else if (is_color && in.take_word("filter")) {
        take_passing(in, true, texels);
    } else if (is_color && in.take_word("transmit")) {
        take_passing(in, false, texels);
    } else if (in.take_word("repeat")) {
        options.repeat = in.vec2();
    } else if (in.take_word("offset")) {
        options.offset = in.vec2();
    } else if (in.keyword() == "bump_map" && in.take_word("bump_size")) {
        options.amount = static_cast<float>(in.number());
    } else {
        return false;
    }
    return true;
}

}  // namespace

ImageField take_image_field(BlockReader& in) {
    if (in.at_number()) {
        in.diagnostics().warning(in.where(), "Old style orientation vector or map type not supported.");
        in.vec3();
    }
    Texels texels(in.context().take_image(in), decoding_of(in.context(), in.keyword() == "image_map"));
    ImageOptions options;
    while (take_option(in, texels, options)) {
    }
    return {std::move(texels), options};
}

}  // namespace rb
