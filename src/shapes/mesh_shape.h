#pragma once
#include "base/diagnostics.h"
#include "kdtree/kdtree.h"
#include "scene/shape.h"
#include "shapes/triangle_block.h"

#include <atomic>
#include <functional>
#include <mutex>

namespace rb {

constexpr uint32_t no_index = std::numeric_limits<uint32_t>::max();

/// Everything a mesh or mesh2 statement says about its surface.
struct MeshData {
    TriangleMesh triangles;  ///< face_normals[i][0] == no_index: face i is flat
    std::vector<Vec2> uvs;
    std::vector<std::array<uint32_t, 3>> face_uvs;  ///< parallel to the faces, or empty: (0, 0)
    std::vector<TexturePtr> textures;
    /// Parallel to the faces, or empty; [0] == no_index: the mesh's own texture, [1] == no_index: one
    /// texture.
    std::vector<std::array<uint32_t, 3>> face_textures;
    std::optional<Vec3> inside_vector;
    /// Where the corners (0,0), (1,0), (1,1), (0,1) of the interpolated uv come to lie; empty: as they are.
    std::optional<std::array<Vec2, 4>> uv_corners;
    /// Makes the shape anew under a map, where its triangles depend on where it stands; empty: they do not.
    std::function<ShapePtr(const Transform&)> moved;
    std::optional<Bounds> extent;  ///< for min_extent and max_extent, where it is not the mesh's own box
};

/// How a mesh looks for what a ray meets. All find the same, bit for bit.
enum class MeshSearch {
    fastest,      ///< eight triangles and three levels of the tree at once, where the processor can
    one_by_one,   ///< the tree, one triangle after the other
    brute_force,  ///< no tree, every ray meets every face
};

/// A triangle mesh with its own kD-tree, shared by all copies of the object.
class MeshShape final : public Shape {
public:
    MeshShape(std::string_view keyword, MeshData data, MeshSearch search = MeshSearch::fastest);

    std::string_view keyword() const override { return keyword_; }
    Bounds bounds() const override { return bounds_; }
    Bounds language_extent() const override { return data_.extent.value_or(bounds_); }
    bool inside(const Vec3& p) const override;
    bool is_patch() const override { return !data_.inside_vector; }
    bool is_faceted() const override { return true; }
    void crossings(const ShapeRay& ray, Crossings& out) const override;
    bool closest(const ShapeRay& ray, const CrossingFilter* filter, Crossing& nearest) const override;
    bool any(const ShapeRay& ray, const CrossingFilter* filter, Crossing& found) const override;
    Vec3 normal(const Vec3& p, const Crossing& at) const override;
    std::optional<Vec2> uv(const Vec3& p, const Crossing& at) const override;
    std::span<const TexturePtr> textures() const override { return data_.textures; }
    void textures_at(const Vec3& p, const Crossing& at, std::vector<TextureWeight>& out) const override;
    ShapePtr transformed(const Transform& map) const override {
        return data_.moved ? data_.moved(map) : nullptr;
    }
    std::optional<TriangleMesh> tessellate(double tolerance) const override;
    std::string describe() const override;

    const MeshData& data() const { return data_; }

    /// Built by the first one who asks.
    const KdTree& tree() const {
        if (!has_tree_.load(std::memory_order_acquire)) build_tree();
        return tree_;
    }
    /// Bytes beside the triangles themselves.
    size_t tree_memory() const { return tree().memory() + blocks_.size() * sizeof(TriangleBlock); }
    void prepare() const override {
        if (search_ != MeshSearch::brute_force) tree();
    }

private:
    Vec3 vertex(uint32_t face, size_t corner) const {
        return Vec3(data_.triangles.vertices[data_.triangles.faces[face][corner]]);
    }
    void build_tree() const;
    void pack_blocks() const;
    template <bool once, class Take>
    bool each_candidate(const ShapeRay& ray, const double& t_max, Take&& take) const;
    template <class Take>
    bool each_by_blocks(const ShapeRay& ray, const double& t_max, Take&& take) const;
    bool starts_on(const ShapeRay& ray, uint32_t face) const;

    /// Everything that a ray needs is in the tree and the blocks.
    bool uses_blocks() const;

    std::string keyword_;
    MeshData data_;
    Bounds bounds_;
    mutable KdTree tree_;
    mutable std::vector<TriangleBlock, HugePages<TriangleBlock>> blocks_;  ///< of the tree's references
    mutable std::atomic<bool> has_tree_ = false;
    mutable std::mutex building_;
    MeshSearch search_;
};

/// Unit vertex normals, and the flat faces marked: where the three normals coincide (spec: geometry 10.3).
/// Reports a zero normal once.
void prepare_normals(TriangleMesh& mesh, SourceRange where, Diagnostics& diagnostics);

}  // namespace rb
