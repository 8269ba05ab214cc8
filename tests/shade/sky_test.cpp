// Measured scenes of sky, fog and alpha (spec: textures 14, shading 22), built in code.
#include "scene_maker.h"

#include <gtest/gtest.h>

namespace rb {
namespace {

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

}  // namespace
}  // namespace rb
