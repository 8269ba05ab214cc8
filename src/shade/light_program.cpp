#include "shade/light_program.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <emmintrin.h>

namespace rb {

namespace {

double smooth_step(double low, double high, double x) {
    if (x < low) return 0.0;
    if (x >= high) return 1.0;
    const double u = (x - low) / (high - low);
    return (3.0 - 2.0 * u) * u * u;
}

/// Grid and jitter stay within one cell more than the axes; an oriented area may face any way.
Vec3 reach_of(const AreaGrid& grid) {
    const double share1 = 0.5 * (1.0 + 1.0 / std::max(grid.size1 - 1, 1)) + 0.01;
    const double share2 = 0.5 * (1.0 + 1.0 / std::max(grid.size2 - 1, 1)) + 0.01;
    if (grid.orient) return Vec3{glm::length(grid.axis1) * (share1 + share2)};
    return glm::abs(grid.axis1) * share1 + glm::abs(grid.axis2) * share2;
}

/// Samples of the pattern in place of so many of a jittered grid, which are noisier still
/// (docs/performance.md). More than 1024 would differ by less than a picture's last bit. `is_adaptive`: the
/// reference would look more closely at edges alone, where there are about as many points as along the grid's
/// sides.
uint32_t pattern_size(uint32_t grid_count, bool is_adaptive) {
    constexpr uint32_t fewest = 16;
    const auto along_edges = static_cast<uint32_t>(3.0 * std::sqrt(grid_count));
    const uint32_t half = std::bit_floor(grid_count / 2);
    const uint32_t enough = is_adaptive ? std::min(half, std::bit_ceil(along_edges)) : half;
    return std::clamp(enough, std::min(grid_count, fewest), 1024u);
}

/// As many as the reference looks at before it decides, or a few more.
uint32_t pilot_size(int adaptive) {
    const uint32_t side = (1u << std::clamp(adaptive, 0, 5)) + 1;
    return std::bit_ceil(side * side);
}

Vec3 unit(const Vec3& v) {
    const double length = glm::length(v);
    return length > 0.0 ? v / length : v;
}

}  // namespace

LightProgram::LightProgram(const Light& light, const Geometry* projected_through, AreaLightMode mode)
    : light_(light), projected_through_(projected_through) {
    direction_ = unit(light.point_at - light.location);
    cos_radius_ = std::cos(light.radius * (pi / 180.0));
    cos_falloff_ = std::cos(light.falloff * (pi / 180.0));
    fades_ = light.fade_power > 0.0 && std::abs(light.fade_distance) > 1e-10;
    attenuates_ = fades_ || light.kind == LightKind::spotlight || light.kind == LightKind::cylinder;
    directed_ = light.parallel || light.kind == LightKind::cylinder;
    AreaGrid& grid = light_.area;
    grid.size1 = std::max(grid.size1, 1);
    grid.size2 = std::max(grid.size2, 1);
    if (grid.orient) grid.circular = true;
    if (grid.size1 < 2 || grid.size2 < 2) grid.circular = false;
    if (!light.is_area) return;
    area_reach_ = reach_of(grid);
    set_up_area(mode);
}

void LightProgram::set_up_area(AreaLightMode mode) {
    const AreaGrid& grid = light_.area;
    if (grid.size1 > 1) grid_step_.x = 1.0 / (grid.size1 - 1);
    if (grid.size2 > 1) grid_step_.y = 1.0 / (grid.size2 - 1);
    even_ = mode == AreaLightMode::true_area;
    if (mode == AreaLightMode::grid || (mode == AreaLightMode::as_written && !grid.jitter)) return;
    density_ = {AxisDensity(grid.size1), AxisDensity(grid.size2)};
    const uint32_t pilot = pilot_size(grid.adaptive);
    pattern_count_ = pattern_size(grid_count(), pilot < grid_count());
    pilot_count_ = std::min(pilot, pattern_count_);
}

uint32_t LightProgram::grid_count() const {
    if (!light_.is_area) return 1;
    return static_cast<uint32_t>(light_.area.size1) * static_cast<uint32_t>(light_.area.size2);
}

Vec2 LightProgram::density_place(const Vec2& u) const {
    if (even_) return even_place(u);
    return {density_[0].place(u.x), density_[1].place(u.y)};
}

Vec2 LightProgram::even_place(const Vec2& u) const {
    const Vec2 size{light_.area.size1, light_.area.size2};
    return even_ ? u * (size - 1.0) : u * size - 0.5;
}

Vec2 LightProgram::area_share() const {
    const auto share = [](double step) { return step == 0.0 ? 0.0 : 0.5 * (1.0 + step) + 0.001; };
    return {share(grid_step_.x), share(grid_step_.y)};
}

void LightProgram::toward(const Vec3& p, std::span<const Vec3> offsets, std::span<LightVector> ways) const {
    if (directed_) {
        for (size_t k = 0; k < offsets.size(); ++k) {
            ways[k] = along_axis(p, offsets[k]);
        }
        return;
    }
    const __m128d one = _mm_set1_pd(1.0);
    for (size_t k = 0; k < offsets.size(); k += 2) {
        const size_t next = std::min(k + 1, offsets.size() - 1);
        const auto coordinate = [&](int axis) {
            const __m128d offset = _mm_setr_pd(offsets[k][axis], offsets[next][axis]);
            const __m128d sample = _mm_add_pd(_mm_set1_pd(light_.location[axis]), offset);
            return _mm_sub_pd(sample, _mm_set1_pd(p[axis]));
        };
        const __m128d x = coordinate(0);
        const __m128d y = coordinate(1);
        const __m128d z = coordinate(2);
        const __m128d square = _mm_add_pd(_mm_add_pd(_mm_mul_pd(x, x), _mm_mul_pd(y, y)), _mm_mul_pd(z, z));
        const __m128d distance = _mm_sqrt_pd(square);
        const __m128d is_zero = _mm_cmpeq_pd(distance, _mm_setzero_pd());
        const __m128d scale = _mm_div_pd(one, _mm_or_pd(distance, _mm_and_pd(is_zero, one)));
        const __m128d unit_x = _mm_mul_pd(x, scale);
        const __m128d unit_y = _mm_mul_pd(y, scale);
        const __m128d unit_z = _mm_mul_pd(z, scale);
        // In the pieces in which a LightVector is read.
        const auto store = [](LightVector& way, __m128d xy, double to_z, double length) {
            _mm_storeu_pd(&way.direction.x, xy);
            way.direction.z = to_z;
            way.distance = length;
        };
        store(ways[next], _mm_unpackhi_pd(unit_x, unit_y), _mm_cvtsd_f64(_mm_unpackhi_pd(unit_z, unit_z)),
              _mm_cvtsd_f64(_mm_unpackhi_pd(distance, distance)));
        store(ways[k], _mm_unpacklo_pd(unit_x, unit_y), _mm_cvtsd_f64(unit_z), _mm_cvtsd_f64(distance));
    }
}

LightVector LightProgram::along_axis(const Vec3& p, const Vec3& offset) const {
    const Vec3 way = light_.location + offset - p;
    if (light_.kind == LightKind::cylinder || light_.is_area) {
        const Vec3 l = unit(light_.location + offset - light_.point_at);
        return {l, glm::dot(way, l)};
    }
    return {-direction_, glm::dot(way, -direction_)};
}

double LightProgram::spot_cone(const LightVector& way) const {
    const double c =
        way.distance > 0.0 ? -glm::dot(way.direction, direction_) : glm::dot(way.direction, direction_);
    if (c <= 0.0) return 0.0;
    double cone = light_.tightness == 0.0 ? 1.0 : std::pow(c, light_.tightness);
    if (cos_radius_ > 0.0 && c < cos_radius_) cone *= smooth_step(cos_falloff_, cos_radius_, c);
    return cone;
}

double LightProgram::cylinder_cone(const Vec3& p) const {
    const Vec3 away = p - light_.location;
    const double k = glm::dot(away, direction_);
    if (k <= 0.0) return 0.0;
    const double radius = glm::length(away - k * direction_);
    if (radius >= light_.falloff) return 0.0;
    const double u = 1.0 - radius / light_.falloff;
    double cone = light_.tightness == 0.0 ? 1.0 : std::pow(u, light_.tightness);
    if (light_.radius > 0.0 && radius > light_.radius) {
        cone *= smooth_step(0.0, 1.0 - light_.radius / light_.falloff, u);
    }
    return cone;
}

double LightProgram::cone(const Vec3& p, const LightVector& way) const {
    if (light_.kind == LightKind::spotlight) return spot_cone(way);
    if (light_.kind == LightKind::cylinder) return cylinder_cone(p);
    return 1.0;
}

double LightProgram::fading(double distance) const {
    return fades_ ? 2.0 / (1.0 + std::pow(distance / light_.fade_distance, light_.fade_power)) : 1.0;
}

double LightProgram::cone_and_fading(const Vec3& p, const LightVector& way) const {
    const double factor = cone(p, way);
    return factor != 0.0 ? factor * fading(way.distance) : factor;
}

}  // namespace rb
