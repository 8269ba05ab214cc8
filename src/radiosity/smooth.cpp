#include "radiosity/smooth.h"

#include "base/parallel.h"
#include "math/basis.h"
#include "math/bounds.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rb {

namespace {

/// The places of records in a tree of halves: the middle of each range parts the others by their coordinates
/// along one axis.
class PlaceTree {
public:
    explicit PlaceTree(std::span<const IrradianceRecord> records)
        : records_(records), order_(records.size()), axes_(records.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        part(0, order_.size());
    }

    /// Calls visit(record) for those up to `reach` away from a point.
    template <class Visit>
    void each_near(const Vec3& point, double reach, const Visit& visit) const {
        each_near(0, order_.size(), point, reach, visit);
    }

private:
    void part(size_t begin, size_t end) {
        if (end - begin < 2) return;
        Bounds box;
        for (size_t i = begin; i < end; ++i) box.include(records_[order_[i]].point);
        const int axis = longest_axis(box.hi - box.lo);
        const size_t middle = begin + (end - begin) / 2;
        const auto at = [this](size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
        // Places may be the same: their numbers keep the order one and only.
        std::nth_element(at(begin), at(middle), at(end), [&](uint32_t a, uint32_t b) {
            const double x = records_[a].point[axis];
            const double y = records_[b].point[axis];
            return x < y || (x == y && a < b);
        });
        axes_[middle] = static_cast<uint8_t>(axis);
        part(begin, middle);
        part(middle + 1, end);
    }

    template <class Visit>
    void each_near(size_t begin, size_t end, const Vec3& point, double reach, const Visit& visit) const {
        if (begin == end) return;
        const size_t middle = begin + (end - begin) / 2;
        const IrradianceRecord& record = records_[order_[middle]];
        const double beyond = point[axes_[middle]] - record.point[axes_[middle]];
        if (beyond <= reach) each_near(begin, middle, point, reach, visit);
        const Vec3 way = point - record.point;
        if (glm::dot(way, way) <= reach * reach) visit(record);
        if (-beyond <= reach) each_near(middle + 1, end, point, reach, visit);
    }

    std::span<const IrradianceRecord> records_;
    std::vector<uint32_t> order_;
    std::vector<uint8_t> axes_;
};

/// How much two records have to say about each other's places: 1 at the same one, 0 beyond the bound.
double weight_of(const IrradianceRecord& a, const IrradianceRecord& b, double bound) {
    // Sines of the angle between the way and the surface: what lies higher or lower is another surface.
    constexpr double flat = 0.05;
    const Vec3 way = b.point - a.point;
    const double distance = glm::length(way);
    const Vec3 both = a.normal + b.normal;
    if (std::abs(glm::dot(way, both)) > flat * distance * glm::length(both)) return 0.0;
    const double error =
        distance / std::min(a.wide_radius, b.wide_radius) + error_of_turn(a.normal, b.normal);
    return std::max(0.0, 1.0 - error / bound);
}

/// A record's light at the place of another one. By the mean of both gradients, which is right to the second
/// order: tangents alone lie above whatever is brightest in the middle.
Rgb carried(const IrradianceRecord& from, const IrradianceRecord& to) {
    const Vec3 way = to.point - from.point;
    const Vec3 turn = glm::cross(from.normal, to.normal);
    const Rgb change = from.translation.along(way) + to.translation.along(way) + from.rotation.along(turn) +
                       to.rotation.along(turn);
    return glm::max(from.mean + 0.5f * change, 0.0f);
}

/// 1 where two means are the same, 0 from where chance does not explain how they differ.
double likeness(const Rgb& a, const Rgb& b, double variance) {
    // Standard deviations of the difference.
    constexpr double most = 2.5;
    constexpr double channels = 3.0;
    const Rgb apart = a - b;
    const double square = static_cast<double>(glm::dot(apart, apart)) / channels;
    return square == 0.0 ? 1.0 : std::max(0.0, 1.0 - square / (most * most * variance));
}

IrradianceRecord smoothed(const IrradianceRecord& record, const PlaceTree& places, double bound) {
    Rgb sum(0.0f);
    double weights = 0;
    double variances = 0;
    places.each_near(record.point, bound * record.wide_radius, [&](const IrradianceRecord& other) {
        double weight = weight_of(record, other, bound);
        if (weight == 0.0) return;
        const Rgb mean = carried(other, record);
        weight *= likeness(record.mean, mean, record.variance + other.variance);
        weights += weight;
        variances += weight * weight * other.variance;
        sum += static_cast<float>(weight) * mean;
    });
    // A bound so small that rounding makes a record too far from itself.
    if (weights == 0.0) return record;
    IrradianceRecord result = record;
    result.variance = variances / (weights * weights);
    result.mean = sum / static_cast<float>(weights);
    return result;
}

}  // namespace

std::vector<IrradianceRecord> smoothed(std::span<const IrradianceRecord> records, double bound, int threads) {
    constexpr double wider = 3.0;
    constexpr size_t chunk = 64;
    const PlaceTree places(records);
    std::vector<IrradianceRecord> result(records.size());
    parallel_for((records.size() + chunk - 1) / chunk, threads, [&](size_t c) {
        for (size_t i = c * chunk; i < std::min(records.size(), (c + 1) * chunk); ++i)
            result[i] = smoothed(records[i], places, wider * bound);
    });
    return result;
}

}  // namespace rb
