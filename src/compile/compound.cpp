#include "compile/compound.h"

#include "compile/search.h"

#include <fmt/format.h>

namespace rb {

Compound::Compound(std::shared_ptr<const Geometry> geometry, CompoundLooks looks)
    : geometry_(std::move(geometry)), looks_(std::move(looks)) {
    const FlatGeometry& flat = geometry_->parts->flat;
    for (const Bounds& box : flat.boxes) {
        if (!box.is_empty()) box_.include(box);
    }
    for (const TopSolid& top : flat.tops) {
        const Bounds& region = flat.solids.nodes[top.node].region;
        if (!region.is_empty()) region_.include(region);
    }
    member_count_ = static_cast<uint32_t>(flat.leaves.size());
    if (flat.instances.empty()) return;
    member_count_ = 0;
    for (const Leaf& leaf : flat.leaves) {
        first_member_.push_back(member_count_);
        member_count_ +=
            leaf.instance == no_surface ? 1u : flat.instances[leaf.instance].compound->member_count();
    }
}

const TexturePtr& Compound::texture_of_copy(bool opaque) {
    static const TexturePtr solid = plain_texture({.source = Color{}});
    static const TexturePtr clear = plain_texture({.source = Color{0, 0, 0, 0, 1}});
    return opaque ? solid : clear;
}

bool Compound::is_texture_of_copy(const TexturePtr& texture) {
    return texture == texture_of_copy(true) || texture == texture_of_copy(false);
}

Compound::Place Compound::place_of(uint32_t member) const {
    if (first_member_.empty()) return {member, 0};
    const auto behind = std::ranges::upper_bound(first_member_, member);
    const auto leaf = static_cast<uint32_t>(behind - first_member_.begin()) - 1;
    return {leaf, member - first_member_[leaf]};
}

void Compound::raise(uint32_t leaf, Crossing& crossing) const {
    const bool nested = geometry_->leaf(leaf).instance != no_surface;
    crossing.member = (first_member_.empty() ? leaf : first_member_[leaf]) + (nested ? crossing.member : 0u);
}

Hit Compound::lowered(const Vec3& p, const Crossing& at) const {
    const Place place = place_of(at.member);
    Hit hit;
    hit.point = p;
    hit.leaf = place.leaf;
    hit.crossing = at;
    hit.crossing.member = place.member;
    return hit;
}

RayQuery Compound::query_of(const ShapeRay& ray, RayMask mask, uint32_t member) const {
    RayQuery query;
    query.ray = ray.ray;
    query.t_max = ray.t_max;
    query.t_min = ray.t_min;
    query.mask = mask;
    query.origin_error = ray.origin_error;
    if (ray.starts_on_surface) {
        const Place place = place_of(member);
        query.origin_leaf = place.leaf;
        query.origin_member = place.member;
        query.origin_part = ray.origin_part;
    }
    return query;
}

bool Compound::closest_of(const ShapeRay& ray, RayMask mask, uint32_t member, Crossing& nearest) const {
    const RayQuery query = query_of(ray, mask, member);
    const Search search(*geometry_->parts, query, ray);
    Hit hit;
    if (!search.closest(nullptr, hit)) return false;
    nearest = hit.crossing;
    raise(hit.leaf, nearest);
    return true;
}

bool Compound::any_of(const ShapeRay& ray, RayMask mask, uint32_t member, Crossing& found) const {
    const RayQuery query = query_of(ray, mask, member);
    const Search search(*geometry_->parts, query, ray);
    const uint32_t element = search.any(nullptr, no_leaf, found);
    if (element == no_leaf) return false;
    raise(geometry_->parts->elements[element].leaf, found);
    return true;
}

ElementError Compound::error_of(uint32_t member) const {
    const Place place = place_of(member);
    return geometry_->parts->error_of(place.leaf, place.member);
}

uint32_t Compound::surface_of(uint32_t member) const {
    const Place place = place_of(member);
    return geometry_->surface_of(place.leaf, place.member);
}

void Compound::surfaces_at(const Vec3& p, const Crossing& at, std::vector<SurfaceWeight>& out) const {
    geometry_->surfaces_at(lowered(p, at), out);
}

bool Compound::inside(const Vec3& p) const {
    const FlatGeometry& flat = geometry_->parts->flat;
    return std::any_of(flat.tops.begin(), flat.tops.end(),
                       [&](const TopSolid& top) { return flat.solids.inside(top.node, p); });
}

/// For those who want all: no tree, no haste.
void Compound::crossings(const ShapeRay& ray, Crossings& out) const {
    const FlatGeometry& flat = geometry_->parts->flat;
    for (uint32_t i = 0; i < flat.leaves.size(); ++i) {
        const Leaf& leaf = flat.leaves[i];
        const Ray moved = leaf.in_world_space ? ray.ray
                                              : Ray{leaf.object_from_world.point(ray.ray.origin),
                                                    leaf.object_from_world.direction(ray.ray.direction)};
        Crossings all;
        leaf.shape->crossings(ShapeRay{moved, ray.t_min, ray.t_max}, all);
        const SolidFilter filter(flat, i, ray.ray);
        for (size_t k = 0; k < all.size(); ++k) {
            Crossing crossing = all[k];
            if (!filter.counts(crossing)) continue;
            raise(i, crossing);
            out.add(crossing);
        }
    }
}

Vec3 Compound::normal(const Vec3& p, const Crossing& at) const {
    const Hit hit = lowered(p, at);
    const Leaf& leaf = geometry_->leaf(hit.leaf);
    Vec3 normal;
    if (leaf.in_world_space) {
        normal = leaf.shape->normal(p, hit.crossing);
    } else {
        normal = leaf.object_from_world.transposed_direction(
            leaf.shape->normal(leaf.object_from_world.point(p), hit.crossing));
    }
    return leaf.inverted ? -normal : normal;
}

std::optional<Vec2> Compound::uv(const Vec3& p, const Crossing& at) const {
    const Hit hit = lowered(p, at);
    const Leaf& leaf = geometry_->leaf(hit.leaf);
    return leaf.shape->uv(leaf.in_world_space ? p : leaf.object_from_world.point(p), hit.crossing);
}

std::string Compound::describe() const { return fmt::format("compound of {} surfaces", member_count_); }

}  // namespace rb
