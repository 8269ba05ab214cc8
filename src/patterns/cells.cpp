// cells (manual 3.4.7.1.8): a random value per unit cube.
#include "patterns/formula.h"
#include "patterns/line_bound.h"
#include "patterns/noise.h"
#include "patterns/noise_tables.h"

namespace rb {

namespace {

class Cells final : public PointPattern<Cells> {
public:
    std::string_view keyword() const override { return "cells"; }
    double value(const Vec3& p) const { return uniform_table()[hash3(cell(p.x), cell(p.y), cell(p.z))]; }
    IntervalSlope bound(const PatternContext&, const LinePlace& place) const override {
        Vec3 p;
        for (int i = 0; i < 3; ++i) {
            const Interval& v = place[static_cast<size_t>(i)].value;
            if (cell(v.lo) != cell(v.hi)) return somewhere_in(0.0, 1.0);
            p[i] = v.lo;
        }
        return value(p);
    }

private:
    static uint32_t cell(double v) { return static_cast<uint32_t>(truncated(std::floor(v + tiny))); }
};

}  // namespace

namespace patterns {
extern const PatternKind cells;
const PatternKind cells{.keyword = "cells", .read = read_plain<Cells>, .example = "cells"};
}  // namespace patterns

}  // namespace rb
