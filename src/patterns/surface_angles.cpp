// slope, aoi (manual 3.4.7.1.2, 3.4.7.1.32): patterns of the angle between a surface and a direction.
#include "patterns/formula.h"
#include "patterns/noise.h"

#include <algorithm>

namespace rb {

namespace {

class AngleOfIncidence final : public Pattern {
public:
    std::string_view keyword() const override { return "aoi"; }
    SurfaceNeed surface_need() const override { return SurfaceNeed::view; }
    void evaluate(const PatternContext& context, std::span<const Vec3>,
                  std::span<double> values) const override {
        std::fill(values.begin(), values.end(), 0.0);
        if (!context.surface) return;
        for (size_t i = 0; i < values.size(); ++i) {
            const uint32_t row = context.rows[i];
            const double c = glm::dot(glm::normalize(context.surface->normals[row]),
                                      glm::normalize(context.surface->directions[row]));
            values[i] = std::acos(std::clamp(c, -1.0, 1.0)) / pi;
        }
    }
};

struct SlopeShape {
    Vec3 direction{0.0, 1.0, 0.0};
    bool toward_point = false;
    double low = 0;
    double high = 0;
    Vec3 altitude{0.0};
    double altitude_low = 0;
    double altitude_high = 0;
};

double rescaled(double v, double low, double high) { return high != low ? (v - low) / (high - low) : v; }

/// Into [0, 1).
double wrapped(double v) {
    if (v == 1.0) return 1.0 - tiny;
    return v < 0.0 ? 1.0 + std::fmod(v, 1.0) : std::fmod(v, 1.0);
}

class Slope final : public Pattern {
public:
    explicit Slope(const SlopeShape& chosen) : shape_(chosen) {}
    std::string_view keyword() const override { return "slope"; }
    SurfaceNeed surface_need() const override { return SurfaceNeed::place; }
    std::string describe() const override {
        return fmt::format("slope <{},{},{}> point_at {} {}..{}", shape_.direction.x, shape_.direction.y,
                           shape_.direction.z, shape_.toward_point, shape_.low, shape_.high);
    }
    void evaluate(const PatternContext& context, std::span<const Vec3> points,
                  std::span<double> values) const override {
        std::fill(values.begin(), values.end(), 0.0);
        if (!context.surface) return;
        for (size_t i = 0; i < values.size(); ++i) {
            const uint32_t row = context.rows[i];
            values[i] = value(context.surface->normals[row], context.surface->points[row], points[i]);
        }
    }

private:
    double value(const Vec3& normal, const Vec3& place, const Vec3& point) const {
        const Vec3 toward = shape_.toward_point ? shape_.direction - place : shape_.direction;
        const double length = glm::length(toward);
        const double c = length > 0.0 ? std::clamp(glm::dot(normal, toward) / length, -1.0, 1.0) : 0.0;
        const double s = rescaled(0.5 * (1.0 + 2.0 / pi * std::asin(c)), shape_.low, shape_.high);
        const double altitude_length = glm::length(shape_.altitude);
        if (altitude_length == 0.0) return wrapped(s);
        const double h = rescaled(glm::dot(point, shape_.altitude) / altitude_length, shape_.altitude_low,
                                  shape_.altitude_high);
        const double share = length / (length + altitude_length);
        const double mixed = share * s + (1.0 - share) * h;
        return mixed >= 1.0 && mixed < 1.0 + tiny ? mixed - tiny : wrapped(mixed);
    }

    SlopeShape shape_;
};

void read_range(BlockReader& in, double& low, double& high) {
    if (!in.at_number()) return;
    low = in.number();
    high = in.at_number() ? in.number() : 0.0;
    if (low == high && low != 0.0) {
        in.diagnostics().warning(in.block_where(),
                                 "Zero slope range. Ignoring the low and high slope values.");
    }
}

constexpr const char* no_direction = "Zero length for both slope and gradient.";

PatternPtr read_slope(BlockReader& outer) {
    SlopeShape shape;
    if (!outer.at_block("slope")) {
        const SourceRange at = outer.where();
        shape.direction = outer.vec3();
        if (shape.direction == Vec3{0.0}) outer.fail_at(at, no_direction);
        return std::make_shared<Slope>(shape);
    }
    BlockReader in(outer.block("slope"), outer.context());
    shape.toward_point = in.take_word("point_at");
    shape.direction = in.vec3();
    read_range(in, shape.low, shape.high);
    if (in.take_word("altitude")) {
        if (shape.toward_point)
            in.fail("Keyword 'altitude' cannot be used with 'point_at' in slope pattern.");
        shape.altitude = in.vec3();
        read_range(in, shape.altitude_low, shape.altitude_high);
    }
    in.finish();
    if (shape.direction == Vec3{0.0} && shape.altitude == Vec3{0.0}) {
        in.fail_at(in.block_where(), no_direction);
    }
    return std::make_shared<Slope>(shape);
}

}  // namespace

namespace patterns {
extern const PatternKind aoi;
const PatternKind aoi{.keyword = "aoi", .read = read_plain<AngleOfIncidence>, .example = "aoi"};
extern const PatternKind slope;
const PatternKind slope{.keyword = "slope", .read = read_slope, .example = "slope <0, 1, 0>"};
}  // namespace patterns

}  // namespace rb
