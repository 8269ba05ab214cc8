#include "kdtree/kdtree.h"

#include <algorithm>
#include <array>

namespace rb {

namespace {

struct Reference {
    BoxF box;
    uint32_t element;
};

struct Split {
    double cost = std::numeric_limits<double>::infinity();
    int axis = -1;
    float plane = 0;
};

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr BoxF empty_box{{inf, inf, inf}, {-inf, -inf, -inf}};

void include(BoxF& box, const BoxF& other) {
    for (int i = 0; i < 3; ++i) {
        box.lo[i] = std::min(box.lo[i], other.lo[i]);
        box.hi[i] = std::max(box.hi[i], other.hi[i]);
    }
}

double half_area(const BoxF& b) {
    const double x = static_cast<double>(b.hi[0]) - static_cast<double>(b.lo[0]);
    const double y = static_cast<double>(b.hi[1]) - static_cast<double>(b.lo[1]);
    const double z = static_cast<double>(b.hi[2]) - static_cast<double>(b.lo[2]);
    return x * y + y * z + z * x;
}

Bounds widened(const BoxF& b) { return {{b.lo[0], b.lo[1], b.lo[2]}, {b.hi[0], b.hi[1], b.hi[2]}}; }

constexpr int most_bad_refines = 3;
constexpr double empty_bonus = 0.8;

}  // namespace

/// Depth first. The references of the node at work lie at the end of one array; a split reorders them to
/// [left only | both | both again | right only], so a level costs only its duplicates.
class KdBuilder {
public:
    KdBuilder(KdTree& tree, const std::vector<BoxF>& boxes, const KdOptions& options,
              const KdTree::Clip& clip)
        : tree_(tree), options_(options), clip_(clip) {
        BoxF hull = empty_box;
        references_.reserve(boxes.size() + boxes.size() / 4);
        for (uint32_t i = 0; i < boxes.size(); ++i) {
            if (boxes[i].lo[0] > boxes[i].hi[0]) continue;
            references_.push_back({boxes[i], i});
            include(hull, boxes[i]);
        }
        if (references_.empty()) return;
        const auto n = static_cast<double>(references_.size());
        most_references_ = static_cast<size_t>(options.most_references * n) + 4096;
        const int depth = options.depth >= 0 ? options.depth : static_cast<int>(8.0 + 1.3 * std::log2(n));
        tree_.bounds_ = widened(hull);
        tree_.nodes_.emplace_back();
        build(0, 0, hull, hull, std::min(depth, 60), 0);
        tree_.nodes_.shrink_to_fit();
        tree_.references_.shrink_to_fit();
    }

private:
    double block_cost(size_t n) const {
        const auto w = static_cast<size_t>(options_.block);
        return options_.element_cost * static_cast<double>((n + w - 1) / w);
    }

    void make_leaf(uint32_t node, size_t begin) {
        const size_t count = references_.size() - begin;
        const auto first = static_cast<uint32_t>(tree_.references_.size());
        for (size_t i = begin; i < references_.size(); ++i)
            tree_.references_.push_back(references_[i].element);
        references_.resize(begin);
        tree_.nodes_[node] = {first, static_cast<uint32_t>(count) << 2 | 3u};
    }

    void build(uint32_t node, size_t begin, const BoxF& cell, const BoxF& hull, int depth, int bad_refines) {
        const size_t n = references_.size() - begin;
        const bool may_grow = tree_.references_.size() + references_.size() < most_references_;
        if (n == 0 || depth == 0 || !may_grow) return make_leaf(node, begin);
        const double leaf_cost = block_cost(n);
        const Split split = static_cast<int>(n) < options_.sweep_below ? best_swept(begin, cell, hull)
                                                                       : best_binned(begin, cell, hull);
        if (split.cost >= leaf_cost) ++bad_refines;
        if (split.axis < 0 || bad_refines > most_bad_refines || (split.cost > 4.0 * leaf_cost && n < 16) ||
            (n <= static_cast<size_t>(options_.block) && split.cost >= leaf_cost)) {
            return make_leaf(node, begin);
        }
        BoxF low_cell = cell;
        BoxF high_cell = cell;
        low_cell.hi[split.axis] = split.plane;
        high_cell.lo[split.axis] = split.plane;
        BoxF low_hull = empty_box;
        BoxF high_hull = empty_box;
        const size_t middle = partition(begin, split, low_cell, high_cell, low_hull, high_hull);

        const auto low = static_cast<uint32_t>(tree_.nodes_.size());
        tree_.nodes_.resize(tree_.nodes_.size() + 2);
        tree_.nodes_[node] = {std::bit_cast<uint32_t>(split.plane),
                              low << 2 | static_cast<uint32_t>(split.axis)};
        build(low + 1, middle, high_cell, high_hull, depth - 1, bad_refines);
        build(low, begin, low_cell, low_hull, depth - 1, bad_refines);
    }

    /// Cuts a straddling reference down to a child's cell; false if nothing of it is left there.
    bool cut(Reference& r, const BoxF& cell) const {
        if (clip_) {
            const Bounds part = clip_(r.element, widened(cell));
            if (part.is_empty()) return false;
            const BoxF box = rounded_outward(part);
            for (int i = 0; i < 3; ++i) {
                r.box.lo[i] = std::max(r.box.lo[i], box.lo[i]);
                r.box.hi[i] = std::min(r.box.hi[i], box.hi[i]);
            }
        }
        for (int i = 0; i < 3; ++i) {
            r.box.lo[i] = std::max(r.box.lo[i], cell.lo[i]);
            r.box.hi[i] = std::min(r.box.hi[i], cell.hi[i]);
            // Rounding may cross the sides of a box that has become flat: it is still there.
            if (r.box.lo[i] > r.box.hi[i]) std::swap(r.box.lo[i], r.box.hi[i]);
        }
        return true;
    }

    size_t partition(size_t begin, const Split& split, const BoxF& low_cell, const BoxF& high_cell,
                     BoxF& low_hull, BoxF& high_hull) {
        const int a = split.axis;
        const float p = split.plane;
        straddling_.clear();
        size_t low_end = begin;
        size_t high_begin = references_.size();
        for (size_t i = begin; i < high_begin;) {
            const Reference& r = references_[i];
            if (r.box.hi[a] <= p) {
                include(low_hull, r.box);
                std::swap(references_[low_end++], references_[i++]);
            } else if (r.box.lo[a] >= p) {
                include(high_hull, r.box);
                std::swap(references_[--high_begin], references_[i]);
            } else {
                ++i;
            }
        }
        // Now [low | both | high]; both may lose references on either side when they are cut exactly.
        for (size_t i = low_end; i < high_begin; ++i) straddling_.push_back(references_[i]);
        const size_t high_count = references_.size() - high_begin;
        right_.assign(references_.begin() + static_cast<std::ptrdiff_t>(high_begin), references_.end());
        references_.resize(low_end);
        for (Reference r : straddling_) {
            if (!cut(r, low_cell)) continue;
            include(low_hull, r.box);
            references_.push_back(r);
        }
        const size_t middle = references_.size();
        for (Reference r : straddling_) {
            if (!cut(r, high_cell)) continue;
            include(high_hull, r.box);
            references_.push_back(r);
        }
        references_.insert(references_.end(), right_.begin(),
                           right_.begin() + static_cast<std::ptrdiff_t>(high_count));
        return middle;
    }

    void consider(Split& best, const BoxF& cell, double inverse_area, int axis, float plane, size_t n_low,
                  size_t n_high) const {
        if (!(plane > cell.lo[axis] && plane < cell.hi[axis])) return;
        BoxF low = cell;
        BoxF high = cell;
        low.hi[axis] = plane;
        high.lo[axis] = plane;
        double cost = options_.traversal_cost + inverse_area * (half_area(low) * block_cost(n_low) +
                                                                half_area(high) * block_cost(n_high));
        if (n_low == 0 || n_high == 0) cost *= empty_bonus;
        if (cost < best.cost) best = {cost, axis, plane};
    }

    Split best_binned(size_t begin, const BoxF& cell, const BoxF& hull) const {
        constexpr int bins = 32;
        std::array<std::array<uint32_t, bins>, 3> starts{};
        std::array<std::array<uint32_t, bins>, 3> ends{};
        std::array<float, 3> scale{};
        for (size_t a = 0; a < 3; ++a) {
            const float width = hull.hi[a] - hull.lo[a];
            scale[a] = width > 0.0f ? static_cast<float>(bins) / width : 0.0f;
            if (!(scale[a] < inf)) scale[a] = 0.0f;
        }
        for (size_t i = begin; i < references_.size(); ++i) {
            const BoxF& b = references_[i].box;
            for (size_t a = 0; a < 3; ++a) {
                const int s = static_cast<int>((b.lo[a] - hull.lo[a]) * scale[a]);
                const int e = static_cast<int>((b.hi[a] - hull.lo[a]) * scale[a]);
                ++starts[a][static_cast<size_t>(std::clamp(s, 0, bins - 1))];
                ++ends[a][static_cast<size_t>(std::clamp(e, 0, bins - 1))];
            }
        }
        const size_t n = references_.size() - begin;
        const double inverse_area = 1.0 / half_area(cell);
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<size_t>(axis);
            consider(best, cell, inverse_area, axis, hull.lo[a], 0, n);
            consider(best, cell, inverse_area, axis, hull.hi[a], n, 0);
            if (scale[a] == 0.0f) continue;
            size_t n_low = 0;
            size_t n_high = n;
            for (size_t k = 1; k < bins; ++k) {
                n_low += starts[a][k - 1];
                n_high -= ends[a][k - 1];
                const float plane = hull.lo[a] + static_cast<float>(k) / scale[a];
                consider(best, cell, inverse_area, axis, plane, n_low, n_high);
            }
        }
        return best;
    }

    /// Every side of every box is a candidate: exact, for small nodes.
    Split best_swept(size_t begin, const BoxF& cell, const BoxF&) {
        const size_t n = references_.size() - begin;
        const double inverse_area = 1.0 / half_area(cell);
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            lows_.clear();
            highs_.clear();
            flats_.clear();
            for (size_t i = begin; i < references_.size(); ++i) {
                const BoxF& b = references_[i].box;
                if (b.lo[axis] == b.hi[axis]) {
                    flats_.push_back(b.lo[axis]);
                } else {
                    lows_.push_back(b.lo[axis]);
                    highs_.push_back(b.hi[axis]);
                }
            }
            std::sort(lows_.begin(), lows_.end());
            std::sort(highs_.begin(), highs_.end());
            std::sort(flats_.begin(), flats_.end());
            size_t lo = 0;
            size_t hi = 0;
            size_t flat = 0;
            while (lo < lows_.size() || hi < highs_.size() || flat < flats_.size()) {
                float plane = inf;
                if (lo < lows_.size()) plane = lows_[lo];
                if (hi < highs_.size()) plane = std::min(plane, highs_[hi]);
                if (flat < flats_.size()) plane = std::min(plane, flats_[flat]);
                // Low side: starts below the plane, and what lies in it.
                const size_t started = lo;
                while (lo < lows_.size() && lows_[lo] == plane) ++lo;
                while (hi < highs_.size() && highs_[hi] == plane) ++hi;
                while (flat < flats_.size() && flats_[flat] == plane) ++flat;
                consider(best, cell, inverse_area, axis, plane, started + flat, n - hi - flat);
            }
        }
        return best;
    }

    KdTree& tree_;
    const KdOptions& options_;
    const KdTree::Clip& clip_;
    std::vector<Reference> references_;
    std::vector<Reference> straddling_;
    std::vector<Reference> right_;
    std::vector<float> lows_;
    std::vector<float> highs_;
    std::vector<float> flats_;
    size_t most_references_ = 0;
};

KdTree::KdTree(const std::vector<BoxF>& boxes, const KdOptions& options, const Clip& clip) {
    KdBuilder(*this, boxes, options, clip);
}

}  // namespace rb
