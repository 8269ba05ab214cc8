#include "radiosity/irradiance_cache.h"

#include "math/random.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

/// A place below a record sees what the record does not.
constexpr double behind = -0.05;

/// What a record says of a place near it. A gradient may not make light out of nothing.
Rgb extrapolated(const IrradianceRecord& record, const Vec3& point, const Vec3& normal) {
    const Rgb change = record.translation.along(point - record.point) +
                       record.rotation.along(glm::cross(record.normal, normal));
    return glm::clamp(record.mean + change, 0.5f * record.mean, 2.0f * record.mean);
}

}  // namespace

size_t IrradianceCache::HashCell::operator()(const Cell& cell) const {
    const uint64_t xy = mixed(static_cast<uint64_t>(cell.x), static_cast<uint64_t>(cell.y));
    return mixed(xy, static_cast<uint64_t>(cell.z));
}

IrradianceCache::Cell IrradianceCache::Level::cell_of(const Vec3& point) const {
    constexpr double far = 0x1p60;
    const Vec3 scaled = glm::clamp(glm::floor(point / cell_size), -far, far);
    return {static_cast<int64_t>(scaled.x), static_cast<int64_t>(scaled.y), static_cast<int64_t>(scaled.z)};
}

void IrradianceCache::insert(const IrradianceRecord& record) {
    const double reach = record.radius * bound_;
    // Places whose neighbours double precision cannot tell apart are of no use.
    if (!(reach > 1e-9 * max_component(glm::abs(record.point))) || !std::isfinite(reach)) return;
    const int exponent = static_cast<int>(std::ceil(std::log2(2.0 * reach)));
    Level& level = levels_[exponent];
    level.cell_size = std::ldexp(1.0, exponent);
    constexpr double rounding = 1e-9;
    const Entry entry{record.point, reach * reach * (1.0 + rounding), static_cast<uint32_t>(records_.size())};
    records_.push_back(record);
    const Cell low = level.cell_of(record.point - Vec3{reach});
    const Cell high = level.cell_of(record.point + Vec3{reach});
    for (int64_t z = low.z; z <= high.z; ++z) {
        for (int64_t y = low.y; y <= high.y; ++y) {
            for (int64_t x = low.x; x <= high.x; ++x) level.cells[{x, y, z}].push_back(entry);
        }
    }
}

double IrradianceCache::weight_of(const IrradianceRecord& record, const Vec3& point,
                                  const Vec3& normal) const {
    const double turned = glm::dot(normal, record.normal);
    const Vec3 way = point - record.point;
    const double distance = glm::length(way);
    const double error = distance / record.radius + 2.0 * std::sqrt(std::max(0.0, 1.0 - turned));
    if (!(error < bound_)) return 0.0;
    const Vec3 both = normal + record.normal;
    if (glm::dot(way, both) < behind * distance * glm::length(both)) return 0.0;
    return 1.0 - error / bound_;
}

IrradianceCache::Found IrradianceCache::look_up(const Vec3& point, const Vec3& normal) const {
    Found found;
    for (const auto& [exponent, level] : levels_) {
        const auto cell = level.cells.find(level.cell_of(point));
        if (cell == level.cells.end()) continue;
        for (const Entry& entry : cell->second) {
            const Vec3 way = point - entry.point;
            if (glm::dot(way, way) > entry.reach_squared) continue;
            const IrradianceRecord& record = records_[entry.record];
            const double weight = weight_of(record, point, normal);
            if (weight <= 0.0) continue;
            found.weight += weight;
            found.mean += static_cast<float>(weight) * extrapolated(record, point, normal);
        }
    }
    if (found.weight > 0.0) found.mean /= static_cast<float>(found.weight);
    return found;
}

}  // namespace rb
