#include "shade/indirect_shading.h"

#include "math/random.h"
#include "shade/draws.h"

namespace rb {

void IndirectShading::begin(size_t count, Scratch::Scope& memory) {
    for (const Side side : {front, back}) {
        mean_[side] = memory.take<Rgb>(count);
        known_[side] = memory.take<uint8_t>(count, uint8_t{0});
    }
}

void IndirectShading::leave_texture(std::span<const uint32_t> rows) {
    if (!program_.world.settings.radiosity->normal) return;
    for (const uint32_t row : rows) known_[front][row] = known_[back][row] = 0;
}

void IndirectShading::add(const FinishProgram& finish, std::span<LitRow> rows, std::span<const Rgb> filters) {
    for (const Side side : {front, back}) {
        const float diffuse = side == front ? finish.finish.raw_diffuse : finish.finish.raw_diffuse_back;
        if (diffuse == 0.0f) continue;
        gather(side, diffuse, rows, filters);
        for (LitRow& row : rows) {
            if (!known_[side][row.root]) continue;
            row.light += row.place.pigment * mean_[side][row.root] * row.place.opacity * diffuse;
        }
    }
}

/// For the rows of which it is not known yet, and where enough of it would be seen.
void IndirectShading::gather(Side side, float diffuse, std::span<const LitRow> rows,
                             std::span<const Rgb> filters) {
    Scratch::Scope memory(thread_scratch());
    const auto asking = memory.take<uint32_t>(rows.size());
    const auto places = memory.take<IndirectPlace>(rows.size());
    const bool perturbed = program_.world.settings.radiosity->normal;
    size_t count = 0;
    for (size_t i = 0; i < rows.size(); ++i) {
        const LitRow& row = rows[i];
        if (known_[side][row.root]) continue;
        const Rgb seen = filters.empty() ? row.place.pigment : filters[i] * row.place.pigment;
        if (!(grey(seen) * row.place.opacity * diffuse > state_.limits.adc_bailout)) continue;
        const HitPoint& hit = state_.hits[row.hit];
        const double sign = side == front ? 1.0 : -1.0;
        const Vec3 normal = perturbed ? row.place.normal : hit.normal;
        const PathRay& ray = state_.ray_of(hit);
        const uint64_t seed = mixed(ray.seed, draw_indirect_light + static_cast<uint64_t>(side));
        places[count] = {hit.point, sign * normal, sign * hit.normal,         hit.leaf, hit.part, hit.member,
                         hit.error, seed,          ray.share * ray.importance};
        asking[count++] = row.root;
    }
    const auto mean = memory.take<Rgb>(count);
    state_.indirect->gather(places.first(count), state_.depth, mean);
    for (size_t k = 0; k < count; ++k) {
        mean_[side][asking[k]] = mean[k];
        known_[side][asking[k]] = 1;
    }
}

}  // namespace rb
