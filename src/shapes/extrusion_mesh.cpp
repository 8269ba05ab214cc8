#include "shapes/extrusion.h"
#include "shapes/region_mesh.h"

#include <cmath>

namespace rb {

namespace {

/// One region's faces between layers of points, in the frame.
class Layers {
public:
    Layers(const SweptOutlines& swept, const RegionMesh& region, const Transform& place, TriangleMesh& mesh)
        : swept_(swept), region_(region), place_(place), mesh_(mesh) {
        const auto& r = place.forward.row;
        mirrored_ = glm::dot(r[0], glm::cross(r[1], r[2])) < 0.0;
    }

    void build() {
        std::vector<double> heights{swept_.h0};
        if (swept_.conic && swept_.h0 < 0.0 && swept_.h1 > 0.0) heights.push_back(0.0);
        heights.push_back(swept_.h1);
        std::vector<std::vector<uint32_t>> layers;
        layers.reserve(heights.size());
        for (const double h : heights) layers.push_back(layer(h));
        for (const auto& t : region_.triangles) {
            if (swept_.open) break;
            face(layers.front()[t[0]], layers.front()[t[1]], layers.front()[t[2]]);
            face(layers.back()[t[0]], layers.back()[t[2]], layers.back()[t[1]]);
        }
        for (size_t i = 0; i + 1 < layers.size(); ++i) {
            const auto& below = layers[i];
            const auto& above = layers[i + 1];
            for (const auto& [a, b] : region_.border) {
                face(below[a], above[a], below[b]);
                face(below[b], above[a], above[b]);
            }
        }
    }

private:
    std::vector<uint32_t> layer(double h) {
        const bool apex = swept_.conic && h == 0.0;
        const double scale = swept_.conic ? h : 1.0;
        std::vector<uint32_t> indices;
        for (const Vec2& p : region_.points) {
            if (!apex || indices.empty())
                mesh_.vertices.emplace_back(place_.point({p.x * scale, p.y * scale, h}));
            indices.push_back(static_cast<uint32_t>(mesh_.vertices.size() - 1));
        }
        return indices;
    }

    void face(uint32_t a, uint32_t b, uint32_t c) {
        if (a == b || b == c || c == a) return;
        if (mirrored_) std::swap(b, c);
        mesh_.faces.push_back({a, b, c});
    }

    const SweptOutlines& swept_;
    const RegionMesh& region_;
    const Transform& place_;
    TriangleMesh& mesh_;
    bool mirrored_ = false;
};

}  // namespace

std::optional<TriangleMesh> Extrusion::tessellate(double tolerance) const {
    const double widest = swept_->conic ? std::max(std::abs(swept_->h0), std::abs(swept_->h1)) : 1.0;
    const double growth = stretch(object_from_local_.forward) * std::max(widest, 1e-300);
    TriangleMesh mesh;
    for (const Outline& outline : swept_->outlines)
        Layers(*swept_, triangulate(outline.flattened(tolerance / growth)), object_from_local_, mesh).build();
    double largest = 0;
    for (const Vec3f& v : mesh.vertices) largest = std::max(largest, max_component(glm::abs(Vec3(v))));
    constexpr double rounding = 2.5e-7;
    mesh.error = tolerance + rounding * largest;
    return mesh;
}

}  // namespace rb
