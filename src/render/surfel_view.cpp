#include "render/surfel_view.h"

#include "base/parallel.h"

namespace rb {

void view_surfels(const Radiosity& radiosity, const CameraRays& rays, const RenderOptions& options,
                  const std::atomic<bool>& stop, Film& film) {
    const Rgb unknown{0.0f, 0.0f, 0.1f};
    const PixelBlock& region = options.region;
    parallel_for(static_cast<size_t>(region.height()), options.threads, stop, [&](size_t row) {
        const int y = region.y0 + static_cast<int>(row);
        for (int x = region.x0; x < region.x1; ++x) {
            Rgb light = unknown;
            Ray ray;
            if (rays.at(x, y, 0, ray)) radiosity.find_surfel(ray, light);
            film.at(x, y) = {light, 0.0f};
        }
    });
}

}  // namespace rb
