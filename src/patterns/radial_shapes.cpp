// onion, leopard, radial, boxed, planar, spherical, cylindrical (manual 3.4.7.1): simple functions of the
// distance to a point, an axis or a plane.
#include "base/scratch.h"
#include "patterns/formula.h"
#include "patterns/line_bound.h"
#include "patterns/sine.h"

#include <algorithm>
#include <array>

namespace rb {

namespace {

class Onion final : public PointPattern<Onion> {
public:
    std::string_view keyword() const override { return "onion"; }
    double value(const Vec3& p) const { return std::fmod(glm::length(p), 1.0); }
    IntervalSlope bound(const PatternContext&, const LinePlace& place) const override {
        return fmod(length(place), 1.0);
    }
};

class Leopard final : public Pattern {
public:
    std::string_view keyword() const override { return "leopard"; }
    void evaluate(const PatternContext&, std::span<const Vec3> points,
                  std::span<double> values) const override {
        const size_t count = points.size();
        Scratch::Scope memory(thread_scratch());
        const auto waves = memory.take<double>(3 * count);
        for (size_t i = 0; i < count; ++i) {
            waves[i] = points[i].x;
            waves[count + i] = points[i].y;
            waves[2 * count + i] = points[i].z;
        }
        sines(waves);
        for (size_t i = 0; i < count; ++i) {
            const double mean = (waves[i] + waves[count + i] + waves[2 * count + i]) / 3.0;
            values[i] = mean * mean;
        }
    }
    IntervalSlope bound(const PatternContext&, const LinePlace& place) const override {
        return square((sin(place[0]) + sin(place[1]) + sin(place[2])) / 3.0);
    }
};

class Radial final : public PointPattern<Radial> {
public:
    std::string_view keyword() const override { return "radial"; }
    double value(const Vec3& p) const {
        if (std::abs(p.x) < 0.001 && std::abs(p.z) < 0.001) return 0.25;
        return 0.25 + (std::atan2(p.x, p.z) + pi) / (2.0 * pi);
    }
    IntervalSlope bound(const PatternContext&, const LinePlace& place) const override {
        const auto reaches_axis = [](const Interval& v) { return v.lo < 0.001 && v.hi > -0.001; };
        if (reaches_axis(place[0].value) && reaches_axis(place[2].value)) return somewhere_in(0.25, 1.25);
        return 0.25 + (atan2(place[0], place[2]) + pi) / (2.0 * pi);
    }
};

class Boxed final : public PointPattern<Boxed> {
public:
    std::string_view keyword() const override { return "boxed"; }
    double value(const Vec3& p) const {
        return faded(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
    }
    IntervalSlope bound(const PatternContext&, const LinePlace& place) const override {
        return faded(max(max(abs(place[0]), abs(place[1])), abs(place[2])));
    }
};

class Planar final : public PointPattern<Planar> {
public:
    std::string_view keyword() const override { return "planar"; }
    double value(const Vec3& p) const { return faded(std::abs(p.y)); }
    IntervalSlope bound(const PatternContext&, const LinePlace& place) const override {
        return faded(abs(place[1]));
    }
};

class Spherical final : public PointPattern<Spherical> {
public:
    std::string_view keyword() const override { return "spherical"; }
    double value(const Vec3& p) const { return faded(glm::length(p)); }
    IntervalSlope bound(const PatternContext&, const LinePlace& place) const override {
        return faded(length(place));
    }
};

class Cylindrical final : public PointPattern<Cylindrical> {
public:
    std::string_view keyword() const override { return "cylindrical"; }
    double value(const Vec3& p) const { return faded(std::sqrt(p.x * p.x + p.z * p.z)); }
    IntervalSlope bound(const PatternContext&, const LinePlace& place) const override {
        return faded(length(std::array{place[0], place[2]}));
    }
};

ColorMap radial_map() {
    return {{0.0f, {0, 1, 1, 0, 0}},
            {0.333f, {1, 1, 0, 0, 0}},
            {0.666f, {1, 0, 1, 0, 0}},
            {1.0f, {0, 1, 1, 0, 0}}};
}

}  // namespace

namespace patterns {
extern const PatternKind onion;
const PatternKind onion{.keyword = "onion", .read = read_plain<Onion>, .example = "onion"};
extern const PatternKind leopard;
const PatternKind leopard{.keyword = "leopard", .read = read_plain<Leopard>, .example = "leopard"};
extern const PatternKind radial;
const PatternKind radial{
    .keyword = "radial", .read = read_plain<Radial>, .default_map = radial_map, .example = "radial"};
extern const PatternKind boxed;
const PatternKind boxed{.keyword = "boxed", .read = read_plain<Boxed>, .example = "boxed"};
extern const PatternKind planar;
const PatternKind planar{.keyword = "planar", .read = read_plain<Planar>, .example = "planar"};
extern const PatternKind spherical;
const PatternKind spherical{.keyword = "spherical", .read = read_plain<Spherical>, .example = "spherical"};
extern const PatternKind cylindrical;
const PatternKind cylindrical{
    .keyword = "cylindrical", .read = read_plain<Cylindrical>, .example = "cylindrical"};
}  // namespace patterns

}  // namespace rb
