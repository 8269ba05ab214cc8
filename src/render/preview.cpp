#include "render/preview.h"

#include <algorithm>
#include <chrono>

namespace rb {

namespace {

/// Where `at` of `whole` lies among `parts`.
int scaled(int at, int parts, int whole) {
    return static_cast<int>(static_cast<int64_t>(at) * parts / whole);
}

/// Each pixel as the coarse one that it lies in; black outside of the region.
Film enlarged(const Film& coarse, const RenderOptions& options) {
    Film film;
    film.width = options.width;
    film.height = options.height;
    film.pixels.resize(static_cast<size_t>(options.width) * static_cast<size_t>(options.height));
    for (int y = options.region.y0; y < options.region.y1; ++y) {
        for (int x = options.region.x0; x < options.region.x1; ++x) {
            film.at(x, y) =
                coarse.at(scaled(x, coarse.width, film.width), scaled(y, coarse.height, film.height));
        }
    }
    return film;
}

}  // namespace

void preview(const World& world, const RenderOptions& options, const std::atomic<bool>& stop,
             const std::function<void(const Film&)>& show) {
    using Clock = std::chrono::steady_clock;
    // Its pixels are faces, of which a smaller picture has the first ones.
    if (world.camera.kind == CameraKind::mesh_camera) return;
    constexpr std::chrono::duration<double> enough{0.3};  // the next one takes four times as long
    constexpr int coarsest = 32;
    RenderOptions rough = options;
    rough.antialias.method = 0;
    rough.shading.quality = std::min(options.shading.quality, 8);
    for (int step = coarsest; step > 1; step /= 2) {
        const auto start = Clock::now();
        rough.width = (options.width + step - 1) / step;
        rough.height = (options.height + step - 1) / step;
        rough.block_size = std::max(1, options.block_size / step);
        const PixelBlock& region = options.region;
        rough.region = {scaled(region.x0, rough.width, options.width),
                        scaled(region.y0, rough.height, options.height),
                        scaled(region.x1 - 1, rough.width, options.width) + 1,
                        scaled(region.y1 - 1, rough.height, options.height) + 1};
        const RenderResult result = render(world, rough, stop, nullptr);
        if (!result.complete) return;
        show(enlarged(result.film, options));
        if (Clock::now() - start > enough) return;
    }
}

}  // namespace rb
