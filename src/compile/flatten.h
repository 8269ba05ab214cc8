#pragma once
#include "compile/compound_store.h"
#include "compile/cutaway.h"
#include "compile/solids.h"
#include "compile/surfaces.h"

namespace rb {

/// A top-level object after the splitting of unions (spec: geometry 5.5).
struct TopSolid {
    uint32_t node = 0;
    uint32_t interior = 0;           ///< index into World::interiors
    uint32_t instance = no_surface;  ///< index into FlatGeometry::instances: it has the interiors
    Bounds box;  ///< of its surfaces; the language takes nothing outside for inside (a disc's half-space)
};

/// What flattening makes: leaves with their boxes, and the solids that decide which of their crossings count.
struct FlatGeometry {
    std::vector<Leaf> leaves;
    std::vector<Bounds> boxes;  ///< parallel to `leaves`: surfaces cut down to where hits can count
    SolidForest solids;
    std::vector<TopSolid> tops;
    std::vector<Cutaway> cutaways;
    std::vector<Instance> instances;
};

/// Flattens objects into `world` (surfaces, interiors, lights) and the result. Leaves are ordered so that of
/// coincident surfaces the one with the lower index is seen (spec: geometry 4.1): infinite objects first,
/// then in declaration order; within one object as put_seen_first() says.
class Flattener {
public:
    Flattener(World& world, TexturePtr default_texture, Diagnostics& diagnostics);
    ~Flattener();

    /// Declared objects asked by trace() keep their `bounded_by` (spec: geometry 6).
    void keep_all_bounds() { keep_all_bounds_ = true; }
    /// Compounds that the store shares become instances.
    void share(CompoundStore& store) {
        store_ = &store;
        list_ = store.new_list();
    }
    /// Room for what add() will make of the objects.
    void reserve(const std::vector<ObjectPtr>& objects);
    void add(const ObjectPtr& object);
    /// The same without splitting a union: one solid per object.
    void add_whole(const ObjectPtr& object);
    FlatGeometry finish();  ///< once, at the end

private:
    struct Inherited;
    struct Draft;

    void add_top(const Object& object, const Inherited& from);
    void add_flattened(const Object& object, const Inherited& from);
    bool add_instance(const Object& object, const Inherited& from);
    uint32_t needs_of(const Inherited& own, const Object& object);
    CompoundPtr make_compound(const Object& object, const Inherited& own);
    std::shared_ptr<const InstanceLook> look_of(CompoundStore::Entry& entry, const Inherited& own);
    std::vector<uint32_t> interiors_of(const CompoundLooks& looks, const Inherited& own);
    Surface surface_of_copy(const Surface& surface, const Inherited& own);
    void add_solid(const Object& object, const Inherited& from);
    void add_light(const Light& light, const Inherited& from);
    void enter_light_group(const Csg& group, Inherited& own);
    void become_target(Inherited& own);
    uint32_t photon_target(const Leaf& leaf) const;
    std::shared_ptr<const Geometry> shape_of(const ObjectPtr& object);
    uint32_t build(const Object& object, const Inherited& from, bool invert, uint32_t parent);
    uint32_t build_shape(const Object& object, const ShapePtr& shape, const Inherited& own, bool invert,
                         uint32_t parent);
    void add_leaf(const Object& object, const Inherited& own, uint32_t node);
    void cut_away(uint32_t leaf);
    void add_lists(const Object& object, const Inherited& from, uint32_t node);
    Inherited inherit(const Object& object, const Inherited& from);
    Surface surface_of(const Object& object, const Inherited& own);
    uint32_t interior_index(const Inherited& own, bool opaque);
    uint32_t add_interior(const InteriorPtr& interior, bool hollow);
    uint32_t shared_interior(bool hollow);
    uint32_t own_interior(uint32_t slot);

    World& world_;
    TexturePtr default_texture_;
    Diagnostics& diagnostics_;
    SurfaceTable surface_table_;
    FlatGeometry flat_;
    std::unique_ptr<Draft> draft_;
    bool keep_all_bounds_ = false;
    CompoundStore* store_ = nullptr;
    uint32_t list_ = 0;  ///< CompoundStore::new_list() of this one's surfaces
};

}  // namespace rb
