#include "compile/geometry.h"

#include "compile/geometry_parts.h"

namespace rb {

Geometry::Geometry() : parts(std::make_unique<Parts>()) {}
Geometry::~Geometry() = default;

const std::vector<Leaf>& Geometry::leaves() const { return parts->flat.leaves; }
bool Geometry::has(uint8_t mask) const { return (parts->all_masks & mask) != 0; }

namespace {

/// Bound on rounding per unit of coordinate, with room for a shape's own frame and solver.
constexpr double coordinate_error = 1e-14;

/// CSG and clips at a candidate crossing.
class SolidFilter final : public CrossingFilter {
public:
    SolidFilter(const SolidForest& solids, const Leaf& leaf, const Ray& ray)
        : solids_(solids), leaf_(leaf), ray_(ray) {}
    bool counts(const Crossing& crossing) const override {
        Vec3 p = ray_.at(crossing.t);
        if (leaf_.in_world_space) leaf_.shape->snap(crossing, p);
        return solids_.counts(leaf_.solid, p, ray_);
    }

private:
    const SolidForest& solids_;
    const Leaf& leaf_;
    const Ray& ray_;
};

/// One query on its way through the elements.
class Search {
public:
    Search(const Geometry::Parts& parts, const RayQuery& query)
        : parts_(parts), query_(query), ray_{query.ray} {
        ray_.t_min = query.t_min;
        if (query.origin_leaf == no_leaf) return;
        ray_.origin_error =
            std::max(query.origin_error, coordinate_error * largest_magnitude(query.ray.origin));
        ray_.t_min = std::max(ray_.t_min, 4.0 * ray_.origin_error);
    }

    double t_min() const { return ray_.t_min; }

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
    bool misses_ball(const Element& e) const {
        const double radius = static_cast<double>(e.radius);
        if (radius == std::numeric_limits<double>::infinity()) return false;
        const Vec3 from = query_.ray.origin - Vec3(e.center);
        const double middle = -glm::dot(from, query_.ray.direction);
        const Vec3 foot = from + middle * query_.ray.direction;
        constexpr double rounding = 1e-13;
        return glm::dot(foot, foot) > radius * radius + rounding * glm::dot(from, from);
    }

    template <bool any>
    bool ask(const Element& e, double t_max, Crossing& found) const {
        const bool starts = e.leaf == query_.origin_leaf;
        ray_.t_max = t_max;
        ray_.starts_on_surface = starts;
        ray_.origin_part = starts ? query_.origin_part : any_part;
        if (e.in_world_space && !e.tests_hits) {
            return any ? e.shape->any(ray_, nullptr, found) : e.shape->closest(ray_, nullptr, found);
        }
        return ask_elsewhere<any>(e, found);
    }

    /// The same for leaves in a space of their own, and for those that are parts of solids.
    template <bool any>
    bool ask_elsewhere(const Element& e, Crossing& found) const {
        const Leaf& leaf = parts_.flat.leaves[e.leaf];
        if (e.in_world_space) return ask_solid<any>(e, leaf, ray_, found);
        const Ray ray{leaf.object_from_world.point(ray_.ray.origin),
                      leaf.object_from_world.direction(ray_.ray.direction)};
        const ShapeRay moved{ray,
                             ray_.t_min,
                             ray_.t_max,
                             ray_.origin_error * static_cast<double>(e.object_stretch),
                             ray_.starts_on_surface,
                             ray_.origin_part};
        return ask_solid<any>(e, leaf, moved, found);
    }

    template <bool any>
    bool ask_solid(const Element& e, const Leaf& leaf, const ShapeRay& ray, Crossing& found) const {
        if (!e.tests_hits)
            return any ? e.shape->any(ray, nullptr, found) : e.shape->closest(ray, nullptr, found);
        const SolidFilter filter(parts_.flat.solids, leaf, query_.ray);
        return any ? e.shape->any(ray, &filter, found) : e.shape->closest(ray, &filter, found);
    }

    const Geometry::Parts& parts_;
    const RayQuery& query_;
    mutable ShapeRay ray_;  ///< for shapes in world space; the rest changes from element to element
};

void fill_hit(const Geometry::Parts& parts, const RayQuery& query, Hit& hit) {
    const Leaf& leaf = parts.flat.leaves[hit.leaf];
    const Ray& ray = query.ray;
    hit.t = hit.crossing.t;
    hit.point = ray.at(hit.t);
    if (leaf.in_world_space) {
        // In its place: a copy would wait for what has only just been stored in other pieces.
        new (&hit.normal) Vec3(leaf.shape->normal(hit.point, hit.crossing));
    } else {
        const Vec3 p = leaf.object_from_world.point(hit.point);
        hit.normal = leaf.object_from_world.transposed_direction(leaf.shape->normal(p, hit.crossing));
    }
    const double square = glm::dot(hit.normal, hit.normal);
    // Most shapes make unit normals, up to rounding.
    if (std::abs(square - 1.0) < 1e-12) {
        if (leaf.inverted) hit.normal = -hit.normal;
    } else if (square > 0.0) {
        const double length = std::sqrt(square);
        hit.normal /= leaf.inverted ? -length : length;
    }
    const double magnitude = largest_magnitude(ray.origin) + hit.t * largest_magnitude(ray.direction);
    const ElementError& error = parts.errors[hit.leaf];
    hit.error = coordinate_error * (error.scale * magnitude + error.offset);
}

}  // namespace

bool Geometry::leaves_for_good(uint32_t leaf, bool outward) const {
    const Leaf& l = leaves()[leaf];
    const Curvature curvature = l.shape->curvature();
    return curvature == Curvature::flat || (curvature == Curvature::convex && outward && !l.inverted);
}

bool Geometry::candidates(const RayBundle& bundle, uint8_t mask, uint32_t left, Candidates& out) const {
    const Parts& p = *parts;
    // Beyond that, single precision bounds nothing.
    constexpr double limit = 1e30;
    if (!(largest_magnitude(bundle.origins.lo) < limit && largest_magnitude(bundle.origins.hi) < limit))
        return false;
    out.listed_count = 0;
    for (uint32_t i = 0; i < p.listed; ++i) {
        const Element& e = p.elements[i];
        if ((e.mask & mask) == 0 || e.leaf == left || p.passes_by(i, bundle)) continue;
        if (out.listed_count == Candidates::most_listed) return false;
        out.listed[out.listed_count++] = i;
    }
    return out.boxes.gather(p.tree, bundle, mask, p.boxed(left));
}

void Geometry::candidates(const Candidates& wider, const RayBundle& bundle, uint32_t left,
                          Candidates& out) const {
    const Parts& p = *parts;
    out.listed_count = 0;
    for (size_t i = 0; i < wider.listed_count; ++i) {
        const uint32_t element = wider.listed[i];
        if (p.elements[element].leaf != left && !p.passes_by(element, bundle))
            out.listed[out.listed_count++] = element;
    }
    out.boxes.gather(wider.boxes, bundle, p.boxed(left));
}

bool Geometry::closest(const RayQuery& query, Hit& hit, const Candidates* candidates) const {
    const Parts& p = *parts;
    const Search search(p, query);
    double t_best = query.t_max;
    hit.leaf = no_leaf;
    Crossing crossing;
    const auto take = [&](uint32_t element) {
        const uint32_t leaf = p.elements[element].leaf;
        if (hit.leaf != no_leaf && crossing.t == t_best && leaf >= hit.leaf) return;
        t_best = crossing.t;
        hit.leaf = leaf;
        hit.crossing.t = crossing.t;
        hit.crossing.part = crossing.part;
        hit.crossing.at = crossing.at;
    };
    const auto try_listed = [&](uint32_t i) {
        if (search.test_listed<false>(i, t_best, crossing)) take(i);
    };
    const auto try_boxed = [&](uint32_t i) {
        if (search.test<false>(p.listed + i, t_best, crossing)) take(p.listed + i);
        return false;
    };
    if (candidates) {
        for (size_t i = 0; i < candidates->listed_count; ++i) try_listed(candidates->listed[i]);
        candidates->boxes.walk(query.ray, query.mask, search.t_min(), t_best, try_boxed);
    } else {
        for (uint32_t i = 0; i < p.listed; ++i) try_listed(i);
        p.tree.walk(query.ray, query.mask, search.t_min(), t_best, try_boxed);
    }
    if (hit.leaf == no_leaf) return false;
    fill_hit(p, query, hit);
    return true;
}

bool Geometry::occluded(const RayQuery& query, uint32_t& blocker, const Candidates* candidates) const {
    const Parts& p = *parts;
    const Search search(p, query);
    Crossing crossing;
    const auto takes = [&](uint32_t element) {
        blocker = p.elements[element].leaf;
        return true;
    };
    uint32_t tried = no_leaf;
    if (blocker < p.element_of_leaf.size()) {
        tried = p.element_of_leaf[blocker];
        if (tried < p.listed) {
            if (search.test_listed<true>(tried, query.t_max, crossing)) return takes(tried);
        } else if (tried != no_leaf && (p.elements[tried].mask & query.mask) != 0) {
            if (search.test<true>(tried, query.t_max, crossing)) return takes(tried);
        }
    }
    const auto listed_blocks = [&](uint32_t i) {
        return i != tried && search.test_listed<true>(i, query.t_max, crossing) && takes(i);
    };
    const auto boxed_blocks = [&](uint32_t i) {
        const uint32_t element = p.listed + i;
        return element != tried && search.test<true>(element, query.t_max, crossing) && takes(element);
    };
    if (candidates) {
        for (size_t i = 0; i < candidates->listed_count; ++i) {
            if (listed_blocks(candidates->listed[i])) return true;
        }
        return candidates->boxes.walk(query.ray, query.mask, search.t_min(), query.t_max, boxed_blocks);
    }
    for (uint32_t i = 0; i < p.listed; ++i) {
        if (listed_blocks(i)) return true;
    }
    return p.tree.walk(query.ray, query.mask, search.t_min(), query.t_max, boxed_blocks);
}

std::vector<uint32_t> Geometry::interiors_at(const Vec3& p) const {
    std::vector<uint32_t> out;
    const SolidForest& solids = parts->flat.solids;
    for (const TopSolid& top : parts->flat.tops) {
        if (top.box.contains(p) && solids.nodes[top.node].region.contains(p) &&
            solids.inside_unclipped(top.node, p)) {
            out.push_back(top.interior);
        }
    }
    return out;
}

Vec2 Geometry::uv(const Hit& hit) const {
    const Leaf& l = leaf(hit.leaf);
    const Vec3 p = l.in_world_space ? hit.point : l.object_from_world.point(hit.point);
    return l.shape->uv(p, hit.crossing).value_or(Vec2{hit.point.x, hit.point.y});
}

void Geometry::surfaces_at(const Hit& hit, std::vector<SurfaceWeight>& out) const {
    out.clear();
    const Leaf& l = leaf(hit.leaf);
    if (l.cutaway != no_surface) {
        cut_surfaces_at(parts->flat.solids, parts->flat.cutaways[l.cutaway], hit.point, out);
    } else if (l.first_texture_surface != no_surface) {
        thread_local std::vector<TextureWeight> textures;
        textures.clear();
        const Vec3 p = l.in_world_space ? hit.point : l.object_from_world.point(hit.point);
        l.shape->textures_at(p, hit.crossing, textures);
        for (const TextureWeight& t : textures) {
            const bool own = t.texture == own_texture;
            out.push_back({own ? l.surface : l.first_texture_surface + t.texture, t.weight});
        }
    }
    if (out.empty()) out.push_back({l.surface, 1.0f});
}

}  // namespace rb
