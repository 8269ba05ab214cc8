#pragma once
#include "scene/shape.h"

#include <algorithm>
#include <cmath>

namespace rb {

/// Makes all crossing queries of a shape from one function of `S`:
///     template <class Sink> void each_crossing(const ShapeRay& ray, Sink&& sink) const;
/// which hands every crossing, in any order and without regard to t_min and t_max, to sink(t, part, at). It
/// may leave out those beyond sink.reach().
template <class S>
class RayShape : public Shape {
public:
    void crossings(const ShapeRay& ray, Crossings& out) const final {
        self().each_crossing(ray, AllCrossings{ray, out});
    }

    bool closest(const ShapeRay& ray, const CrossingFilter* filter, Crossing& nearest) const override {
        bool found = false;
        self().each_crossing(ray, NearestCrossing{ray.t_min, finite(ray.t_max), filter, nearest, found});
        return found;
    }

    bool any(const ShapeRay& ray, const CrossingFilter* filter, Crossing& crossing) const override {
        bool found = false;
        self().each_crossing(ray, FirstCrossing{ray.t_min, finite(ray.t_max), filter, crossing, found});
        return found;
    }

private:
    /// Overflow is no place.
    static double finite(double t) { return std::min(t, std::numeric_limits<double>::max()); }

    struct AllCrossings {
        const ShapeRay& ray;
        Crossings& out;

        void operator()(double t, uint32_t part, const Vec2& at) {
            if (t > ray.t_min && t <= finite(ray.t_max)) out.add({t, part, at});
        }
        double reach() const { return ray.t_max; }
    };

    struct NearestCrossing {
        double t_min;
        double best;
        const CrossingFilter* filter;
        Crossing& nearest;
        bool& found;

        void operator()(double t, uint32_t part, const Vec2& at) {
            if (!(t > t_min && t <= best)) return;
            if (filter && !filter->counts({t, part, at})) return;
            nearest.t = t;
            nearest.part = part;
            nearest.at = at;
            best = t;
            found = true;
        }
        double reach() const { return best; }
    };

    struct FirstCrossing {
        double t_min;
        double t_max;
        const CrossingFilter* filter;
        Crossing& crossing;
        bool& found;

        void operator()(double t, uint32_t part, const Vec2& at) {
            if (found || !(t > t_min && t <= t_max)) return;
            crossing = {t, part, at};
            found = !filter || filter->counts(crossing);
        }
        double reach() const { return found ? -std::numeric_limits<double>::infinity() : t_max; }
    };

    const S& self() const { return static_cast<const S&>(*this); }
};

/// If `map` is rotation, uniform scale, translation and perhaps a mirror: its scale factor, else 0.
inline double similarity_scale(const Affine& map) {
    const double a = glm::dot(map.row[0], map.row[0]);
    const double b = glm::dot(map.row[1], map.row[1]);
    const double c = glm::dot(map.row[2], map.row[2]);
    const double tolerance = 1e-12 * a;
    if (std::abs(a - b) > tolerance || std::abs(a - c) > tolerance) return 0.0;
    if (std::abs(glm::dot(map.row[0], map.row[1])) > tolerance ||
        std::abs(glm::dot(map.row[0], map.row[2])) > tolerance ||
        std::abs(glm::dot(map.row[1], map.row[2])) > tolerance) {
        return 0.0;
    }
    return std::sqrt(a);
}

/// `angle` of the point (x, z) as a share of the full turn in [0, 1): 0 at +x, 1/4 at +z (spec:
/// geometry 9.1).
inline double turn_share(double x, double z) {
    const double rho = std::hypot(x, z);
    if (rho == 0.0) return 0.0;
    const double share = std::acos(std::fmin(std::fmax(x / rho, -1.0), 1.0)) / (2.0 * pi);
    return z < 0.0 ? 1.0 - share : share;
}

}  // namespace rb
