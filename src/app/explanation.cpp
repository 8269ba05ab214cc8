#include "app/explanation.h"

#include "compile/geometry.h"

#include <unordered_set>

#include <fmt/format.h>

namespace rb {

namespace {

double percent(uint64_t part, uint64_t whole) {
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

template <class... Args>
void add(std::string& text, std::string_view subject, fmt::format_string<Args...> format, Args&&... args) {
    text += fmt::format("  {:<20}", subject) + fmt::format(format, std::forward<Args>(args)...) + "\n";
}

void explain_geometry(std::string& text, const World& world) {
    const auto& leaves = world.geometry->leaves();
    std::unordered_set<const Shape*> shapes;
    size_t copies = 0;
    for (const Leaf& leaf : leaves) {
        if (leaf.instance != no_surface) ++copies;
        if (leaf.shape) shapes.insert(leaf.shape.get());
    }
    add(text, "shapes", "{} in the scene", leaves.size());
    if (shapes.size() < leaves.size())
        add(text, "", "{} kept: the others share what these know", shapes.size());
    if (copies > 0) add(text, "compounds", "{} copies of declared ones are not taken apart", copies);
}

void explain_surfaces(std::string& text, const Needs& needs) {
    add(text, "textures", "{} compiled for {} surfaces", needs.textures, needs.surfaces);
    add(text, "surface coordinates", "worked out for {} of {} surfaces; no pattern looks at the others'",
        needs.with_coordinates, needs.surfaces);
    add(text, "interiors", "{}",
        needs.interiors ? "followed: something lets light through, mirrors by its ior or fills the air"
                        : "not followed: nothing lets light through, mirrors by its ior or fills the air");
    add(text, "air", "{}",
        needs.air ? "fog, rainbows or media on all rays" : "clear: nothing is done on a ray's way");
}

void explain_lights(std::string& text, const Needs& needs, const RayCounters& rays) {
    add(text, "lights", "{}, {} with an area, {} without shadows", needs.lights, needs.area_lights,
        needs.shadowless_lights);
    const uint64_t ways = rays.shadow + rays.unreached + rays.unhindered;
    add(text, "shadow rays", "{} not sent ({:.1f} %): the light does not reach the place", rays.unreached,
        percent(rays.unreached, ways));
    add(text, "", "{} not sent ({:.1f} %): nothing stands between", rays.unhindered,
        percent(rays.unhindered, ways));
    if (!needs.filtered_shadows) add(text, "filtered shadows", "not looked for: nothing lets light through");
    if (!needs.opaque_shadows) add(text, "opaque shadows", "not looked for: nothing stops light");
}

}  // namespace

std::string explanation(const World& world, const RenderResult& result) {
    std::string text = "What the scene did not need\n";
    explain_geometry(text, world);
    explain_surfaces(text, result.needs);
    explain_lights(text, result.needs, result.counters);
    return text;
}

}  // namespace rb
