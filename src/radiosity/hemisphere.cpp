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
        for (int ring = 0; ring < rings_; ++ring) {
            for (int sector = 0; sector < sectors_; ++sector) {
                directions_.push_back(direction_of(v, ring, sector, 0));
            }
        }
    }
    for (int ring = 0; ring <= rings_; ++ring) {
        const double square = static_cast<double>(ring) / rings_;
        sines_.push_back(std::sqrt(square));
        cosines_.push_back(std::sqrt(1.0 - square));
    }
}

Vec3 HemisphereGrid::direction_of(size_t variant, int ring, int sector, int number) const {
    const double u = step_u * static_cast<double>(variant + 1) + golden_step * sector;
    const double v = step_v * static_cast<double>(variant + 1) + golden_step * ring;
    // Evenly spread over the ring of all sectors, over the sector of all rings, and over the cell.
    const double square = (ring + fraction(u + step_u * number)) / rings_;
    const double turn = (sector + fraction(v + step_v * number)) / sectors_;
    const double sine = std::sqrt(square);
    return {sine * std::cos(2.0 * pi * turn), sine * std::sin(2.0 * pi * turn),
            std::sqrt(std::max(0.0, 1.0 - square))};
}

Vec3 HemisphereGrid::further(size_t variant, size_t cell, int number) const {
    const auto sectors = static_cast<size_t>(sectors_);
    return direction_of(variant, static_cast<int>(cell / sectors), static_cast<int>(cell % sectors), number);
}

size_t HemisphereGrid::cell_of(const Vec3& direction) const {
    const double square = direction.x * direction.x + direction.y * direction.y;
    const double turn = fraction(std::atan2(direction.y, direction.x) / (2.0 * pi));
    const int ring = std::min(static_cast<int>(square * rings_), rings_ - 1);
    const int sector = std::min(static_cast<int>(turn * sectors_), sectors_ - 1);
    return static_cast<size_t>(ring) * static_cast<size_t>(sectors_) + static_cast<size_t>(sector);
}

Hemisphere::Hemisphere(const HemisphereGrid& grid, const Vec3& normal, uint64_t seed)
    : grid_(&grid), variant_((mixed(seed, 0) >> 32) % grid.variants()), normal_(normal) {
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
