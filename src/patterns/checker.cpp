// checker COLOR, COLOR   (manual 3.4.7.1.4): unit cubes of two kinds in turn.
#include "patterns/formula.h"
#include "patterns/line_bound.h"
#include "patterns/noise.h"

#include <array>

namespace rb {

namespace {

class Checker final : public Pattern {
public:
    std::string_view keyword() const override { return "checker"; }
    void evaluate(const PatternContext&, std::span<const Vec3> points,
                  std::span<double> values) const override {
        for (size_t i = 0; i < points.size(); ++i) {
            const Vec3& p = points[i];
            const double cell = quick_floor(p.x + tiny) + quick_floor(p.y + tiny) + quick_floor(p.z + tiny);
            values[i] = is_odd(cell) ? 1.0 : 0.0;
        }
    }
    IntervalSlope bound(const PatternContext&, const LinePlace& place) const override {
        const Interval cell =
            floor(place[0].value + tiny) + floor(place[1].value + tiny) + floor(place[2].value + tiny);
        // Sums of whole numbers are exact but for the bound on their rounding.
        const Interval whole{std::ceil(cell.lo), std::floor(cell.hi)};
        if (!whole.is_point()) return somewhere_in(0.0, 1.0);
        return is_odd(whole.lo) ? 1.0 : 0.0;
    }
};

PatternPtr read(BlockReader&) { return std::make_shared<Checker>(); }

constexpr std::array<Color, 2> default_list{Color{0, 0, 1, 0, 0}, Color{0, 1, 0, 0, 0}};

}  // namespace

namespace patterns {
extern const PatternKind checker;
const PatternKind checker{.keyword = "checker",
                          .read = read,
                          .list_size = 2,
                          .default_list = default_list,
                          .default_frequency = 0,
                          .example = "checker"};
}  // namespace patterns

}  // namespace rb
