#pragma once
#include "radiosity/gradient.h"

#include <cstdint>
#include <map>
#include <unordered_map>
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
};

/// Records of indirect light by place, for interpolation (Ward, Rubinstein and Clear 1988, "A Ray Tracing
/// Solution for Diffuse Interreflection"). Lookups may run at once, but not together with insert().
class IrradianceCache {
public:
    /// `bound`: error up to which a record is used.
    explicit IrradianceCache(double bound) : bound_(bound) {}

    void insert(const IrradianceRecord& record);

    struct Found {
        Rgb mean{0.0f};
        double weight = 0;  ///< sum over the records used, each up to 1; 0: nothing is known here
    };
    Found look_up(const Vec3& point, const Vec3& normal) const;

    size_t size() const { return records_.size(); }

private:
    struct Cell {
        int64_t x, y, z;
        friend bool operator==(const Cell&, const Cell&) = default;
    };
    struct HashCell {
        size_t operator()(const Cell& cell) const;
    };
    /// A record, as cells have it: most that are asked are too far away.
    struct Entry {
        Vec3 point{0.0};
        double reach_squared = 0;  ///< or a little more
        uint32_t record = 0;
    };
    /// Cells of a size that holds the reach of its records in at most two along each axis.
    struct Level {
        double cell_size = 1;
        std::unordered_map<Cell, std::vector<Entry>, HashCell> cells;

        Cell cell_of(const Vec3& point) const;
    };
    double weight_of(const IrradianceRecord& record, const Vec3& point, const Vec3& normal) const;

    double bound_;
    std::vector<IrradianceRecord> records_;
    std::map<int, Level> levels_;  ///< by exponent of the cell size
};

}  // namespace rb
