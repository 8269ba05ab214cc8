#include "render/pretrace.h"

#include "base/parallel.h"
#include "base/scratch.h"
#include "math/random.h"

namespace rb {

namespace {

/// One row of grid cells, each seen through one place in it.
void survey_row(const Integrator& integrator, const CameraRays& rays, const RenderOptions& options, int row,
                int step, bool middles, const IndirectLight& collector) {
    Scratch::Scope memory(thread_scratch());
    const auto count = static_cast<size_t>((options.width + step - 1) / step);
    const auto positions = memory.take<Vec2>(count);
    const auto batch = memory.take<CameraRay>(count, CameraRay{});
    const auto light = memory.take<Radiance>(count);
    for (size_t i = 0; i < count; ++i) {
        const uint64_t place = mixed(options.seed, static_cast<uint64_t>(row) << 32 | i);
        const uint64_t cell = mixed(place, static_cast<uint64_t>(step));
        const Vec2 in_cell =
            middles ? Vec2(0.5) : Vec2(unit_random(mixed(cell, 0)), unit_random(mixed(cell, 1)));
        positions[i] = (Vec2(static_cast<double>(i), row) + in_cell) * static_cast<double>(step) - 0.5;
        batch[i].seed = mixed(cell, 2);
    }
    rays.at(positions, batch);
    RayCounters ignored;
    integrator.trace(batch, light, ignored, &collector);
}

}  // namespace

PictureSurvey survey_of(const Integrator& integrator, const CameraRays& rays, const RenderOptions& options,
                        bool middles, const std::atomic<bool>& stop) {
    return [&integrator, &rays, &options, middles, &stop](int step, const CachedLight* known,
                                                          Coverage coverage) {
        std::vector<std::vector<IndirectPlace>> rows(static_cast<size_t>((options.height + step - 1) / step));
        parallel_for(rows.size(), options.threads, stop, [&](size_t row) {
            const PlaceCollector collector(known, coverage, rows[row]);
            survey_row(integrator, rays, options, static_cast<int>(row), step, middles && step == 1,
                       collector);
        });
        std::vector<IndirectPlace> places;
        for (const auto& row : rows) places.insert(places.end(), row.begin(), row.end());
        return places;
    };
}

}  // namespace rb
