#include "scene_maker.h"

#include "../geometry/statement.h"

#include <gtest/gtest.h>

namespace rb {

SceneMaker::SceneMaker() {
    scene.effective_version = 370;
    scene.camera.kind = CameraKind::orthographic;
    scene.camera.location = {0, 0, -5};
}

Object& SceneMaker::add(std::string_view geometry, TextureLayers layers, const Interior& interior) {
    auto object = std::make_shared<Object>(*object_from(geometry));
    object->texture = WornTexture{std::make_shared<TextureLayers>(std::move(layers)), {}};
    object->interior = std::make_shared<Interior>(interior);
    objects_.push_back(object);
    scene.objects.push_back(object);
    return *object;
}

void SceneMaker::light(const Vec3& location, const Rgb& color, const std::function<void(Light&)>& change) {
    auto source = std::make_shared<Light>();
    source->location = location;
    source->color = color;
    if (change) change(*source);
    auto object = std::make_shared<Object>();
    object->geometry = LightPtr(source);
    scene.objects.push_back(object);
}

std::vector<Radiance> SceneMaker::look_all(std::span<const CameraRay> rays, RayCounters* counters) const {
    Diagnostics diagnostics;
    const World world = compile(scene, {}, diagnostics);
    const Integrator integrator(world, options);
    std::vector<Radiance> out(rays.size());
    RayCounters ignored;
    integrator.trace(rays, out, counters ? *counters : ignored);
    return out;
}

Radiance SceneMaker::look(const Vec3& origin, const Vec3& direction) const {
    CameraRay ray;
    ray.ray = {origin, glm::normalize(direction)};
    ray.seed = 1;
    return look_all({&ray, 1}).front();
}

Radiance SceneMaker::look_at(double x, double y, double from_z) const {
    return look({x, y, from_z}, {0, 0, 1});
}

Finish dark_finish(const std::function<void(Finish&)>& change) {
    Finish finish;
    finish.ambient = Rgb(0.0f);
    finish.diffuse = 0;
    if (change) change(finish);
    return finish;
}

Finish diffuse_only(float diffuse) {
    return dark_finish([=](Finish& f) { f.diffuse = diffuse; });
}

void expect_rgb(const Radiance& seen, double r, double g, double b, double tolerance) {
    EXPECT_NEAR(seen.rgb.x, r, tolerance);
    EXPECT_NEAR(seen.rgb.y, g, tolerance);
    EXPECT_NEAR(seen.rgb.z, b, tolerance);
}

Texture plain(const Color& color, const Finish& finish) {
    Texture texture;
    auto pigment = std::make_shared<Pigment>();
    pigment->source = color;
    texture.pigment = pigment;
    texture.finish = std::make_shared<Finish>(finish);
    return texture;
}

}  // namespace rb
