#include "compile/compound_store.h"

#include "compile/flatten_parts.h"

#include <algorithm>

namespace rb {

namespace {

/// Crossing::member numbers them.
constexpr double most_leaves = 2e9;

/// Targets and what photons do at them belong to each copy.
bool asks_for_photons(const Object& object) { return object.photons != ObjectPhotons{}; }

bool is_limited(const Object& object) {
    return object.inverse || asks_for_photons(object) || !object.clipped_by.empty() ||
           !object.bounded_by.empty();
}

/// The language makes a triangle's normals anew after each transformation: they may turn over, and smooth
/// ones become unit again (spec: geometry 10.1). That a transform beside the shape does not do.
bool transforms_by_rule(const Shape& shape) {
    return shape.keyword() == "triangle" || shape.keyword() == "smooth_triangle";
}

}  // namespace

CompoundStore::CompoundStore(const std::vector<ObjectPtr>& objects, InstanceMode mode, bool brute_force)
    : brute_force_(brute_force) {
    if (mode == InstanceMode::never) return;
    // A leaf costs about 750 bytes, and an instance as much; flattened copies are quicker to render.
    const bool always = mode == InstanceMode::always;
    least_leaves_ = always ? 1 : 8;
    least_saved_ = always ? 1 : 50'000;
    for (const ObjectPtr& object : objects) count_use(*object);
    std::erase_if(facts_, [&](const auto& entry) {
        const Facts& f = entry.second;
        return !f.can_be_shared || f.uses < 2.0 || f.leaves < least_leaves_ || f.leaves > most_leaves ||
               (f.uses - 1.0) * f.leaves < least_saved_;
    });
}

bool CompoundStore::shares(const Object& object) const {
    if (facts_.empty()) return false;
    const auto* csg = as<Csg>(object);
    return csg && facts_.contains(csg->children.get()) && !is_limited(object);
}

CompoundStore::Entry& CompoundStore::entry(const Object& object, uint32_t needs) {
    const auto& children = as<Csg>(object)->children;
    Entry& entry = entries_[{children.get(), needs}];
    entry.children = children;
    return entry;
}

/// For an object at top level, or one that a split union puts there. What is shared is looked into once: if
/// its copies are instances, what stands in it is flattened once.
void CompoundStore::count_use(const Object& object) {
    const auto* csg = as<Csg>(object);
    if (!csg) return;
    if (csg->children.use_count() > 1) {
        facts_of(csg->children);
        Facts& facts = facts_[csg->children.get()];
        if (!is_limited(object)) facts.uses += 1.0;
        if (csg->cutaway_textures || csg->is_light_group) facts.can_be_shared = false;
        if (facts.uses > 1.0) return;
    }
    if (!splits(object)) return;
    for (const ObjectPtr& child : *csg->children) count_use(*child);
}

CompoundStore::Facts CompoundStore::facts_of(const Object& object) {
    Facts facts;
    if (const auto* csg = as<Csg>(object)) {
        facts = facts_of(csg->children);
        if (csg->cutaway_textures || csg->is_light_group) facts.can_be_shared = false;
    } else {
        facts.leaves = 1;
        const ShapePtr* shape = as<ShapePtr>(object);
        facts.can_be_shared = shape && !transforms_by_rule(**shape);
    }
    if (asks_for_photons(object)) facts.can_be_shared = false;
    for (const auto& list : {object.clipped_by, object.bounded_by}) {
        for (const ObjectPtr& limit : list) {
            if (!facts_of(*limit).can_be_shared) facts.can_be_shared = false;
        }
    }
    return facts;
}

CompoundStore::Facts CompoundStore::facts_of(const std::shared_ptr<const Children>& children) {
    const bool is_shared = children.use_count() > 1;
    if (is_shared) {
        const auto known = facts_.find(children.get());
        if (known != facts_.end()) return known->second;
    }
    Facts facts;
    for (const ObjectPtr& child : *children) {
        const Facts below = facts_of(*child);
        facts.leaves += below.leaves;
        if (!below.can_be_shared) facts.can_be_shared = false;
    }
    if (is_shared) facts_.emplace(children.get(), facts);
    return facts;
}

}  // namespace rb
