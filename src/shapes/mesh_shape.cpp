#include "shapes/mesh_shape.h"

#include "kdtree/wide_walk.h"
#include "shapes/nearest_face.h"
#include "shapes/woop_block.h"

#include <algorithm>

#include <fmt/format.h>

namespace rb {

namespace {

/// A face whose box is much larger than itself is worth cutting exactly at split planes.
bool is_sliver(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    const Vec3f size = glm::max(glm::max(a, b), c) - glm::min(glm::min(a, b), c);
    const Vec3f n = glm::cross(b - a, c - a);
    const float box = size.x * size.y + size.y * size.z + size.z * size.x;
    return box * box > 4.0f * glm::dot(n, n);
}

}  // namespace

MeshShape::MeshShape(std::string_view keyword, MeshData data, MeshSearch search)
    : keyword_(keyword), data_(std::move(data)), search_(search) {
    for (const auto& face : data_.triangles.faces) {
        for (const uint32_t v : face) bounds_.include(Vec3(data_.triangles.vertices[v]));
    }
}

void MeshShape::build_tree() const {
    const std::lock_guard lock(building_);
    if (has_tree_.load(std::memory_order_relaxed)) return;
    KdOptions options;
    options.block = TriangleBlock::size;
    options.traversal_cost = 3.0;
    std::vector<bool> slivers(data_.triangles.faces.size());
    const auto box_of = [&](uint32_t face) {
        const auto& f = data_.triangles.faces[face];
        const Vec3f& a = data_.triangles.vertices[f[0]];
        const Vec3f& b = data_.triangles.vertices[f[1]];
        const Vec3f& c = data_.triangles.vertices[f[2]];
        slivers[face] = is_sliver(a, b, c);
        const Vec3f lo = glm::min(glm::min(a, b), c);
        const Vec3f hi = glm::max(glm::max(a, b), c);
        return BoxF{{lo.x, lo.y, lo.z}, {hi.x, hi.y, hi.z}};
    };
    const auto clip = [&](uint32_t face, const Bounds& cell) {
        if (!slivers[face]) return cell;
        return clipped_triangle(vertex(face, 0), vertex(face, 1), vertex(face, 2), cell);
    };
    tree_ = KdTree(static_cast<uint32_t>(data_.triangles.faces.size()), box_of, options, clip);
    if (uses_blocks()) pack_blocks();
    has_tree_.store(true, std::memory_order_release);
}

bool MeshShape::uses_blocks() const { return search_ == MeshSearch::fastest && has_wide(); }

void MeshShape::pack_blocks() const {
    const auto faces = tree_.references();
    blocks_.resize(faces.size() / TriangleBlock::size);
    for (size_t i = 0; i < faces.size(); ++i) {
        const auto& face = data_.triangles.faces[faces[i]];
        const auto& vertices = data_.triangles.vertices;
        blocks_[i / TriangleBlock::size].set(i % TriangleBlock::size, faces[i], vertices[face[0]],
                                             vertices[face[1]], vertices[face[2]]);
    }
}

bool MeshShape::starts_on(const ShapeRay& ray, uint32_t face) const {
    if (ray.starts_on_surface && face == ray.origin_part) return true;
    return ray.origin_error > 0.0 &&
           in_plane(ray.ray.origin, vertex(face, 0), vertex(face, 1), vertex(face, 2), ray.origin_error);
}

/// Calls take(face, hit) for the faces that the ray meets in (t_min, t_max] and that are not where it starts;
/// ends when take returns true. A face may come more than once. `once`: of faces that share what the ray
/// meets an even number come.
template <bool once, class Take>
bool MeshShape::each_candidate(const ShapeRay& ray, const double& t_max, Take&& take) const {
    const WoopRay woop(ray.ray);
    const Vec3f* vertices = data_.triangles.vertices.data();
    const auto* faces = data_.triangles.faces.data();
    const auto test = [&](uint32_t face) {
        const Vec3f& a = vertices[faces[face][0]];
        const Vec3f& b = vertices[faces[face][1]];
        const Vec3f& c = vertices[faces[face][2]];
        TriangleHit hit;
        if (!(once ? woop.hits_once(a, b, c, hit) : woop.hits(a, b, c, hit))) return false;
        if (!(hit.t > ray.t_min && hit.t <= t_max)) return false;
        return !starts_on(ray, face) && take(face, hit);
    };
    if (search_ == MeshSearch::brute_force) {
        for (uint32_t face = 0; face < data_.triangles.faces.size(); ++face) {
            if (test(face)) return true;
        }
        return false;
    }
    if constexpr (!once) {
        if (uses_blocks()) return each_by_blocks(ray, t_max, take);
    }
    return tree().walk(ray.ray, ray.t_min, t_max, [&](const uint32_t* found, uint32_t count) {
        for (uint32_t i = 0; i < count; ++i) {
            // What fills a block.
            if (i > 0 && found[i] == found[i - 1]) break;
            if (test(found[i])) return true;
        }
        return false;
    });
}

template <class Take>
RB_WIDE bool MeshShape::each_by_blocks(const ShapeRay& ray, const double& t_max, Take&& take) const {
    const KdTree& kd = tree();
    const uint32_t* references = kd.references().data();
    const TriangleBlock* blocks = blocks_.data();
    const WoopBlockRay woop{WoopRay(ray.ray)};
    return kd.walk_wide(ray.ray, ray.t_min, t_max, [&](const uint32_t* found, uint32_t count) RB_WIDE {
        const TriangleBlock* block = blocks + static_cast<size_t>(found - references) / TriangleBlock::size;
        for (uint32_t at = 0; at < count; at += TriangleBlock::size, ++block) {
            WoopBlockRay::Hits hits;
            for (unsigned met = woop.meets(*block, ray.t_min, t_max, hits); met != 0; met &= met - 1) {
                const auto i = static_cast<uint32_t>(std::countr_zero(met));
                const TriangleHit hit = hits[i];
                // t_max may have come nearer.
                if (hit.t <= t_max && !starts_on(ray, block->face[i]) && take(block->face[i], hit))
                    return true;
            }
        }
        return false;
    });
}

void MeshShape::crossings(const ShapeRay& ray, Crossings& out) const {
    std::vector<Crossing> all;
    each_candidate<true>(ray, ray.t_max, [&](uint32_t face, const TriangleHit& hit) {
        all.push_back({hit.t, face, hit.at});
        return false;
    });
    std::sort(all.begin(), all.end(), [](const Crossing& a, const Crossing& b) { return a.part < b.part; });
    for (size_t i = 0; i < all.size(); ++i) {
        if (i == 0 || all[i].part != all[i - 1].part) out.add(all[i]);
    }
}

bool MeshShape::closest(const ShapeRay& ray, const CrossingFilter* filter, Crossing& nearest) const {
    return nearest_face(ray, filter, nearest,
                        [&](const double& t_max, auto&& take) { each_candidate<false>(ray, t_max, take); });
}

bool MeshShape::any(const ShapeRay& ray, const CrossingFilter* filter, Crossing& found) const {
    return each_candidate<false>(ray, ray.t_max, [&](uint32_t face, const TriangleHit& hit) {
        found = {hit.t, face, hit.at};
        return !filter || filter->counts(found);
    });
}

bool MeshShape::inside(const Vec3& p) const {
    if (!data_.inside_vector || !bounds_.contains(p)) return false;
    const Ray ray{p, *data_.inside_vector};
    const WoopRay woop(ray);
    std::vector<uint32_t> met;
    constexpr double far = std::numeric_limits<double>::infinity();
    const auto collect = [&](const uint32_t* faces, uint32_t count) {
        for (uint32_t i = 0; i < count; ++i) {
            TriangleHit hit;
            const uint32_t f = faces[i];
            if (woop.hits_once(vertex(f, 0), vertex(f, 1), vertex(f, 2), hit) && hit.t > 0.0)
                met.push_back(f);
        }
        return false;
    };
    if (search_ == MeshSearch::brute_force) {
        for (uint32_t f = 0; f < data_.triangles.faces.size(); ++f) collect(&f, 1);
    } else {
        tree().walk(ray, 0.0, far, collect);
    }
    std::sort(met.begin(), met.end());
    met.erase(std::unique(met.begin(), met.end()), met.end());
    return met.size() % 2 == 1;
}

Vec3 MeshShape::normal(const Vec3&, const Crossing& at) const {
    const TriangleMesh& mesh = data_.triangles;
    if (!mesh.face_normals.empty() && mesh.face_normals[at.part][0] != no_index) {
        const auto& n = mesh.face_normals[at.part];
        return Vec3(mesh.normals[n[0]]) * (1.0 - at.at.x - at.at.y) + Vec3(mesh.normals[n[1]]) * at.at.x +
               Vec3(mesh.normals[n[2]]) * at.at.y;
    }
    const Vec3 a = vertex(at.part, 0);
    return glm::cross(vertex(at.part, 2) - a, vertex(at.part, 1) - a);
}

std::optional<Vec2> MeshShape::uv(const Vec3&, const Crossing& at) const {
    if (data_.face_uvs.empty()) return Vec2{0.0};
    const auto& i = data_.face_uvs[at.part];
    const Vec2 w =
        data_.uvs[i[0]] * (1.0 - at.at.x - at.at.y) + data_.uvs[i[1]] * at.at.x + data_.uvs[i[2]] * at.at.y;
    if (!data_.uv_corners) return w;
    const auto& corner = *data_.uv_corners;
    return (1.0 - w.y) * ((1.0 - w.x) * corner[0] + w.x * corner[1]) +
           w.y * ((1.0 - w.x) * corner[3] + w.x * corner[2]);
}

void MeshShape::textures_at(const Vec3&, const Crossing& at, std::vector<TextureWeight>& out) const {
    if (data_.face_textures.empty()) return;
    const auto& textures = data_.face_textures[at.part];
    if (textures[0] == no_index) return;
    if (textures[1] == no_index) {
        out.push_back({textures[0], 1.0f});
        return;
    }
    out.push_back({textures[0], static_cast<float>(1.0 - at.at.x - at.at.y)});
    out.push_back({textures[1], static_cast<float>(at.at.x)});
    out.push_back({textures[2], static_cast<float>(at.at.y)});
}

std::optional<TriangleMesh> MeshShape::tessellate(double) const {
    TriangleMesh copy = data_.triangles;
    copy.error = 0;
    return copy;
}

std::string MeshShape::describe() const {
    return fmt::format("{} vertices, {} faces", data_.triangles.vertices.size(),
                       data_.triangles.faces.size());
}

void prepare_normals(TriangleMesh& mesh, SourceRange where, Diagnostics& diagnostics) {
    bool zero = false;
    for (Vec3f& n : mesh.normals) {
        constexpr float tiny = 1e-10f;
        if (std::abs(n.x) < tiny && std::abs(n.y) < tiny && std::abs(n.z) < tiny) {
            zero = true;
            n = Vec3f{1, 0, 0};
        }
        n = Vec3f(glm::normalize(Vec3(n)));
    }
    if (zero) diagnostics.warning(where, "Normal vector in mesh cannot be zero - changing it to <1,0,0>.");
    for (auto& face : mesh.face_normals) {
        if (face[0] == no_index) continue;
        const auto differs = [&](uint32_t i, uint32_t k) {
            const Vec3 d = Vec3(mesh.normals[i]) - Vec3(mesh.normals[k]);
            return glm::dot(d, d) > 1e-10;
        };
        if (!differs(face[0], face[1]) && !differs(face[0], face[2])) face[0] = no_index;
    }
}

}  // namespace rb
