// mesh { triangle { ... } smooth_triangle { ... } ... [inside_vector <v>] }   (manual 3.5.2.3)
#include "shapes/mesh_shape.h"
#include "shapes/registry.h"

#include <bit>
#include <unordered_map>

namespace rb {

namespace {

struct SameBits {
    size_t operator()(const Vec3f& v) const {
        size_t h = 0;
        for (int i = 0; i < 3; ++i) {
            h = (h ^ std::bit_cast<uint32_t>(v[i])) * 0x9e3779b97f4a7c15ULL;
            h ^= h >> 32;
        }
        return h;
    }
    bool operator()(const Vec3f& a, const Vec3f& b) const { return a == b; }
};

/// Collects triangles into shared vertices, normals, uvs and textures.
class Collector {
public:
    MeshData mesh;

    void add(BlockReader& in, bool smooth) {
        std::array<Vec3f, 3> points;
        std::array<Vec3f, 3> normals;
        for (size_t i = 0; i < 3; ++i) {
            points[i] = Vec3f(in.vec3());
            if (smooth) normals[i] = Vec3f(in.vec3());
        }
        std::array<Vec2, 3> uvs{};
        const bool has_uvs = in.take_word("uv_vectors");
        if (has_uvs) {
            for (Vec2& uv : uvs) uv = in.vec2();
        }
        const auto textures = read_textures(in);
        in.finish();
        if (glm::cross(Vec3(points[1] - points[0]), Vec3(points[2] - points[0])) == Vec3{0.0}) return;
        TriangleMesh& t = mesh.triangles;
        t.faces.push_back({vertex(points[0]), vertex(points[1]), vertex(points[2])});
        std::array<uint32_t, 3> normal_index{no_index, no_index, no_index};
        if (smooth) {
            for (size_t i = 0; i < 3; ++i) {
                normal_index[i] = static_cast<uint32_t>(t.normals.size());
                t.normals.push_back(normals[i]);
            }
        }
        t.face_normals.push_back(normal_index);
        const auto first_uv = static_cast<uint32_t>(mesh.uvs.size());
        mesh.uvs.insert(mesh.uvs.end(), uvs.begin(), uvs.end());
        mesh.face_uvs.push_back({first_uv, first_uv + 1, first_uv + 2});
        mesh.face_textures.push_back(textures);
        has_uvs_ = has_uvs_ || has_uvs;
    }

    /// Drops what no triangle used.
    void finish() {
        if (!has_uvs_) {
            mesh.uvs.clear();
            mesh.face_uvs.clear();
        }
        if (mesh.triangles.normals.empty()) mesh.triangles.face_normals.clear();
        if (mesh.textures.empty()) mesh.face_textures.clear();
    }

private:
    uint32_t vertex(const Vec3f& p) {
        const auto [at, is_new] =
            by_place_.try_emplace(p, static_cast<uint32_t>(mesh.triangles.vertices.size()));
        if (is_new) mesh.triangles.vertices.push_back(p);
        return at->second;
    }

    uint32_t texture(const TexturePtr& t) {
        const auto [at, is_new] =
            by_pointer_.try_emplace(t.get(), static_cast<uint32_t>(mesh.textures.size()));
        if (is_new) mesh.textures.push_back(t);
        return at->second;
    }

    TexturePtr identifier(BlockReader& in) {
        if (!in.at_thing<TexturePtr>())
            in.fail("Texture identifier expected, " + in.found() + " found instead");
        return in.thing<TexturePtr>();
    }

    std::array<uint32_t, 3> read_textures(BlockReader& outer) {
        std::array<uint32_t, 3> out{no_index, no_index, no_index};
        if (outer.at_block("texture")) {
            BlockReader in(outer.block("texture"), outer.context());
            out[0] = texture(identifier(in));
            in.finish();
        } else if (outer.at_block("texture_list")) {
            BlockReader in(outer.block("texture_list"), outer.context());
            for (uint32_t& t : out) t = texture(identifier(in));
            in.finish();
        }
        return out;
    }

    std::unordered_map<Vec3f, uint32_t, SameBits, SameBits> by_place_;
    std::unordered_map<const TextureLayers*, uint32_t> by_pointer_;
    bool has_uvs_ = false;
};

ShapePtr read(BlockReader& in) {
    Collector collector;
    for (;;) {
        if (in.at_block("triangle") || in.at_block("smooth_triangle")) {
            const bool smooth = in.at_block("smooth_triangle");
            BlockReader inner(in.block(smooth ? "smooth_triangle" : "triangle"), in.context());
            collector.add(inner, smooth);
        } else if (in.take_word("inside_vector")) {
            const Vec3 v = in.vec3();
            if (v != Vec3{0.0}) collector.mesh.inside_vector = v;
        } else {
            break;
        }
    }
    if (collector.mesh.triangles.faces.empty()) in.fail("No triangles in triangle mesh.");
    collector.finish();
    prepare_normals(collector.mesh.triangles, in.block_where(), in.diagnostics());
    return std::make_shared<MeshShape>("mesh", std::move(collector.mesh));
}

}  // namespace

namespace shapes {
extern const ShapeKind mesh;
const ShapeKind mesh{"mesh", read,
                     "mesh { triangle { <0,0,0>, <1,0,0>, <0,1,0> } triangle { <0,0,0>, <0,0,1>, <1,0,0> } "
                     "triangle { <0,0,0>, <0,1,0>, <0,0,1> } triangle { <1,0,0>, <0,0,1>, <0,1,0> } "
                     "inside_vector <.3,.4,.5> }"};
}  // namespace shapes

}  // namespace rb
