#include "render/render.h"

#include "base/parallel.h"
#include "base/scratch.h"
#include "render/block_borders.h"
#include "render/pretrace.h"
#include "render/surfel_view.h"

#include <mutex>
#include <optional>

namespace rb {

namespace {

std::vector<PixelBlock> blocks_of(const PixelBlock& region, int size) {
    std::vector<PixelBlock> blocks;
    for (int y = region.y0; y < region.y1; y += size) {
        for (int x = region.x0; x < region.x1; x += size) {
            blocks.push_back({x, y, std::min(x + size, region.x1), std::min(y + size, region.y1)});
        }
    }
    return blocks;
}

}  // namespace

RenderResult render(const World& world, const RenderOptions& options, const std::atomic<bool>& stop,
                    const std::function<void(size_t, size_t)>& progress, BlockLog* log) {
    const PixelBlock& region = options.region;
    const size_t total = static_cast<size_t>(region.width()) * static_cast<size_t>(region.height());

    RenderResult result;
    result.film.width = options.width;
    result.film.height = options.height;
    result.film.pixels.resize(static_cast<size_t>(options.width) * static_cast<size_t>(options.height));

    ShadingOptions shading = options.shading;
    shading.indirect_light = options.gi != GiMode::off;
    Integrator integrator(world, shading);
    result.needs = needs_of(integrator.program());
    if (world.settings.photons && options.shading.quality >= 9) {
        integrator.show(
            photon_light(integrator.program(), options.threads, options.seed, stop, result.photons));
    }
    const PatternSettings patterns{world.settings.noise_generator, world.settings.number_of_waves};
    const CameraRays rays(world.camera, patterns, options.width, options.height);
    const Lens lens(world.camera, patterns);
    std::optional<Radiosity> radiosity;
    const IndirectLight* indirect = nullptr;
    if (ShadingProgram::has_indirect_light(world, shading)) {
        radiosity.emplace(world, shading, options.gi, options.gi_error, integrator.program().photons);
        const bool middles =
            options.antialias.method == 0 && !lens.is_open() && rays.rays_per_position() == 1;
        radiosity->prepare(survey_of(integrator, rays, options, middles, stop),
                           std::max(options.width, options.height), options.threads, stop,
                           options.radiosity_files);
        indirect = &radiosity->light();
    }
    if (options.view_surfels && radiosity) {
        view_surfels(*radiosity, rays, options, stop, result.film);
        result.complete = !stop.load(std::memory_order_relaxed);
        result.radiosity = radiosity->report();
        return result;
    }
    const SampleDistance distance(world.settings.assumed_gamma, options.antialias.gamma);
    const std::vector<PixelBlock> blocks = blocks_of(region, options.block_size);

    // Only method 1 looks at the pixels beside a block.
    std::optional<BlockBorders> borders;
    if (options.antialias.method == 1 && options.shading.skip_unneeded)
        borders.emplace(region, options.block_size);

    std::mutex mutex;
    size_t done = 0;
    parallel_for(blocks.size(), options.threads, stop, [&](size_t i) {
        const PixelBlock& block = blocks[i];
        const size_t count = static_cast<size_t>(block.width()) * static_cast<size_t>(block.height());
        if (log) {
            const std::lock_guard lock(mutex);
            if (log->restore(block, result.film)) {
                done += count;
                return;
            }
        }
        RayCounters counters;
        Scratch::Scope memory(thread_scratch());
        const auto pixels = memory.take<Radiance>(count);
        Sampler sampler(integrator, rays, lens, options.seed, counters, indirect);
        render_block(sampler, block, options.antialias, distance, borders ? &*borders : nullptr, pixels);

        const std::lock_guard lock(mutex);
        for (int y = block.y0; y < block.y1; ++y) {
            const auto row = pixels.begin() + static_cast<std::ptrdiff_t>(y - block.y0) * block.width();
            std::copy_n(row, block.width(), &result.film.at(block.x0, y));
        }
        result.counters += counters;
        if (log) log->finished(block, result.film);
        done += count;
        if (progress) progress(done, total);
    });
    result.complete = done == total;
    if (radiosity) result.radiosity = radiosity->report();
    return result;
}

}  // namespace rb
