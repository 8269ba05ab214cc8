#pragma once
#include "math/transform.h"
#include "scene/shape.h"
#include "shapes/outline.h"
#include "shapes/ray_shape.h"

#include <memory>

namespace rb {

/// What an Extrusion is in its own frame (u, v, h): regions of the plane (u, v), swept from h0 to h1.
struct SweptOutlines {
    std::string_view keyword;
    std::vector<Outline> outlines;  ///< a point is inside if it is inside any
    double h0 = 0;
    double h1 = 1;
    bool conic = false;       ///< the section at height h is the outline scaled by h, else the outline
    bool open = false;        ///< no caps
    bool top_inside = false;  ///< points at h1 belong to the solid
    double base_normal = 1;   ///< sign of the normal's h on the cap at h0 (language rule)
    Bounds extent;            ///< what min_extent and max_extent show; empty: the box
};

/// A plane figure swept along an axis: prism and text. Normals of the walls follow the order of the points
/// and may point inward (language rule).
class Extrusion final : public RayShape<Extrusion> {
public:
    Extrusion(std::shared_ptr<const SweptOutlines> swept, const Transform& object_from_local);

    /// Parts; walls are numbered on from `first_wall`, all outlines' pieces in order, with `at.x` as the
    /// parameter on the piece.
    enum Part : uint32_t { cap0 = 0, cap1 = 1, first_wall = 2 };

    std::string_view keyword() const override { return swept_->keyword; }
    NormalRule normal_rule() const override { return NormalRule::by_point_order; }
    Bounds bounds() const override { return box_; }
    Bounds language_extent() const override;
    bool inside(const Vec3& p) const override;

    template <class Sink>
    void each_crossing(const ShapeRay& query, Sink&& sink) const {
        const Local ray = put_on_parts(query);
        Slab slab;
        if (!clip(ray, slab)) return;
        FlatBox way;
        if (!way_of(ray, slab, query.t_min, sink.reach(), way)) return;
        uint32_t next = first_wall;
        for (uint32_t i = 0; i < swept_->outlines.size(); ++i) {
            const Outline& outline = swept_->outlines[i];
            const uint32_t first = next;
            next += static_cast<uint32_t>(outline.pieces().size());
            if (!outline.box().overlaps(way)) continue;
            Walls walls;
            cross(outline, first, ray, ray.touched == i ? &ray.contact : nullptr, walls);
            each_interval(ray, walls, [&](const Crossing& enters, const Crossing& leaves) {
                const bool cap_in = slab.t_in > enters.t;
                const bool cap_out = slab.t_out < leaves.t;
                const Crossing a = cap_in ? Crossing{slab.t_in, slab.in_cap, {}} : enters;
                const Crossing b = cap_out ? Crossing{slab.t_out, slab.out_cap, {}} : leaves;
                if (!(a.t <= b.t)) return;
                if (!cap_in || has_cap(slab.in_cap)) sink(a.t, a.part, a.at);
                if (!cap_out || has_cap(slab.out_cap)) sink(b.t, b.part, b.at);
            });
        }
    }

    Vec3 normal(const Vec3& p, const Crossing& at) const override;
    void snap(const Crossing& at, Vec3& p) const override;
    ShapePtr transformed(const Transform& map) const override {
        return std::make_shared<Extrusion>(swept_, then(object_from_local_, map));
    }
    std::optional<TriangleMesh> tessellate(double tolerance) const override;
    std::string describe() const override;

private:
    static constexpr uint32_t none = std::numeric_limits<uint32_t>::max();
    static constexpr double inf = std::numeric_limits<double>::infinity();

    /// The ray in the frame; `touched`: the outline on whose wall it starts, at `contact`.
    struct Local {
        Vec3 o;
        Vec3 d;
        uint32_t touched = none;
        Outline::Contact contact;
    };
    struct Slab {
        double t_in = -inf;
        double t_out = inf;
        uint32_t in_cap = cap0;
        uint32_t out_cap = cap1;
    };
    /// Crossings with the walls of one outline; always_inside: the ray runs along them within.
    struct Wall {
        double t;
        uint32_t part;
        double w;
        Crossing crossing() const { return {t, part, {w, 0.0}}; }
    };
    class Walls {
    public:
        bool always_inside = false;

        /// Keeps them in the order of t.
        void add(const Wall& wall) {
            if (count_ == few_.size() && many_.empty()) many_.assign(few_.begin(), few_.end());
            if (count_ >= few_.size()) many_.emplace_back();
            Wall* const all = many_.empty() ? few_.data() : many_.data();
            size_t i = count_++;
            for (; i > 0 && wall.t < all[i - 1].t; --i) all[i] = all[i - 1];
            all[i] = wall;
        }
        size_t size() const { return count_; }
        const Wall& operator[](size_t i) const { return many_.empty() ? few_[i] : many_[i]; }

    private:
        std::array<Wall, 16> few_;
        std::vector<Wall> many_;
        size_t count_ = 0;
    };

    double height(uint32_t cap) const { return cap == cap0 ? swept_->h0 : swept_->h1; }
    bool has_cap(uint32_t cap) const { return !swept_->open && !(swept_->conic && height(cap) == 0.0); }
    Vec2 flat(const Vec3& local) const {
        const Vec2 p{local.x, local.y};
        return swept_->conic ? p / local.z : p;
    }
    bool is_near(const Vec3& p, double distance) const;
    Local put_on_parts(const ShapeRay& query) const;
    void touch_known_part(uint32_t part, Local& ray) const;
    void touch_nearest(double within, Local& ray) const;
    bool clip(const Local& ray, Slab& slab) const;
    /// The box of the ray's way through the slab in the outlines' plane; false if there is none.
    bool way_of(const Local& ray, const Slab& slab, double t_min, double t_max, FlatBox& way) const;
    void cross(const Outline& outline, uint32_t first, const Local& ray, const Outline::Contact* contact,
               Walls& walls) const;

    /// Calls take(enters, leaves) for each piece of the line between the walls.
    template <class Take>
    void each_interval(const Local& ray, const Walls& walls, Take&& take) const {
        constexpr Crossing begin{-inf, cap0, Vec2{0.0}};
        constexpr Crossing end{inf, cap0, Vec2{0.0}};
        if (walls.always_inside) take(begin, end);
        // At the apex a conic sweep is a point: outside. From there on, or from far away, the sides
        // alternate.
        size_t apex = 0;
        if (swept_->conic && ray.d.z != 0.0) {
            const double t = -ray.o.z / ray.d.z;
            while (apex < walls.size() && walls[apex].t < t) ++apex;
        }
        for (size_t i = apex; i < walls.size(); i += 2) {
            if (i + 1 < walls.size()) {
                take(walls[i].crossing(), walls[i + 1].crossing());
            } else if (swept_->conic) {
                take(walls[i].crossing(), end);
            }
        }
        for (size_t i = apex; i > 0; i -= std::min<size_t>(i, 2)) {
            take(i > 1 ? walls[i - 2].crossing() : begin, walls[i - 1].crossing());
        }
    }

    std::shared_ptr<const SweptOutlines> swept_;
    Transform object_from_local_;
    Bounds box_;
    double local_stretch_;  ///< bound on how lengths grow from object to local
};

}  // namespace rb
