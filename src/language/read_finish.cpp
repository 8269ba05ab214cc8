// finish. Language spec 18.3.
#include "language/read.h"

#include <cmath>

#include <fmt/format.h>

namespace rb {

namespace {

/// What `albedo` asks for at the end of the block.
struct Albedo {
    bool diffuse = false;
    bool phong = false;
    bool specular = false;
};

void read_reflection(const Block& block, const ReadContext& context, Finish& finish) {
    BlockReader in(block, context);
    Reflection reflection;
    reflection.exponent = finish.reflection.exponent;
    reflection.max = in.rgb_color();
    reflection.min = reflection.max;
    bool two = false;
    if (in.at_color()) {
        two = true;
        reflection.max = in.rgb_color();
    }
    while (!in.at_end()) {
        if (in.take_word("fresnel")) {
            const SourceRange at = in.where();
            const double value = in.at_number() ? std::trunc(in.number()) : 1.0;
            if (value != 0 && value != 1) in.fail_at(at, "fresnel must be true or false");
            reflection.fresnel = value == 1;
        } else if (in.take_word("falloff")) {
            reflection.falloff = static_cast<float>(in.number());
        } else if (in.take_word("exponent")) {
            reflection.exponent = static_cast<float>(in.number());
        } else if (in.take_word("metallic")) {
            reflection.metallic = in.at_number() ? static_cast<float>(in.number()) : 1.0f;
        } else {
            break;
        }
    }
    in.finish();
    if (!two && reflection.fresnel) reflection.min = Rgb{0.0f};
    finish.reflection = reflection;
}

void read_irid(const Block& block, const ReadContext& context, Finish& finish) {
    BlockReader in(block, context);
    finish.irid_amount = static_cast<float>(in.number());
    while (!in.at_end()) {
        if (in.take_word("thickness")) {
            finish.irid_thickness = static_cast<float>(in.number());
        } else if (in.take_word("turbulence")) {
            finish.irid_turbulence = static_cast<float>(in.vec3().x);
        } else {
            break;
        }
    }
    in.finish();
}

void read_subsurface(const Block& block, const ReadContext& context, Finish& finish) {
    BlockReader in(block, context);
    if (!finish.translucency) finish.translucency.emplace(0.0f);
    while (!in.at_end()) {
        if (in.take_word("translucency")) {
            finish.translucency = in.rgb_color();
        } else if (in.at_word("anisotropy")) {
            const SourceRange where = in.where();
            in.skip_item();
            if (in.rgb_color() != Rgb(0.0f))
                context.diagnostics->unsupported(where, "anisotropy",
                                                 "light is scattered in all directions alike");
        } else {
            break;
        }
    }
    in.finish();
}

bool take_highlight(BlockReader& in, Finish& finish, Albedo& albedo) {
    if (in.take_word("diffuse")) {
        albedo.diffuse = in.take_word("albedo");
        finish.raw_diffuse = static_cast<float>(in.number());
        finish.raw_diffuse_back = in.at_number() ? static_cast<float>(in.number()) : 0.0f;
        finish.diffuse = finish.raw_diffuse;
        finish.diffuse_back = finish.raw_diffuse_back;
    } else if (in.take_word("brilliance")) {
        finish.brilliance = static_cast<float>(in.number());
    } else if (in.take_word("phong")) {
        albedo.phong = in.take_word("albedo");
        finish.phong = static_cast<float>(in.number());
    } else if (in.take_word("phong_size")) {
        finish.phong_size = static_cast<float>(in.number());
    } else if (in.take_word("specular")) {
        albedo.specular = in.take_word("albedo");
        finish.specular = static_cast<float>(in.number());
    } else if (in.take_word("roughness")) {
        const SourceRange at = in.where();
        const double roughness = in.number();
        if (roughness == 0) {
            in.diagnostics().warning(at, "Zero roughness used.");
            finish.roughness_exponent = 0;
        } else {
            finish.roughness_exponent = static_cast<float>(1 / roughness);
        }
    } else {
        return false;
    }
    return true;
}

bool take_legacy(BlockReader& in, Finish& finish) {
    const SourceRange at = in.where();
    if (in.take_word("ior")) {
        finish.ior = static_cast<float>(in.number());
    } else if (in.take_word("caustics")) {
        finish.caustics = static_cast<float>(in.number());
    } else if (in.take_word("refraction")) {
        finish.refraction = static_cast<float>(in.number());
    } else {
        return false;
    }
    in.diagnostics().warning(at, "This belongs in the interior statement.");
    return true;
}

bool take_item(BlockReader& in, Finish& finish) {
    if (in.take_word("ambient")) {
        finish.ambient = in.rgb_color();
    } else if (in.take_word("emission")) {
        finish.emission = in.rgb_color();
    } else if (in.take_word("crand")) {
        finish.crand = static_cast<float>(in.number());
    } else if (in.take_word("metallic")) {
        finish.metallic = in.at_number() ? static_cast<float>(in.number()) : 1.0f;
    } else if (in.take_word("conserve_energy")) {
        finish.conserve_energy = in.optional_switch();
    } else if (in.at_block("reflection")) {
        read_reflection(in.block("reflection"), in.context(), finish);
    } else if (in.take_word("reflection")) {
        finish.reflection.max = in.rgb_color();
        finish.reflection.min = finish.reflection.max;
    } else if (in.take_word("reflection_exponent")) {
        finish.reflection.exponent = static_cast<float>(in.number());
    } else if (in.at_block("irid")) {
        read_irid(in.block("irid"), in.context(), finish);
    } else if (in.at_block("subsurface")) {
        read_subsurface(in.block("subsurface"), in.context(), finish);
    } else {
        return false;
    }
    return true;
}

}  // namespace

FinishPtr read_finish(const Block& block, const ReadContext& context, const FinishPtr& base) {
    BlockReader in(block, context);
    auto finish = std::make_shared<Finish>();
    if (base) *finish = *base;
    finish->where = block.where;
    if (in.at_thing<FinishPtr>()) *finish = *in.thing<FinishPtr>();
    Albedo albedo;
    while (!in.at_end()) {
        if (!take_highlight(in, *finish, albedo) && !take_item(in, *finish) && !take_legacy(in, *finish))
            break;
    }
    in.finish();
    if (albedo.diffuse) {
        finish->diffuse *= (finish->brilliance + 1) / 2;
        finish->diffuse_back *= (finish->brilliance + 1) / 2;
    }
    if (albedo.phong) finish->phong *= (finish->phong_size + 1) / 2;
    if (albedo.specular) {
        const float r = finish->roughness_exponent;
        finish->specular *= (r + 2) / (4 * (2 - std::pow(2.0f, -r / 2)));
    }
    return finish;
}

}  // namespace rb
