// Measured scenes of lights and shadows (spec: shading 22), built in code.
#include "scene_maker.h"
#include "shade/light_program.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace rb {
namespace {

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
TEST(Lights, SeveralWaysAtOnceAreTheSameBitForBit) {
    Light light;
    light.location = {3, 5, -4};
    for (const LightKind kind : {LightKind::point, LightKind::cylinder}) {
        light.kind = kind;
        light.point_at = Vec3{0.3, -1, 2};
        const LightProgram program(light);
        const Vec3 p{0.1, 0.2, 0.3};
        // The last one leads from the light to itself.
        const std::vector<Vec3> offsets{{0.5, 0.25, 1}, {-0.1, 0.7, 0.3}, {1, 1, 1}, p - light.location};
        for (size_t count = 1; count <= offsets.size(); ++count) {
            std::vector<LightVector> several(count);
            program.toward(p, std::span(offsets).first(count), several);
            for (size_t k = 0; k < count; ++k) {
                const LightVector one = program.toward(p, offsets[k]);
                EXPECT_EQ(several[k].direction, one.direction);
                EXPECT_EQ(several[k].distance, one.distance);
            }
        }
    }
}

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
