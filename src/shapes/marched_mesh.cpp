#include "shapes/marched_mesh.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace rb {

namespace {

/// A cube cut into six tetrahedra around its diagonal (Kuhn): corners as bits x, y, z. Neighbours fit.
constexpr std::array<std::array<unsigned, 4>, 6> tetrahedra{
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

class Marching {
public:
    Marching(const std::function<double(const Vec3&)>& value, const Bounds& box, double cell)
        : value_(value), cell_(cell) {
        // A rim of two cells; the odd shift keeps corners off symmetry planes.
        constexpr double rim = 2.137;
        first_ = box.lo - Vec3{rim * cell};
        for (int i = 0; i < 3; ++i) {
            count_[static_cast<size_t>(i)] =
                static_cast<uint32_t>(std::ceil(box.size()[i] / cell + 2.0 * rim)) + 1;
        }
    }

    TriangleMesh run() {
        sample();
        for (uint32_t z = 0; z + 1 < count_[2]; ++z) {
            for (uint32_t y = 0; y + 1 < count_[1]; ++y) {
                for (uint32_t x = 0; x + 1 < count_[0]; ++x) cube(x, y, z);
            }
        }
        return std::move(mesh_);
    }

private:
    uint32_t index(uint32_t x, uint32_t y, uint32_t z) const { return (z * count_[1] + y) * count_[0] + x; }
    Vec3 corner(uint32_t i) const {
        const uint32_t x = i % count_[0];
        const uint32_t y = i / count_[0] % count_[1];
        const uint32_t z = i / count_[0] / count_[1];
        return first_ + cell_ * Vec3(x, y, z);
    }

    void sample() {
        const uint32_t n = count_[0] * count_[1] * count_[2];
        outside_.resize(n);
        for (uint32_t i = 0; i < n; ++i) outside_[i] = value_(corner(i)) > 0.0 ? 1 : 0;
    }

    void cube(uint32_t x, uint32_t y, uint32_t z) {
        std::array<uint32_t, 8> corners;
        unsigned out = 0;
        for (uint32_t k = 0; k < 8; ++k) {
            corners[k] = index(x + (k & 1), y + (k >> 1 & 1), z + (k >> 2));
            out += outside_[corners[k]];
        }
        if (out == 0 || out == 8) return;
        for (const auto& t : tetrahedra)
            tetrahedron({corners[t[0]], corners[t[1]], corners[t[2]], corners[t[3]]});
    }

    void tetrahedron(std::array<uint32_t, 4> c) {
        // Even permutations bring the odd ones out to the front: the orientation stays.
        std::array<uint32_t, 4> in{};
        std::array<uint32_t, 4> out{};
        size_t inner = 0;
        size_t outer = 0;
        for (const uint32_t k : c) (outside_[k] ? out[outer++] : in[inner++]) = k;
        if (inner == 0 || outer == 0) return;
        if (inner == 1) {
            facet(in[0], vertex(in[0], out[0]), vertex(in[0], out[1]), vertex(in[0], out[2]));
        } else if (outer == 1) {
            facet(in[0], vertex(in[0], out[0]), vertex(in[1], out[0]), vertex(in[2], out[0]));
        } else {
            const uint32_t a = vertex(in[0], out[0]);
            const uint32_t b = vertex(in[0], out[1]);
            const uint32_t d = vertex(in[1], out[1]);
            const uint32_t e = vertex(in[1], out[0]);
            facet(in[0], a, b, d);
            facet(in[0], a, d, e);
        }
    }

    /// Left-handed: outward is (c - a) x (b - a). `inner` lies behind every facet of its tetrahedron.
    void facet(uint32_t inner, uint32_t a, uint32_t b, uint32_t c) {
        const Vec3 p = exact_[a];
        const double side = glm::dot(glm::cross(exact_[c] - p, exact_[b] - p), p - corner(inner));
        if (side < 0.0) std::swap(b, c);
        mesh_.faces.push_back({a, b, c});
    }

    uint32_t vertex(uint32_t in, uint32_t out) {
        const uint64_t key = static_cast<uint64_t>(std::min(in, out)) << 32 | std::max(in, out);
        const auto [at, is_new] = vertices_.try_emplace(key, static_cast<uint32_t>(exact_.size()));
        if (!is_new) return at->second;
        const Vec3 a = corner(in);
        const Vec3 b = corner(out);
        double lo = 0.0;
        double hi = 1.0;
        constexpr int halvings = 30;
        for (int i = 0; i < halvings; ++i) {
            const double s = 0.5 * (lo + hi);
            (value_(a + s * (b - a)) > 0.0 ? hi : lo) = s;
        }
        // Facets that shrink to nothing would break the mesh; the bound counts what this moves.
        constexpr double rim = 0.01;
        exact_.push_back(a + std::clamp(lo, rim, 1.0 - rim) * (b - a));
        mesh_.vertices.emplace_back(exact_.back());
        return at->second;
    }

    const std::function<double(const Vec3&)>& value_;
    double cell_;
    Vec3 first_;
    std::array<uint32_t, 3> count_{};
    std::vector<uint8_t> outside_;
    std::unordered_map<uint64_t, uint32_t> vertices_;
    std::vector<Vec3> exact_;
    TriangleMesh mesh_;
};

}  // namespace

TriangleMesh marched_mesh(const std::function<double(const Vec3&)>& value, const Bounds& box, double cell) {
    return Marching(value, box, cell).run();
}

}  // namespace rb
