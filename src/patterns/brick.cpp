// brick COLOR, COLOR [brick_size <v>] [mortar f] (manual 3.4.7.1.6): mortar is the first of the list.
#include "patterns/formula.h"
#include "patterns/noise.h"

#include <array>

namespace rb {

namespace {

class Brick final : public PointPattern<Brick> {
public:
    Brick(const Vec3& brick_size, double mortar_width)
        : size(brick_size), mortar(mortar_width), joint_(single(single(mortar_width) - 2.0 * tiny)) {}
    std::string_view keyword() const override { return "brick"; }
    std::string describe() const override {
        return fmt::format("brick brick_size <{},{},{}> mortar {}", size.x, size.y, size.z, mortar);
    }
    double value(const Vec3& p) const {
        const double x = (p.x + tiny + joint_) / size.x;
        const double y = (p.y + tiny + joint_) / size.y;
        const double z = (p.z + tiny + joint_) / size.z;
        if (fraction(y) <= joint_ / size.y) return 0.0;
        // Every second course is shifted by half a brick, along x and along z in turn.
        const double shift_x = fraction(0.5 * y) <= 0.5 ? 0.0 : 0.5;
        if (fraction(x + shift_x) <= joint_ / size.x) return 0.0;
        if (fraction(z + (0.5 - shift_x)) <= joint_ / size.z) return 0.0;
        return 1.0;
    }

    const Vec3 size;
    const double mortar;

private:
    double joint_;
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
