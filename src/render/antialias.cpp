#include "render/antialias.h"

#include "render/antialias_methods.h"

#include <vector>

namespace rb {

namespace {

void render_plain(Sampler& sampler, const PixelBlock& block, std::span<Radiance> out) {
    std::vector<Vec2> positions;
    positions.reserve(out.size());
    for (int y = block.y0; y < block.y1; ++y) {
        for (int x = block.x0; x < block.x1; ++x) positions.emplace_back(x, y);
    }
    sampler.sample(positions, out);
}

}  // namespace

void render_block(Sampler& sampler, const PixelBlock& block, const AntialiasOptions& options,
                  const SampleDistance& distance, BlockBorders* borders, std::span<Radiance> out) {
    switch (options.method) {
        case 1:
            render_by_neighbours(sampler, block, options, distance, borders, out);
            break;
        case 2:
            render_by_corners(sampler, block, options, distance, out);
            break;
        case 3:
            render_by_confidence(sampler, block, options, distance, out);
            break;
        case method_by_error:
            render_by_error(sampler, block, options, distance, out);
            break;
        default:
            render_plain(sampler, block, out);
            break;
    }
}

}  // namespace rb
