#pragma once
#include "scene/scene.h"
#include "shade/integrator.h"

#include <functional>
#include <string_view>

namespace rb {

/// Builds a scene in code and looks at it along single rays.
struct SceneMaker {
    Scene scene;
    ShadingOptions options;

    SceneMaker();

    /// Adds an object: its geometry as text, its texture layers (bottom first), its interior.
    Object& add(std::string_view geometry, TextureLayers layers, const Interior& interior = {});
    void light(const Vec3& location, const Rgb& color, const std::function<void(Light&)>& change = {});

    Radiance look(const Vec3& origin, const Vec3& direction) const;
    /// Along z through (x, y) from z = -5, as the measured scenes do.
    Radiance look_at(double x = 0.0005, double y = 0.0005, double from_z = -5) const;
    std::vector<Radiance> look_all(std::span<const CameraRay> rays, RayCounters* counters = nullptr) const;

private:
    std::vector<std::shared_ptr<Object>> objects_;
};

void expect_rgb(const Radiance& seen, double r, double g, double b, double tolerance = 7e-5);
inline void expect_grey(const Radiance& seen, double v, double tolerance = 7e-5) {
    expect_rgb(seen, v, v, v, tolerance);
}

/// A finish without ambient and diffuse, changed by `change`.
Finish dark_finish(const std::function<void(Finish&)>& change = {});
Finish diffuse_only(float diffuse = 1.0f);
Texture plain(const Color& color, const Finish& finish);
inline Color rgb(float r, float g, float b) { return {r, g, b, 0, 0}; }
inline Color grey_color(float v) { return {v, v, v, 0, 0}; }

}  // namespace rb
