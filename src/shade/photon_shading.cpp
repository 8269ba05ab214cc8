#include "shade/photon_shading.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

constexpr double facing_limit = 1e-10;

/// A photon stands for light across its way; on the surface it is spread over more, within reason.
constexpr double least_cosine = 0.1;

}  // namespace

void PhotonShading::add(const FinishProgram& finish, std::span<LitRow> rows) {
    Scratch::Scope scratch(thread_scratch());
    const auto memory = scratch.take<NearPhoton>(program_.photons->capacity());
    for (LitRow& row : rows) {
        if (state_.hits[row.hit].collects_photons) row.light += gathered(finish, row, memory);
    }
}

Rgb PhotonShading::gathered(const FinishProgram& finish, const LitRow& row, std::span<NearPhoton> memory) {
    const HitPoint& hit = state_.hits[row.hit];
    KnownPhotons* known = program_.options.skip_unneeded ? &known_ : nullptr;
    const GatheredPhotons found = program_.photons->around(hit.point, row.place.normal, memory, known);
    const bool shows_back = finish.finish.diffuse_back != 0.0f;
    Rgb sum(0.0f);
    LightMeeting meeting;
    for (const NearPhoton& photon : found.photons) {
        meeting.direction = photon.direction;
        meeting.cosine = glm::dot(row.place.normal, photon.direction);
        meeting.backside = !row.double_illuminate && meeting.cosine < facing_limit;
        if (meeting.backside && !shows_back) continue;
        const double along = glm::dot(hit.normal, photon.direction);
        meeting.color = photon.color / static_cast<float>(std::clamp(along, least_cosine, 1.0));
        Rgb light = reflected_light(finish, row.place, meeting);
        if (finish.finish.irid_amount > 0.0f) {
            const double cosines =
                std::abs(meeting.cosine) + std::abs(glm::dot(row.place.normal, row.place.direction));
            light *= iridescence(finish, program_.world.settings.irid_wavelength, row.place.irid_thickness,
                                 cosines);
        }
        sum += light;
    }
    return found.photons.empty() ? sum : sum / static_cast<float>(found.extent);
}

}  // namespace rb
