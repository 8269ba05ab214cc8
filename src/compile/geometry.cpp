#include "compile/geometry.h"

#include "compile/search.h"

namespace rb {

Geometry::Geometry() : parts(std::make_unique<Parts>()) {}
Geometry::~Geometry() = default;

const std::vector<Leaf>& Geometry::leaves() const { return parts->flat.leaves; }
bool Geometry::has(RayMask mask) const { return (parts->all_masks & mask) != 0; }

namespace {

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
    const ElementError error = parts.error_of(hit.leaf, hit.crossing.member);
    hit.error = coordinate_error * (error.scale * magnitude + error.offset);
}

/// Of the members of a copy.
void add_interiors(const Geometry::Parts& parts, const TopSolid& top, const Vec3& p,
                   std::vector<uint32_t>& out) {
    if (!top.box.contains(p)) return;
    const SolidForest& solids = parts.flat.solids;
    const Instance& instance = parts.flat.instances[top.instance];
    const Vec3 there = solids.shapes[solids.nodes[top.node].placed].object_from_world.point(p);
    for (const uint32_t interior : instance.compound->interiors_at(there)) {
        out.push_back(instance.look->interiors[interior]);
    }
}

}  // namespace

ElementError Geometry::Parts::error_of_member(uint32_t index, uint32_t member) const {
    const ElementError& own = errors[index];
    const Leaf& leaf = flat.leaves[index];
    const Instance& instance = flat.instances[leaf.instance];
    const ElementError inner = instance.compound->error_of(member);
    const double in = stretch(leaf.object_from_world);
    const double moved = largest_magnitude(leaf.object_from_world->row[3]);
    return {own.scale + instance.world_stretch * inner.scale * in,
            own.offset + instance.world_stretch * (inner.scale * moved + inner.offset)};
}

bool Geometry::leaves_for_good(uint32_t leaf, bool outward) const {
    const Leaf& l = leaves()[leaf];
    const Curvature curvature = l.shape->curvature();
    return curvature == Curvature::flat || (curvature == Curvature::convex && outward && !l.inverted);
}

bool Geometry::is_convex_body(uint32_t leaf, const Vec3& p) const {
    const Leaf& l = leaves()[leaf];
    constexpr int either = blocks_light | filters_light;
    if ((l.mask & either) != blocks_light || l.instance != no_surface || !l.shape->is_convex_body())
        return false;
    if (parts->flat.solids.nodes[l.solid].tests_hits) return false;
    return !l.shape->inside(l.in_world_space ? p : l.object_from_world.point(p));
}

bool Geometry::candidates(const RayBundle& bundle, RayMask mask, uint32_t left, Candidates& out) const {
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
    const Search search(*parts, query);
    if (!search.closest(candidates, hit)) return false;
    fill_hit(*parts, query, hit);
    return true;
}

bool Geometry::occluded(const RayQuery& query, uint32_t& blocker, const Candidates* candidates) const {
    const Parts& p = *parts;
    const Search search(p, query);
    Crossing crossing;
    uint32_t tried = no_leaf;
    if (blocker < p.element_of_leaf.size()) {
        tried = p.element_of_leaf[blocker];
        if (tried < p.listed) {
            if (search.test_listed<true>(tried, query.t_max, crossing)) return true;
        } else if (tried != no_leaf && (p.elements[tried].mask & query.mask) != 0) {
            if (search.test<true>(tried, query.t_max, crossing)) return true;
        }
    }
    const uint32_t element = search.any(candidates, tried, crossing);
    if (element == no_leaf) return false;
    blocker = p.elements[element].leaf;
    return true;
}

std::vector<uint32_t> Geometry::solids_near(const Bounds& box) const {
    std::vector<uint32_t> out;
    for (uint32_t i = 0; i < parts->flat.tops.size(); ++i) {
        if (!intersection(parts->flat.tops[i].box, box).is_empty()) out.push_back(i);
    }
    return out;
}

std::vector<uint32_t> Geometry::interiors_at(const Vec3& p) const {
    Bounds here;
    here.include(p);
    return interiors_at(p, solids_near(here));
}

std::vector<uint32_t> Geometry::interiors_at(const Vec3& p, std::span<const uint32_t> tops) const {
    std::vector<uint32_t> out;
    const SolidForest& solids = parts->flat.solids;
    for (const uint32_t i : tops) {
        const TopSolid& top = parts->flat.tops[i];
        if (top.instance != no_surface) {
            add_interiors(*parts, top, p, out);
        } else if (top.box.contains(p) && solids.nodes[top.node].region.contains(p) &&
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

uint32_t Geometry::surface_of(uint32_t index, uint32_t member) const {
    const Leaf& l = leaf(index);
    if (l.instance == no_surface) return l.surface;
    const Instance& instance = parts->flat.instances[l.instance];
    return instance.look->surfaces[instance.compound->surface_of(member)];
}

void Geometry::surfaces_at(const Hit& hit, std::vector<SurfaceWeight>& out) const {
    out.clear();
    const Leaf& l = leaf(hit.leaf);
    if (l.instance != no_surface) {
        const Instance& instance = parts->flat.instances[l.instance];
        instance.compound->surfaces_at(l.object_from_world.point(hit.point), hit.crossing, out);
        for (SurfaceWeight& worn : out) worn.surface = instance.look->surfaces[worn.surface];
    } else if (l.cutaway != no_surface) {
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
