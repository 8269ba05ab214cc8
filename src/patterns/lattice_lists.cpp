// hexagon, square, triangular (lists in the xz plane) and cubic (a list by the six faces of a cube); manual
// 3.4.7.1.
#include "patterns/formula.h"
#include "patterns/line_bound.h"
#include "patterns/noise.h"
#include "patterns/quad.h"

#include <algorithm>
#include <array>

namespace rb {

namespace {

constexpr double root3 = 1.7320508075688772;

/// The number of a hexagon among 0, 1, 2, from what numbers its kind when counted on.
RB_INLINE double hexagon_kind(double index) {
    // Whole numbers: the quotient is never rounded up to the next one.
    if (std::abs(index) < 1e15) return index - 3.0 * std::floor(index / 3.0);
    const double kind = std::fmod(index, 3.0);
    return kind < 0.0 ? kind + 3.0 : kind;
}

/// Where the middle of a point's hexagon is, and its number.
struct HexagonPlace {
    double x;
    double z;
    double index;
};

/// Centres are at (1.5 i, root3 (j + i/2)); the nearest is among those of the two nearest columns.
RB_INLINE void find_hexagon(const Vec3& p, HexagonPlace& place) {
    const double column = std::floor(p.x / 1.5);
    double best = 1e300;
    place = {0.0, 0.0, 0.0};
    for (const double i : {column, column + 1.0}) {
        const double dx = p.x - 1.5 * i;
        const double below = std::floor(p.z / root3 - 0.5 * i);
        for (const double j : {below, below + 1.0}) {
            const double z = root3 * (j + 0.5 * i);
            const double d = dx * dx + (p.z - z) * (p.z - z);
            const bool nearer = (d < best - 1e-9) | ((d < best + 1e-9) & (z > place.z));
            best = nearer ? d : best;
            place.x = nearer ? 1.5 * i : place.x;
            place.z = nearer ? z : place.z;
            place.index = nearer ? 2.0 * i + j : place.index;
        }
    }
}

RB_FOR_EACH_TARGET void hexagon_values(std::span<const Vec3> points, std::span<double> values) {
    HexagonPlace place;
    for (size_t k = 0; k < points.size(); ++k) {
        find_hexagon(points[k], place);
        values[k] = hexagon_kind(place.index);
    }
}

class Hexagon final : public Pattern {
public:
    std::string_view keyword() const override { return "hexagon"; }
    void evaluate(const PatternContext&, std::span<const Vec3> points,
                  std::span<double> values) const override {
        hexagon_values(points, values);
    }
    IntervalSlope bound(const PatternContext&, const LinePlace& line) const override {
        const Interval& x = line[0].value;
        const Interval& z = line[2].value;
        HexagonPlace place;
        find_hexagon({0.5 * (x.lo + x.hi), 0.0, 0.5 * (z.lo + z.hi)}, place);
        // Farthest from the middle, across each pair of sides.
        const Interval across = Interval(0.5 * root3) * (x - place.x);
        const Interval along = z - place.z;
        constexpr double rounding = 1e-6;
        const double farthest =
            std::max({abs(along).hi, abs(across + 0.5 * along).hi, abs(across - 0.5 * along).hi});
        if (farthest < 0.5 * root3 - rounding) return hexagon_kind(place.index);
        return somewhere_in(0.0, 2.0);
    }
};

class Square final : public PointPattern<Square> {
public:
    std::string_view keyword() const override { return "square"; }
    double value(const Vec3& p) const {
        const bool a = std::fmod(std::floor(p.x), 2.0) != 0.0;
        const bool b = std::fmod(std::floor(p.z), 2.0) != 0.0;
        return a ? (b ? 2.0 : 3.0) : (b ? 1.0 : 0.0);
    }
};

class Triangular final : public PointPattern<Triangular> {
public:
    std::string_view keyword() const override { return "triangular"; }
    double value(const Vec3& p) const {
        constexpr double height = root3 / 2.0;
        double w = p.z - root3 * std::floor(p.z / root3);
        const bool mirrored = w >= height;
        if (mirrored) w = root3 - w;
        const double a = std::floor(p.x);
        const double u = p.x - a;
        double v;
        if (w < root3 * u && w < root3 * (1.0 - u)) {
            v = modulo6(-2.0 * a);
        } else {
            v = modulo6(1.0 + 2.0 * (u < 0.5 ? a : a + 1.0));
        }
        return mirrored ? 5.0 - v : v;
    }

private:
    static double modulo6(double v) { return v - 6.0 * std::floor(v / 6.0); }
};

class Cubic final : public PointPattern<Cubic> {
public:
    std::string_view keyword() const override { return "cubic"; }
    double value(const Vec3& p) const {
        const double x = std::abs(p.x);
        const double y = std::abs(p.y);
        const double z = std::abs(p.z);
        if (p.x >= 0.0 && x >= y && x >= z) return 0.0;
        if (p.y >= 0.0 && y >= x && y >= z) return 1.0;
        if (p.z >= 0.0 && z >= x && z >= y) return 2.0;
        if (p.x < 0.0 && x >= y && x >= z) return 3.0;
        if (p.y < 0.0 && y >= x && y >= z) return 4.0;
        return 5.0;
    }
};

constexpr Color red{1, 0, 0, 0, 0};
constexpr Color green{0, 1, 0, 0, 0};
constexpr Color blue{0, 0, 1, 0, 0};
constexpr Color yellow{1, 1, 0, 0, 0};
constexpr Color cyan{0, 1, 1, 0, 0};
constexpr Color magenta{1, 0, 1, 0, 0};
constexpr std::array three{blue, green, red};
constexpr std::array four{red, green, blue, yellow};
constexpr std::array six{red, green, blue, yellow, cyan, magenta};

}  // namespace

namespace patterns {
extern const PatternKind hexagon;
const PatternKind hexagon{.keyword = "hexagon",
                          .read = read_plain<Hexagon>,
                          .list_size = 3,
                          .default_list = three,
                          .default_frequency = 0,
                          .example = "hexagon"};
extern const PatternKind square;
const PatternKind square{.keyword = "square",
                         .read = read_plain<Square>,
                         .list_size = 4,
                         .default_list = four,
                         .default_frequency = 0,
                         .example = "square"};
extern const PatternKind triangular;
const PatternKind triangular{.keyword = "triangular",
                             .read = read_plain<Triangular>,
                             .list_size = 6,
                             .default_list = six,
                             .default_frequency = 0,
                             .example = "triangular"};
extern const PatternKind cubic;
const PatternKind cubic{.keyword = "cubic",
                        .read = read_plain<Cubic>,
                        .list_size = 6,
                        .default_list = six,
                        .default_frequency = 0,
                        .example = "cubic"};
}  // namespace patterns

}  // namespace rb
