#include "shapes/height_field_shape.h"

#include "shapes/nearest_face.h"
#include "shapes/woop.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace rb {

namespace {

/// Bound on the relative error of a computed distance to a grid line, with room.
constexpr double relative_error = 4e-15;
/// What lies this far below the water is seen, as in the reference: grid units.
constexpr double water_margin = 0.001;
constexpr double full_height = 65536.0;

HeightGrid::Range hull(HeightGrid::Range a, HeightGrid::Range b) {
    return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

}  // namespace

HeightGrid::HeightGrid(int columns, int rows, std::vector<uint16_t> heights, bool smooth)
    : columns_(columns), rows_(rows), heights_(std::move(heights)) {
    build_levels();
    if (smooth) build_normals();
}

HeightGrid::Range HeightGrid::range(size_t level, int x, int z) const {
    if (level > 0) {
        const Level& l = levels_[level - 1];
        return l.ranges[static_cast<size_t>(z) * static_cast<size_t>(l.width) + static_cast<size_t>(x)];
    }
    const uint16_t* low = heights_.data() + index(x, z);
    const uint16_t* high = low + columns_;
    const auto sample = [](uint16_t height) { return Range{height, height}; };
    return hull(hull(sample(low[0]), sample(low[1])), hull(sample(high[0]), sample(high[1])));
}

void HeightGrid::build_levels() {
    int width = columns_ - 1;
    int depth = rows_ - 1;
    for (size_t below = 0; below == 0 || width > 1 || depth > 1; ++below) {
        Level level;
        level.width = (width + 1) / 2;
        const int rows = (depth + 1) / 2;
        level.ranges.reserve(static_cast<size_t>(level.width) * static_cast<size_t>(rows));
        for (int z = 0; z < rows; ++z) {
            for (int x = 0; x < level.width; ++x) {
                const int right = std::min(2 * x + 1, width - 1);
                const int far = std::min(2 * z + 1, depth - 1);
                level.ranges.push_back(hull(hull(range(below, 2 * x, 2 * z), range(below, right, 2 * z)),
                                            hull(range(below, 2 * x, far), range(below, right, far))));
            }
        }
        width = level.width;
        depth = rows;
        levels_.push_back(std::move(level));
    }
}

/// Spec: geometry 11.3, "smooth".
void HeightGrid::build_normals() {
    normals_.reserve(heights_.size());
    for (int z = 0; z < rows_; ++z) {
        for (int x = 0; x < columns_; ++x) {
            Vec3 sum{0.0};
            for (const int dx : {-1, 1}) {
                for (const int dz : {-1, 1}) {
                    if (x + dx < 0 || x + dx >= columns_ || z + dz < 0 || z + dz >= rows_) continue;
                    const double here = height(x, z);
                    sum += glm::normalize(
                        Vec3{dx * (here - height(x + dx, z)), 1.0, dz * (here - height(x, z + dz))});
                }
            }
            constexpr double most = 32767.0;
            const Vec3 n = glm::normalize(sum) * most;
            normals_.push_back(
                {static_cast<int16_t>(n.x), static_cast<int16_t>(n.y), static_cast<int16_t>(n.z)});
        }
    }
}

Vec3 HeightGrid::vertex_normal(int x, int z) const {
    const auto& n = normals_[index(x, z)];
    return {static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2])};
}

HeightField::HeightField(std::shared_ptr<const HeightGrid> grid, double water)
    : grid_(std::move(grid)), water_(water) {
    const Vec3 size{static_cast<double>(grid_->columns() - 1), full_height,
                    static_cast<double>(grid_->rows() - 1)};
    for (int i = 0; i < 3; ++i) {
        grid_from_space_.row[static_cast<size_t>(i)][i] = size[i];
        space_from_grid_.row[static_cast<size_t>(i)][i] = 1.0 / size[i];
    }
}

Bounds HeightField::grid_box() const {
    const HeightGrid::Range range = grid_->range(grid_->top_level(), 0, 0);
    return {{0.0, std::max<double>(range.lo, water_ - water_margin), 0.0},
            {static_cast<double>(grid_->columns() - 1), static_cast<double>(range.hi),
             static_cast<double>(grid_->rows() - 1)}};
}

Bounds HeightField::bounds() const {
    const Bounds box = grid_box();
    return box.is_empty() ? Bounds{} : rb::transformed(box, space_from_grid_);
}

Bounds HeightField::language_extent() const {
    Bounds box = grid_box();
    const HeightGrid::Range range = grid_->range(grid_->top_level(), 0, 0);
    box.lo.y = std::max<double>(range.lo, water_) - water_margin;
    box.hi.y += water_margin;
    return rb::transformed(box, space_from_grid_);
}

Bounds HeightField::solid_bounds() const { return Bounds::everything(); }

bool HeightField::inside(const Vec3& p) const {
    const Vec3 q = grid_from_space_.point(p);
    const Bounds box = grid_box();
    if (!(q.x >= 0.0 && q.x < box.hi.x && q.z >= 0.0 && q.z < box.hi.z && q.y < box.hi.y + water_margin))
        return false;
    if (q.y < water_) return true;
    const int x = static_cast<int>(q.x);
    const int z = static_cast<int>(q.z);
    const double u = q.x - x;
    const double v = q.z - z;
    const auto level = [&](int dx, int dz) { return std::max(grid_->height(x + dx, z + dz), water_); };
    if (u + v <= 1.0) {
        const double here = level(0, 0);
        return q.y < here + u * (level(1, 0) - here) + v * (level(0, 1) - here);
    }
    const double there = level(1, 1);
    return q.y < there + (1.0 - u) * (level(0, 1) - there) + (1.0 - v) * (level(1, 0) - there);
}

std::array<Vec3, 3> HeightField::triangle(uint32_t part) const {
    const int cells = grid_->columns() - 1;
    const int x = static_cast<int>(part / 2) % cells;
    const int z = static_cast<int>(part / 2) / cells;
    const auto vertex = [&](int dx, int dz) {
        return Vec3{static_cast<double>(x + dx), grid_->height(x + dx, z + dz), static_cast<double>(z + dz)};
    };
    if (part % 2 == 0) return {vertex(0, 0), vertex(1, 0), vertex(0, 1)};
    return {vertex(1, 1), vertex(0, 1), vertex(1, 0)};
}

/// Upward in grid space.
Vec3 HeightField::grid_normal(uint32_t part) const {
    const auto [a, b, c] = triangle(part);
    const double sign = part % 2 == 0 ? 1.0 : -1.0;
    return {sign * (a.y - b.y), 1.0, sign * (a.y - c.y)};
}

/// A square of 2^level cells, and the ray's way through it.
struct HeightField::Node {
    size_t level;
    int x, z;
    double near, far;
};

/// The squares that a ray in grid space meets, near to far. Every way is widened by its relative error, so
/// that no cell is missed.
class HeightField::Walk {
public:
    Walk(const HeightField& field, const Ray& ray, double t_min, double t_max)
        : grid_(*field.grid_),
          ray_(ray),
          floor_(field.water_ - water_margin),
          inverse_x_(1.0 / ray.direction.x),
          inverse_z_(1.0 / ray.direction.z) {
        Node root{grid_.top_level(), 0, 0, t_min, t_max};
        const Bounds box = field.grid_box();
        for (int i = 0; i < 3; ++i) {
            const double o = ray.origin[i];
            const double d = ray.direction[i];
            if (d == 0.0) {
                if (o < box.lo[i] || o > box.hi[i]) return;
                continue;
            }
            const double a = (box.lo[i] - o) / d;
            const double b = (box.hi[i] - o) / d;
            narrow(root, std::min(a, b), std::max(a, b));
        }
        if (root.near <= root.far && !passes_by(root)) stack_[waiting_++] = root;
    }

    /// The next cell; false if none is left before `t_max`.
    bool next(double t_max, int& x, int& z) {
        while (waiting_ > 0) {
            Node node = stack_[--waiting_];
            bool meets = node.near <= t_max;
            while (meets && node.level > 0) meets = descend(node);
            if (!meets) continue;
            x = node.x;
            z = node.z;
            return true;
        }
        return false;
    }

private:
    static void narrow(Node& node, double near, double far) {
        near -= relative_error * std::abs(near);
        far += relative_error * std::abs(far);
        if (near > node.near) node.near = near;
        if (far < node.far) node.far = far;
    }

    bool passes_by(const Node& node) const {
        const HeightGrid::Range range = grid_.range(node.level, node.x, node.z);
        const double a = node.near * ray_.direction.y;
        const double b = node.far * ray_.direction.y;
        const double slack = relative_error * (std::abs(ray_.origin.y) + std::abs(a) + std::abs(b));
        const double lo = ray_.origin.y + std::min(a, b) - slack;
        const double hi = ray_.origin.y + std::max(a, b) + slack;
        return lo > range.hi || hi < range.lo || hi < floor_ || range.hi < floor_;
    }

    /// A half of a node's squares in one direction, and the ray's way through its slab.
    struct Half {
        int place;
        double near, far;
    };
    struct Halves {
        std::array<Half, 2> half;  ///< the far one first
        size_t count;
    };

    /// Halves `node`, which has number `place` in one direction, at a grid line of that direction.
    static Halves halves(const Node& node, int place, int line, int last, double origin, double inverse,
                         double direction) {
        const Half low{2 * place, node.near, node.far};
        if (line >= last) return {{low, low}, 1};
        const Half high{2 * place + 1, node.near, node.far};
        if (direction == 0.0) {
            if (origin == line) return {{high, low}, 2};
            return {{origin > line ? high : low, low}, 1};
        }
        const double t = (line - origin) * inverse;
        const double error = relative_error * std::abs(t);
        Half near = direction > 0.0 ? low : high;
        Half far = direction > 0.0 ? high : low;
        near.far = std::min(t + error, near.far);
        far.near = std::max(t - error, far.near);
        if (far.near > far.far) return {{near, near}, 1};
        if (near.near > near.far) return {{far, far}, 1};
        return {{far, near}, 2};
    }

    /// Replaces a node by the nearest of its parts that the ray meets; the others wait. False if it meets
    /// none.
    bool descend(Node& node) {
        const size_t level = node.level - 1;
        const int half = 1 << level;
        const Halves columns = halves(node, node.x, (2 * node.x + 1) * half, grid_.columns() - 1,
                                      ray_.origin.x, inverse_x_, ray_.direction.x);
        const Halves rows = halves(node, node.z, (2 * node.z + 1) * half, grid_.rows() - 1, ray_.origin.z,
                                   inverse_z_, ray_.direction.z);
        bool found = false;
        for (size_t i = 0; i < columns.count; ++i) {
            const Half& c = columns.half[i];
            for (size_t k = 0; k < rows.count; ++k) {
                const Half& r = rows.half[k];
                const Node part{level, c.place, r.place, std::max(c.near, r.near), std::min(c.far, r.far)};
                if (!(part.near <= part.far) || passes_by(part)) continue;
                if (found) stack_[waiting_++] = node;
                node = part;
                found = true;
            }
        }
        return found;
    }

    const HeightGrid& grid_;
    const Ray& ray_;
    double floor_;
    double inverse_x_;
    double inverse_z_;
    // A level leaves at most three squares behind.
    std::array<Node, 64> stack_;
    size_t waiting_ = 0;
};

/// True if the ray starts on the plane of the triangle.
bool HeightField::starts_in(const ShapeRay& ray, const Vec3& origin, uint32_t part) const {
    if (ray.starts_on_surface && part == ray.origin_part) return true;
    if (!(ray.origin_error > 0.0)) return false;
    const Vec3 n = grid_normal(part);
    const double height = glm::dot(n, origin - triangle(part)[0]);
    const Vec3 in_space = grid_from_space_.transposed_direction(n);
    return height * height <= ray.origin_error * ray.origin_error * glm::dot(in_space, in_space);
}

/// Calls take(part, hit) for the triangles that the ray meets in (t_min, t_max], about near to far; ends when
/// take returns true.
template <class Take>
bool HeightField::each_candidate(const ShapeRay& query, const double& t_max, Take&& take) const {
    const Ray ray{grid_from_space_.point(query.ray.origin), grid_from_space_.direction(query.ray.direction)};
    Walk walk(*this, ray, query.t_min, t_max);
    const WoopRay woop(ray);
    const double floor = water_ - water_margin;
    int x = 0;
    int z = 0;
    while (walk.next(t_max, x, z)) {
        const uint32_t first = 2 * static_cast<uint32_t>(z * (grid_->columns() - 1) + x);
        for (uint32_t part = first; part < first + 2; ++part) {
            const auto [a, b, c] = triangle(part);
            TriangleHit hit;
            if (!woop.hits(a, b, c, hit) || !(hit.t > query.t_min && hit.t <= t_max)) continue;
            if (ray.origin.y + hit.t * ray.direction.y < floor) continue;
            if (starts_in(query, ray.origin, part)) continue;
            if (take(part, hit)) return true;
        }
    }
    return false;
}

void HeightField::crossings(const ShapeRay& ray, Crossings& out) const {
    each_candidate(ray, ray.t_max, [&](uint32_t part, const TriangleHit& hit) {
        out.add({hit.t, part, hit.at});
        return false;
    });
}

bool HeightField::closest(const ShapeRay& ray, const CrossingFilter* filter, Crossing& nearest) const {
    return nearest_face(ray, filter, nearest,
                        [&](const double& t_max, auto&& take) { each_candidate(ray, t_max, take); });
}

bool HeightField::any(const ShapeRay& ray, const CrossingFilter* filter, Crossing& found) const {
    return each_candidate(ray, ray.t_max, [&](uint32_t part, const TriangleHit& hit) {
        found = {hit.t, part, hit.at};
        return !filter || filter->counts(found);
    });
}

Vec3 HeightField::normal(const Vec3& p, const Crossing& at) const {
    if (!grid_->is_smooth()) return grid_from_space_.transposed_direction(grid_normal(at.part));
    const Vec3 q = grid_from_space_.point(p);
    const int cells = grid_->columns() - 1;
    const int x = static_cast<int>(at.part / 2) % cells;
    const int z = static_cast<int>(at.part / 2) / cells;
    const double u = std::clamp(q.x - x, 0.0, 1.0);
    const double v = std::clamp(q.z - z, 0.0, 1.0);
    const auto corner = [&](int dx, int dz) {
        return glm::normalize(grid_from_space_.transposed_direction(grid_->vertex_normal(x + dx, z + dz)));
    };
    return (1.0 - v) * ((1.0 - u) * corner(0, 0) + u * corner(1, 0)) +
           v * ((1.0 - u) * corner(0, 1) + u * corner(1, 1));
}

ShapePtr HeightField::transformed(const Transform& map) const {
    auto moved = std::make_shared<HeightField>(*this);
    moved->grid_from_space_ = then(map.backward, grid_from_space_);
    moved->space_from_grid_ = then(space_from_grid_, map.forward);
    return moved;
}

std::optional<TriangleMesh> HeightField::tessellate(double) const {
    if (grid_box().lo.y > grid_->range(grid_->top_level(), 0, 0).lo) return std::nullopt;
    TriangleMesh mesh;
    for (int z = 0; z < grid_->rows(); ++z) {
        for (int x = 0; x < grid_->columns(); ++x) {
            mesh.vertices.emplace_back(space_from_grid_.point(
                {static_cast<double>(x), grid_->height(x, z), static_cast<double>(z)}));
        }
    }
    const auto columns = static_cast<uint32_t>(grid_->columns());
    for (uint32_t z = 0; z + 1 < static_cast<uint32_t>(grid_->rows()); ++z) {
        for (uint32_t x = 0; x + 1 < columns; ++x) {
            const uint32_t at = z * columns + x;
            mesh.faces.push_back({at, at + 1, at + columns});
            mesh.faces.push_back({at + columns + 1, at + columns, at + 1});
        }
    }
    // What single precision rounds.
    const Bounds box = bounds();
    mesh.error = glm::length(glm::max(glm::abs(box.lo), glm::abs(box.hi))) * 0x1p-24;
    return mesh;
}

std::string HeightField::describe() const {
    return fmt::format("{} x {} heights, water level {}{}", grid_->columns(), grid_->rows(),
                       water_ / full_height, grid_->is_smooth() ? ", smooth" : "");
}

}  // namespace rb
