#pragma once
#include "compile/instance.h"
#include "compile/world.h"

#include <map>
#include <unordered_map>

namespace rb {

/// The compounds of a scene that are kept once for all their copies: which they are, and those made so far.
/// Copies are told by their children, which the copies of a declared object share.
class CompoundStore {
public:
    /// Looks at all objects; `mode` says what is worth sharing.
    CompoundStore(const std::vector<ObjectPtr>& objects, InstanceMode mode, bool brute_force);

    /// True for a copy of a compound that stands in the scene often enough, if nothing in it forbids sharing
    /// (lights, cutaway_textures, single triangles, limits or `inverse` of the copy itself).
    bool shares(const Object& object) const;

    /// What decides the look of copies that show no place: where their surfaces are listed, and what they
    /// wear.
    struct Wear {
        uint32_t list = 0;  ///< see new_list()
        TexturePtr texture;
        TexturePtr interior_texture;
        LightChoice lights;

        friend bool operator==(const Wear&, const Wear&) = default;
    };

    /// What a copy of `object` is an instance of. `needs`: what of the copy decides which crossings count and
    /// which rays see them. An entry that says nothing is yet to be made; one without compound is not to be.
    struct Entry {
        bool known = false;
        CompoundPtr compound;
        std::shared_ptr<const std::vector<ObjectPtr>> children;  ///< keeps the key alive
        std::shared_ptr<const InstanceLook> last_look;
        Wear last_wear;  ///< of the copy with the last look
    };
    Entry& entry(const Object& object, uint32_t needs);

    /// A number for one more list of surfaces: the world's, a compound's.
    uint32_t new_list() { return ++lists_; }

    bool brute_force() const { return brute_force_; }

private:
    /// What is known of a list of children.
    struct Facts {
        double leaves = 0;
        double uses = 0;
        bool can_be_shared = true;
    };
    using Children = std::vector<ObjectPtr>;

    void count_use(const Object& object);
    Facts facts_of(const Object& object);
    Facts facts_of(const std::shared_ptr<const Children>& children);

    std::unordered_map<const Children*, Facts> facts_;
    std::map<std::pair<const Children*, uint32_t>, Entry> entries_;
    double least_leaves_ = 0;
    double least_saved_ = 0;
    uint32_t lists_ = 0;
    bool brute_force_ = false;
};

}  // namespace rb
