#include "shapes/solid_mesh.h"

#include "shapes/marched_mesh.h"
#include "shapes/mesh_refinement.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

/// Vertices on the surface, where the solid begins and ends. So a facet as small as the tolerance is near.
/// Of a larger one the slopes tell: with a gradient that differs from g by at most e around it, a function
/// that is zero at the corners is at most e r on a facet with the enclosing radius r (the mean square
/// distance of a point from the corners, weighted as it is between them, is at most r^2), and along g it
/// rises by |g| - e at least.
class Facets {
public:
    Facets(const PointSolid& solid, double within)
        : solid_(solid), within_((1.0 - placing_share) * within), placing_(placing_share * within) {}

    /// Takes a mesh whose vertices are near the surface: within `reach`.
    std::vector<MeshFace> start_with(const TriangleMesh& mesh, double reach) {
        const std::vector<Vec3> outward = ways_out(mesh);
        for (size_t i = 0; i < outward.size(); ++i) add(Vec3(mesh.vertices[i]), outward[i], reach);
        return mesh.faces;
    }

    Vec3 point(uint32_t i) const { return vertices_[i].point; }

    uint32_t between(uint32_t a, uint32_t b, const Vec3& outward) {
        add(0.5 * (point(a) + point(b)), outward, glm::length(point(b) - point(a)));
        return static_cast<uint32_t>(vertices_.size() - 1);
    }

    bool is_near(const MeshFace& face) const {
        Bounds region;
        for (const uint32_t k : face) {
            if (!vertices_[k].is_on_surface) return false;
            region.include(point(k));
        }
        const double radius = enclosing_radius(point(face[0]), point(face[1]), point(face[2]));
        // Every point of a triangle is as near to a corner.
        if (radius <= within_) return true;
        const auto slopes = solid_.slopes({region.lo - within_, region.hi + within_});
        if (!slopes) return false;
        const double steepness = glm::length(slopes->middle);
        const double e = slopes->spread;
        return e * radius + placing_ * (steepness + e) <= within_ * (steepness - e);
    }

private:
    static constexpr double placing_share = 1e-6;

    struct Vertex {
        Vec3 point;
        bool is_on_surface;
    };

    void add(const Vec3& from, const Vec3& way_out, double reach) {
        const double length = glm::length(way_out);
        // Slivers at an edge may look any way.
        const std::array<Vec3, 4> ways{length > 0.0 ? way_out / length : Vec3{1, 1, 1}, Vec3{1, 0, 0},
                                       Vec3{0, 1, 0}, Vec3{0, 0, 1}};
        for (const Vec3& way : ways) {
            if (const auto distance = surface_along(from, way, reach)) {
                vertices_.push_back({from + *distance * way, true});
                return;
            }
        }
        vertices_.push_back({from, false});
    }

    /// Up or down the way, to the nearest place found where the solid begins or ends.
    std::optional<double> surface_along(const Vec3& from, const Vec3& way, double reach) const {
        const bool is_in = solid_.inside(from);
        const auto differs = [&](double s) { return solid_.inside(from + s * way) != is_in; };
        constexpr double first = 1e-3;
        constexpr double growth = 1.5;
        double before = 0.0;
        for (double s = first * reach; before < reach; s *= growth) {
            for (const double side : is_in ? std::array{1.0, -1.0} : std::array{-1.0, 1.0}) {
                if (!differs(side * s)) continue;
                double near = side * before;
                double far = side * s;
                while (std::abs(far - near) > placing_) {
                    const double middle = 0.5 * (near + far);
                    if (middle == near || middle == far) break;
                    (differs(middle) ? far : near) = middle;
                }
                return 0.5 * (near + far);
            }
            before = s;
        }
        return std::nullopt;
    }

    const PointSolid& solid_;
    double within_;
    double placing_;  ///< how near a vertex is to the surface
    std::vector<Vertex> vertices_;
};

}  // namespace

std::optional<GradientBound> GradientBound::of(const std::array<Interval, 3>& along_axes) {
    GradientBound bound;
    Vec3 half{0.0};
    for (int i = 0; i < 3; ++i) {
        const Interval& s = along_axes[static_cast<size_t>(i)];
        if (s.maybe_nan || s.has_infinity()) return std::nullopt;
        bound.middle[i] = 0.5 * (s.lo + s.hi);
        half[i] = 0.5 * (s.hi - s.lo);
    }
    bound.spread = glm::length(half);
    return bound;
}

std::optional<TriangleMesh> solid_mesh(const PointSolid& solid, const Bounds& box, double tolerance) {
    if (box.is_empty()) return TriangleMesh{};
    constexpr double first_share = 1.0 / 32.0;
    const double cell = first_share * std::max({box.size().x, box.size().y, box.size().z});
    const double within = tolerance - float_rounding(box);
    if (!(cell > 0.0) || !(within > 0.0)) return std::nullopt;
    Facets facets(solid, within);
    const auto side = [&](const Vec3& p) { return solid.inside(p) ? -1.0 : 1.0; };
    MeshRefinement refinement(facets, facets.start_with(marched_mesh(side, box, cell), cell));
    if (!refinement.run(most_mesh_faces)) return std::nullopt;
    TriangleMesh mesh = refinement.take_mesh();
    mesh.error = tolerance;
    return mesh;
}

}  // namespace rb
