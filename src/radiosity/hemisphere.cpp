#include "radiosity/hemisphere.h"

#include "math/basis.h"
#include "math/random.h"
#include "math/recurrence.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

// Steps of the additive recurrence that spreads points evenly over a square: of the plastic number.
constexpr double step_u = 0.7548776662466927;
constexpr double step_v = 0.5698402909980532;

}  // namespace

HemisphereGrid::HemisphereGrid(int count) {
    // Cells of equal weight that are about as long as they are wide (Ward and Heckbert 1992).
    rings_ = std::max(1, static_cast<int>(std::lround(std::sqrt(count / pi))));
    sectors_ = std::max(1, static_cast<int>(std::lround(static_cast<double>(count) / rings_)));
    constexpr size_t most_directions = 1 << 15;
    variants_ = std::clamp<size_t>(most_directions / size(), 1, 64);
    directions_.reserve(variants_ * size());
    for (size_t v = 0; v < variants_; ++v) {
        const double ring_shift = fraction(step_u * static_cast<double>(v + 1));
        const double sector_shift = fraction(step_v * static_cast<double>(v + 1));
        for (int ring = 0; ring < rings_; ++ring) {
            for (int sector = 0; sector < sectors_; ++sector) {
                // Evenly spread over the ring of all sectors, and over the sector of all rings.
                const double square = (ring + fraction(ring_shift + golden_step * sector)) / rings_;
                const double turn = (sector + fraction(sector_shift + golden_step * ring)) / sectors_;
                const double sine = std::sqrt(square);
                directions_.emplace_back(sine * std::cos(2.0 * pi * turn), sine * std::sin(2.0 * pi * turn),
                                         std::sqrt(std::max(0.0, 1.0 - square)));
            }
        }
    }
    for (int ring = 0; ring <= rings_; ++ring) {
        const double square = static_cast<double>(ring) / rings_;
        sines_.push_back(std::sqrt(square));
        cosines_.push_back(std::sqrt(1.0 - square));
    }
}

Hemisphere::Hemisphere(const HemisphereGrid& grid, const Vec3& normal, uint64_t seed)
    : grid_(&grid), directions_(grid.variant(mixed(seed, 0) >> 32)), normal_(normal) {
    const Across plane(normal);
    const double turn = 2.0 * pi * unit_random(mixed(seed, 1));
    across_ = plane.at(turn);
    along_ = glm::cross(normal, across_);
}

Vec3 Hemisphere::tangent(double sector) const {
    const double angle = 2.0 * pi * sector / grid_->sectors();
    return std::cos(angle) * across_ + std::sin(angle) * along_;
}

}  // namespace rb
