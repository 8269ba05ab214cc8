#include "math/roots.h"
#include "shapes/blob.h"
#include "shapes/ray_shape.h"
#include "shapes/solid_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace rb {

namespace {

/// One component along a ray whose parameter is 0 near the blob.
struct Chord {
    const BlobComponent* component = nullptr;
    Vec3 o;
    Vec3 d;
    double enter = 0;
    double leave = 0;
    double most = 0;  ///< of 1 - r^2 at a distance r along the ray

    void meets(double at, double from, double to, double room) {
        if (!(from < to)) return;
        most = std::max(most, room);
        if (!(leave > enter)) {
            enter = from + at;
            leave = to + at;
        } else {
            enter = std::min(enter, from + at);
            leave = std::max(leave, to + at);
        }
    }
    /// As high as its field may be along the ray.
    double peak() const { return std::max(component->strength, 0.0) * most * most; }

    /// Finds where the ray is within distance 1 of the axis; false if nowhere.
    bool find() {
        const double length = component->length;
        const double dd = glm::dot(d, d);
        for (const double end : {0.0, length}) {
            const Vec3 p = o - Vec3{0, 0, end};
            const double at = -glm::dot(p, d) / dd;
            const Vec3 q = p + at * d;
            const double room = std::max(1.0 - glm::dot(q, q), 0.0);
            const double half = std::sqrt(room / dd);
            meets(at, -half, half, room);
            if (length == 0.0) break;
        }
        if (length > 0.0) find_between();
        return enter < leave;
    }

    void find_between() {
        const double length = component->length;
        const double across = d.x * d.x + d.y * d.y;
        const double at = across > 0.0 ? -(o.x * d.x + o.y * d.y) / across : 0.0;
        const double x = o.x + at * d.x;
        const double y = o.y + at * d.y;
        const double room = 1.0 - x * x - y * y;
        if (!(room > 0.0)) return;
        const double half = across > 0.0 ? std::sqrt(room / across) : std::numeric_limits<double>::infinity();
        double from = -half;
        double to = half;
        if (d.z != 0.0) {
            const double a = -o.z / d.z - at;
            const double b = (length - o.z) / d.z - at;
            from = std::max(from, std::min(a, b));
            to = std::min(to, std::max(a, b));
        } else if (o.z < 0.0 || o.z > length) {
            return;
        }
        meets(at, from, to, room);
    }

    /// Adds the field as a polynomial in u, with t = base + scale u; `within` is in the piece that it holds
    /// for.
    void add_to(std::array<double, 5>& sum, double within, double base, double scale) const {
        Vec3 p = o + base * d;
        Vec3 e = scale * d;
        const double length = component->length;
        const double height = o.z + within * d.z;
        if (height > length) {
            p.z -= length;
        } else if (height > 0.0) {
            p.z = e.z = 0.0;
        }
        const double a = -glm::dot(e, e);
        const double b = -2.0 * glm::dot(p, e);
        const double c = 1.0 - glm::dot(p, p);
        const double s = component->strength;
        sum[0] += s * a * a;
        sum[1] += 2.0 * s * a * b;
        sum[2] += s * (b * b + 2.0 * a * c);
        sum[3] += 2.0 * s * b * c;
        sum[4] += s * c * c;
    }
};

/// All components that a ray meets, and where the sum of their polynomials changes.
struct Chords {
    std::vector<Chord> chords;  ///< in the order of the components
    std::vector<double> cuts;

    void clear() {
        chords.clear();
        cuts.clear();
    }
    /// Before around() is asked.
    void set_out() {
        std::ranges::sort(cuts);
        by_entry_.resize(chords.size());
        std::iota(by_entry_.begin(), by_entry_.end(), 0u);
        std::ranges::sort(by_entry_, {}, [&](uint32_t i) { return chords[i].enter; });
        entered_ = 0;
        around_.clear();
    }
    /// Those that reach over a place, in their order. Places must be asked for from near to far.
    std::span<const uint32_t> around(double t) {
        std::erase_if(around_, [&](uint32_t i) { return !(chords[i].leave >= t); });
        for (; entered_ < by_entry_.size() && chords[by_entry_[entered_]].enter <= t; ++entered_) {
            const uint32_t i = by_entry_[entered_];
            if (chords[i].leave >= t) around_.insert(std::ranges::upper_bound(around_, i), i);
        }
        return around_;
    }
    void cut(double t, double lo, double hi) {
        if (t > lo && t < hi) cuts.push_back(t);
    }
    void add(const Chord& chord, double lo, double hi) {
        if (!(chord.leave > lo) || !(chord.enter < hi)) return;
        chords.push_back(chord);
        cuts.push_back(std::clamp(chord.enter, lo, hi));
        cuts.push_back(std::clamp(chord.leave, lo, hi));
        if (chord.component->length > 0.0 && chord.d.z != 0.0) {
            cut(-chord.o.z / chord.d.z, std::max(lo, chord.enter), std::min(hi, chord.leave));
            cut((chord.component->length - chord.o.z) / chord.d.z, std::max(lo, chord.enter),
                std::min(hi, chord.leave));
        }
    }

private:
    std::vector<uint32_t> by_entry_;
    size_t entered_ = 0;
    std::vector<uint32_t> around_;
};

/// For each component, with how many that have a positive strength it shares space, itself among them.
std::vector<int> overlap_counts(const std::vector<BlobComponent>& components,
                                const std::vector<Bounds>& boxes) {
    std::vector<size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::ranges::sort(order, {}, [&](size_t i) { return boxes[i].lo.x; });
    std::vector<int> counts(boxes.size(), 0);
    for (size_t a = 0; a < order.size(); ++a) {
        const size_t i = order[a];
        counts[i] += components[i].strength > 0.0 ? 1 : 0;
        for (size_t b = a + 1; b < order.size() && boxes[order[b]].lo.x <= boxes[i].hi.x; ++b) {
            const size_t k = order[b];
            if (intersection(boxes[i], boxes[k]).is_empty()) continue;
            counts[i] += components[k].strength > 0.0 ? 1 : 0;
            counts[k] += components[i].strength > 0.0 ? 1 : 0;
        }
    }
    return counts;
}

BoxTree tree_over(const std::vector<Bounds>& boxes) {
    // Fewer are looked at sooner than a tree of them.
    constexpr size_t few = 12;
    std::vector<BoxTree::Item> items;
    if (boxes.size() <= few) return {};
    for (const Bounds& box : boxes) {
        if (!box.is_finite() || box.is_empty()) return {};
        items.push_back({box, 1});
    }
    return BoxTree(items);
}

/// The box that the language counts for a component: a cylinder's holds a sphere around its middle, too.
Bounds language_box(const BlobComponent& c) {
    Bounds box = c.box(1.0);
    if (c.length > 0.0) {
        const double r = std::sqrt(1.0 + 0.25 * c.length * c.length);
        const Vec3 middle{0, 0, 0.5 * c.length};
        box.include(transformed(Bounds{middle - r, middle + r}, c.object_from_local.forward));
    }
    return box;
}

/// Bound on the square of a map's largest stretch (largest row sum of its product with its transpose).
double squared_stretch(const Affine& map) {
    double most = 0.0;
    for (size_t i = 0; i < 3; ++i) {
        double sum = 0.0;
        for (size_t k = 0; k < 3; ++k) sum += std::abs(glm::dot(map.row[i], map.row[k]));
        most = std::max(most, sum);
    }
    return most;
}

/// The blob for its mesh; the function is threshold minus field, so that it grows outward.
class BlobSolid final : public PointSolid {
public:
    BlobSolid(const Blob& blob, const BlobData& data) : blob_(blob), data_(data) {
        for (const BlobComponent& c : data.components) {
            boxes_.push_back(c.box(1.0));
            stretches_.push_back(squared_stretch(c.object_from_local.backward));
        }
    }
    bool inside(const Vec3& p) const override { return blob_.inside(p); }
    std::optional<GradientBound> slopes(const Bounds& region) const override {
        double bend_of_all = 0.0;
        for (size_t i = 0; i < boxes_.size(); ++i) {
            if (!intersection(region, boxes_[i]).is_empty()) bend_of_all += bend(i, region);
        }
        return GradientBound{blob_.slope(region.center()), 0.5 * glm::length(region.size()) * bend_of_all};
    }

private:
    /// How fast a component's gradient may change anywhere in the box (a Lipschitz constant).
    /// The second derivatives of S (1 - r^2)^2 are S (12 r^2 - 4) outward and 4 S (r^2 - 1) across.
    double bend(size_t i, const Bounds& box) const {
        const BlobComponent& c = data_.components[i];
        const double reach = 0.5 * glm::length(box.size()) * std::sqrt(stretches_[i]);
        const double r = glm::length(c.from_axis(c.object_from_local.inverse_point(box.center())));
        const double lo = std::clamp(r - reach, 0.0, 1.0);
        const double hi = std::min(r + reach, 1.0);
        const double most = std::max({4.0 - 4.0 * lo * lo, 4.0 - 12.0 * lo * lo, 12.0 * hi * hi - 4.0});
        return std::abs(c.strength) * most * stretches_[i];
    }

    const Blob& blob_;
    const BlobData& data_;
    std::vector<Bounds> boxes_;
    std::vector<double> stretches_;
};

}  // namespace

Vec3 BlobComponent::from_axis(const Vec3& local) const {
    return {local.x, local.y, local.z - std::clamp(local.z, 0.0, length)};
}

double BlobComponent::field(const Vec3& p) const {
    const Vec3 q = from_axis(object_from_local.inverse_point(p));
    const double w = 1.0 - glm::dot(q, q);
    return w > 0.0 ? strength * w * w : 0.0;
}

Vec3 BlobComponent::slope(const Vec3& p) const {
    const Vec3 q = from_axis(object_from_local.inverse_point(p));
    const double w = 1.0 - glm::dot(q, q);
    return w > 0.0 ? 4.0 * strength * w * object_from_local.normal(q) : Vec3{0.0};
}

Bounds BlobComponent::box(double r) const {
    const auto& m = object_from_local.forward.row;
    Vec3 half;
    for (int i = 0; i < 3; ++i) half[i] = r * std::hypot(m[0][i], m[1][i], m[2][i]);
    const Vec3 far = m[3] + length * m[2];
    half += 16.0 * std::numeric_limits<double>::epsilon() * (half + glm::abs(m[3]) + glm::abs(far));
    Bounds box{m[3] - half, m[3] + half};
    box.include(Bounds{far - half, far + half});
    return box;
}

double BlobComponent::most_beyond(const Vec3& direction, double height) const {
    if (!(strength > 0.0)) return 0.0;
    const Affine& map = object_from_local.forward;
    const Vec3 slopes = map.transposed_direction(direction);
    const double top = glm::dot(map.row[3], direction) + std::max(length * slopes.z, 0.0);
    const double apart = height - top;
    if (!(apart > 0.0)) return strength;
    const double w = 1.0 - apart * apart / glm::dot(slopes, slopes);
    return w > 0.0 ? strength * w * w : 0.0;
}

Blob::Blob(BlobData data, bool with_tree) : data_(std::move(data)) {
    std::vector<Bounds> boxes;
    for (const BlobComponent& c : data_.components) boxes.push_back(c.box(1.0));
    if (with_tree) tree_ = tree_over(boxes);
    const std::vector<int> overlaps = overlap_counts(data_.components, boxes);
    // A surface point needs a component that brings its share of the threshold.
    for (size_t i = 0; i < boxes.size(); ++i) {
        const BlobComponent& c = data_.components[i];
        if (data_.threshold > 0.0) {
            if (!(c.strength > 0.0)) continue;
            extent_.include(language_box(c));
            const double share = data_.threshold / (overlaps[i] * c.strength);
            if (share <= 1.0) box_.include(c.box(std::sqrt(1.0 - std::sqrt(share))));
        } else {
            extent_.include(language_box(c));
            box_.include(boxes[i]);
        }
    }
}

Bounds Blob::solid_bounds() const { return data_.threshold > 0.0 ? box_ : Bounds::everything(); }

/// How far it reaches: beyond that all components together stay below the threshold.
double Blob::height_along(const Vec3& direction) const {
    constexpr int halvings = 24;
    constexpr double rounding = 1e-9;
    const Vec3 half = 0.5 * box_.size();
    double inner = glm::dot(box_.center(), direction) - glm::dot(half, glm::abs(direction));
    double outer = glm::dot(box_.center(), direction) + glm::dot(half, glm::abs(direction));
    for (int i = 0; i < halvings; ++i) {
        const double height = 0.5 * (inner + outer);
        double most = 0.0;
        for (const BlobComponent& c : data_.components) most += c.most_beyond(direction, height);
        (most * (1.0 + rounding) < data_.threshold ? outer : inner) = height;
    }
    return outer;
}

Extent Blob::extent(const Vec3& direction) const {
    if (!has_tight_extent() || !box_.is_finite() || box_.is_empty()) return {};
    return {-height_along(-direction), height_along(direction)};
}

template <class Take>
void Blob::each_along(const Ray& ray, Take&& take) const {
    constexpr double end = std::numeric_limits<double>::infinity();
    each_found([&](const auto& found) { tree_.walk(ray, 1, 0.0, end, found); }, take);
}

template <class Take>
void Blob::each_at(const Vec3& p, Take&& take) const {
    each_found([&](const auto& found) { tree_.walk_at(p, 1, found); }, take);
}

template <class Walk, class Take>
void Blob::each_found(Walk&& walk, Take&& take) const {
    if (tree_.is_empty()) {
        for (const BlobComponent& c : data_.components) take(c);
        return;
    }
    thread_local std::vector<uint32_t> met;
    met.clear();
    walk([&](uint32_t element) {
        met.push_back(tree_.order()[element]);
        return false;
    });
    std::ranges::sort(met);
    for (const uint32_t i : met) take(data_.components[i]);
}

double Blob::field(const Vec3& p) const {
    double sum = 0.0;
    each_at(p, [&](const BlobComponent& c) { sum += c.field(p); });
    return sum;
}

Vec3 Blob::slope(const Vec3& p) const {
    Vec3 sum{0.0};
    each_at(p, [&](const BlobComponent& c) { sum += c.slope(p); });
    return sum;
}

bool Blob::inside(const Vec3& p) const { return field(p) >= data_.threshold; }

Vec3 Blob::normal(const Vec3& p, const Crossing&) const {
    const Vec3 n = slope(p);
    return n == Vec3{0.0} ? Vec3{1, 0, 0} : n;
}

/// `level` becomes the field at the origin: taking it for the threshold puts the root there exactly.
bool Blob::starts_here(const ShapeRay& query, double& level) const {
    if (!query.starts_on_surface && !(query.origin_error > 0.0)) return false;
    const double f = field(query.ray.origin);
    if (!query.starts_on_surface) {
        const Vec3 n = slope(query.ray.origin);
        const double off = f - level;
        if (off * off > query.origin_error * query.origin_error * glm::dot(n, n)) return false;
    }
    level = f;
    return true;
}

template <class Take>
void Blob::each_crossing(const ShapeRay& query, Take&& take) const {
    const Ray& ray = query.ray;
    double level = data_.threshold;
    const bool at_origin = starts_here(query, level);
    // Near the blob numbers are small; on it the origin itself is the best place.
    const double dd = glm::dot(ray.direction, ray.direction);
    const double shift =
        at_origin || box_.is_empty() ? 0.0 : glm::dot(box_.center() - ray.origin, ray.direction) / dd;
    const Vec3 start = ray.at(shift);
    // Nothing before the origin matters, and what a query asks must not move a root.
    const double lo = -shift;
    constexpr double hi = std::numeric_limits<double>::infinity();

    thread_local Chords found;
    found.clear();
    each_along(ray, [&](const BlobComponent& c) {
        Chord chord{&c, c.object_from_local.inverse_point(start),
                    c.object_from_local.inverse_direction(ray.direction)};
        if (chord.find()) found.add(chord, lo, hi);
    });
    found.set_out();
    const std::vector<double>& cuts = found.cuts;
    for (size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double a = cuts[i];
        const double b = cuts[i + 1];
        if (!(a < b)) continue;
        if (shift + a > query.t_max) return;
        // Where the ray starts on the surface, that root is divided out.
        const bool first = at_origin && a == 0.0;
        const double base = first ? 0.0 : a + 0.5 * (b - a);
        const double scale = first ? b : 0.5 * (b - a);
        const double within = a + 0.5 * (b - a);
        const auto chords = found.around(within);
        double peak = 0.0;
        for (const uint32_t k : chords) peak += found.chords[k].peak();
        constexpr double rounding = 1e-9;
        if (!first && peak * (1.0 + rounding) < level) continue;
        std::array<double, 5> sum{0, 0, 0, 0, -level};
        for (const uint32_t k : chords) found.chords[k].add_to(sum, within, base, scale);
        std::array<double, 4> roots{};
        const int n = first ? solve_cubic({sum[0], sum[1], sum[2], sum[3]}, 0.0, 1.0,
                                          std::span<double, 3>(roots.data(), 3))
                            : solve_quartic(sum, -1.0, 1.0, roots);
        for (int k = 0; k < n; ++k) {
            const double u = roots[static_cast<size_t>(k)];
            if (take(shift + (base + scale * u))) return;
        }
    }
}

void Blob::crossings(const ShapeRay& query, Crossings& out) const {
    each_crossing(query, [&](double t) {
        if (t > query.t_max) return true;
        if (t > query.t_min) out.add({t, 0u, Vec2{0.0}});
        return false;
    });
}

bool Blob::closest(const ShapeRay& query, const CrossingFilter* filter, Crossing& nearest) const {
    bool found = false;
    each_crossing(query, [&](double t) {
        if (t > query.t_max) return true;
        if (!(t > query.t_min)) return false;
        const Crossing crossing{t, 0u, Vec2{0.0}};
        if (filter && !filter->counts(crossing)) return false;
        nearest = crossing;
        return found = true;
    });
    return found;
}

ShapePtr Blob::transformed(const Transform& map) const {
    BlobData moved = data_;
    for (BlobComponent& c : moved.components) c.object_from_local = then(c.object_from_local, map);
    return std::make_shared<Blob>(std::move(moved));
}

void Blob::textures_at(const Vec3& p, const Crossing&, std::vector<TextureWeight>& out) const {
    if (data_.textures.empty()) return;
    float sum = 0.0f;
    each_at(p, [&](const BlobComponent& c) {
        const auto weight = static_cast<float>(std::abs(c.field(p)));
        if (weight == 0.0f) return;
        sum += weight;
        const auto known =
            std::find_if(out.begin(), out.end(), [&](const auto& t) { return t.texture == c.texture; });
        if (known == out.end()) {
            out.push_back({c.texture, weight});
        } else {
            known->weight += weight;
        }
    });
    for (TextureWeight& t : out) t.weight /= sum;
}

std::optional<TriangleMesh> Blob::tessellate(double tolerance) const {
    if (!(data_.threshold > 0.0)) return std::nullopt;
    return solid_mesh(BlobSolid(*this, data_), box_, tolerance);
}

std::string Blob::describe() const {
    std::string text = fmt::format("threshold {}", data_.threshold);
    for (const BlobComponent& c : data_.components) {
        const Vec3& p = c.object_from_local.forward.row[3];
        text += fmt::format(", {} at <{},{},{}> strength {}", c.length > 0.0 ? "cylinder" : "sphere", p.x,
                            p.y, p.z, c.strength);
    }
    return text;
}

}  // namespace rb
