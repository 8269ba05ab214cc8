#pragma once
#include "compile/world.h"
#include "language/load.h"
#include "render/render.h"

#include <gtest/gtest.h>

namespace rb {

/// A square picture of a scene with these settings of radiosity.
inline RenderResult rendered(GiMode mode, const std::string& radiosity, const std::string& scene, int size,
                             RenderOptions options = {}) {
    LoadOptions loading;
    loading.input_file = "closed_form";
    loading.input_text = "#version 3.7; global_settings { assumed_gamma 1.0 radiosity { " + radiosity +
                         " } }\n#default { finish { ambient 0 diffuse 1 } }\n" + scene;
    SourceMap sources;
    Diagnostics diagnostics;
    Scene read;
    if (!load_scene(loading, sources, diagnostics, read)) {
        for (const Diagnostic& d : diagnostics.all()) ADD_FAILURE() << format(d, sources);
        return {};
    }
    const World world = compile(read, {}, diagnostics);
    options.width = options.height = size;
    options.region = {0, 0, size, size};
    options.gi = mode;
    const std::atomic<bool> stop{false};
    return render(world, options, stop, nullptr);
}

/// Something of everything: curved, flat, clear and mirroring surfaces, shadows and a texture.
inline const std::string several =
    "camera { location <0, 2, -5> look_at <0, 0.5, 0> }\nbackground { rgb <0.3, 0.4, 0.5> }\n"
    "light_source { <5, 9, -4>, rgb 1 }\nplane { y, 0 pigment { checker rgb 0.3, rgb 0.8 } }\n"
    "sphere { <-1.2, 0.6, 0>, 0.6 pigment { rgb <0.9, 0.4, 0.2> } }\n"
    "sphere { <1.2, 0.6, 0>, 0.6 pigment { rgb 1 } finish { diffuse 0.1 reflection 0.8 } }\n"
    "box { <-0.4, 0, 0.5>, <0.4, 1, 1.3> pigment { rgbt <0.2, 0.8, 0.3, 0.5> } }\n";

}  // namespace rb
