// Objects, CSG and object modifiers. Language spec 17, geometry 3.
#include "language/read.h"
#include "language/skipped.h"
#include "shapes/registry.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

namespace rb {

namespace {

constexpr std::array<std::string_view, 40> object_words{
    "bicubic_patch", "blob",       "box",           "composite",      "cone",
    "cubic",         "cylinder",   "difference",    "disc",           "height_field",
    "intersection",  "isosurface", "julia_fractal", "lathe",          "light_group",
    "light_source",  "merge",      "mesh",          "mesh2",          "object",
    "ovus",          "parametric", "plane",         "poly",           "polygon",
    "polynomial",    "prism",      "quadric",       "quartic",        "smooth_triangle",
    "sor",           "sphere",     "sphere_sweep",  "superellipsoid", "text",
    "torus",         "triangle",   "union",         "cubic",          "text"};

std::optional<CsgKind> csg_kind(std::string_view keyword) {
    if (keyword == "union" || keyword == "composite" || keyword == "light_group") return CsgKind::union_;
    if (keyword == "merge") return CsgKind::merge;
    if (keyword == "intersection") return CsgKind::intersection;
    if (keyword == "difference") return CsgKind::difference;
    return std::nullopt;
}

/// An object that was read at once bears its keyword, which no identifier can.
bool is_identifier(const Item& item) { return !is_object_keyword(item.text); }

/// Leaves out the arguments of a shape that is not drawn yet, up to the object modifiers.
void skip_shape(BlockReader& in) {
    constexpr std::array<std::string_view, 27> modifiers{
        "translate",         "rotate",    "scale",    "matrix",        "transform",        "texture",
        "pigment",           "normal",    "finish",   "interior",      "interior_texture", "material",
        "uv_mapping",        "no_shadow", "no_image", "no_reflection", "no_radiosity",     "hollow",
        "double_illuminate", "inverse",   "sturm",    "hierarchy",     "bounded_by",       "clipped_by",
        "photons",           "radiosity", "dtag"};
    while (!in.at_end()) {
        const std::string_view word = in.peek_word();
        if (std::find(modifiers.begin(), modifiers.end(), word) != modifiers.end()) return;
        if (in.peek().kind == Item::Kind::bad) return;
        skip_item(in);
    }
}

/// The next object of the block; null if none is next.
ObjectPtr take_object(BlockReader& in) {
    if (in.at_thing<ObjectPtr>()) return in.thing<ObjectPtr>();
    if (in.at_any_block() && is_object_keyword(in.peek().block->keyword)) {
        const Block& block = *in.peek().block;
        in.skip_item();
        return read_object(block, in.context());
    }
    return nullptr;
}

/// An edit of a worn texture must see the transformations that it has had.
TexturePtr bare(std::optional<WornTexture>& worn) {
    if (!worn) return nullptr;
    return transformed(worn->layers, worn->world_from_texture);
}

void wear(std::optional<WornTexture>& worn, TexturePtr layers) { worn = WornTexture{std::move(layers), {}}; }

class ModifierReader {
public:
    ModifierReader(BlockReader& in, Object& object, std::string_view keyword)
        : in_(in), object_(object), keyword_(keyword) {}

    void read() {
        while (!in_.at_end()) {
            if (!take_transform() && !take_texture() && !take_flag() && !take_limit() && !take_rest()) break;
        }
        if (object_.interior_texture && !object_.texture) {
            in_.fail("Interior texture requires an exterior texture.");
        }
    }

    /// A light_group takes few of them.
    void read_of_group(Csg& group) {
        while (!in_.at_end()) {
            if (in_.take_word("global_lights")) {
                group.global_lights = in_.optional_switch();
            } else if (in_.at_block("photons")) {
                read_object_photons(in_.block("photons"), in_.context(), object_.photons);
            } else if (!take_transform()) {
                break;
            }
        }
    }

private:
    bool take_transform() {
        Transform map;
        if (!take_transformation(in_, map)) return false;
        transform_object(object_, map);
        return true;
    }

    bool take_texture() {
        const ReadContext& context = in_.context();
        const SourceRange at = in_.where();
        if (in_.at_block("texture")) {
            const TexturePtr layer = read_texture(in_.block("texture"), context);
            const bool identity = object_.texture && object_.texture->world_from_texture.is_identity();
            TexturePtr below =
                object_.texture ? (identity ? object_.texture->layers : bare(object_.texture)) : nullptr;
            wear(object_.texture, layered(below, layer, at));
        } else if (in_.at_block("pigment") || in_.at_block("normal") || in_.at_block("finish")) {
            TexturePtr layers = bare(object_.texture);
            edit_texture(in_.block(in_.peek_word()), context, layers);
            wear(object_.texture, std::move(layers));
        } else if (in_.at_block("interior_texture")) {
            const TexturePtr layer = read_texture(in_.block("interior_texture"), context);
            wear(object_.interior_texture, layered(bare(object_.interior_texture), layer, at));
        } else if (in_.at_block("interior")) {
            object_.interior = read_interior(in_.block("interior"), context, object_.interior);
        } else if (in_.at_block("material")) {
            const auto material = read_material(in_.block("material"), context);
            if (material->texture)
                wear(object_.texture, layered(bare(object_.texture), material->texture, at));
            if (material->interior_texture) {
                wear(object_.interior_texture,
                     layered(bare(object_.interior_texture), material->interior_texture, at));
            }
            if (material->interior) object_.interior = material->interior;
        } else if (in_.at_word("uv_mapping")) {
            if (object_.texture) in_.fail("uv_mapping must be specified before texture.");
            in_.skip_item();
            object_.uv_mapping = true;
        } else {
            return false;
        }
        return true;
    }

    bool take_flag() {
        if (in_.take_word("no_shadow")) {
            object_.no_shadow = true;
        } else if (in_.take_word("no_image")) {
            object_.no_image = in_.optional_switch();
        } else if (in_.take_word("no_reflection")) {
            object_.no_reflection = in_.optional_switch();
        } else if (in_.take_word("no_radiosity")) {
            object_.no_radiosity = in_.optional_switch();
        } else if (in_.take_word("hollow")) {
            const bool on = in_.optional_switch();
            object_.hollow = on;
        } else if (in_.take_word("double_illuminate")) {
            object_.double_illuminate = in_.optional_switch();
        } else if (in_.take_word("inverse")) {
            object_.inverse = !object_.inverse;
        } else if (in_.at_word("sturm")) {
            require(
                {"blob", "cubic", "quartic", "poly", "polynomial", "torus", "ovus", "lathe", "sor", "prism"});
            in_.skip_item();
            object_.sturm = in_.optional_switch();
        } else if (in_.at_word("hierarchy")) {
            require({"height_field", "mesh", "mesh2", "blob"});
            in_.skip_item();
            in_.optional_switch();
        } else {
            return false;
        }
        return true;
    }

    bool take_limit() {
        const bool bounds = in_.at_block("bounded_by");
        if (!bounds && !in_.at_block("clipped_by")) return false;
        const Block& block = in_.block(bounds ? "bounded_by" : "clipped_by");
        BlockReader inner(block, in_.context());
        ObjectList& target = bounds ? object_.bounded_by : object_.clipped_by;
        if (inner.take_word(bounds ? "clipped_by" : "bounded_by")) {
            target = bounds ? object_.clipped_by : object_.bounded_by;
            inner.finish();
            return true;
        }
        std::vector<ObjectPtr> list = target;
        const size_t before = list.size();
        while (ObjectPtr object = take_object(inner)) {
            if (object->texture) {
                inner.fail_at(object->where, "Illegal texture or patch in clip, bound or object pattern.");
            }
            list.push_back(std::move(object));
        }
        if (list.size() == before)
            inner.fail(fmt::format("Expected 'object', {} found instead", inner.found()));
        Transform map;
        while (take_transformation(inner, map)) {
        }
        if (!map.is_identity()) {
            for (size_t i = before; i < list.size(); ++i) {
                auto moved = make_object(*list[i]);
                transform_object(*moved, map);
                list[i] = std::move(moved);
            }
        }
        inner.finish();
        target = std::move(list);
        return true;
    }

    bool take_rest() {
        auto* csg = std::get_if<Csg>(&object_.geometry);
        if (in_.at_word("split_union")) {
            if (!csg || (csg->kind != CsgKind::union_ && csg->kind != CsgKind::merge)) misused("split_union");
            in_.skip_item();
            csg->split_union = in_.optional_switch();
        } else if (in_.at_word("cutaway_textures")) {
            if (!csg || csg->kind == CsgKind::union_ || csg->kind == CsgKind::merge)
                misused("cutaway_textures");
            in_.skip_item();
            csg->cutaway_textures = true;
        } else if (in_.at_block("photons")) {
            read_object_photons(in_.block("photons"), in_.context(), object_.photons);
        } else if (in_.at_block("radiosity")) {
            const auto importance = read_importance(in_.block("radiosity"), in_.context());
            if (importance) object_.radiosity_importance = static_cast<float>(*importance);
        } else if (in_.take_word("dtag")) {
            in_.text();
        } else if (in_.peek().kind == Item::Kind::color) {
            in_.diagnostics().warning(in_.where(), "Quick color belongs in texture. Color ignored.");
            in_.skip_item();
        } else {
            return false;
        }
        return true;
    }

    void require(std::initializer_list<std::string_view> keywords) {
        std::string_view shape = keyword_;
        if (const auto* known = std::get_if<ShapePtr>(&object_.geometry)) shape = (*known)->keyword();
        if (const auto* unknown = std::get_if<UnsupportedShape>(&object_.geometry)) shape = unknown->keyword;
        if (std::find(keywords.begin(), keywords.end(), shape) == keywords.end()) misused(in_.peek_word());
    }
    [[noreturn]] void misused(std::string_view word) {
        in_.fail(fmt::format("Keyword '{}' cannot be used with this object.", word));
    }

    BlockReader& in_;
    Object& object_;
    std::string_view keyword_;
};

}  // namespace

bool is_object_keyword(std::string_view keyword) {
    // Asked several times for each object: one look at length and first letter leaves hardly any to compare.
    constexpr size_t drawers = 256;
    const auto drawer = [](std::string_view word) {
        return (static_cast<size_t>(word.front()) + 32 * word.size()) % drawers;
    };
    static const std::array<std::vector<std::string_view>, drawers> words = [&] {
        std::array<std::vector<std::string_view>, drawers> all;
        for (const std::string_view word : object_words) all[drawer(word)].push_back(word);
        for (const ShapeKind* kind : all_shapes()) all[drawer(kind->keyword)].push_back(kind->keyword);
        return all;
    }();
    if (keyword.empty()) return false;
    const auto& candidates = words[drawer(keyword)];
    return std::find(candidates.begin(), candidates.end(), keyword) != candidates.end();
}

std::optional<double> read_importance(const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    std::optional<double> importance;
    if (in.take_word("importance")) {
        const SourceRange at = in.where();
        importance = in.number();
        if (!(*importance > 0 && *importance <= 1)) in.fail_at(at, "Radiosity importance must be in (0,1].");
    }
    in.finish();
    return importance;
}

std::shared_ptr<Object> read_new_object(const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    auto object = make_object();
    object->radiosity_importance = static_cast<float>(context.session->default_importance);
    const std::string_view keyword = block.keyword;
    const auto csg = csg_kind(keyword);
    const bool is_light_group = keyword == "light_group";
    if (in.at_thing<ObjectPtr>() &&
        (keyword == "object" || !csg || (is_identifier(in.peek()) && !is_light_group))) {
        *object = *in.thing<ObjectPtr>();
    } else if (keyword == "object") {
        const ObjectPtr inner = take_object(in);
        if (!inner) in.fail(fmt::format("Expected 'object', {} found instead", in.found()));
        *object = *inner;
    } else if (csg) {
        auto children = std::make_shared<std::vector<ObjectPtr>>();
        children->reserve(
            static_cast<size_t>(std::count_if(block.items.begin(), block.items.end(), [](const Item& item) {
                return std::holds_alternative<ObjectPtr>(item.thing);
            })));
        while (ObjectPtr child = take_object(in)) children->push_back(std::move(child));
        if (children->size() < 2 && !is_light_group && context.language_version >= 150) {
            context.diagnostics->warning(block.where, "Should have at least 2 objects in csg.");
        }
        Csg compound;
        compound.kind = *csg;
        compound.children = std::move(children);
        compound.is_light_group = is_light_group;
        object->geometry = std::move(compound);
    } else if (keyword == "light_source") {
        object->where = block.where;
        object->geometry = read_light(in);
        return object;
    } else if (const ShapeKind* kind = find_shape(keyword)) {
        object->geometry = kind->read(in);
    } else {
        object->geometry = UnsupportedShape{std::string(keyword)};
        skip_shape(in);
    }
    object->where = block.where;
    ModifierReader modifiers(in, *object, keyword);
    if (is_light_group) {
        modifiers.read_of_group(std::get<Csg>(object->geometry));
    } else {
        modifiers.read();
    }
    in.finish();
    return object;
}

}  // namespace rb
