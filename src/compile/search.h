#pragma once
#include "compile/compound.h"
#include "compile/geometry_parts.h"

#include <algorithm>
#include <cmath>

namespace rb {

/// Bound on rounding per unit of coordinate, with room for a shape's own frame and solver.
constexpr double coordinate_error = 1e-14;

/// CSG and clips at a candidate crossing.
class SolidFilter final : public CrossingFilter {
public:
    SolidFilter(const FlatGeometry& flat, uint32_t leaf, const Ray& ray)
        : solids_(flat.solids), leaf_(flat.leaves[leaf]), box_(flat.boxes[leaf]), ray_(ray) {}
    bool counts(const Crossing& crossing) const override {
        Vec3 p = ray_.at(crossing.t);
        if (!box_.contains(p) && is_far(p)) return false;
        if (leaf_.in_world_space) leaf_.shape->snap(crossing, p);
        return solids_.counts(leaf_.solid, p, ray_);
    }

private:
    /// Farther from the box in which crossings count than rounding may have moved it.
    bool is_far(const Vec3& p) const {
        constexpr double rounding = 1e-9;
        const Vec3 slack{rounding * (largest_magnitude(p) + largest_magnitude(p - ray_.origin))};
        return !Bounds{box_.lo - slack, box_.hi + slack}.contains(p);
    }

    const SolidForest& solids_;
    const Leaf& leaf_;
    const Bounds& box_;
    const Ray& ray_;
};

/// One query on its way through the elements.
class Search {
public:
    Search(const Geometry::Parts& parts, const RayQuery& query)
        : parts_(parts), query_(query), ray_{query.ray} {
        ray_.t_min = query.t_min;
        if (query.origin_leaf != no_leaf) set_origin_error();
    }

    /// Within a Compound: `query` repeats what `outer`, of any length, asks there.
    Search(const Geometry::Parts& parts, const RayQuery& query, const ShapeRay& outer)
        : parts_(parts),
          query_(query),
          per_speed_(1.0 / glm::dot(query.ray.direction, query.ray.direction)),
          ray_{query.ray} {
        ray_.t_min = query.t_min;
        if (outer.starts_on_surface || outer.origin_error > 0.0) {
            ray_.origin_error =
                std::max(query.origin_error, coordinate_error * largest_magnitude(query.ray.origin));
        }
    }

    /// The nearest crossing that counts: fills leaf and crossing of the hit.
    [[gnu::always_inline]] bool closest(const Candidates* candidates, Hit& hit) const {
        double t_best = query_.t_max;
        hit.leaf = no_leaf;
        Crossing crossing;
        const auto take = [&](uint32_t element) {
            const uint32_t leaf = parts_.elements[element].leaf;
            if (hit.leaf != no_leaf && crossing.t == t_best && leaf >= hit.leaf) return;
            t_best = crossing.t;
            hit.leaf = leaf;
            hit.crossing.t = crossing.t;
            hit.crossing.part = crossing.part;
            hit.crossing.member = crossing.member;
            hit.crossing.at = crossing.at;
        };
        const auto try_listed = [&](uint32_t i) {
            if (test_listed<false>(i, t_best, crossing)) take(i);
        };
        const auto try_boxed = [&](uint32_t i) {
            if (test<false>(parts_.listed + i, t_best, crossing)) take(parts_.listed + i);
            return false;
        };
        if (candidates) {
            for (size_t i = 0; i < candidates->listed_count; ++i) try_listed(candidates->listed[i]);
            candidates->boxes.walk(query_.ray, query_.mask, ray_.t_min, t_best, try_boxed);
        } else {
            for (uint32_t i = 0; i < parts_.listed; ++i) try_listed(i);
            parts_.tree.walk(query_.ray, query_.mask, ray_.t_min, t_best, try_boxed);
        }
        return hit.leaf != no_leaf;
    }

    /// An element that any crossing was found of, or no_leaf; `without` has been tried.
    [[gnu::always_inline]] uint32_t any(const Candidates* candidates, uint32_t without,
                                        Crossing& found) const {
        uint32_t met = no_leaf;
        const auto listed_blocks = [&](uint32_t i) {
            if (i == without || !test_listed<true>(i, query_.t_max, found)) return false;
            met = i;
            return true;
        };
        const auto boxed_blocks = [&](uint32_t i) {
            const uint32_t element = parts_.listed + i;
            if (element == without || !test<true>(element, query_.t_max, found)) return false;
            met = element;
            return true;
        };
        if (candidates) {
            for (size_t i = 0; i < candidates->listed_count; ++i) {
                if (listed_blocks(candidates->listed[i])) return met;
            }
            candidates->boxes.walk(query_.ray, query_.mask, ray_.t_min, query_.t_max, boxed_blocks);
            return met;
        }
        for (uint32_t i = 0; i < parts_.listed; ++i) {
            if (listed_blocks(i)) return met;
        }
        parts_.tree.walk(query_.ray, query_.mask, ray_.t_min, query_.t_max, boxed_blocks);
        return met;
    }

    /// True if the ray misses a listed element for sure, within t_min and t_max.
    bool passes_by(uint32_t element, double t_max) const {
        const PlaneTest& plane = parts_.planes[element];
        if (plane.normal == Vec3{0.0}) return false;
        const double height = plane.distance - glm::dot(plane.normal, query_.ray.origin);
        const double slope = glm::dot(plane.normal, query_.ray.direction);
        constexpr double rounding = 1.0 - 1e-13;
        return (height < 0.0) != (slope < 0.0) || std::abs(height) * rounding > std::abs(slope) * t_max;
    }

    template <bool any>
    bool test_listed(uint32_t element, double t_max, Crossing& found) const {
        const Element& e = parts_.elements[element];
        return (e.mask & query_.mask) != 0 && !passes_by(element, t_max) && ask<any>(e, t_max, found);
    }

    /// For an element with one of the query's mask bits.
    template <bool any>
    bool test(uint32_t element, double t_max, Crossing& found) const {
        const Element& e = parts_.elements[element];
        return !misses_ball(e) && ask<any>(e, t_max, found);
    }

private:
    void set_origin_error() {
        ray_.origin_error =
            std::max(query_.origin_error, coordinate_error * largest_magnitude(query_.ray.origin));
        ray_.t_min = std::max(ray_.t_min, 4.0 * ray_.origin_error);
    }

    bool misses_ball(const Element& e) const {
        const double radius = static_cast<double>(e.radius);
        if (radius == std::numeric_limits<double>::infinity()) return false;
        const Vec3 from = query_.ray.origin - Vec3(e.center);
        const double middle = -glm::dot(from, query_.ray.direction) * per_speed_;
        const Vec3 foot = from + middle * query_.ray.direction;
        constexpr double rounding = 1e-13;
        return glm::dot(foot, foot) > radius * radius + rounding * glm::dot(from, from);
    }

    template <bool any>
    [[gnu::always_inline]] bool ask(const Element& e, double t_max, Crossing& found) const {
        const bool starts = e.leaf == query_.origin_leaf;
        ray_.t_max = t_max;
        ray_.starts_on_surface = starts;
        ray_.origin_part = starts ? query_.origin_part : any_part;
        return e.is_costly ? ask_within_box<any>(e, found) : ask_whole<any>(e, found);
    }

    template <bool any>
    [[gnu::always_inline]] bool ask_whole(const Element& e, Crossing& found) const {
        if (e.in_world_space && !e.tests_hits) {
            return any ? e.shape->any(ray_, nullptr, found) : e.shape->closest(ray_, nullptr, found);
        }
        return ask_elsewhere<any>(e, found);
    }

    /// Asks for the part of the ray within the element's box.
    template <bool any>
    bool ask_within_box(const Element& e, Crossing& found) const {
        const double t_min = ray_.t_min;
        const bool met = cut_to(parts_.flat.boxes[e.leaf]) && ask_whole<any>(e, found);
        ray_.t_min = t_min;
        return met;
    }

    /// False if nothing of the ray is left; generous, since what is cut off is only work.
    bool cut_to(const Bounds& box) const {
        constexpr double slack = 1e-6;
        for (int i = 0; i < 3; ++i) {
            const double o = query_.ray.origin[i];
            const double d = query_.ray.direction[i];
            if (d == 0.0) continue;
            const double a = (box.lo[i] - o) / d;
            const double b = (box.hi[i] - o) / d;
            const double near = std::min(a, b);
            const double far = std::max(a, b);
            const double pad = slack * (std::abs(near) + std::abs(far));
            ray_.t_min = std::max(ray_.t_min, near - pad);
            ray_.t_max = std::min(ray_.t_max, far + pad);
        }
        return ray_.t_min < ray_.t_max;
    }

    /// The same for leaves in a space of their own, and for those that are parts of solids.
    template <bool any>
    bool ask_elsewhere(const Element& e, Crossing& found) const {
        if (e.slabs != no_slabs && parts_.slabs[e.slabs].are_missed(ray_.ray, ray_.t_min, ray_.t_max))
            return false;
        const Leaf& leaf = parts_.flat.leaves[e.leaf];
        if (e.in_world_space) return ask_solid<any>(e, ray_, found);
        const Ray ray{leaf.object_from_world.point(ray_.ray.origin),
                      leaf.object_from_world.direction(ray_.ray.direction)};
        const ShapeRay moved{ray,
                             ray_.t_min,
                             ray_.t_max,
                             ray_.origin_error * static_cast<double>(e.object_stretch),
                             ray_.starts_on_surface,
                             ray_.origin_part};
        if (leaf.instance != no_surface) {
            const Compound& compound = *parts_.flat.instances[leaf.instance].compound;
            return any ? compound.any_of(moved, query_.mask, query_.origin_member, found)
                       : compound.closest_of(moved, query_.mask, query_.origin_member, found);
        }
        return ask_solid<any>(e, moved, found);
    }

    template <bool any>
    bool ask_solid(const Element& e, const ShapeRay& ray, Crossing& found) const {
        if (!e.tests_hits)
            return any ? e.shape->any(ray, nullptr, found) : e.shape->closest(ray, nullptr, found);
        const SolidFilter filter(parts_.flat, e.leaf, query_.ray);
        return any ? e.shape->any(ray, &filter, found) : e.shape->closest(ray, &filter, found);
    }

    const Geometry::Parts& parts_;
    const RayQuery& query_;
    double per_speed_ = 1.0;  ///< one over the squared length of the direction
    mutable ShapeRay ray_;    ///< for shapes in world space; the rest changes from element to element
};

}  // namespace rb
