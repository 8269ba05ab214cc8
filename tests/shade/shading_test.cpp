// Measured scenes (spec: shading 22), built in code. Names say which.
#include "pattern_text.h"
#include "scene_maker.h"

#include <cmath>

#include <gtest/gtest.h>

namespace rb {
namespace {

const Color tan_color = rgb(0.8f, 0.4f, 0.2f);

void expect_rgb(const Radiance& seen, double r, double g, double b, double tolerance = 7e-5) {
    EXPECT_NEAR(seen.rgb.x, r, tolerance);
    EXPECT_NEAR(seen.rgb.y, g, tolerance);
    EXPECT_NEAR(seen.rgb.z, b, tolerance);
}
void expect_grey(const Radiance& seen, double v, double tolerance = 7e-5) {
    expect_rgb(seen, v, v, v, tolerance);
}

Finish diffuse_only(float diffuse = 1.0f) {
    return dark_finish([=](Finish& f) { f.diffuse = diffuse; });
}

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

/// A white plane seen at the centres of pixels of an 8 x 8 picture, 8 units wide.
void expect_row(const SceneMaker& s, int first_column, const std::vector<double>& expected,
                double from_z = -5) {
    for (size_t i = 0; i < expected.size(); ++i) {
        const double x = first_column + static_cast<double>(i) + 0.5 - 4.0;
        EXPECT_NEAR(s.look_at(x, -0.5, from_z).rgb.x, expected[i], 7e-5)
            << "column " << first_column + static_cast<int>(i);
    }
}

TEST(Lights, Cones) {
    SceneMaker spot;
    spot.add("plane{<0,0,1>,0}", {plain(grey_color(1), diffuse_only())});
    spot.light({0, 0, -4}, Rgb(1.0f), [](Light& l) {
        l.kind = LightKind::spotlight;
        l.point_at = Vec3{0.0};
    });
    expect_row(spot, 4, {0.9847, 0.9300, 0.7964, 0.1302});

    SceneMaker tight;
    tight.add("plane{<0,0,1>,0}", {plain(grey_color(1), diffuse_only())});
    tight.light({0, 0, -4}, Rgb(1.0f), [](Light& l) {
        l.kind = LightKind::spotlight;
        l.point_at = Vec3{0.0};
        l.radius = 10;
        l.falloff = 40;
        l.tightness = 10;
    });
    expect_row(tight, 4, {0.8443, 0.3794, 0.0438, 0.0});

    SceneMaker tube;
    tube.add("plane{<0,0,1>,0}", {plain(grey_color(1), diffuse_only())});
    tube.light({0, 0.5, -4}, Rgb(1.0f), [](Light& l) {
        l.kind = LightKind::cylinder;
        l.point_at = {0, 0.5, 0};
        l.radius = 1.5;
        l.falloff = 3.2;
        l.tightness = 2;
    });
    expect_row(tube, 4, {0.4233, 0.1747, 0.0054, 0.0});
}

TEST(Lights, ParallelFadeAndBackside) {
    SceneMaker parallel;
    parallel.add("plane{<0,0,1>,0}", {plain(grey_color(1), diffuse_only())});
    parallel.light({4, 0, -4}, Rgb(1.0f), [](Light& l) { l.parallel = true; });
    expect_grey(parallel.look_at(), 0.7809);

    SceneMaker fade;
    fade.add("plane{<0,0,1>,0}", {plain(grey_color(1), diffuse_only())});
    fade.light({0, 0, -4}, Rgb(0.5f), [](Light& l) { l.fade_distance = l.fade_power = 2; });
    expect_grey(fade.look_at(), 0.2);

    SceneMaker back;
    back.add("disc{<0,0,0>,<0,0,1>,5}", {plain(grey_color(1), dark_finish([](Finish& f) {
                                                   f.diffuse = 0.6f;
                                                   f.diffuse_back = 0.3f;
                                               }))});
    back.light({0, 0, 4}, Rgb(0.5f));
    expect_grey(back.look_at(), 0.15);
}

SceneMaker half_shaded_area(const std::function<void(AreaGrid&)>& change) {
    SceneMaker s;
    s.scene.camera.location = {0, 0, -50};
    s.add("plane{<0,0,1>,0}", {plain(grey_color(1), diffuse_only())}).hollow = true;
    s.add("box{<-100,-100,-4.01>,<0,100,-4>}", {plain(grey_color(0), Finish{})}).no_image = true;
    s.light({0, 0, -8}, Rgb(1.0f), [&](Light& l) {
        l.is_area = true;
        l.area.axis1 = {7, 0, 0};
        l.area.axis2 = {0, 7, 0};
        change(l.area);
    });
    return s;
}

TEST(Lights, AreaGrids) {
    const auto grid = [](int size) { return [size](AreaGrid& g) { g.size1 = g.size2 = size; }; };
    expect_row(half_shaded_area(grid(5)), 1, {0.1191, 0.3679, 0.3735, 0.6226, 0.6131, 0.8337, 0.8003}, -50);
    expect_row(half_shaded_area(grid(4)), 1, {0.2382, 0.2453, 0.4981, 0.4981, 0.7358, 0.7146, 0.6860}, -50);
    expect_row(half_shaded_area([](AreaGrid& g) { g.size1 = g.size2 = 9, g.adaptive = 1; }), 1,
               {0.1787, 0.3066, 0.4358, 0.5603, 0.6744, 0.7741, 0.8575}, -50);
    expect_row(half_shaded_area([](AreaGrid& g) { g.size1 = g.size2 = 7, g.circular = true; }), 1,
               {0.0893, 0.2453, 0.3735, 0.6226, 0.7358, 0.8635, 0.8861}, -50);
}

TEST(Lights, AreaIlluminationAndAbsoluteThreshold) {
    SceneMaker s;
    s.add("plane{<0,0,1>,0}", {plain(grey_color(1), diffuse_only())});
    s.light({0, 0, -10}, Rgb(1.0f), [](Light& l) {
        l.is_area = true;
        l.area.axis1 = {40, 0, 0};
        l.area.axis2 = {0, 40, 0};
        l.area.size1 = l.area.size2 = 3;
        l.area.area_illumination = true;
    });
    expect_grey(s.look_at(), 0.4580);

    SceneMaker dim;
    dim.add("plane{<0,0,1>,0}", {plain(grey_color(10), diffuse_only())});
    dim.add("box{<-100,-100,-5>,<-1,100,-4>}", {plain(grey_color(0), Finish{})}).no_image = true;
    dim.light({0, 0, -10}, Rgb(0.03f), [](Light& l) {
        l.is_area = true;
        l.area.axis1 = {8, 0, 0};
        l.area.axis2 = {0, 8, 0};
        l.area.size1 = l.area.size2 = 9;
        l.area.adaptive = 0;
    });
    expect_grey(dim.look_at(), 0.15);
}

// The mean over many seeds must be that of the language's own jitter: cells of the grid, uniformly.
TEST(Lights, JitterKeepsTheDensityOfTheGrid) {
    SceneMaker s = half_shaded_area([](AreaGrid& g) { g.size1 = g.size2 = 4, g.jitter = true; });
    std::vector<CameraRay> rays(4000);
    for (size_t i = 0; i < rays.size(); ++i) rays[i] = {{{1.0, 0.0, -50.0}, {0, 0, 1}}, true, i};
    double sum = 0;
    for (const Radiance& r : s.look_all(rays)) sum += static_cast<double>(r.rgb.x);
    // Lit share: light x > -1 of a light spread over +-(7/2)(4/3).
    const double share = (7.0 / 2 * 4 / 3 + 1.0) / (7.0 * 4 / 3);
    EXPECT_NEAR(sum / 4000, share * 8.0 / std::sqrt(65.0), 2e-3);
}

SceneMaker lamp_behind(const std::function<void(SceneMaker&)>& add_blocker) {
    SceneMaker s;
    s.scene.camera.location = {0, 0, 5};
    s.add("plane{<0,0,-1>,-10}", {plain(grey_color(1), diffuse_only())});
    s.light({0, 0, -10}, Rgb(1.0f));
    add_blocker(s);
    return s;
}

TEST(Shadows, FilteringSurfaces) {
    const SceneMaker box = lamp_behind([](SceneMaker& s) {
        s.add("box{<-3,-3,0>,<3,3,2>}", {plain({1, 0.5f, 0.25f, 0.5f, 0.25f}, Finish{})});
    });
    expect_rgb(box.look_at(0.0005, 0.0005, 5), 0.5625, 0.25, 0.1406);
    const SceneMaker fade = lamp_behind([](SceneMaker& s) {
        Interior interior;
        interior.fade_distance = 1;
        interior.fade_power = 2;
        interior.fade_color = {1, 0.5f, 0};
        s.add("box{<-3,-3,0>,<3,3,2>}", {plain({1, 1, 1, 0, 1}, Finish{})}, interior);
    });
    expect_rgb(fade.look_at(0.0005, 0.0005, 5), 1.0, 0.6, 0.2);
    const SceneMaker caustics = lamp_behind([](SceneMaker& s) {
        Interior interior;
        interior.caustics = 0.5;
        s.add("disc{<0,0,0>,<0,0,1>,3 rotate <0,20,0>}", {plain({1, 1, 1, 0, 0.2f}, Finish{})}, interior);
    });
    expect_grey(caustics.look_at(0.0005, 0.0005, 5), 0.2493);
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

TEST(Sky, LayersOfASkySphereDependOnVersion) {
    const auto pigment = [](const Color& c) {
        auto p = std::make_shared<Pigment>();
        p->source = c;
        return p;
    };
    SceneMaker s;
    s.scene.background = rgb(0.9f, 0.6f, 0.3f);
    s.scene.sky_sphere.emplace();
    s.scene.sky_sphere->pigments = {pigment({1, 0, 0, 0, 0.25f}), pigment({0.2f, 0.8f, 0.4f, 0.3f, 0.2f})};
    expect_rgb(s.look_at(), 0.3535, 0.466, 0.224);
    s.scene.effective_version = 360;
    expect_rgb(s.look_at(), 0.52, 0.43, 0.215);
    SceneMaker plain_sky;
    plain_sky.scene.background = Color{0.9f, 0.6f, 0.3f, 0, 0.4f};
    expect_rgb(plain_sky.look_at(), 0.54, 0.36, 0.18);
    plain_sky.scene.effective_version = 360;
    expect_rgb(plain_sky.look_at(), 0.9, 0.6, 0.3);
}

TEST(Fog, ConstantAndGround) {
    SceneMaker s;
    s.scene.camera.location = {0, 0, -15};
    Fog fog;
    fog.color = rgb(0.2f, 0.4f, 0.8f);
    fog.distance = 20;
    s.scene.fogs = {fog};
    s.add("disc{<0,0,0>,<0,0,-1>,50}",
          {plain(rgb(1, 0.5f, 0.25f), dark_finish([](Finish& f) { f.emission = Rgb(1.0f); }))});
    expect_rgb(s.look_at(0, 0, -15), 0.577893, 0.447237, 0.540198, 2e-5);
    s.scene.fogs[0].color = {0.2f, 0.4f, 0.8f, 0.3f, 0.6f};
    expect_rgb(s.look_at(0, 0, -15), 0.536, 0.406, 0.461, 2e-5);

    SceneMaker ground;
    ground.scene.background = rgb(0.9f, 0.5f, 0.1f);
    fog.type = 2;
    fog.distance = 5;
    fog.alt = 2;
    ground.scene.fogs = {fog};
    expect_rgb(ground.look({0, 1, 0}, {0.5 / 8, 3.5 / 8, 1}), 0.43145, 0.43307, 0.56855, 1e-4);
    expect_rgb(ground.look({0, 1, 0}, {0.5 / 8, -0.5 / 8, 1}), 0.2, 0.4, 0.8, 1e-4);
}

TEST(Alpha, SurfacesAndBackground) {
    SceneMaker s;
    s.options.alpha_output = true;
    EXPECT_EQ(s.look_at().transmit, 1.0f);
    const Finish bright = dark_finish([](Finish& f) { f.emission = Rgb(1.0f); });
    s.add("disc{<0,0,0>,<0,0,1>,3}", {plain({1, 0.5f, 0.25f, 0.5f, 0}, bright)});
    EXPECT_NEAR(s.look_at().transmit, 1 - 0.69, 1e-5);
    s.scene.background = grey_color(0.5f);
    EXPECT_EQ(s.look_at().transmit, 0.0f);
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

TEST(Stream, ResultOfARayDoesNotDependOnItsBatch) {
    SceneMaker s = half_shaded_area([](AreaGrid& g) { g.size1 = g.size2 = 3, g.jitter = true; });
    Interior glass;
    glass.ior = 1.5;
    Finish finish = dark_finish([](Finish& f) {
        f.reflection.max = Rgb(1.0f);
        f.reflection.fresnel = true;
        f.phong = 0.5f;
    });
    s.add("sphere{<0.5,0,-2>,1.5}",
          {plain({1, 0.9f, 0.8f, 0.9f, 0}, finish), plain({1, 1, 1, 0, 0.7f}, finish)}, glass);
    s.scene.background = rgb(0.2f, 0.3f, 0.4f);
    std::vector<CameraRay> rays;
    for (int i = 0; i < 200; ++i) {
        rays.push_back({{{-2.0 + 0.02 * i, 0.3, -40.0}, {0, 0, 1}}, true, static_cast<uint64_t>(i)});
    }
    const auto together = s.look_all(rays);
    for (size_t i = 0; i < rays.size(); i += 7) {
        const auto alone = s.look_all({&rays[i], 1});
        EXPECT_EQ(alone[0].rgb, together[i].rgb) << i;
        EXPECT_EQ(alone[0].transmit, together[i].transmit) << i;
    }
}

}  // namespace
}  // namespace rb
