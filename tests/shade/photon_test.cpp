// Photons on their way: how many are shot, where they come to rest, and the light that they bring. Counts and
// means measured with POV-Ray 3.7.
#include "photons/pattern.h"
#include "photons/shoot.h"
#include "scene_maker.h"
#include "shade/shading_program.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace rb {
namespace {

/// A clear ball over a white floor, under a light that its photons may refract.
struct BallScene : SceneMaker {
    BallScene() {
        scene.settings.photons.emplace();
        scene.settings.photons->spacing = 0.1;
        scene.settings.photons->jitter = 0;
        Interior glass;
        glass.ior = 1.3;
        ball = &add("sphere{0,1}", {plain({0, 0, 0, 0, 1}, dark_finish())}, glass);
        ball->photons.target = 1;
        floor = &add("plane{y,-3}", {plain(rgb(1, 1, 1), diffuse_only())});
    }
    void light_up(const std::function<void(Light&)>& change = {}) {
        light({0, 20, 0}, Rgb(1.0f), [&](Light& l) {
            l.photons.ways.refraction = PhotonSwitch::on;
            if (change) change(l);
        });
    }
    Object* ball;
    Object* floor;
};

struct Shot {
    PhotonCounters counters;
    std::shared_ptr<const PhotonMaps> maps;
};

Shot shoot(const SceneMaker& maker, int threads = 1) {
    Diagnostics diagnostics;
    const World world = compile(maker.scene, {}, diagnostics);
    const ShadingProgram program(world, {});
    const std::atomic<bool> stop{false};
    Shot shot;
    shot.maps = photon_light(program, threads, 0, stop, shot.counters);
    return shot;
}

void expect_counts(const SceneMaker& maker, uint64_t shot, uint64_t stored) {
    const Shot done = shoot(maker);
    EXPECT_EQ(done.counters.shot, shot);
    EXPECT_EQ(done.counters.on_surfaces, stored);
}

TEST(Photons, RingsOfAPointLight) {
    BallScene s;
    s.light_up();
    expect_counts(s, 416, 694);
}

TEST(Photons, SpacingOfATarget) {
    BallScene s;
    s.light_up();
    s.ball->photons.target = 2;
    expect_counts(s, 133, 190);
}

TEST(Photons, RingsOfAParallelLight) {
    BallScene s;
    s.light_up([](Light& l) {
        l.parallel = true;
        l.point_at = {0, 0, 0};
    });
    s.scene.settings.photons->spacing = 0.11;
    expect_counts(s, 347, 568);
}

TEST(Photons, SpotlightSendsNoneBeyondItsCone) {
    BallScene s;
    s.light_up([](Light& l) {
        l.kind = LightKind::spotlight;
        l.point_at = {0, 0, 0};
        l.radius = 1;
        l.falloff = 2;
    });
    expect_counts(s, 284, 266);
}

TEST(Photons, CylinderSendsNoneBeyondItsWall) {
    BallScene s;
    s.light_up([](Light& l) {
        l.kind = LightKind::cylinder;
        l.parallel = true;
        l.point_at = {0, 0, 0};
        l.radius = 0.3;
        l.falloff = 0.5;
    });
    expect_counts(s, 284, 128);
}

TEST(Photons, AreaLightSendsThemFromAllSamples) {
    BallScene s;
    s.light_up([](Light& l) {
        l.is_area = true;
        l.area.axis1 = {4, 0, 0};
        l.area.axis2 = {0, 0, 4};
        l.area.size1 = l.area.size2 = 3;
        l.photons.from_area = true;
    });
    expect_counts(s, 576, 702);
}

TEST(Photons, CountDecidesTheSpacing) {
    BallScene s;
    s.light_up();
    s.scene.settings.photons->count = 10000;
    expect_counts(s, 3525, 6636);
    s.ball->photons.collect = false;
    expect_counts(s, 7087, 6792);
    s.ball->photons.collect = true;
    s.ball->photons.ways.reflection = PhotonSwitch::on;
    expect_counts(s, 1591, 2906);
}

TEST(Photons, SwitchesOfBothSides) {
    BallScene s;
    s.light_up([](Light& l) { l.photons.ways.refraction = PhotonSwitch::unsaid; });
    expect_counts(s, 0, 0);
    s.ball->photons.ways.refraction = PhotonSwitch::on;
    expect_counts(s, 416, 694);
    s.floor->photons.collect = false;
    expect_counts(s, 416, 347);
    s.ball->no_image = true;
    expect_counts(s, 962, 0);
}

/// The ball is another object. `margin`: where jitter decides about photons at its edges.
void expect_counts_at(std::string_view geometry, uint64_t shot, uint64_t stored, uint64_t margin = 0) {
    BallScene s;
    s.light_up();
    s.ball->photons.target = 0;
    s.ball->world_from_object = Transform::translation({0, 1e6, 0});
    Interior glass;
    glass.ior = 1.3;
    s.add(geometry, {plain({0, 0, 0, 0, 1}, dark_finish())}, glass);
    SCOPED_TRACE(geometry);
    const Shot done = shoot(s);
    EXPECT_EQ(done.counters.shot, shot);
    EXPECT_NEAR(static_cast<double>(done.counters.on_surfaces), static_cast<double>(stored),
                static_cast<double>(margin));
}

TEST(Photons, TargetsAmongCompounds) {
    expect_counts_at("union{sphere{-2*x,1} sphere{2*x,1} photons{target}}", 832, 1388);
    expect_counts_at("union{sphere{-2*x,1 photons{target 2}} sphere{2*x,1} photons{target}}", 832, 1388);
    expect_counts_at("union{sphere{-2*x,1} sphere{2*x,1} photons{target} split_union off}", 2917, 1240, 6);
    expect_counts_at("union{sphere{-2*x,1 photons{target 2}} sphere{2*x,1} split_union off}", 133, 190);
    expect_counts_at("difference{sphere{0,1} sphere{<0,.5,0>,.6} photons{target}}", 416, 832);
    expect_counts_at("difference{sphere{0,1 photons{target}} sphere{<0,.5,0>,.6}}", 416, 704);
}

TEST(Photons, LevelsEndTheWay) {
    BallScene s;
    s.light_up();
    s.scene.settings.photons->max_trace_level = 2;
    expect_counts(s, 416, 347);
    s.scene.settings.photons->max_trace_level = 1;
    expect_counts(s, 416, 0);
    s.scene.settings.photons->max_trace_level = 0;
    expect_counts(s, 962, 0);
}

TEST(Photons, WhatStandsBeforeTheTargetEndsThem) {
    BallScene s;
    s.light_up();
    Object& pane = s.add("disc{5*y,y,9}", {plain({0, 0, 0, 0, 1}, dark_finish())});
    expect_counts(s, 962, 0);
    pane.photons.pass_through = true;
    expect_counts(s, 416, 694);
}

TEST(Photons, ReflectionAndRefractionSplitThem) {
    BallScene s;
    s.light_up();
    s.add("sphere{0,100}", {plain(rgb(1, 1, 1), diffuse_only())}).hollow = true;
    const Finish mirror = dark_finish([](Finish& f) { f.reflection.min = f.reflection.max = Rgb(0.5f); });
    s.ball->texture =
        WornTexture{std::make_shared<TextureLayers>(TextureLayers{plain({0, 0, 0, 0, 1}, mirror)}), {}};
    s.ball->interior = std::make_shared<Interior>();
    s.ball->photons.ways.reflection = PhotonSwitch::on;
    expect_counts(s, 416, 2776);
}

TEST(Photons, ThreadsDoNotMatter) {
    BallScene s;
    s.light_up();
    s.scene.settings.photons->spacing = 0.01;
    s.scene.settings.photons->jitter = 0.4;
    const Shot one = shoot(s, 1);
    const Shot four = shoot(s, 4);
    const PhotonMap& a = one.maps->surface_map();
    const PhotonMap& b = four.maps->surface_map();
    ASSERT_GT(a.size(), 10000u);
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size(); ++i) {
        ASSERT_EQ(a.place(i), b.place(i));
        ASSERT_EQ(a.color(i), b.color(i));
    }
}

TEST(Photons, TooManyAreRefused) {
    BallScene s;
    s.light_up();
    for (const double spacing : {1e-7, 0.0, -1.0}) {
        s.scene.settings.photons->spacing = spacing;
        EXPECT_THROW(shoot(s), SceneError);
    }
}

}  // namespace
}  // namespace rb
