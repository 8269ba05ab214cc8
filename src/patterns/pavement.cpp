// pavement (manual 3.4.7.1.24): copies of one polyform - squares, triangles or hexagons of six triangles put
// together - tile the xz plane. 1 on the border of a tile, falling to 0 in the middle of each cell.
#include "patterns/formula.h"
#include "patterns/pavement_tables.h"

#include <algorithm>

namespace rb {

namespace {

struct PavementOptions {
    int sides = 3;
    int tiles = 1;
    int pattern = 1;
    int exterior = 0;  ///< how corners that stand out are drawn
    int interior = 0;  ///< how corners that go in are drawn
    int form = 0;      ///< rounds the tile where three sides of a cell are joined
};

constexpr double h = 0.86602540378443864676;  ///< height of the triangle of side 1

/// Of a coordinate that may be too large for whole numbers.
int64_t whole(double floor) { return std::abs(floor) < 1e15 ? static_cast<int64_t>(floor) : 0; }
bool has(unsigned mask, unsigned bits) { return (mask & bits) == bits; }

double norm(int kind, const Vec2& d) {
    if (kind == 0) return std::max(d.x, d.y);
    return kind == 1 ? d.x + d.y : glm::length(d);
}

/// A corner of the unit square: the mask of the cell around it, or its bits.
struct Corner {
    unsigned bits;
    Vec2 at;
};

double square_value(const PavementOptions& o, unsigned mask, const Vec2& p) {
    const auto doubled = [&](const Vec2& corner) { return 2.0 * glm::abs(p - corner); };
    const int form = o.form % 4;
    constexpr Corner turns[]{{0x16, {0, 1}}, {0x2C, {1, 1}}, {0x49, {1, 0}}, {0x83, {0, 0}}};
    for (const Corner& turn : turns) {
        if (form == 3 || !has(mask, turn.bits)) continue;
        const double v = std::abs(norm(form, doubled(turn.at)) - 1.0);
        return form == 0 ? v : std::min(v, 1.0);
    }
    double v = 0.0;
    if (has(mask, 1)) v = std::max(v, 2.0 * p.y - 1.0);
    if (has(mask, 2)) v = std::max(v, 2.0 * p.x - 1.0);
    if (has(mask, 4)) v = std::max(v, 1.0 - 2.0 * p.y);
    if (has(mask, 8)) v = std::max(v, 1.0 - 2.0 * p.x);
    constexpr Corner inward[]{{0x10, {0, 1}}, {0x20, {1, 1}}, {0x40, {1, 0}}, {0x80, {0, 0}}};
    for (const Corner& corner : inward) {
        if (has(mask, corner.bits)) v = std::max(v, 1.0 - norm(o.interior % 3, doubled(corner.at)));
    }
    constexpr Corner outward[]{{0x06, {1, 0}}, {0x0C, {0, 0}}, {0x09, {0, 1}}, {0x03, {1, 1}}};
    for (const Corner& corner : outward) {
        if (!has(mask, corner.bits)) continue;
        const Vec2 d = doubled(corner.at);
        if (o.exterior % 3 == 1) v = std::max(v, std::min(1.0, 2.0 - d.x - d.y));
        if (o.exterior % 3 == 2 && d.x <= 1.0 && d.y <= 1.0)
            v = std::max(v, std::min(1.0, glm::length(1.0 - d)));
    }
    return v;
}

/// A place in the triangle (0,0), (1,0), (1/2,h), with what the formulas share.
class TrianglePlace {
public:
    explicit TrianglePlace(const Vec2& p) : u(p.x), w(p.y) {}

    double left() const { return 1.0 - 2.0 * h * std::abs(2.0 * h * u - w); }
    double right() const { return 1.0 - 2.0 * h * std::abs(2.0 * h * (1.0 - u) - w); }
    double bottom() const { return 1.0 - 4.0 * h * w; }
    double distance(double x, double z) const { return std::hypot(u - x, w - z); }

    const double u;
    const double w;
    // Positive towards the left corner (1, against the right side's direction), and so on round the triangle.
    const double d1 = 1.0 - std::abs(2.0 * h * w + u);
    const double d2 = 1.0 - std::abs(2.0 * h * w - u + 1.0);
    const double d3 = 1.0 - 2.0 * u;
};

/// Where the tile goes on around a corner of the triangle: at the top, left, right.
double inner_corners(int kind, bool top, bool left, bool right, const TrianglePlace& p) {
    const double u = p.u;
    const double w = p.w;
    double v = 0.0;
    if (kind == 0) {
        if (top) v = std::max(v, 1.0 - 4.0 * h * (h - w));
        if (left) v = std::max(v, 1.0 - 2.0 * h * std::abs(2.0 * h * u + w));
        if (right) v = std::max(v, 1.0 - 2.0 * h * std::abs(2.0 * h * (u - 1.0) - w));
    } else if (kind == 1) {
        const double along = 1.5 * std::abs(2.0 * h * w + u);
        const double back = 1.5 * std::abs(2.0 * h * w - u + 1.0);
        if (top && p.d1 < 0.0 && p.d2 < 0.0) v = std::max(v, std::min(along - 2.0, back - 2.0));
        if (left && p.d1 > 0.0 && p.d3 > 0.0) v = std::max(v, std::min(1.0 - along, 1.0 - 3.0 * u));
        if (right && p.d3 < 0.0 && p.d2 > 0.0) v = std::max(v, std::min(1.0 - back, 3.0 * u - 2.0));
    } else if (kind == 2) {
        if (top) v = std::max(v, 1.0 - 3.0 * p.distance(0.5, h));
        if (left) v = std::max(v, 1.0 - 3.0 * p.distance(0.0, 0.0));
        if (right) v = std::max(v, 1.0 - 3.0 * p.distance(1.0, 0.0));
    }
    return v;
}

/// Corners of the tile, where two sides of the cell lie on its border; `v` where there is none.
double outer_corners(int kind, unsigned mask, const TrianglePlace& p, double v) {
    const double x = p.u - 0.5;
    const double z = p.w - h / 3.0;
    if (kind == 2) {
        const bool rounds = (has(mask, 3) && p.d1 <= 0.0 && p.d2 <= 0.0) ||
                            (has(mask, 6) && p.d2 >= 0.0 && p.d3 <= 0.0) ||
                            (has(mask, 5) && p.d1 >= 0.0 && p.d3 >= 0.0);
        return rounds ? std::min(1.0, 4.0 * h * std::hypot(x, z)) : v;
    }
    if (kind != 1) return v;
    if (has(mask, 3) && p.left() >= 0.0 && p.right() >= 0.0) v = std::min(1.0, std::abs(4.0 * h * z));
    if (has(mask, 6) && p.right() >= 0.0 && p.bottom() >= 0.0)
        v = std::min(1.0, 2.0 * h * std::abs(2.0 * h * x - z));
    if (has(mask, 5) && p.left() >= 0.0 && p.bottom() >= 0.0)
        v = std::min(1.0, 2.0 * h * std::abs(2.0 * h * x + z));
    return v;
}

/// Where a side of the tile turns into a corner that goes in, a form draws one curve.
double formed(int form, unsigned mask, const TrianglePlace& p, double v) {
    struct Turn {
        unsigned bits;
        bool lies_there;
        Vec2 centre;
        double depth;
    };
    const bool at_top = p.d1 < 0.0 && p.d2 < 0.0;
    const bool at_left = p.d1 > 0.0 && p.d3 > 0.0;
    const bool at_right = p.d3 < 0.0 && p.d2 > 0.0;
    const Turn turns[]{{0x120, at_top, {0, 0}, -p.d1}, {0x140, at_left, {0.5, h}, p.d1},
                       {0x210, at_top, {1, 0}, -p.d2}, {0x240, at_right, {0.5, h}, p.d2},
                       {0x410, at_left, {1, 0}, p.d3}, {0x420, at_right, {0, 0}, -p.d3}};
    for (const Turn& turn : turns) {
        if (!has(mask, turn.bits) || !turn.lies_there) continue;
        if (form == 1) return std::min(1.0, 2.0 * turn.depth);
        return std::clamp(4.0 * h * (p.distance(turn.centre.x, turn.centre.y) - 2.0 * h / 3.0), 0.0, 1.0);
    }
    return v;
}

double triangle_value(const PavementOptions& o, unsigned mask, const TrianglePlace& p) {
    double v = 0.0;
    if (has(mask, 1)) v = std::max(v, p.left());
    if (has(mask, 2)) v = std::max(v, p.right());
    if (has(mask, 4)) v = std::max(v, p.bottom());
    const bool hexagons = o.sides == 6;
    const bool top = (mask & 0x83) == 0 || (hexagons && has(mask, 0x4000));
    const bool left = (mask & 0x85) == 0 || (hexagons && has(mask, 0x2000));
    const bool right = (mask & 0x86) == 0 || (hexagons && has(mask, 0x1000));
    v = std::max(v, inner_corners(o.interior % 3, top, left, right, p));
    if (!hexagons) v = outer_corners(o.exterior % 3, mask, p, v);
    return o.form % 3 == 0 ? v : formed(o.form % 3, mask, p, v);
}

/// A triangle by its half column and row, and a place in it, mirrored if the triangle points down.
struct TriangleCell {
    int64_t i;
    int64_t j;
    Vec2 place;
};
TriangleCell triangle_cell(double x, double z) {
    const double column = quick_floor(x);
    const double row = quick_floor(z / (2.0 * h));
    TriangleCell cell{2 * whole(column), 2 * whole(row), {x - column, z - 2.0 * h * row}};
    double& u = cell.place.x;
    double& w = cell.place.y;
    if (w > h) {
        w -= h;
        const bool right_half = u > 0.5;
        u += right_half ? -0.5 : 0.5;
        cell.i += right_half ? 1 : -1;
        cell.j += 1;
    }
    if (u == 0.0 || w / u > 2.0 * h) {
        w = h - w;
        u = 0.5 - u;
        cell.i -= 1;
    }
    if (u == 1.0 || w / (1.0 - u) > 2.0 * h) {
        w = h - w;
        u = 1.5 - u;
        cell.i += 1;
    }
    return cell;
}

class Pavement final : public PointPattern<Pavement> {
public:
    explicit Pavement(const PavementOptions& chosen) : options(chosen) {
        if (const auto* layout = find_pavement(options.sides, options.tiles, options.pattern)) {
            repeat_ = layout->repeat;
            masks_ = layout->decoded();
        }
    }
    std::string_view keyword() const override { return "pavement"; }
    std::string describe() const override {
        const PavementOptions& o = options;
        return fmt::format("pavement {}/{}/{} exterior {} interior {} form {}", o.sides, o.tiles, o.pattern,
                           o.exterior, o.interior, o.form);
    }
    bool exists() const { return !masks_.empty(); }
    double value(const Vec3& p) const {
        if (!exists()) return 0.0;
        if (options.sides == 4) {
            const double column = quick_floor(p.x);
            const double row = quick_floor(p.z);
            return square_value(options, mask(whole(column), whole(row)), {p.x - column, p.z - row});
        }
        const TriangleCell cell = triangle_cell(p.x, p.z);
        return triangle_value(options, mask(cell.i, cell.j), TrianglePlace(cell.place));
    }

    const PavementOptions options;

private:
    unsigned mask(int64_t i, int64_t j) const { return masks_[repeat_.index(i, j)]; }

    PavementLayout::Repeat repeat_{};
    std::vector<uint16_t> masks_;
};

PatternPtr read_parameter(BlockReader& in, const PatternPtr& so_far) {
    PavementOptions o = static_cast<const Pavement&>(*so_far).options;
    const SourceRange at = in.where();
    if (in.take_word("number_of_sides")) {
        o.sides = in.integer();
        if (o.sides != 3 && o.sides != 4 && o.sides != 6)
            in.fail_at(at, "number_of_sides of pavement must be 3, 4 or 6.");
    } else if (in.take_word("number_of_tiles")) {
        o.tiles = in.integer();
    } else if (in.take_word("pattern")) {
        o.pattern = in.integer();
    } else if (in.take_word("exterior")) {
        o.exterior = in.integer();
    } else if (in.take_word("interior")) {
        o.interior = in.integer();
    } else if (in.take_word("form")) {
        o.form = in.integer();
    } else {
        return nullptr;
    }
    return std::make_shared<Pavement>(o);
}

/// Which numbers go together is known when all have been read.
std::string check(const Pattern& pattern) {
    const auto& pavement = static_cast<const Pavement&>(pattern);
    if (pavement.exists()) return {};
    const int most = most_pavement_tiles(pavement.options.sides);
    if (pavement.options.tiles < 1 || pavement.options.tiles > most)
        return fmt::format("number_of_tiles of pavement must be between 1 and {}.", most);
    return fmt::format("A pavement of {} tiles with {} sides has no pattern {}.", pavement.options.tiles,
                       pavement.options.sides, pavement.options.pattern);
}

}  // namespace

namespace patterns {
extern const PatternKind pavement;
const PatternKind pavement{
    .keyword = "pavement",
    .read = [](BlockReader&) -> PatternPtr { return std::make_shared<Pavement>(PavementOptions{}); },
    .read_parameter = read_parameter,
    .check = check,
    .example = "pavement number_of_sides 4 number_of_tiles 3 pattern 2 exterior 1 interior 1 form 1"};
}  // namespace patterns

}  // namespace rb
