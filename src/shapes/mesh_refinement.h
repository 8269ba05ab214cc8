#pragma once
#include "scene/shape.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace rb {

using MeshFace = std::array<uint32_t, 3>;

/// A mesh that takes more is not affordable.
constexpr size_t most_mesh_faces = 500'000;

/// Bound on how far rounding to single precision moves a point of the box.
inline double float_rounding(const Bounds& box) {
    const Vec3 most = glm::max(glm::abs(box.lo), glm::abs(box.hi));
    return 0.5 * std::numeric_limits<float>::epsilon() * glm::length(most);
}

/// Radius of the smallest ball around a triangle.
inline double enclosing_radius(const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto squared = [](const Vec3& v) { return glm::dot(v, v); };
    std::array<double, 3> sides{squared(b - a), squared(c - b), squared(a - c)};
    std::ranges::sort(sides);
    const double area = glm::length(glm::cross(b - a, c - a));
    const bool is_acute = sides[0] + sides[1] > sides[2];
    return 0.5 * std::sqrt(is_acute ? sides[0] * sides[1] * sides[2] : sides[2]) / (is_acute ? area : 1.0);
}

/// The way out at each vertex: the sum over its faces, as long as twice their areas.
inline std::vector<Vec3> ways_out(const TriangleMesh& mesh) {
    std::vector<Vec3> outward(mesh.vertices.size(), Vec3{0.0});
    for (const MeshFace& f : mesh.faces) {
        const Vec3 a(mesh.vertices[f[0]]);
        const Vec3 n = glm::cross(Vec3(mesh.vertices[f[2]]) - a, Vec3(mesh.vertices[f[1]]) - a);
        for (const uint32_t k : f) outward[k] += n;
    }
    return outward;
}

/// Cuts the faces of a mesh at their longest edges until all of them are proven to be near a surface. The
/// faces on both sides of an edge are cut together, so that a closed mesh stays closed (M.-C. Rivara, New
/// longest-edge algorithms for the refinement of triangulations, 1997). `Surface` knows the vertices:
///     Vec3 point(uint32_t vertex) const;
///     uint32_t between(uint32_t a, uint32_t b, const Vec3& outward);  // a new one, of the surface
///     bool is_near(const MeshFace& face) const;
template <class Surface>
class MeshRefinement {
public:
    MeshRefinement(Surface& surface, std::vector<MeshFace> faces)
        : surface_(surface), faces_(std::move(faces)), states_(faces_.size(), State::unknown) {
        for (uint32_t i = 0; i < faces_.size(); ++i) link(i);
    }

    /// False if it takes more than `most` faces, or if edges no longer become shorter.
    bool run(size_t most) {
        std::vector<uint32_t> open(faces_.size());
        for (uint32_t i = 0; i < open.size(); ++i) open[i] = i;
        while (!open.empty()) {
            const uint32_t face = open.back();
            if (is_near(face)) {
                open.pop_back();
                continue;
            }
            if (faces_.size() >= most || !cut_for(face, open)) return false;
        }
        return true;
    }

    /// With the vertices that the surface has got meanwhile.
    TriangleMesh take_mesh() {
        TriangleMesh mesh;
        mesh.faces = std::move(faces_);
        uint32_t count = 0;
        for (const MeshFace& face : mesh.faces)
            count = std::max({count, face[0] + 1, face[1] + 1, face[2] + 1});
        for (uint32_t i = 0; i < count; ++i) mesh.vertices.emplace_back(surface_.point(i));
        return mesh;
    }

private:
    enum class State : uint8_t { unknown, near, far };

    /// Ordered by squared length, and of equal ones by name: both sides agree on the longest.
    struct Edge {
        double length;
        uint64_t name;
        size_t from;  ///< which corner of the face
        // NOLINTNEXTLINE(modernize-use-nullptr): there is no pointer
        auto operator<=>(const Edge&) const = default;
        bool is_same(const Edge& other) const { return name == other.name; }
    };

    static uint64_t directed(uint32_t a, uint32_t b) { return uint64_t{a} << 32 | b; }

    bool is_near(uint32_t face) {
        State& state = states_[face];
        if (state == State::unknown) state = surface_.is_near(faces_[face]) ? State::near : State::far;
        return state == State::near;
    }

    Edge longest_edge(uint32_t face) const {
        Edge longest{-1.0, 0, 0};
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t a = faces_[face][k];
            const uint32_t b = faces_[face][(k + 1) % 3];
            const Vec3 d = surface_.point(std::max(a, b)) - surface_.point(std::min(a, b));
            longest = std::max(longest, Edge{glm::dot(d, d), directed(std::min(a, b), std::max(a, b)), k});
        }
        return longest;
    }

    /// Goes from neighbour to neighbour, to the longest edge around, and cuts there.
    bool cut_for(uint32_t face, std::vector<uint32_t>& open) {
        for (;;) {
            const Edge edge = longest_edge(face);
            const uint32_t a = faces_[face][edge.from];
            const uint32_t b = faces_[face][(edge.from + 1) % 3];
            const auto across = face_of_.find(directed(b, a));
            const bool is_rim = across == face_of_.end();
            const uint32_t other = is_rim ? face : across->second;
            const Edge others = longest_edge(other);
            if (!others.is_same(edge)) {
                face = other;
                continue;
            }
            const Vec3 outward = area(face) + (is_rim ? Vec3{0.0} : area(other));
            const uint32_t middle = surface_.between(a, b, outward);
            const auto is_apart = [&](uint32_t end) {
                constexpr double least = 0.05;
                const Vec3 d = surface_.point(middle) - surface_.point(end);
                return glm::dot(d, d) > least * least * edge.length;
            };
            if (!is_apart(a) || !is_apart(b)) return false;
            halve(face, edge.from, middle, open);
            if (!is_rim) halve(other, others.from, middle, open);
            return true;
        }
    }

    void halve(uint32_t face, size_t from, uint32_t middle, std::vector<uint32_t>& open) {
        const uint32_t a = faces_[face][from];
        const uint32_t b = faces_[face][(from + 1) % 3];
        const uint32_t c = faces_[face][(from + 2) % 3];
        face_of_.erase(directed(a, b));
        const auto added = static_cast<uint32_t>(faces_.size());
        faces_[face] = {a, middle, c};
        states_[face] = State::unknown;
        faces_.push_back({middle, b, c});
        states_.push_back(State::unknown);
        link(face);
        link(added);
        open.push_back(face);
        open.push_back(added);
    }

    void link(uint32_t face) {
        for (size_t k = 0; k < 3; ++k) face_of_[directed(faces_[face][k], faces_[face][(k + 1) % 3])] = face;
    }

    /// Outward, as long as twice the face's area.
    Vec3 area(uint32_t face) const {
        const Vec3 a = surface_.point(faces_[face][0]);
        return glm::cross(surface_.point(faces_[face][2]) - a, surface_.point(faces_[face][1]) - a);
    }

    Surface& surface_;
    std::vector<MeshFace> faces_;
    std::vector<State> states_;
    std::unordered_map<uint64_t, uint32_t> face_of_;  ///< by directed edge
};

}  // namespace rb
