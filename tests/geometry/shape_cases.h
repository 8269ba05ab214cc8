#pragma once
#include "compile/world.h"
#include "math/transform.h"
#include "shapes/registry.h"

#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace rb {

/// A statement that makes one shape: what property tests and the stress suite run on.
struct ShapeCase {
    std::string name;
    std::string_view statement;
    const ShapeKind* kind = nullptr;
};

/// The example of every registered shape, then further forms that take other ways through the code.
const std::vector<ShapeCase>& shape_cases();

ShapePtr shape_from(std::string_view statement);

/// True if surface and solid end together: a patch has no inside, a disc's half-space and a height field's go
/// on without a surface.
bool bounds_a_body(const Shape& shape);

/// False for shapes whose normals follow the order of their points, as the language has it.
bool has_outward_normals(const Shape& shape);

/// The statement's object, moved.
ObjectPtr placed(std::string_view statement, const Transform& map);

World world_of(const std::vector<ObjectPtr>& objects, const CompileOptions& options = {});

/// Random numbers.
class Dice {
public:
    explicit Dice(uint64_t seed) : random_(seed) {}
    double unit() { return unit_(random_); }
    double between(double a, double b) { return a + (b - a) * unit(); }
    /// Spread evenly over the exponents.
    double scale(double least, double most) { return std::exp(between(std::log(least), std::log(most))); }
    size_t below(size_t n) { return static_cast<size_t>(unit() * static_cast<double>(n)); }
    bool coin() { return unit() < 0.5; }
    Vec3 direction() { return glm::normalize(Vec3{normal_(random_), normal_(random_), normal_(random_)}); }
    Vec3 point(double half) { return Vec3{2 * unit() - 1, 2 * unit() - 1, 2 * unit() - 1} * half; }

private:
    std::mt19937_64 random_;
    std::uniform_real_distribution<double> unit_{0, 1};
    std::normal_distribution<double> normal_;
};

}  // namespace rb
