#include "radiosity/outlook.h"

#include "base/scratch.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

/// Sums over the light of spots.
struct Tally {
    float count = 0;
    float sum = 0;
    float squares = 0;

    void add(float light) { add({1.0f, light, light * light}); }
    void add(const Tally& other) {
        count += other.count;
        sum += other.sum;
        squares += other.squares;
    }
    float deviation() const {
        if (count == 0.0f) return 0.0f;
        const float mean = sum / count;
        return std::sqrt(std::max(0.0f, squares / count - mean * mean));
    }
};

/// So far that one cannot stand for the other.
bool is_far(const Outlook& known, const Outlook& other) {
    constexpr double far = 0.5;
    return known.strangeness(other.point(), other.normal()) > far;
}

}  // namespace

Outlook::Outlook(const Vec3& point, const Hemisphere& hemisphere, std::span<const GatheredLight> light)
    : point_(point), normal_(hemisphere.normal()) {
    double inverse_distances = 0;
    double light_by_distance = 0;
    double sum = 0;
    spots_.reserve(light.size());
    for (size_t k = 0; k < light.size(); ++k) {
        if (light[k].distance == 0.0) continue;
        spots_.push_back(
            {Vec3f(hemisphere.direction(k)), static_cast<float>(light[k].distance), grey(light[k].rgb)});
        inverse_distances += 1.0 / light[k].distance;
        light_by_distance += static_cast<double>(spots_.back().light) / light[k].distance;
        sum += static_cast<double>(spots_.back().light);
        brightest_ = std::max(brightest_, spots_.back().light);
    }
    if (spots_.empty()) return;
    reach_ = std::min(static_cast<double>(spots_.size()) / inverse_distances, sum / light_by_distance);
    mean_ = static_cast<float>(sum / static_cast<double>(spots_.size()));
}

double Outlook::strangeness(const Vec3& point, const Vec3& normal) const {
    const double turned = std::max(0.0, 1.0 - glm::dot(normal, normal_));
    return glm::length(point - point_) / reach_ + std::sqrt(turned);
}

void Outlook::count_rays(const Vec3& point, const Hemisphere& hemisphere, std::span<uint8_t> rays) const {
    // More lowers the error a little, but the whole costs by up to a half more.
    constexpr float most = 4.0f;
    // A deviation is at most half of the range, and rounds to 2 from 1.5 on.
    if (!(mean_ > 0.0f && brightest_ > 3.0f * mean_)) return;
    const HemisphereGrid& grid = hemisphere.grid();
    Scratch::Scope memory(thread_scratch());
    const auto tallies = memory.take<Tally>(grid.size(), Tally{});
    const Vec3 way = point_ - point;
    for (const Spot& spot : spots_) {
        const Vec3 seen = std::isfinite(spot.distance)
                              ? glm::normalize(way + double{spot.distance} * Vec3(spot.direction))
                              : Vec3(spot.direction);
        if (const auto cell = hemisphere.cell_of(seen)) tallies[*cell].add(spot.light);
    }
    const int sectors = grid.sectors();
    for (int ring = 0; ring < grid.rings(); ++ring) {
        for (int sector = 0; sector < sectors; ++sector) {
            Tally around;
            for (int r = std::max(ring - 1, 0); r <= std::min(ring + 1, grid.rings() - 1); ++r) {
                for (int s = sector - 1; s <= sector + 1; ++s) {
                    around.add(tallies[static_cast<size_t>(r * sectors + (s + sectors) % sectors)]);
                }
            }
            const float worth = around.deviation() / mean_;
            rays[static_cast<size_t>(ring * sectors + sector)] =
                worth > 1.0f ? static_cast<uint8_t>(std::min(std::round(worth), most)) : uint8_t{1};
        }
    }
}

const Outlook* Outlooks::nearest(const Vec3& point, const Vec3& normal) const {
    const Outlook* best = nullptr;
    double least = 1.0;
    for (const Outlook& outlook : outlooks_) {
        const double strangeness = outlook.strangeness(point, normal);
        if (!(strangeness < least)) continue;
        least = strangeness;
        best = &outlook;
    }
    return best;
}

bool Outlooks::lack(const Outlook& outlook) const {
    constexpr size_t most = 512;
    if (!(outlook.brightest() > 0.0f)) return false;
    const Outlook* there = nearest(outlook.point(), outlook.normal());
    if (!there || is_far(*there, outlook)) return outlooks_.size() < most;
    return outlook.brightest() > 2.0f * there->brightest();
}

void Outlooks::insert(Outlook outlook) {
    if (!lack(outlook)) return;
    const Outlook* there = nearest(outlook.point(), outlook.normal());
    if (!there || is_far(*there, outlook)) {
        outlooks_.push_back(std::move(outlook));
    } else {
        outlooks_[static_cast<size_t>(there - outlooks_.data())] = std::move(outlook);
    }
}

}  // namespace rb
