// Measured scenes (spec: shading 22), built in code. Names say which.
#include "pattern_text.h"
#include "scene_maker.h"

#include <cmath>

#include <gtest/gtest.h>

namespace rb {
namespace {

const Color tan_color = rgb(0.8f, 0.4f, 0.2f);

/// A plane z = 0 of one finish, lit from <4, 0, -3>: n.l = 0.6.
Radiance lit_plane(const Color& color, const std::function<void(Finish&)>& change) {
    SceneMaker s;
    s.add("plane{<0,0,1>,0}", {plain(color, dark_finish(change))});
    s.light({4, 0, -3}, Rgb(1.0f));
    return s.look_at(0, 0);
}

TEST(Shading, DefaultFinish) {
    SceneMaker s;
    s.add("plane{<0,0,1>,0}", {plain(grey_color(0.5f), Finish{})});
    s.light({0, 0, -10}, Rgb(1.0f));
    expect_grey(s.look_at(), 0.35);
}

TEST(Shading, HighlightsAndBrilliance) {
    expect_rgb(lit_plane(tan_color, [](Finish& f) { f.diffuse = 1, f.brilliance = 3; }), 0.1728, 0.0864,
               0.0432);
    expect_grey(lit_plane(tan_color, [](Finish& f) { f.phong = 0.5f, f.phong_size = 5; }), 0.0389);
    expect_grey(lit_plane(tan_color, [](Finish& f) { f.specular = 0.5f, f.roughness_exponent = 10; }),
                0.1638);
    expect_rgb(
        lit_plane(tan_color, [](Finish& f) { f.specular = 0.5f, f.roughness_exponent = 10, f.metallic = 1; }),
        0.1324, 0.0695, 0.0381);
    expect_rgb(lit_plane(grey_color(0.5f),
                         [](Finish& f) { f.diffuse = 1, f.irid_amount = 0.3f, f.irid_thickness = 0.5f; }),
               0.3561, 0.2126, 0.2550);
}

// Measured, at random: 0.5, 0.3134, 0.4004, 0.1136. The light loses a uniform share of `crand`.
TEST(Shading, CrandIsUniform) {
    SceneMaker s;
    Finish grainy = diffuse_only(0.5f);
    grainy.crand = 0.4f;
    s.add("plane{<0,0,1>,0}", {plain(grey_color(1), grainy)});
    s.light({0, 0, -1e6}, Rgb(1.0f));
    std::vector<CameraRay> rays(4000);
    for (size_t i = 0; i < rays.size(); ++i) rays[i] = {{{0.0, 0.0, -5.0}, {0, 0, 1}}, true, i};
    double sum = 0;
    double squares = 0;
    for (const Radiance& r : s.look_all(rays)) {
        const double lost = (0.5 - static_cast<double>(r.rgb.x)) / 0.4;
        EXPECT_GE(lost, -1e-5);
        EXPECT_LE(lost, 1.0);
        sum += lost;
        squares += lost * lost;
    }
    EXPECT_NEAR(sum / 4000, 1.0 / 2, 0.015);
    EXPECT_NEAR(squares / 4000, 1.0 / 3, 0.015);
}

TEST(Shading, OwnLightOfFilteringSurfaceDependsOnVersion) {
    SceneMaker s;
    const Finish bright = dark_finish([](Finish& f) { f.ambient = Rgb(1.0f); });
    s.add("plane{<0,0,1>,0}", {plain({0.8f, 0.4f, 0.2f, 0.5f, 0}, bright)});
    expect_rgb(s.look_at(), 0.4, 0.2, 0.1);
    s.scene.effective_version = 360;
    expect_rgb(s.look_at(), 0.48, 0.24, 0.12);
}

TEST(Shading, LayersFilterWhatIsBelowButNotItsMirrors) {
    SceneMaker layers;
    layers.add("plane{<0,0,1>,0}",
               {plain(tan_color, dark_finish([](Finish& f) { f.ambient = Rgb(1.0f); })),
                plain({1, 0.5f, 0, 0.5f, 0}, dark_finish([](Finish& f) { f.ambient = Rgb(0.5f); }))});
    expect_rgb(layers.look_at(), 0.65, 0.225, 0.0);

    SceneMaker mirrors;
    mirrors.scene.background = rgb(0.5f, 0.25f, 1);
    const auto mirror = [](float r) {
        return dark_finish([=](Finish& f) { f.reflection.min = f.reflection.max = Rgb(r); });
    };
    mirrors.add("plane{<0,0,1>,0}",
                {plain(grey_color(0), mirror(0.5f)), plain({1, 0.5f, 0, 0, 0.5f}, mirror(0.3f))});
    expect_rgb(mirrors.look_at(), 0.4, 0.2, 0.8);
}

TEST(Shading, ConserveEnergy) {
    SceneMaker s;
    s.scene.background = rgb(0.5f, 0.25f, 1);
    s.add("plane{<0,0,1>,10}", {plain(grey_color(1), dark_finish([](Finish& f) { f.ambient = Rgb(0.5f); }))});
    s.add("plane{<0,0,1>,0}", {plain({1, 1, 1, 0, 1}, dark_finish([](Finish& f) {
                                         f.reflection.min = f.reflection.max = Rgb(0.4f);
                                         f.conserve_energy = true;
                                     }))});
    expect_rgb(s.look_at(), 0.5, 0.4, 0.7);
}

Radiance mirror_at_60(const Color& color, const Reflection& reflection, double ior) {
    SceneMaker s;
    s.scene.background = rgb(0.5f, 0.25f, 1);
    Interior interior;
    interior.ior = ior;
    s.add("box{<-50,-50,0>,<50,50,9> rotate <0,60,0>}",
          {plain(color, dark_finish([&](Finish& f) { f.reflection = reflection; }))}, interior);
    return s.look_at();
}

TEST(Shading, Mirrors) {
    Reflection r;
    r.min = Rgb(0.2f);
    r.max = Rgb(0.8f);
    r.falloff = 3;
    expect_rgb(mirror_at_60(grey_color(0), r, 0), 0.1375, 0.0688, 0.2750);
    Reflection fresnel;
    fresnel.max = Rgb(1.0f);
    fresnel.fresnel = true;
    expect_rgb(mirror_at_60(grey_color(0), fresnel, 1.5), 0.0446, 0.0223, 0.0892);
    Reflection metallic;
    metallic.min = metallic.max = Rgb(0.5f);
    metallic.metallic = 1;
    expect_rgb(mirror_at_60(tan_color, metallic, 0), 0.2030, 0.0544, 0.1237);
    Reflection power;
    power.min = power.max = Rgb(1.0f);
    power.exponent = 2;
    SceneMaker s;
    s.scene.background = rgb(0.5f, 0.25f, 1);
    s.add("plane{<0,0,1>,0}", {plain(grey_color(0), dark_finish([&](Finish& f) { f.reflection = power; }))});
    expect_rgb(s.look_at(), 0.7071, 0.5, 1.0);
}

SceneMaker facing_mirrors(float reflection) {
    SceneMaker s;
    const Finish mirror = dark_finish([=](Finish& f) {
        f.emission = Rgb(0.1f);
        f.reflection.min = f.reflection.max = Rgb(reflection);
    });
    s.add("plane{<0,0,-1>,-1}", {plain(grey_color(1), mirror)});
    s.add("plane{<0,0,1>,-8}", {plain(grey_color(1), mirror)});
    return s;
}

TEST(Shading, LimitsOfDepth) {
    SceneMaker deep = facing_mirrors(1);
    deep.scene.settings.max_trace_level = 3;
    expect_grey(deep.look_at(), 0.3);
    SceneMaker dim = facing_mirrors(0.5f);
    dim.scene.settings.max_trace_level = 20;
    dim.scene.settings.adc_bailout = 0.3f;
    expect_grey(dim.look_at(), 0.15);
    SceneMaker endless = facing_mirrors(1);
    endless.scene.settings.max_trace_level = 256;
    expect_grey(endless.look_at(), 25.6, 1e-3);
}

TEST(Shading, ClearSurfacesCostNoLevelButRefractingOnesDo) {
    for (const double ior : {0.0, 1.5}) {
        SceneMaker s;
        s.scene.settings.max_trace_level = 2;
        s.scene.background = rgb(0.5f, 0.25f, 1);
        Interior interior;
        interior.ior = ior;
        for (int i = 0; i < 8; ++i) {
            s.add("disc{<0,0," + std::to_string(i) + ">,<0,0,-1>,9}", {plain({1, 1, 1, 0, 1}, dark_finish())},
                  interior);
        }
        if (ior == 0.0) {
            expect_rgb(s.look_at(), 0.5, 0.25, 1.0);
        } else {
            expect_grey(s.look_at(), 0.0);
        }
    }
}

Radiance through_box(double fade_power) {
    SceneMaker s;
    s.scene.background = grey_color(1);
    Interior interior;
    interior.fade_distance = 1;
    interior.fade_power = fade_power;
    interior.fade_color = {1, 0.5f, 0};
    s.add("box{<-3,-3,0>,<3,3,2>}", {plain({1, 1, 1, 0, 1}, dark_finish())}, interior);
    return s.look_at();
}

TEST(Interiors, Fade) {
    expect_rgb(through_box(0), 1.0, 0.75, 0.5);
    expect_rgb(through_box(1000), 1.0, 0.3679, 0.1353);
    SceneMaker s;
    s.scene.background = grey_color(1);
    Interior outer;
    outer.fade_distance = 1;
    outer.fade_power = 1001;
    outer.fade_color = {0, 1, 1};
    Interior inner = outer;
    inner.fade_color = {1, 0, 1};
    s.add("box{<-3,-3,0>,<3,3,4>}", {plain({1, 1, 1, 0, 1}, dark_finish())}, outer);
    s.add("box{<-2,-2,1>,<2,2,2>}", {plain({1, 1, 1, 0, 1}, dark_finish())}, inner);
    expect_rgb(s.look_at(), 0.1353, 0.3679, 1.0);
}

SceneMaker wedge(double dispersion) {
    SceneMaker s;
    Texture screen = plain(grey_color(0), dark_finish([](Finish& f) { f.emission = Rgb(1.0f); }));
    auto pigment = std::make_shared<Pigment>();
    const WrittenPattern written = pattern_of("gradient x scale 40 translate <-20,0,0>");
    pigment->source = written.pattern;
    pigment->modifiers = written.modifiers;
    screen.pigment = pigment;
    s.add("plane{<0,0,-1>,-20}", {screen});
    Interior interior;
    interior.ior = 1.5;
    interior.dispersion = dispersion;
    s.add("intersection{plane{<0,0,-1>,0 rotate <0,30,0>} plane{<0,0,1>,2}}",
          {plain({1, 1, 1, 0, 1}, dark_finish())}, interior);
    return s;
}

TEST(Interiors, Refraction) {
    expect_grey(wedge(1).look_at(0, 0), 0.63755);
    expect_rgb(wedge(1.2).look_at(0, 0), 0.61521, 0.63151, 0.65431);
    SceneMaker s;
    s.scene.background = rgb(1, 0.5f, 0.25f);
    Interior interior;
    interior.ior = 1.5;
    s.add("sphere{<-30,0,0>,1}", {plain(grey_color(1), Finish{})});
    s.add("box{<-8,-8,-8>,<8,8,2>}", {plain({1, 1, 1, 0, 0.5f}, dark_finish())}, interior);
    expect_rgb(s.look({0, 0, 0}, {1, 0, 0.5}), 0.5, 0.25, 0.125);
}

TEST(Textures, BlendsShadeBothChildren) {
    const Finish bright = dark_finish([](Finish& f) { f.ambient = Rgb(1.0f); });
    const auto child = [&](const Color& c) {
        return std::make_shared<const TextureLayers>(TextureLayers{plain(c, bright)});
    };
    const WrittenPattern written = pattern_of("gradient x scale 8 translate <-4,0,0>");
    Texture blend;
    blend.pattern = written.pattern;
    blend.modifiers = written.modifiers;
    blend.map = {{0.0f, child(rgb(1, 0, 0))}, {1.0f, child(rgb(0, 0, 1))}};
    SceneMaker s;
    s.add("plane{<0,0,1>,0}", {blend});
    expect_rgb(s.look_at(-0.5, 0), 0.5625, 0, 0.4375);
    Texture average;
    average.average = true;
    average.map = {{1.0f, child(rgb(1, 0, 0))}, {3.0f, child(rgb(0, 0, 1))}};
    SceneMaker mean;
    mean.add("plane{<0,0,1>,0}", {average});
    expect_rgb(mean.look_at(), 0.25, 0, 0.75);
}

// An object's transformation acts on its texture as if it were written in it, also where bumps keep their
// size.
TEST(Textures, PlaceOfTheObjectIsPartOfTheTexture) {
    const Transform place = then(Transform::scaling({1, 2, 3}), Transform::rotation_deg({30, 40, 50}));
    for (const char* bumps : {"bumps 0.8", "bumps 0.8 no_bump_scale", "gradient x 0.5 sine_wave"}) {
        auto normal = std::make_shared<Normal>(written_normal(bumps));
        Texture texture = plain(grey_color(1), diffuse_only());
        texture.normal = normal;
        auto pigment = std::make_shared<Pigment>();
        pigment->source = pattern_of("granite").pattern;
        texture.pigment = pigment;
        SceneMaker worn;
        worn.add("plane{<0,0,1>,0}", {texture}).texture->world_from_texture = place;
        worn.light({3, 4, -5}, Rgb(1.0f));
        SceneMaker written_in;
        written_in.add("plane{<0,0,1>,0}", {transformed(texture, place)});
        written_in.light({3, 4, -5}, Rgb(1.0f));
        for (const double x : {-2.3, 0.4, 1.7}) {
            const Rgb expected = written_in.look_at(x, 0.3).rgb;
            expect_rgb(worn.look_at(x, 0.3), expected.x, expected.y, expected.z, 1e-6);
        }
    }
}

}  // namespace
}  // namespace rb
