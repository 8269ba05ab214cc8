#include "radiosity/irradiance_cache.h"

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

double error_of_turn(const Vec3& from, const Vec3& to) {
    constexpr double share_of_chord = 0.5;
    return share_of_chord * std::sqrt(std::max(0.0, 1.0 - glm::dot(from, to)));
}

void IrradianceCache::insert(const IrradianceRecord& record) {
    const double reach = record.radius * bound_;
    // Places whose neighbours double precision cannot tell apart are of no use.
    if (!(reach > 1e-9 * max_component(glm::abs(record.point))) || !std::isfinite(reach)) return;
    constexpr double rounding = 1e-9;
    const Entry entry{record.point, reach * reach * (1.0 + rounding), static_cast<uint32_t>(records_.size())};
    records_.push_back(record);
    if (nodes_.empty()) {
        nodes_.emplace_back();
        root_ = {record.point, std::exp2(std::ceil(std::log2(reach)))};
    }
    for (const double side : {-reach, reach}) {
        while (!root_.contains(record.point + Vec3{side})) grow_towards(record.point + Vec3{side});
    }
    put(0, root_, entry, reach);
}

/// The root becomes an eighth of a new one.
void IrradianceCache::grow_towards(const Vec3& point) {
    const size_t octant = root_.octant_of(point);
    const Cube whole{root_.center + (2.0 * (root_.eighth(octant).center - root_.center)), 2.0 * root_.half};
    const size_t old = whole.octant_of(root_.center);
    nodes_.push_back(std::move(nodes_.front()));
    nodes_.front() = {};
    nodes_.front().children[old] = static_cast<uint32_t>(nodes_.size() - 1);
    root_ = whole;
}

void IrradianceCache::put(uint32_t node, const Cube& cube, const Entry& entry, double reach) {
    if (cube.half < reach) {
        nodes_[node].entries.push_back(entry);
        return;
    }
    for (size_t octant = 0; octant < 8; ++octant) {
        const Cube part = cube.eighth(octant);
        if (max_component(glm::abs(entry.point - part.center)) > part.half + reach) continue;
        if (nodes_[node].children[octant] == 0) {
            nodes_[node].children[octant] = static_cast<uint32_t>(nodes_.size());
            nodes_.emplace_back();
        }
        put(nodes_[node].children[octant], part, entry, reach);
    }
}

double IrradianceCache::weight_of(const IrradianceRecord& record, const Vec3& point,
                                  const Vec3& normal) const {
    const Vec3 way = point - record.point;
    const double distance = glm::length(way);
    const double error = distance / record.radius + error_of_turn(record.normal, normal);
    if (!(error < bound_)) return 0.0;
    const Vec3 both = normal + record.normal;
    if (glm::dot(way, both) < behind * distance * glm::length(both)) return 0.0;
    return 1.0 - error / bound_;
}

IrradianceCache::Found IrradianceCache::look_up(const Vec3& point, const Vec3& normal) const {
    Found found;
    if (nodes_.empty() || !root_.contains(point)) return found;
    Cube cube = root_;
    for (const Node* node = &nodes_.front();;) {
        for (const Entry& entry : node->entries) {
            const Vec3 way = point - entry.point;
            if (glm::dot(way, way) > entry.reach_squared) continue;
            const IrradianceRecord& record = records_[entry.record];
            const double weight = weight_of(record, point, normal);
            if (weight <= 0.0) continue;
            found.weight += weight;
            found.mean += static_cast<float>(weight) * extrapolated(record, point, normal);
        }
        const size_t octant = cube.octant_of(point);
        if (node->children[octant] == 0) break;
        node = &nodes_[node->children[octant]];
        cube = cube.eighth(octant);
    }
    if (found.weight > 0.0) found.mean /= static_cast<float>(found.weight);
    return found;
}

}  // namespace rb
