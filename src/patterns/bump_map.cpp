// bump_map (manual 3.4.6.2.5): a picture as heights, whose slopes turn the normal.
#include "patterns/formula.h"
#include "patterns/image_field.h"

namespace rb {

namespace {

/// The neighbours of a pixel wrap around; at most two pixels over the edge.
double around(double v, double size) {
    if (v < 0.0) return v + size;
    return v >= size ? v - size : v;
}

class BumpMap final : public PointPattern<BumpMap> {
public:
    explicit BumpMap(ImageField field) : field_(std::move(field)) {}
    std::string_view keyword() const override { return "bump_map"; }
    double value(const Vec3& p) const {
        const auto place = field_.place(p);
        return place ? height(*place) : 0.0;
    }

    bool perturb(const PatternContext&, float amount, std::span<const Vec3> points,
                 std::span<Vec3> normals) const override {
        const double strength = field_.options().amount.value_or(amount);
        for (size_t i = 0; i < points.size(); ++i) {
            if (const auto place = field_.place(points[i])) normals[i] = turned(*place, strength, normals[i]);
        }
        return true;
    }

private:
    double height(const Vec2& place) const {
        if (field_.options().use_index && field_.texels().has_palette()) return field_.index(place);
        return static_cast<double>(grey(field_.color(place).rgb()));
    }

    /// By the triangle through the heights here and at the two pixels below, in a frame about the normal.
    Vec3 turned(const Vec2& at, double strength, const Vec3& n) const {
        const double width = field_.texels().width();
        const double below = around(at.y + 1.0, field_.texels().height());
        const double left = around(at.x - 1.0, width);
        const double right = around(left + 2.0, width);
        const Vec3 p1{0.0, strength * height(at), 0.0};
        const Vec3 p2{-1.0, strength * height({left, below}), 1.0};
        const Vec3 p3{1.0, strength * height({right, below}), 1.0};
        const Vec3 bump = glm::normalize(glm::cross(p3 - p2, p1 - p2));
        Vec3 up = n;
        Vec3 across = glm::cross(n, Vec3{0.0, 1.0, 0.0});
        const double length = glm::length(across);
        if (length < tiny) {
            across = {1.0, 0.0, 0.0};
            up = {0.0, n.y < 0.0 ? -1.0 : 1.0, 0.0};
        } else {
            across /= length;
        }
        const Vec3 along = glm::normalize(glm::cross(across, up));
        return bump.x * across + bump.y * up - bump.z * along;
    }

    static constexpr double tiny = 1e-10;
    ImageField field_;
};

}  // namespace

namespace patterns {
extern const PatternKind bump_map;
const PatternKind bump_map{.keyword = "bump_map",
                           .read = read_picture<BumpMap>,
                           .default_frequency = 0,
                           .only_in = "normal",
                           .example = "bump_map { function 4, 3 { pattern { gradient y } } bump_size 2 }"};
}  // namespace patterns

}  // namespace rb
