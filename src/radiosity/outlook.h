#pragma once
#include "radiosity/hemisphere.h"
#include "shade/ray_stream.h"

#include <cstdint>
#include <vector>

namespace rb {

/// What a gather saw, kept to tell gathers near by where to look more closely.
class Outlook {
public:
    Outlook() = default;
    /// `light`: by cell of the hemisphere; distance 0 where nothing was sent.
    Outlook(const Vec3& point, const Hemisphere& hemisphere, std::span<const GatheredLight> light);

    const Vec3& point() const { return point_; }
    const Vec3& normal() const { return normal_; }
    float brightest() const { return brightest_; }

    /// How little it tells of a place: 0 at its own, nothing from 1 on.
    double strangeness(const Vec3& point, const Vec3& normal) const;

    /// How many rays each cell of a hemisphere around another place deserves: in proportion to how much the
    /// light in and around the cell differs, per mean light (Neyman 1934), but one at least. What was met is
    /// looked for where it is seen from there. `rays` are 1 before.
    void count_rays(const Vec3& point, const Hemisphere& hemisphere, std::span<uint8_t> rays) const;

private:
    /// Reads and writes the fields (see light_file.h).
    template <class File>
    friend struct LightFields;

    /// What one cell met.
    struct Spot {
        Vec3f direction{0.0f};
        float distance = 0;
        float light = 0;
    };

    Vec3 point_{0.0};
    Vec3 normal_{0.0};
    double reach_ = 0;  ///< what is seen from other places is the same as far as that
    float mean_ = 0;
    float brightest_ = 0;
    std::vector<Spot> spots_;
};

/// Outlooks all over a scene, none near another. Lookups may run at once, but not together with insert().
class Outlooks {
public:
    Outlooks() = default;
    explicit Outlooks(std::vector<Outlook> outlooks) : outlooks_(std::move(outlooks)) {}

    /// The one that tells most of a place; null if none tells anything.
    const Outlook* nearest(const Vec3& point, const Vec3& normal) const;

    /// It is far from all others and there is room, or it shows something bright that the one there missed.
    bool lack(const Outlook& outlook) const;

    /// If they lack it.
    void insert(Outlook outlook);

    /// In the order in which they came.
    const std::vector<Outlook>& all() const { return outlooks_; }

private:
    std::vector<Outlook> outlooks_;
};

}  // namespace rb
