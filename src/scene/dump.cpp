#include "scene/scene.h"

#include <map>

#include <fmt/format.h>

namespace rb {

namespace {

std::string text(const Vec3& v) { return fmt::format("<{:.9g},{:.9g},{:.9g}>", v.x, v.y, v.z); }
std::string text(const Rgb& c) { return fmt::format("<{:.6g},{:.6g},{:.6g}>", c.x, c.y, c.z); }
std::string text(const Color& c) {
    std::string out = fmt::format("<{:.6g},{:.6g},{:.6g}", c.red, c.green, c.blue);
    if (c.filter != 0 || c.transmit != 0) out += fmt::format(",{:.6g},{:.6g}", c.filter, c.transmit);
    return out + ">";
}
std::string text(const Transform& map) {
    const auto& r = map.forward.row;
    return fmt::format("{} {} {} {}", text(r[0]), text(r[1]), text(r[2]), text(r[3]));
}

class Dumper {
public:
    std::string out;

    void line(int indent, std::string_view content) {
        out.append(static_cast<size_t>(indent) * 2, ' ');
        out += content;
        out += '\n';
    }
    void number(int indent, std::string_view name, double value, double usual) {
        if (value != usual) line(indent, fmt::format("{} {:.9g}", name, value));
    }
    void flag(int indent, std::string_view name, bool value) {
        if (value) line(indent, name);
    }
    void transform(int indent, const Transform& map) {
        if (!map.is_identity()) line(indent, "matrix " + text(map));
    }

    void camera(const Camera& c) {
        constexpr const char* kinds[] = {"perspective",      "orthographic", "fisheye",
                                         "ultra_wide_angle", "omnimax",      "panoramic",
                                         "cylinder",         "spherical",    "mesh_camera"};
        line(0, fmt::format("camera {}", kinds[static_cast<size_t>(c.kind)]));
        line(1, "location " + text(c.location));
        line(1, "direction " + text(c.direction));
        line(1, "up " + text(c.up));
        line(1, "right " + text(c.right));
        number(1, "angle", c.angle_deg, 90);
        number(1, "vertical_angle", c.vertical_angle_deg, 180);
        number(1, "aperture", c.aperture, 0);
        number(1, "blur_samples", c.blur_samples, 0);
        number(1, "focal_distance", c.focal_distance, 1);
    }

    void photons(int indent, const PhotonSettings& p) {
        line(indent, fmt::format("photons spacing {:.9g} count {:.9g} gather {} {}", p.spacing, p.count,
                                 p.gather_min, p.gather_max));
        number(indent + 1, "jitter", p.jitter, 0.4);
        number(indent + 1, "autostop", p.autostop, 0.5);
        line(indent + 1, fmt::format("expand_thresholds {:.9g} {:.9g}", p.expand_increase, p.expand_count));
        line(indent + 1,
             fmt::format("radius {:.9g} {:.9g} {:.9g} {:.9g}", p.surface_radius.radius,
                         p.surface_radius.multiplier, p.media_radius.radius, p.media_radius.multiplier));
        if (p.media_steps > 0)
            line(indent + 1, fmt::format("media {} {:.9g}", p.media_steps, p.media_factor));
        number(indent + 1, "max_trace_level", p.max_trace_level, -1);
        number(indent + 1, "adc_bailout", p.adc_bailout, -1);
        if (!p.save_file.empty()) line(indent + 1, "save_file " + p.save_file);
        if (!p.load_file.empty()) line(indent + 1, "load_file " + p.load_file);
    }

    void light(int indent, const Light& l) {
        constexpr const char* kinds[] = {"point", "spotlight", "cylinder", "shadowless"};
        line(indent, fmt::format("light_source {} {} {}", kinds[static_cast<size_t>(l.kind)],
                                 text(l.location), text(l.color)));
        flag(indent + 1, "parallel", l.parallel);
        if (l.parallel || l.kind == LightKind::spotlight || l.kind == LightKind::cylinder) {
            line(indent + 1, "point_at " + text(l.point_at));
        }
        if (l.kind == LightKind::spotlight || l.kind == LightKind::cylinder) {
            line(indent + 1, fmt::format("radius {:.9g} falloff {:.9g} tightness {:.9g}", l.radius, l.falloff,
                                         l.tightness));
        }
        if (l.is_area) {
            line(indent + 1, fmt::format("area_light {} {} {} {} adaptive {}{}{}{}{}", text(l.area.axis1),
                                         text(l.area.axis2), l.area.size1, l.area.size2, l.area.adaptive,
                                         l.area.jitter ? " jitter" : "", l.area.circular ? " circular" : "",
                                         l.area.orient ? " orient" : "",
                                         l.area.area_illumination ? " area_illumination" : ""));
        }
        number(indent + 1, "fade_distance", l.fade_distance, 0);
        number(indent + 1, "fade_power", l.fade_power, 0);
        flag(indent + 1, "media_attenuation", l.media_attenuation);
        flag(indent + 1, "media_interaction off", !l.media_interaction);
        photon_ways(indent + 1, l.photons.ways);
        flag(indent + 1, "photons area_light", l.photons.from_area);
        if (l.looks_like) object(indent + 1, *l.looks_like, "looks_like ");
        if (l.projected_through) object(indent + 1, *l.projected_through, "projected_through ");
    }

    void object(int indent, const Object& o, std::string_view prefix = "") {
        if (const auto* l = std::get_if<LightPtr>(&o.geometry)) return light(indent, **l);
        std::string name(prefix);
        if (const auto* shape = std::get_if<ShapePtr>(&o.geometry)) name += (*shape)->keyword();
        if (const auto* unknown = std::get_if<UnsupportedShape>(&o.geometry))
            name += unknown->keyword + " (unsupported)";
        const auto* csg = std::get_if<Csg>(&o.geometry);
        constexpr const char* kinds[] = {"union", "merge", "intersection", "difference"};
        if (csg) name += csg->is_light_group ? "light_group" : kinds[static_cast<size_t>(csg->kind)];
        line(indent, name);
        if (const auto* shape = std::get_if<ShapePtr>(&o.geometry))
            described(indent + 1, (*shape)->describe());
        if (csg) {
            for (const ObjectPtr& child : *csg->children) object(indent + 1, *child);
            flag(indent + 1, "split_union off", !csg->split_union);
            flag(indent + 1, "cutaway_textures", csg->cutaway_textures);
            flag(indent + 1, "global_lights", csg->global_lights);
        }
        transform(indent + 1, o.world_from_object);
        if (o.texture) worn(indent + 1, "texture", *o.texture);
        if (o.interior_texture) worn(indent + 1, "interior_texture", *o.interior_texture);
        if (o.interior) interior(indent + 1, *o.interior);
        for (const ObjectPtr& b : o.bounded_by) object(indent + 1, *b, "bounded_by ");
        for (const ObjectPtr& c : o.clipped_by) object(indent + 1, *c, "clipped_by ");
        flags(indent + 1, o);
    }

    void layers(int indent, const TextureLayers& layers) {
        for (const Texture& layer : layers) texture(indent, layer);
    }

    void pigment(int indent, const Pigment& p, const std::string& keyword = "pigment") {
        if (const auto* color = std::get_if<Color>(&p.source)) {
            line(indent, keyword + " " + text(*color));
        } else {
            const auto* pattern = std::get_if<PatternPtr>(&p.source);
            const std::string name = pattern && *pattern ? (*pattern)->describe()
                                     : p.average         ? "average"
                                                         : "none";
            line(indent, keyword + " " + name);
            modifiers(indent + 1, p.modifiers);
        }
        flag(indent + 1, "uv_mapping", p.uv_mapping);
        if (const auto* colors = std::get_if<ColorMap>(&p.map)) color_map(indent + 1, *colors);
        if (const auto* children = std::get_if<BlendMap<PigmentPtr>>(&p.map)) {
            for (const auto& entry : *children) {
                line(indent + 1, fmt::format("[{:.6g}]", entry.position));
                pigment(indent + 2, *entry.value, keyword);
            }
        }
        if (p.quick_color) line(indent + 1, "quick_color " + text(*p.quick_color));
    }

    void color_map(int indent, const ColorMap& map) {
        for (const auto& entry : map)
            line(indent, fmt::format("[{:.6g} {}]", entry.position, text(entry.value)));
    }

    void media(int indent, const Media& m) {
        line(indent, "media");
        line(indent + 1, fmt::format("method {} intervals {} samples {}, {}", m.method, m.intervals,
                                     m.min_samples, m.max_samples));
        number(indent + 1, "confidence", m.confidence, 0.9);
        number(indent + 1, "variance", m.variance, 1.0 / 128.0);
        number(indent + 1, "ratio", m.ratio, 0.9);
        number(indent + 1, "aa_threshold", m.aa_threshold, 0.1);
        number(indent + 1, "aa_level", m.aa_level, 3);
        number(indent + 1, "jitter", m.jitter, 0);
        if (m.absorption != Rgb{0.0f}) line(indent + 1, "absorption " + text(m.absorption));
        if (m.emission != Rgb{0.0f}) line(indent + 1, "emission " + text(m.emission));
        if (m.scattering.color != Rgb{0.0f}) {
            line(indent + 1,
                 fmt::format("scattering {} {} eccentricity {:.9g} extinction {:.9g}", m.scattering.type,
                             text(m.scattering.color), m.scattering.eccentricity, m.scattering.extinction));
        }
        flag(indent + 1, "collect off", !m.collect);
        for (const DensityPtr& density : m.densities) pigment(indent + 1, *density, "density");
    }

    void rainbow(const Rainbow& r) {
        line(0, fmt::format("rainbow direction {} up {} angle {:.9g} width {:.9g} distance {:.9g}",
                            text(r.direction), text(r.up), r.angle, r.width, r.distance));
        number(1, "jitter", r.jitter, 0);
        number(1, "arc_angle", r.arc_angle, 360);
        number(1, "falloff_angle", r.falloff_angle, 360);
        if (r.color_map) color_map(1, *r.color_map);
    }

private:
    void described(int indent, const std::string& all) {
        size_t start = 0;
        while (start < all.size()) {
            const size_t end = std::min(all.find('\n', start), all.size());
            line(indent, std::string_view(all).substr(start, end - start));
            start = end + 1;
        }
    }

    void flags(int indent, const Object& o) {
        flag(indent, "uv_mapping", o.uv_mapping);
        flag(indent, "inverse", o.inverse);
        flag(indent, "no_shadow", o.no_shadow);
        flag(indent, "no_image", o.no_image);
        flag(indent, "no_reflection", o.no_reflection);
        flag(indent, "no_radiosity", o.no_radiosity);
        if (o.radiosity_importance != 1.0f)
            line(indent, fmt::format("radiosity importance {}", o.radiosity_importance));
        flag(indent, "double_illuminate", o.double_illuminate);
        flag(indent, "sturm", o.sturm);
        if (o.hollow) line(indent, *o.hollow ? "hollow" : "hollow off");
        number(indent, "photons target", static_cast<double>(o.photons.target), 0);
        photon_ways(indent, o.photons.ways);
        flag(indent, "photons collect off", !o.photons.collect);
        flag(indent, "photons pass_through", o.photons.pass_through);
    }

    void photon_ways(int indent, const PhotonWays& ways) {
        const auto way = [&](const char* name, PhotonSwitch value) {
            if (value == PhotonSwitch::unsaid) return;
            line(indent, fmt::format("photons {} {}", name, value == PhotonSwitch::on ? "on" : "off"));
        };
        way("refraction", ways.refraction);
        way("reflection", ways.reflection);
    }

    void worn(int indent, std::string_view name, const WornTexture& worn) {
        line(indent, name);
        transform(indent + 1, worn.world_from_texture);
        if (worn.layers) layers(indent + 1, *worn.layers);
    }

    void interior(int indent, const Interior& i) {
        line(indent, "interior");
        number(indent + 1, "ior", i.ior, 0);
        number(indent + 1, "dispersion", i.dispersion, 1);
        number(indent + 1, "caustics", i.caustics, 0);
        number(indent + 1, "fade_distance", i.fade_distance, 0);
        number(indent + 1, "fade_power", i.fade_power, 0);
        if (i.fade_color != Rgb{0.0f}) line(indent + 1, "fade_color " + text(i.fade_color));
        for (const MediaPtr& m : i.media) media(indent + 1, *m);
    }

    void modifiers(int indent, const PatternModifiers& m) {
        constexpr const char* waves[] = {"ramp", "triangle", "sine", "scallop", "cubic", "poly"};
        number(indent, "frequency", static_cast<double>(m.frequency), 1);
        number(indent, "phase", static_cast<double>(m.phase), 0);
        if (m.wave != Wave::ramp) line(indent, fmt::format("{}_wave", waves[static_cast<size_t>(m.wave)]));
        number(indent, "poly_exponent", static_cast<double>(m.poly_exponent), 1);
        number(indent, "noise_generator", m.noise_generator, 0);
        number(indent, "agate_turb", static_cast<double>(m.agate_turbulence), 1);
        for (const Warp& warp : m.warps) this->warp(indent, warp);
    }

    void warp(int indent, const Warp& warp) {
        if (const auto* map = std::get_if<Transform>(&warp)) line(indent, "matrix " + text(*map));
        if (const auto* t = std::get_if<TurbulenceWarp>(&warp)) {
            line(indent, fmt::format("{} {} octaves {} omega {:.6g} lambda {:.6g}",
                                     t->classic ? "turbulence" : "warp turbulence", text(t->amount),
                                     t->octaves, t->omega, t->lambda));
        }
        if (const auto* r = std::get_if<RepeatWarp>(&warp)) {
            line(indent, fmt::format("warp repeat axis {} width {:.6g} offset {} flip {}", r->axis, r->width,
                                     text(r->offset), text(r->flip)));
        }
        if (const auto* b = std::get_if<BlackHoleWarp>(&warp)) {
            line(indent, fmt::format("warp black_hole {} radius {:.6g} strength {:.6g} falloff {:.6g}{}",
                                     text(b->center), b->radius, b->strength, b->falloff,
                                     b->inverse ? " inverse" : ""));
        }
        if (const auto* m = std::get_if<MappingWarp>(&warp)) {
            constexpr const char* kinds[] = {"cylindrical", "spherical", "toroidal", "planar"};
            line(indent, fmt::format("warp {} orientation {} dist_exp {:.6g}",
                                     kinds[static_cast<size_t>(m->kind)], text(m->orientation), m->dist_exp));
        }
        if (std::holds_alternative<CubicWarp>(warp)) line(indent, "warp cubic");
    }

    void normal(int indent, const Normal& n) {
        line(indent, fmt::format("normal {} {:.6g}",
                                 n.pattern   ? n.pattern->describe()
                                 : n.average ? "average"
                                             : "none",
                                 n.amount));
        modifiers(indent + 1, n.modifiers);
        number(indent + 1, "accuracy", static_cast<double>(n.accuracy), static_cast<double>(0.02f));
        flag(indent + 1, "no_bump_scale", n.no_bump_scale);
        flag(indent + 1, "uv_mapping", n.uv_mapping);
        if (const auto* slopes = std::get_if<BlendMap<HeightSlope>>(&n.map)) {
            for (const auto& e : *slopes) {
                line(indent + 1,
                     fmt::format("[{:.6g} <{:.6g},{:.6g}>]", e.position, e.value.height, e.value.slope));
            }
        }
        if (const auto* children = std::get_if<BlendMap<NormalPtr>>(&n.map)) {
            for (const auto& e : *children) {
                line(indent + 1, fmt::format("[{:.6g}]", e.position));
                normal(indent + 2, *e.value);
            }
        }
    }

    void finish(int indent, const Finish& f) {
        line(indent, "finish");
        const auto single = [&](std::string_view name, float value, float usual) {
            if (value != usual) line(indent + 1, fmt::format("{} {:.6g}", name, value));
        };
        if (f.ambient != Rgb{0.1f}) line(indent + 1, "ambient " + text(f.ambient));
        if (f.emission != Rgb{0.0f}) line(indent + 1, "emission " + text(f.emission));
        single("diffuse", f.diffuse, 0.6f);
        single("diffuse_back", f.diffuse_back, 0);
        single("brilliance", f.brilliance, 1);
        single("crand", f.crand, 0);
        single("phong", f.phong, 0);
        single("phong_size", f.phong_size, 40);
        single("specular", f.specular, 0);
        single("roughness_exponent", f.roughness_exponent, 20);
        single("metallic", f.metallic, 0);
        if (f.reflection.max != Rgb{0.0f} || f.reflection.min != Rgb{0.0f}) {
            line(indent + 1, fmt::format("reflection {} {}{} falloff {:.6g} exponent {:.6g} metallic {:.6g}",
                                         text(f.reflection.min), text(f.reflection.max),
                                         f.reflection.fresnel ? " fresnel" : "", f.reflection.falloff,
                                         f.reflection.exponent, f.reflection.metallic));
        }
        flag(indent + 1, "conserve_energy", f.conserve_energy);
        single("irid", f.irid_amount, 0);
        if (f.ior) single("ior", *f.ior, 0);
        if (f.caustics) single("caustics", *f.caustics, 0);
    }

    void texture(int indent, const Texture& t) {
        line(indent, "layer");
        flag(indent + 1, "uv_mapping", t.uv_mapping);
        if (t.is_patterned()) {
            line(indent + 1, "pattern " + (t.pattern ? t.pattern->describe() : std::string("average")));
            modifiers(indent + 1, t.modifiers);
            for (const auto& entry : t.map) {
                line(indent + 1, fmt::format("[{:.6g}]", entry.position));
                layers(indent + 2, *entry.value);
            }
            return;
        }
        if (t.pigment) pigment(indent + 1, *t.pigment);
        if (t.normal) normal(indent + 1, *t.normal);
        if (t.finish) finish(indent + 1, *t.finish);
    }
};

void dump_radiosity(Dumper& d, const RadiositySettings& s) {
    const RadiositySettings usual;
    d.line(1, "radiosity");
    d.number(2, "adc_bailout", static_cast<double>(s.adc_bailout), static_cast<double>(usual.adc_bailout));
    d.flag(2, "always_sample", s.always_sample);
    d.number(2, "brightness", static_cast<double>(s.brightness), 1.0);
    d.number(2, "count", s.count, usual.count);
    d.number(2, "error_bound", s.error_bound, usual.error_bound);
    d.number(2, "gray_threshold", static_cast<double>(s.gray_threshold), 0.0);
    d.number(2, "low_error_factor", s.low_error_factor, usual.low_error_factor);
    d.number(2, "max_sample", static_cast<double>(s.max_sample), static_cast<double>(usual.max_sample));
    d.number(2, "maximum_reuse", s.maximum_reuse, usual.maximum_reuse);
    d.number(2, "minimum_reuse", s.minimum_reuse, usual.minimum_reuse);
    d.number(2, "nearest_count", s.nearest_count, usual.nearest_count);
    d.flag(2, "normal", s.normal);
    d.flag(2, "media", s.media);
    d.flag(2, "subsurface", s.subsurface);
    d.number(2, "pretrace_start", s.pretrace_start, usual.pretrace_start);
    d.number(2, "pretrace_end", s.pretrace_end, usual.pretrace_end);
    d.number(2, "recursion_limit", s.recursion_limit, usual.recursion_limit);
}

void dump_settings(Dumper& d, const Scene& scene) {
    const GlobalSettings& s = scene.settings;
    d.line(0, fmt::format("version {} effective {}", scene.language_version, scene.effective_version));
    d.line(0, "global_settings");
    if (s.assumed_gamma) {
        const auto* power = std::get_if<double>(&*s.assumed_gamma);
        d.line(1, power ? fmt::format("assumed_gamma {:.9g}", *power) : std::string("assumed_gamma srgb"));
    }
    d.number(1, "adc_bailout", static_cast<double>(s.adc_bailout), static_cast<double>(1.0f / 255.0f));
    if (s.ambient_light != Rgb{1.0f}) d.line(1, "ambient_light " + text(s.ambient_light));
    d.number(1, "max_trace_level", s.max_trace_level, 5);
    d.number(1, "noise_generator", s.noise_generator, 2);
    d.number(1, "number_of_waves", s.number_of_waves, 10);
    if (s.radiosity) dump_radiosity(d, *s.radiosity);
    if (s.photons) d.photons(1, *s.photons);
    d.flag(1, "subsurface", s.subsurface.has_value());
}

}  // namespace

std::string dump(const Scene& scene) {
    Dumper d;
    dump_settings(d, scene);
    d.camera(scene.camera);
    if (scene.background) d.line(0, "background " + text(*scene.background));
    if (scene.sky_sphere) {
        d.line(0, "sky_sphere");
        for (const PigmentPtr& pigment : scene.sky_sphere->pigments) d.pigment(1, *pigment);
        d.transform(1, scene.sky_sphere->world_from_sky);
    }
    for (const Fog& fog : scene.fogs) {
        d.line(0, fmt::format("fog {} distance {:.9g} type {} offset {:.9g} alt {:.9g} up {}",
                              text(fog.color), fog.distance, fog.type, fog.offset, fog.alt, text(fog.up)));
    }
    for (const Rainbow& rainbow : scene.rainbows) d.rainbow(rainbow);
    for (const MediaPtr& media : scene.atmosphere) d.media(0, *media);
    for (const ObjectPtr& object : scene.objects) d.object(0, *object);
    if (scene.default_texture) {
        d.line(0, "default");
        d.layers(1, *scene.default_texture);
    }
    return d.out;
}

}  // namespace rb
