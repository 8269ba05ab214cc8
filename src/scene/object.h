#pragma once
#include "base/returning_allocator.h"
#include "base/source.h"
#include "scene/light.h"
#include "scene/media.h"
#include "scene/shape.h"
#include "scene/texture.h"

#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace rb {

/// What fills a solid (manual 3.4.7). Which object it belongs to matters, so it is shared by pointer.
struct Interior {
    SourceRange where;
    double ior = 0;  ///< 0: not given, the surrounding's
    double dispersion = 1;
    int dispersion_samples = 7;
    double caustics = 0;
    double fade_distance = 0;
    double fade_power = 0;
    Rgb fade_color{0.0f};
    std::vector<MediaPtr> media;  ///< they add up
};
using InteriorPtr = std::shared_ptr<const Interior>;

/// The same with its media moved; null stays null.
InteriorPtr transformed(const InteriorPtr& interior, const Transform& map);

struct Object;
using ObjectPtr = std::shared_ptr<const Object>;

/// A list of objects in the size of a pointer, for what hardly any object has: copies share it until one
/// changes.
class ObjectList {
public:
    ObjectList() = default;
    ObjectList(std::vector<ObjectPtr> objects);

    operator const std::vector<ObjectPtr>&() const { return objects_ ? *objects_ : none; }
    bool empty() const { return !objects_; }
    auto begin() const { return objects_ ? objects_->begin() : none.begin(); }
    auto end() const { return objects_ ? objects_->end() : none.end(); }

private:
    static const std::vector<ObjectPtr> none;

    std::shared_ptr<const std::vector<ObjectPtr>> objects_;
};

enum class CsgKind { union_, merge, intersection, difference };

/// A compound. In a difference the children from the second on are subtracted as they stand here (not
/// inverted).
struct Csg {
    CsgKind kind = CsgKind::union_;
    std::shared_ptr<const std::vector<ObjectPtr>> children;
    bool split_union = true;
    bool cutaway_textures = false;
    bool is_light_group = false;  ///< a union whose own lights shine on nothing outside of it
    bool global_lights = false;   ///< light groups: the lights outside of all groups shine in, too
};

/// A shape that the reader knows but the renderer does not draw yet; the compiler says so where it is used.
struct UnsupportedShape {
    std::string keyword;
};

/// A texture as an object wears it, with the transformations that followed it in the object.
struct WornTexture {
    TexturePtr layers;
    SharedTransform world_from_texture;
};

/// A thing in the scene. Copying is cheap: shapes, textures and children are shared. The transform applies to
/// the geometry; what the object wears carries its own, since only later transformations move it.
struct Object {
    SourceRange where;
    std::variant<ShapePtr, Csg, LightPtr, UnsupportedShape> geometry;
    SharedTransform world_from_object;

    std::optional<WornTexture> texture;
    std::optional<WornTexture> interior_texture;
    /// For leaves that end up without texture: the default in force at the end of the outermost statement.
    /// Null: the scene's.
    TexturePtr fallback_texture;
    InteriorPtr interior;
    ObjectList bounded_by;
    ObjectList clipped_by;

    bool uv_mapping = false;
    bool inverse = false;
    bool no_shadow = false;
    bool no_image = false;
    bool no_reflection = false;
    bool no_radiosity = false;
    bool double_illuminate = false;
    bool sturm = false;
    std::optional<bool> hollow;
    ObjectPhotons photons;
    float radiosity_importance = 1.0f;  ///< (0, 1]: share of the radiosity samples
};

/// A new object, or a copy of one. Objects are let go while the world is made of them (compile()), which
/// should give their memory back.
template <typename... From>
std::shared_ptr<Object> make_object(const From&... from) {
    return std::allocate_shared<Object>(ReturningAllocator<Object>(), from...);
}

/// Applies a transformation statement to an object as the language does: geometry, bounds, clips, and what
/// the object wears so far (not with uv_mapping). CSG children are reached through their parent's transform.
void transform_object(Object& object, const Transform& map);

}  // namespace rb
