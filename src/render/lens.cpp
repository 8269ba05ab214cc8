#include "render/lens.h"

#include "math/chi_square.h"
#include "math/jitter.h"
#include "math/shuffle.h"
#include "patterns/pigment_program.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace rb {

namespace {

constexpr std::array<Vec2, 4> grid_4{{{-.25, .25}, {.25, .25}, {-.25, -.25}, {.25, -.25}}};
constexpr std::array<Vec2, 7> grid_7{{{-.288675, 0},
                                      {0, 0},
                                      {.288675, 0},
                                      {-.144338, .25},
                                      {-.144338, -.25},
                                      {.144338, .25},
                                      {.144338, -.25}}};
constexpr std::array<Vec2, 19> grid_19{{{-.19245, .333333},
                                        {-.19245, -.333333},
                                        {.19245, .333333},
                                        {.19245, -.333333},
                                        {.3849, 0},
                                        {-.3849, 0},
                                        {0, 0},
                                        {0, .333333},
                                        {0, -.333333},
                                        {-.288675, .166667},
                                        {-.288675, -.166667},
                                        {.288675, .166667},
                                        {.288675, -.166667},
                                        {-.096225, .166667},
                                        {-.096225, -.166667},
                                        {.096225, .166667},
                                        {.096225, -.166667},
                                        {-.19245, 0},
                                        {.19245, 0}}};
constexpr std::array<Vec2, 37> grid_37{{{0, 0},
                                        {-.216506, .375},
                                        {.216506, -.375},
                                        {-.216506, -.375},
                                        {.216506, .375},
                                        {-.433013, 0},
                                        {.433013, 0},
                                        {-.144338, .25},
                                        {.144338, -.25},
                                        {-.144338, -.25},
                                        {.144338, .25},
                                        {-.288675, 0},
                                        {.288675, 0},
                                        {-.072169, .125},
                                        {.072169, -.125},
                                        {-.072169, -.125},
                                        {.072169, .125},
                                        {-.144338, 0},
                                        {.144338, 0},
                                        {-.360844, .125},
                                        {-.360844, -.125},
                                        {.360844, .125},
                                        {.360844, -.125},
                                        {-.288675, .25},
                                        {-.288675, -.25},
                                        {.288675, .25},
                                        {.288675, -.25},
                                        {-.072169, .375},
                                        {-.072169, -.375},
                                        {.072169, .375},
                                        {.072169, -.375},
                                        {-.216506, .125},
                                        {-.216506, -.125},
                                        {.216506, .125},
                                        {.216506, -.125},
                                        {0, .25},
                                        {0, -.25}}};

constexpr std::array<int, 1> chunks_7{7};
constexpr std::array<int, 3> chunks_19{7, 6, 6};
constexpr std::array<int, 8> chunks_37{7, 6, 6, 4, 4, 4, 4, 2};
constexpr int later_chunk = 4;

/// A grid that is used from `least` samples on.
struct LensGrid {
    int least;
    std::span<const Vec2> points;
    std::span<const int> chunks;
    double jitter;  ///< where there are no more samples than points
};
const std::array<LensGrid, 4> grids{{{37, grid_37, chunks_37, .0721688},
                                     {19, grid_19, chunks_19, .096225},
                                     {7, grid_7, chunks_7, .144338},
                                     {1, grid_4, {}, .25}}};

double radical_inverse(uint32_t base, uint32_t n) {
    double value = 0;
    double digit = 1.0 / base;
    for (; n > 0; n /= base, digit /= base) value += digit * (n % base);
    return value;
}

/// Fills up with points of a low-discrepancy disc that fall where no point is yet.
void add_points(std::vector<Vec2>& points, int count) {
    const auto cells = static_cast<size_t>(2.0 * std::ceil(std::sqrt(count / pi)) + 1.0);
    std::vector<bool> taken(cells * cells, false);
    const auto cell_of = [&](const Vec2& p) {
        const auto place = [&](double c) {
            return std::min(static_cast<size_t>((c + 0.5) * static_cast<double>(cells)), cells - 1);
        };
        return place(p.y) * cells + place(p.x);
    };
    for (const Vec2& p : points) taken[cell_of(p)] = true;
    int budget = 10 * count;
    uint32_t draws = 0;
    const auto draw = [&] {
        const uint32_t k = ++draws;
        --budget;
        const double radius = std::sqrt(0.25 * radical_inverse(2, k));
        const double angle = 2.0 * pi * radical_inverse(3, k);
        return Vec2{radius * std::cos(angle), radius * std::sin(angle)};
    };
    while (static_cast<int>(points.size()) < count) {
        const int index = static_cast<int>(points.size());
        Vec2 p = draw();
        while (taken[cell_of(p)] && budget > count - index) p = draw();
        taken[cell_of(p)] = true;
        points.push_back(p);
    }
}

}  // namespace

Lens::Lens(const Camera& camera, const PatternSettings& patterns) {
    if (camera.aperture == 0.0 || camera.blur_samples <= 0) return;
    const int count = camera.blur_samples;
    if (camera.bokeh) {
        has_bokeh_ = true;
        lay_bokeh(*camera.bokeh, patterns, count);
    } else {
        lay_grid(count);
    }
    thresholds_.assign(static_cast<size_t>(count), 0.0);
    if (count > 1 && camera.variance > 0.0) {
        const double p = 1.0 - camera.confidence;
        const double last = chi_square_quantile(count - 1, p);
        for (int n = 1; n <= count; ++n)
            thresholds_[static_cast<size_t>(n - 1)] = camera.variance * chi_square_quantile(n, p) / last;
    }
    radius_ = camera.aperture / 2.0;
    focal_distance_ = camera.focal_distance;
    least_ = camera.blur_samples_min;
    location_ = camera.location;
    const auto unit = [](const Vec3& v) {
        const double length = glm::length(v);
        return length > 0.0 ? v / length : v;
    };
    across_ = unit(glm::cross(camera.up, camera.direction));
    upward_ = unit(glm::cross(camera.direction, camera.right));
    direction_length_ = glm::length(camera.direction);
}

void Lens::lay_grid(int count) {
    const LensGrid& grid = *std::ranges::find_if(grids, [&](const LensGrid& g) { return count >= g.least; });
    const auto base = grid.points.first(std::min(grid.points.size(), static_cast<size_t>(count)));
    points_.assign(base.begin(), base.end());
    add_points(points_, count);
    chunks_ = grid.chunks;
    const bool exact = static_cast<size_t>(count) == grid.points.size() && !grid.chunks.empty();
    jitter_ = exact ? grid.jitter : 0.5 / std::sqrt(static_cast<double>(count));
}

/// Points fall where the pigment, over the square of the lens, is bright.
void Lens::lay_bokeh(const Pigment& pigment, const PatternSettings& patterns, int count) {
    const PigmentProgram program(pigment, patterns);
    std::mt19937 random;
    const auto uniform = [&] { return static_cast<double>(random()) * 0x1p-32; };
    uniform();
    const double all = static_cast<double>(count) * count;
    for (uint32_t draws = 1; points_.size() < static_cast<size_t>(count); ++draws) {
        const Vec2 place{radical_inverse(2, draws), radical_inverse(3, draws)};
        const Vec3 point{place, 0.0};
        Color color;
        program.evaluate({{&point, 1}}, {&color, 1});
        if (uniform() <= static_cast<double>(grey(color.rgb())) + draws / all) points_.push_back(place - 0.5);
    }
    jitter_ = 0.5 / std::sqrt(static_cast<double>(count));
}

int Lens::next_chunk(int count) const {
    int from = 0;
    int chunk = later_chunk;
    for (const int size : chunks_) {
        if (from == count) {
            chunk = size;
            break;
        }
        from += size;
    }
    return std::min(chunk, static_cast<int>(points_.size()) - count);
}

bool Lens::ray(const CameraRays& rays, double x, double y, int index, Ray& out) const {
    const auto seed =
        static_cast<uint32_t>(static_cast<int>(313.0 * x + 11.0) + static_cast<int>(311.0 * y + 17.0)) +
        static_cast<uint32_t>(index);
    const auto shift = [](uint32_t k) { return (2.0 * (shuffled_hash[k & 4095u] % 16) + 1.0) / 32.0 - 0.5; };
    double dx = shift(seed);
    double dy = shift(seed + 1);
    const Vec2 fine = position_jitter(dx, dy);
    dx += (fine.x - 0.5) / 16.0;
    dy += (fine.y - 0.5) / 16.0;
    const Vec2 moved = position_jitter(x + dx + 0.5, y + dy - 0.5);
    const Vec2& point = points_[static_cast<size_t>(index)];
    return ray_from(rays, {x + dx, y + dy}, point + 2.0 * jitter_ * moved, out);
}

bool Lens::ray(const CameraRays& rays, const Vec2& position, const Vec2& place, Ray& out) const {
    if (has_bokeh_) {
        const auto index = static_cast<size_t>(place.x * static_cast<double>(points_.size()));
        return ray_from(rays, position, points_[std::min(index, points_.size() - 1)], out);
    }
    const double radius = 0.5 * std::sqrt(place.x);
    const double angle = 2.0 * pi * place.y;
    return ray_from(rays, position, {radius * std::cos(angle), radius * std::sin(angle)}, out);
}

bool Lens::ray_from(const CameraRays& rays, const Vec2& position, const Vec2& point, Ray& out) const {
    const auto view = rays.view(position.x, position.y, 0);
    if (!view) return false;
    const Vec3 offset = radius_ * point.x * across_ - radius_ * point.y * upward_;
    out.origin = location_ + offset;
    out.direction = glm::normalize(view->direction * (focal_distance_ / direction_length_) - offset);
    rays.disturb(view->place, out.direction);
    return true;
}

void Lens::add(LensSum& sum, const CameraRay& ray, const Radiance& light) const {
    if (ray.exists) {
        sum.light.rgb += light.rgb;
        sum.light.transmit += light.transmit;
    }
    const std::array<float, 4> channels{light.rgb.x, light.rgb.y, light.rgb.z, light.transmit};
    for (size_t c = 0; c < 4; ++c) {
        const double value = static_cast<double>(channels[c]);
        sum.sums[c] += value;
        sum.squares[c] += value * value;
    }
    ++sum.count;
}

bool Lens::is_settled(const LensSum& sum) const {
    if (sum.count >= static_cast<int>(points_.size())) return true;
    if (sum.count < least_) return false;
    const double n = sum.count;
    const double limit = thresholds_[static_cast<size_t>(sum.count - 1)];
    for (size_t c = 0; c < 4; ++c) {
        const double mean = sum.sums[c] / n;
        if (!((sum.squares[c] / n - mean * mean) / n < limit)) return false;
    }
    return true;
}

}  // namespace rb
