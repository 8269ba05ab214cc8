// A picture does not depend on how large its scene is or where it stands. Each shape's scene is rendered as
// it is and with everything (shape, camera, light) scaled and moved. Numbers moved by 1e6 sizes keep 1e-10 of
// the size: an edge moves by less than 1e-8 pixels. So at most 0.2 % of the pixels may differ by more than
// 8/255: those which an edge, or a single-precision number of the shape, happens to cut that finely.
#include "render/render.h"
#include "stress.h"
#include "tests/geometry/statement.h"

#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace rb::stress {

namespace {

struct Placement {
    double scale = 1;
    double sizes = 0;  ///< moved by so many sizes
};

std::string scene_text(std::string_view statement, const Placement& place) {
    const double d = place.scale * place.sizes;
    return fmt::format(
        "#declare S = {:.17g}; #declare T = <{:.17g},{:.17g},{:.17g}>;\n"
        "camera {{ location <0.9,1.3,-2.2>*S+T look_at T angle 32 }}\n"
        "light_source {{ <3,4,-2>*S+T rgb 1 }}\n"
        "object {{ {} scale S translate T pigment {{ rgb 1 }} finish {{ ambient 0.1 diffuse 0.8 phong 0.5 }} "
        "}}\n",
        place.scale, d, 0.3 * d, -0.7 * d, statement);
}

Film picture(const std::string& text) {
    const Scene scene = scene_from(text);
    Diagnostics diagnostics;
    RenderOptions options;
    options.width = 80;
    options.height = 60;
    options.region = {0, 0, options.width, options.height};
    CompileOptions compiling;
    compiling.image_width = options.width;
    compiling.image_height = options.height;
    const World world = compile(scene, compiling, diagnostics);
    const std::atomic<bool> stop{false};
    return render(world, options, stop, [](size_t, size_t) {}).film;
}

double share_off(const Film& a, const Film& b) {
    constexpr float visible = 8.0f / 255.0f;
    size_t off = 0;
    for (size_t i = 0; i < a.pixels.size(); ++i) {
        bool same = true;
        for (int k = 0; k < 3; ++k)
            same = same && std::abs(a.pixels[i].rgb[k] - b.pixels[i].rgb[k]) <= visible;
        off += same ? 0 : 1;
    }
    return static_cast<double>(off) / static_cast<double>(a.pixels.size());
}

void run(const Effort& effort, Table& table) {
    std::vector<Placement> places;
    for (const double scale : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
        for (const double sizes : {0.0, 1e3, 1e6}) {
            if (scale != 1.0 || sizes != 0.0) places.push_back({scale, sizes});
        }
    }
    // A part of the run looks at a part of the shapes.
    const std::vector<ShapeCase>& cases = shape_cases();
    const size_t step = effort.share >= 0.5 ? 1 : 4;
    std::vector<ShapeCase> chosen;
    for (size_t i = 0; i < cases.size(); i += step) chosen.push_back(cases[i]);
    std::vector<Film> wanted;
    for (const ShapeCase& c : chosen) wanted.push_back(picture(scene_text(c.statement, {})));
    for (const Placement& place : places) {
        const std::string what = fmt::format("scaled by {}, moved by {} sizes", place.scale, place.sizes);
        table.run_listed(what, chosen.size(), [&](size_t i) -> Trial {
            constexpr double most = 0.002;
            const double off = share_off(wanted[i], picture(scene_text(chosen[i].statement, place)));
            if (off <= most) return {};
            return {true, fmt::format("{}: {:.2f} % of the pixels", chosen[i].name, 100 * off)};
        });
    }
}

}  // namespace

const Family placement{"placement", "Pictures of shapes, scaled and moved", run};

}  // namespace rb::stress
