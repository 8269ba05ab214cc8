// bicubic_patch { type t [flatness f] [u_steps n] [v_steps n] [accuracy f] [uv_vectors <..> x 4]
//                 <p00>, <p01>, ... <p33> }   (manual 3.5.2.1)
#include "shapes/mesh_shape.h"
#include "shapes/registry.h"

#include <cmath>
#include <map>

namespace rb {

namespace {

/// Control points; the first index belongs to u.
using Net = std::array<std::array<Vec3, 4>, 4>;
using Weights = std::array<double, 4>;

Weights bernstein(double w) {
    const double v = 1.0 - w;
    return {v * v * v, 3.0 * v * v * w, 3.0 * v * w * w, w * w * w};
}
Weights bernstein_slope(double w) {
    const double v = 1.0 - w;
    return {-3.0 * v * v, 3.0 * v * v - 6.0 * v * w, 6.0 * v * w - 3.0 * w * w, 3.0 * w * w};
}

Vec3 blend(const Net& net, const Weights& u, const Weights& v) {
    Vec3 sum{0.0};
    for (size_t i = 0; i < 4; ++i) {
        for (size_t k = 0; k < 4; ++k) sum += u[i] * v[k] * net[i][k];
    }
    return sum;
}

using Row = std::array<Vec3, 4>;

/// De Casteljau's halves.
void halve(const Row& p, Row& low, Row& high) {
    const Vec3 middle = 0.5 * (p[1] + p[2]);
    low = {p[0], 0.5 * (p[0] + p[1]), Vec3{0.0}, Vec3{0.0}};
    high = {Vec3{0.0}, Vec3{0.0}, 0.5 * (p[2] + p[3]), p[3]};
    low[2] = 0.5 * (low[1] + middle);
    high[1] = 0.5 * (middle + high[2]);
    low[3] = high[0] = 0.5 * (low[2] + high[1]);
}

std::array<Net, 2> halves_in_v(const Net& net) {
    std::array<Net, 2> out;
    for (size_t i = 0; i < 4; ++i) halve(net[i], out[0][i], out[1][i]);
    return out;
}

Net transposed(const Net& net) {
    Net out;
    for (size_t i = 0; i < 4; ++i) {
        for (size_t k = 0; k < 4; ++k) out[k][i] = net[i][k];
    }
    return out;
}

std::array<Net, 2> halves_in_u(const Net& net) {
    const auto out = halves_in_v(transposed(net));
    return {transposed(out[0]), transposed(out[1])};
}

struct Detail {
    double flatness = 0;
    int u_steps = 0;
    int v_steps = 0;
    std::optional<std::array<Vec2, 4>> uv_corners;
};

/// Cuts the patch into triangles as the language does (spec: geometry 10.6).
class Subdivision {
public:
    Subdivision(const Net& net, const Detail& detail) : net_(net), detail_(detail) {}

    /// False if there would be too many triangles.
    bool build(MeshData& mesh) {
        mesh_ = &mesh;
        return divide(net_, {0.0, 1.0, 0.0, 1.0}, 0);
    }

private:
    struct Range {
        double u0, u1, v0, v1;
    };

    bool divide(const Net& part, const Range& r, int depth) {
        constexpr size_t most = 20'000'000;
        if (mesh_->triangles.faces.size() > most) return false;
        const bool u_done = depth >= detail_.u_steps;
        const bool v_done = depth >= detail_.v_steps;
        if ((u_done && v_done) || is_flat(part)) {
            leaf(r);
            return true;
        }
        const double u = 0.5 * (r.u0 + r.u1);
        const double v = 0.5 * (r.v0 + r.v1);
        if (u_done) return halves(halves_in_v(part), {r.u0, r.u1, r.v0, v}, {r.u0, r.u1, v, r.v1}, depth);
        const auto cut = halves_in_u(part);
        if (v_done) return halves(cut, {r.u0, u, r.v0, r.v1}, {u, r.u1, r.v0, r.v1}, depth);
        return halves(halves_in_v(cut[0]), {r.u0, u, r.v0, v}, {r.u0, u, v, r.v1}, depth) &&
               halves(halves_in_v(cut[1]), {u, r.u1, r.v0, v}, {u, r.u1, v, r.v1}, depth);
    }
    bool halves(const std::array<Net, 2>& parts, const Range& a, const Range& b, int depth) {
        return divide(parts[0], a, depth + 1) && divide(parts[1], b, depth + 1);
    }

    bool is_flat(const Net& p) const {
        if (!(detail_.flatness > 0.0)) return false;
        const Vec3& a = p[0][0];
        const Vec3& b = p[0][3] == a ? p[3][3] : p[0][3];
        const Vec3 n = glm::cross(b - a, p[3][0] - a);
        const double length = glm::length(n);
        if (!(length > 0.0)) return false;
        for (const Row& row : p) {
            for (const Vec3& q : row) {
                if (!(std::abs(glm::dot(q - a, n)) < detail_.flatness * length)) return false;
            }
        }
        return true;
    }

    void leaf(const Range& r) {
        const uint32_t p00 = vertex(r.u0, r.v0);
        const uint32_t p03 = vertex(r.u0, r.v1);
        const uint32_t p33 = vertex(r.u1, r.v1);
        const uint32_t p30 = vertex(r.u1, r.v0);
        face({p00, p03, p33});
        face({p00, p33, p30});
    }

    void face(const std::array<uint32_t, 3>& f) {
        const auto& v = mesh_->triangles.vertices;
        const Vec3 a(v[f[0]]);
        if (glm::cross(Vec3(v[f[1]]) - a, Vec3(v[f[2]]) - a) == Vec3{0.0}) return;
        mesh_->triangles.faces.push_back(f);
        mesh_->triangles.face_normals.push_back(f);
        mesh_->face_uvs.push_back(f);
    }

    /// Neighbouring leaves share the vertex, so that nothing shows between them.
    uint32_t vertex(double u, double v) {
        TriangleMesh& mesh = mesh_->triangles;
        const auto [it, is_new] = known_.try_emplace({u, v}, static_cast<uint32_t>(mesh.vertices.size()));
        if (!is_new) return it->second;
        mesh.vertices.emplace_back(blend(net_, bernstein(u), bernstein(v)));
        const Vec3 n = glm::cross(blend(net_, bernstein_slope(u), bernstein(v)),
                                  blend(net_, bernstein(u), bernstein_slope(v)));
        const double length = glm::length(n);
        mesh.normals.emplace_back(length > 0.0 ? n / length : Vec3{1, 0, 0});
        mesh_->uvs.emplace_back(v, u);
        return it->second;
    }

    const Net& net_;
    Detail detail_;
    MeshData* mesh_ = nullptr;
    std::map<std::pair<double, double>, uint32_t> known_;
};

bool at_float(const BlockReader& in) { return in.at_number() && in.peek().terms == 1; }

/// `type t flatness f ...`, or as before version 1.0 the bare numbers type [flatness] u v.
Detail read_detail(BlockReader& in) {
    Detail detail;
    std::optional<int> type;
    if (at_float(in)) {
        std::vector<double> bare;
        while (at_float(in)) bare.push_back(in.number());
        if (bare.size() < 3 || bare.size() > 4) in.fail("Expected type, flatness, u_steps and v_steps.");
        type = static_cast<int>(bare[0]);
        if (bare.size() == 4) detail.flatness = bare[1];
        detail.u_steps = static_cast<int>(bare[bare.size() - 2]);
        detail.v_steps = static_cast<int>(bare.back());
    }
    for (;;) {
        const SourceRange at = in.where();
        if (in.take_word("type")) {
            type = in.integer();
            if (*type < 0 || *type > 1)
                in.diagnostics().warning(at, "Patch type is no longer supported. Using type 1.");
        } else if (in.take_word("flatness")) {
            detail.flatness = in.number();
        } else if (in.take_word("u_steps")) {
            detail.u_steps = in.integer();
        } else if (in.take_word("v_steps")) {
            detail.v_steps = in.integer();
        } else if (in.take_word("accuracy")) {
            in.number();
        } else if (in.take_word("uv_vectors")) {
            std::array<Vec2, 4> corners;
            for (Vec2& corner : corners) corner = in.vec2();
            detail.uv_corners = corners;
        } else {
            break;
        }
    }
    if (!type) in.fail("Undefined bicubic patch type.");
    return detail;
}

/// Null if there would be too many triangles.
ShapePtr make_patch(const Net& net, const Detail& detail) {
    MeshData mesh;
    mesh.uv_corners = detail.uv_corners;
    Bounds hull;
    for (const Row& row : net) {
        for (const Vec3& p : row) hull.include(p);
    }
    mesh.extent = hull;
    if (!Subdivision(net, detail).build(mesh)) return nullptr;
    // The language measures flatness where the patch stands in the world.
    if (detail.flatness > 0.0) {
        mesh.moved = [net, detail](const Transform& map) {
            Net moved = net;
            for (Row& row : moved) {
                for (Vec3& p : row) p = map.point(p);
            }
            return make_patch(moved, detail);
        };
    }
    return std::make_shared<MeshShape>("bicubic_patch", std::move(mesh));
}

ShapePtr read(BlockReader& in) {
    const Detail detail = read_detail(in);
    Net net;
    for (Row& row : net) {
        for (Vec3& p : row) p = in.vec3();
    }
    constexpr int most_steps = 22;
    ShapePtr patch;
    if (std::max(detail.u_steps, 0) + std::max(detail.v_steps, 0) <= most_steps)
        patch = make_patch(net, detail);
    if (!patch) in.fail_at(in.block_where(), "The patch's u_steps and v_steps ask for too many triangles.");
    return patch;
}

}  // namespace

namespace shapes {
extern const ShapeKind bicubic_patch;
const ShapeKind bicubic_patch{
    "bicubic_patch", read,
    "bicubic_patch { type 1 flatness 0 u_steps 3 v_steps 2 "
    "<-.6,-.6,0>, <-.2,-.7,0>, <.2,-.5,0>, <.6,-.6,0>, <-.7,-.2,0>, <-.2,-.2,0>, <.2,-.2,0>, <.6,-.2,0>, "
    "<-.6,.2,0>, <-.2,.2,0>, <.2,.2,0>, <.5,.2,0>, <-.6,.6,0>, <-.2,.6,0>, <.2,.7,0>, <.6,.6,0> }"};
}  // namespace shapes

}  // namespace rb
