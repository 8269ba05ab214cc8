// interior, material. Language spec 18.9, 19.
#include "language/read.h"

namespace rb {

InteriorPtr read_interior(const Block& block, const ReadContext& context, const InteriorPtr& base) {
    BlockReader in(block, context);
    auto interior = std::make_shared<Interior>();
    if (base) *interior = *base;
    if (in.at_thing<InteriorPtr>()) *interior = *in.thing<InteriorPtr>();
    interior->where = block.where;
    while (!in.at_end()) {
        if (in.take_word("ior")) {
            interior->ior = in.number();
        } else if (in.take_word("dispersion")) {
            interior->dispersion = in.number();
        } else if (in.take_word("dispersion_samples")) {
            const SourceRange at = in.where();
            interior->dispersion_samples = in.integer();
            if (interior->dispersion_samples < 2) in.fail_at(at, "dispersion_samples must be at least 2.");
        } else if (in.take_word("caustics")) {
            interior->caustics = in.number();
        } else if (in.take_word("fade_distance")) {
            interior->fade_distance = in.number();
        } else if (in.take_word("fade_power")) {
            interior->fade_power = in.number();
        } else if (in.take_word("fade_color") || in.take_word("fade_colour")) {
            interior->fade_color = in.rgb_color();
        } else if (in.at_block("media")) {
            interior->media.push_back(read_media(in.block("media"), context));
        } else if (in.take_word("refraction")) {
            in.diagnostics().warning(in.where(), "Use of 'refraction' keyword is obsolete.");
            in.number();
        } else {
            break;
        }
    }
    in.finish();
    return interior;
}

std::shared_ptr<const Material> read_material(const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    auto material = std::make_shared<Material>();
    material->where = block.where;
    using Shared = std::shared_ptr<const Material>;
    if (in.at_thing<Shared>()) *material = *in.thing<Shared>();
    while (!in.at_end()) {
        Transform map;
        const SourceRange at = in.where();
        if (in.at_block("texture")) {
            material->texture = layered(material->texture, read_texture(in.block("texture"), context), at);
        } else if (in.at_block("interior_texture")) {
            material->interior_texture =
                layered(material->interior_texture, read_texture(in.block("interior_texture"), context), at);
        } else if (in.at_block("interior")) {
            material->interior = read_interior(in.block("interior"), context, material->interior);
        } else if (take_transformation(in, map)) {
            material->texture = transformed(material->texture, map);
            material->interior = transformed(material->interior, map);
        } else {
            break;
        }
    }
    in.finish();
    return material;
}

}  // namespace rb
