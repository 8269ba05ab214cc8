// sphere { <center>, radius }   (manual 3.5.1.1)
#include "shapes/registry.h"

#include <cmath>

#include <fmt/format.h>

namespace rb {

namespace {

class Sphere final : public Shape {
public:
    Sphere(const Vec3& center, double radius) : center_(center), radius_(std::abs(radius)) {}

    std::string_view keyword() const override { return "sphere"; }
    Bounds bounds() const override { return {center_ - radius_, center_ + radius_}; }
    bool inside(const Vec3& p) const override {
        const Vec3 q = p - center_;
        return glm::dot(q, q) < radius_ * radius_;
    }
    void crossings(const Ray&, double, double, bool, Crossings&) const override {}
    Vec3 normal(const Vec3& p, const Crossing&) const override { return p - center_; }
    std::optional<TriangleMesh> tessellate(double) const override { return std::nullopt; }
    std::string describe() const override {
        return fmt::format("center <{},{},{}> radius {}", center_.x, center_.y, center_.z, radius_);
    }

private:
    Vec3 center_;
    double radius_;
};

ShapePtr read(BlockReader& in) {
    const Vec3 center = in.vec3();
    const double radius = in.number();
    return std::make_shared<Sphere>(center, radius);
}

}  // namespace

namespace shapes {
extern const ShapeKind sphere;
const ShapeKind sphere{"sphere", read, "sphere { <0.3, -0.2, 0.1>, 0.7 }"};
}  // namespace shapes

}  // namespace rb
