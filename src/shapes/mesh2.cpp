// mesh2 { vertex_vectors{} [normal_vectors{}] [uv_vectors{}] [texture_list{}] face_indices{} ... }
// (manual 3.5.2.4)
#include "shapes/mesh_shape.h"
#include "shapes/registry.h"

#include <cmath>

#include <fmt/format.h>

namespace rb {

namespace {

using Indices = std::vector<std::array<uint32_t, 3>>;

size_t count(BlockReader& in) {
    const SourceRange at = in.where();
    const int n = in.integer();
    if (n < 0) in.fail_at(at, "A negative number of items.");
    return static_cast<size_t>(n);
}

template <class Vector>
std::vector<Vector> vectors(BlockReader& outer, std::string_view keyword) {
    BlockReader in(outer.block(keyword), outer.context());
    const size_t n = count(in);
    constexpr int terms = Vector::length();
    std::vector<double> values;
    in.numbers(n, terms, values);
    in.finish();
    std::vector<Vector> out;
    out.reserve(n);
    for (size_t i = 0; i < n; ++i) {
        Vector v;
        for (int k = 0; k < terms; ++k) {
            v[k] = static_cast<typename Vector::value_type>(values[i * terms + static_cast<size_t>(k)]);
        }
        out.push_back(v);
    }
    return out;
}

/// Checks and truncates one written index triple.
std::array<uint32_t, 3> checked(const BlockReader& in, const double* v, size_t limit,
                                std::string_view message) {
    std::array<uint32_t, 3> out{};
    for (size_t k = 0; k < 3; ++k) {
        const double index = std::trunc(v[k]);
        if (!(index >= 0.0 && index < static_cast<double>(limit))) in.fail(std::string(message));
        out[k] = static_cast<uint32_t>(index);
    }
    return out;
}

Indices index_block(BlockReader& outer, std::string_view keyword, size_t limit, std::string_view message) {
    BlockReader in(outer.block(keyword), outer.context());
    const size_t n = count(in);
    std::vector<double> values;
    in.numbers(n, 3, values);
    Indices out;
    out.reserve(n);
    for (size_t i = 0; i < n; ++i) out.push_back(checked(in, &values[3 * i], limit, message));
    in.finish();
    return out;
}

void read_textures(BlockReader& outer, MeshData& mesh) {
    BlockReader in(outer.block("texture_list"), outer.context());
    const size_t n = count(in);
    while (mesh.textures.size() < n) {
        if (in.at_thing<TexturePtr>()) {
            mesh.textures.push_back(in.thing<TexturePtr>());
        } else {
            const Block& block = in.block("texture");
            if (!in.context().read_texture) in.fail("Textures cannot be read here.");
            mesh.textures.push_back(in.context().read_texture(block, in.context()));
        }
    }
    in.finish();
}

bool at_index(const BlockReader& in) { return in.at_number() && in.peek().terms == 1; }

void read_faces(BlockReader& outer, MeshData& mesh) {
    BlockReader in(outer.block("face_indices"), outer.context());
    const size_t n = count(in);
    const size_t vertices = mesh.triangles.vertices.size();
    constexpr std::string_view out_of_range = "Mesh face index out of range.";
    Indices& faces = mesh.triangles.faces;
    if (mesh.textures.empty()) {
        std::vector<double> values;
        in.numbers(n, 3, values);
        faces.reserve(n);
        for (size_t i = 0; i < n; ++i) faces.push_back(checked(in, &values[3 * i], vertices, out_of_range));
        in.finish();
        return;
    }
    const auto texture = [&] {
        const int index = in.integer();
        if (index < 0 || static_cast<size_t>(index) >= mesh.textures.size()) {
            in.fail("Texture index out of range in mesh2.");
        }
        return static_cast<uint32_t>(index);
    };
    while (faces.size() < n) {
        const Vec3 v = in.vec3();
        faces.push_back(checked(in, &v[0], vertices, out_of_range));
        std::array<uint32_t, 3> textures{no_index, no_index, no_index};
        if (at_index(in)) textures[0] = texture();
        if (at_index(in)) textures[1] = textures[2] = texture();
        if (at_index(in)) textures[2] = texture();
        mesh.face_textures.push_back(textures);
    }
    in.finish();
}

void read_attribute_indices(BlockReader& in, MeshData& mesh) {
    const size_t faces = mesh.triangles.faces.size();
    TriangleMesh& t = mesh.triangles;
    bool has_uv_indices = false;
    for (;;) {
        if (in.at_block("uv_indices")) {
            mesh.face_uvs = index_block(in, "uv_indices", mesh.uvs.size(), "Mesh UV index out of range.");
            if (mesh.face_uvs.size() != faces) in.fail("Number of uv indices must equal number of faces.");
            has_uv_indices = true;
        } else if (in.at_block("normal_indices")) {
            t.face_normals =
                index_block(in, "normal_indices", t.normals.size(), "Mesh normal index out of range.");
            if (t.face_normals.size() > faces)
                in.fail("Number of normal indices cannot be more than number of faces.");
            t.face_normals.resize(faces, {no_index, no_index, no_index});
        } else {
            break;
        }
    }
    if (t.face_normals.empty() && !t.normals.empty()) {
        if (t.normals.size() != t.vertices.size()) in.fail("Missing normal_indices section in mesh2.");
        t.face_normals = t.faces;
    }
    if (!has_uv_indices && mesh.uvs.size() > 1) {
        if (mesh.uvs.size() != t.vertices.size()) in.fail("Missing uv_indices section in mesh2.");
        mesh.face_uvs = t.faces;
    }
}

ShapePtr read(BlockReader& in) {
    MeshData mesh;
    const SourceRange start = in.block_where();
    const auto again = [&](bool seen) {
        if (seen) in.diagnostics().warning(in.where(), "The block was given before; the last one counts.");
    };
    for (;;) {
        if (in.at_block("vertex_vectors")) {
            again(!mesh.triangles.vertices.empty());
            mesh.triangles.vertices = vectors<Vec3f>(in, "vertex_vectors");
        } else if (in.at_block("normal_vectors")) {
            again(!mesh.triangles.normals.empty());
            mesh.triangles.normals = vectors<Vec3f>(in, "normal_vectors");
        } else if (in.at_block("uv_vectors")) {
            again(!mesh.uvs.empty());
            mesh.uvs = vectors<Vec2>(in, "uv_vectors");
        } else {
            break;
        }
    }
    if (mesh.triangles.vertices.empty()) in.fail("No vertices in triangle mesh.");
    if (in.at_block("texture_list")) read_textures(in, mesh);
    read_faces(in, mesh);
    if (mesh.triangles.faces.empty()) in.fail("No faces in triangle mesh.");
    read_attribute_indices(in, mesh);
    if (in.take_word("inside_vector")) {
        const Vec3 v = in.vec3();
        if (v != Vec3{0.0}) mesh.inside_vector = v;
    }
    prepare_normals(mesh.triangles, start, in.diagnostics());
    return std::make_shared<MeshShape>("mesh2", std::move(mesh));
}

}  // namespace

namespace shapes {
extern const ShapeKind mesh2;
const ShapeKind mesh2{"mesh2", read,
                      "mesh2 { vertex_vectors { 4, <0,0,0>, <1,0,0>, <0,1,0>, <0,0,1> } "
                      "face_indices { 4, <0,1,2>, <0,3,1>, <0,2,3>, <1,3,2> } inside_vector <.3,.4,.5> }"};
}  // namespace shapes

}  // namespace rb
