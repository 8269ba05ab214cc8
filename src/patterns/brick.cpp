// brick COLOR, COLOR [brick_size <v>] [mortar f] (manual 3.4.7.1.6): mortar is the first of the list.
#include "patterns/formula.h"
#include "patterns/line_bound.h"
#include "patterns/noise.h"
#include "patterns/quad.h"

#include <array>

namespace rb {

namespace {

/// What decides where mortar is: the brick's size, half of which every second course is shifted by, and the
/// joint's width, also as a share of each.
struct Courses {
    Vec3 size;
    double joint;
    Vec3 share;
};

/// Without branches: which joint a point is in, if any, is nothing that a processor could foresee.
RB_FOR_EACH_TARGET void brick_values(const Courses& courses, std::span<const Vec3> points,
                                     std::span<double> values) {
    const double joint = courses.joint;
    for (size_t i = 0; i < points.size(); ++i) {
        const Vec3& p = points[i];
        const double x = (p.x + tiny + joint) / courses.size.x;
        const double y = (p.y + tiny + joint) / courses.size.y;
        const double z = (p.z + tiny + joint) / courses.size.z;
        // Along x and along z in turn.
        const double shift_x = fraction(0.5 * y) <= 0.5 ? 0.0 : 0.5;
        const double across = fraction(x + shift_x);
        const double along = fraction(z + (0.5 - shift_x));
        const bool mortar =
            (fraction(y) <= courses.share.y) | (across <= courses.share.x) | (along <= courses.share.z);
        values[i] = mortar ? 0.0 : 1.0;
    }
}

class Brick final : public Pattern {
public:
    Brick(const Vec3& brick_size, double mortar_width) : size(brick_size), mortar(mortar_width) {
        courses_.size = size;
        courses_.joint = single(single(mortar_width) - 2.0 * tiny);
        courses_.share = courses_.joint / size;
    }
    std::string_view keyword() const override { return "brick"; }
    std::string describe() const override {
        return fmt::format("brick brick_size <{},{},{}> mortar {}", size.x, size.y, size.z, mortar);
    }
    void evaluate(const PatternContext&, std::span<const Vec3> points,
                  std::span<double> values) const override {
        brick_values(courses_, points, values);
    }
    IntervalSlope bound(const PatternContext&, const LinePlace& place) const override {
        const auto counted = [&](int axis) {
            return (place[static_cast<size_t>(axis)].value + tiny + courses_.joint) / courses_.size[axis];
        };
        // The share of a brick between two of a point's coordinates, and whether it is in the joint.
        const auto share = [](const Interval& v) { return fraction({v, 0.0}).value; };
        const auto all_joint = [&](const Interval& v, int axis) {
            return share(v).hi <= courses_.share[axis];
        };
        const auto no_joint = [&](const Interval& v, int axis) { return share(v).lo > courses_.share[axis]; };
        const Interval y = counted(1);
        if (all_joint(y, 1)) return 0.0;
        const Interval course = share(0.5 * y);
        const bool is_first = course.hi <= 0.5;
        if (!is_first && !(course.lo > 0.5)) return somewhere_in(0.0, 1.0);
        const Interval x = counted(0) + (is_first ? 0.0 : 0.5);
        const Interval z = counted(2) + (is_first ? 0.5 : 0.0);
        if (all_joint(x, 0) || all_joint(z, 2)) return 0.0;
        if (no_joint(x, 0) && no_joint(y, 1) && no_joint(z, 2)) return 1.0;
        return somewhere_in(0.0, 1.0);
    }

    const Vec3 size;
    const double mortar;

private:
    Courses courses_;
};

PatternPtr read(BlockReader&) { return std::make_shared<Brick>(Vec3{8.0, 3.0, 4.5}, 0.5); }
PatternPtr read_parameter(BlockReader& in, const PatternPtr& so_far) {
    const auto& b = static_cast<const Brick&>(*so_far);
    if (in.take_word("brick_size")) return std::make_shared<Brick>(in.vec3(), b.mortar);
    if (in.take_word("mortar")) return std::make_shared<Brick>(b.size, in.number());
    return nullptr;
}

constexpr std::array<Color, 2> default_list{Color{0.5f, 0.5f, 0.5f, 0, 0}, Color{0.6f, 0.15f, 0.15f, 0, 0}};

}  // namespace

namespace patterns {
extern const PatternKind brick;
const PatternKind brick{.keyword = "brick",
                        .read = read,
                        .read_parameter = read_parameter,
                        .list_size = 2,
                        .default_list = default_list,
                        .default_frequency = 0,
                        .example = "brick"};
}  // namespace patterns

}  // namespace rb
