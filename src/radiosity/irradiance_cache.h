#pragma once
#include "radiosity/gradient.h"

#include <cstdint>
#include <vector>

namespace rb {

/// What was gathered at a place, and how far it is good for.
struct IrradianceRecord {
    Vec3 point{0.0};
    Vec3 normal{0.0};
    Rgb mean{0.0f};
    Gradient rotation;     ///< change of the mean with the normal turned about an axis
    Gradient translation;  ///< change of the mean with the place
    double radius = 0;     ///< the error grows by 1 over it
    /// Likewise, for places whose light is known to be alike (see smoothed()).
    double wide_radius = 0;
    double variance = 0;  ///< of the mean, by chance; mean over the channels
};

/// How far a turn of the normal counts as an error: its gradient answers for most of it.
double error_of_turn(const Vec3& from, const Vec3& to);

/// Records of indirect light by place, for interpolation (Ward, Rubinstein and Clear 1988, "A Ray Tracing
/// Solution for Diffuse Interreflection"). Lookups may run at once, but not together with insert().
class IrradianceCache {
public:
    /// `bound`: error up to which a record is used.
    explicit IrradianceCache(double bound) : bound_(bound) {}

    void insert(const IrradianceRecord& record);

    /// The same records, where they are, with other light.
    void relight(std::vector<IrradianceRecord> records) { records_ = std::move(records); }

    struct Found {
        Rgb mean{0.0f};
        double weight = 0;  ///< sum over the records used, each up to 1; 0: nothing is known here
    };
    Found look_up(const Vec3& point, const Vec3& normal) const;

    /// In the order in which they came.
    const std::vector<IrradianceRecord>& records() const { return records_; }
    size_t size() const { return records_.size(); }

private:
    /// A record, as nodes have it: most that are asked are too far away.
    struct Entry {
        Vec3 point{0.0};
        double reach_squared = 0;  ///< or a little more
        uint32_t record = 0;
    };
    /// A cube of an octree; it holds records that reach into it and about as far as it is large.
    struct Node {
        std::array<uint32_t, 8> children{};  ///< 0: none
        std::vector<Entry> entries;
    };
    struct Cube {
        Vec3 center{0.0};
        double half = 0;

        /// Which eighth a point is in, and the cube of it.
        size_t octant_of(const Vec3& point) const {
            return (point.x >= center.x ? 1u : 0u) | (point.y >= center.y ? 2u : 0u) |
                   (point.z >= center.z ? 4u : 0u);
        }
        Cube eighth(size_t octant) const {
            const double step = 0.5 * half;
            return {center +
                        Vec3{octant & 1 ? step : -step, octant & 2 ? step : -step, octant & 4 ? step : -step},
                    step};
        }
        bool contains(const Vec3& point) const { return max_component(glm::abs(point - center)) <= half; }
    };
    void grow_towards(const Vec3& point);
    void put(uint32_t node, const Cube& cube, const Entry& entry, double reach);
    double weight_of(const IrradianceRecord& record, const Vec3& point, const Vec3& normal) const;

    double bound_;
    std::vector<IrradianceRecord> records_;
    std::vector<Node> nodes_;  ///< the first is the root
    Cube root_;
};

}  // namespace rb
