#include "kdtree/box_tree.h"

#include "kdtree/box_f.h"

#include <array>

namespace rb {

namespace {

constexpr float inf = std::numeric_limits<float>::infinity();

}  // namespace

/// Top down: a range is split in two by the surface area heuristic, and the larger parts again, until there
/// are four.
class BoxTreeBuilder {
public:
    BoxTreeBuilder(BoxTree& tree, std::span<const BoxTree::Item> items) : tree_(tree), items_(items) {
        if (items.empty()) return;
        Bounds hull;
        for (const auto& item : items) {
            hull.include(item.box);
            tree_.common_mask_ &= item.mask;
        }
        tree_.center_ = hull.center();
        parts_.reserve(items.size());
        BoxF all = empty_box_f;
        for (uint32_t i = 0; i < items.size(); ++i) {
            BoxF box = rounded_outward({items[i].box.lo - tree_.center_, items[i].box.hi - tree_.center_});
            for (int k = 0; k < 3; ++k) {
                // The difference was rounded too.
                box.lo[k] = std::nextafter(box.lo[k], -inf);
                box.hi[k] = std::nextafter(box.hi[k], inf);
            }
            parts_.push_back({box, i});
            include(all, box);
        }
        for (int k = 0; k < 3; ++k)
            tree_.reach_ = std::max({tree_.reach_, std::abs(all.lo[k]), std::abs(all.hi[k])});
        build({0, items.size(), all}, 0);
    }

private:
    struct Part {
        BoxF box;
        uint32_t item;
        float middle(int axis) const { return box.lo[axis] + box.hi[axis]; }
    };
    struct Range {
        size_t begin;
        size_t end;
        BoxF box;
        size_t size() const { return end - begin; }
    };

    uint32_t build(const Range& all, int depth) {
        std::array<Range, 4> ranges;
        size_t count = 0;
        ranges[count++] = all;
        while (count < 4) {
            size_t widest = 4;
            for (size_t i = 0; i < count; ++i) {
                if (ranges[i].size() < 2) continue;
                if (widest == 4 || half_area(ranges[i].box) > half_area(ranges[widest].box)) widest = i;
            }
            if (widest == 4) break;
            const Range whole = ranges[widest];
            const size_t middle = split(whole, depth);
            ranges[widest] = range(whole.begin, middle);
            ranges[count++] = range(middle, whole.end);
        }
        const auto at = static_cast<uint32_t>(tree_.nodes_.size());
        tree_.nodes_.emplace_back();
        for (size_t i = 0; i < 4; ++i)
            set_child(at, i, i < count ? ranges[i] : Range{0, 0, empty_box_f}, depth);
        return at;
    }

    void set_child(uint32_t at, size_t i, const Range& range, int depth) {
        RayMask mask = 0;
        uint32_t child = 0;
        if (range.size() == 1) {
            child = BoxTree::element_bit | static_cast<uint32_t>(tree_.order_.size());
            tree_.order_.push_back(parts_[range.begin].item);
        } else if (range.size() > 1) {
            child = build(range, depth + 1);
        }
        for (size_t k = range.begin; k < range.end; ++k) mask |= items_[parts_[k].item].mask;
        BoxTree::Node& node = tree_.nodes_[at];
        node.child[i] = child;
        node.mask[i] = mask;
        for (int axis = 0; axis < 3; ++axis) {
            node.planes[axis][0][i] = range.box.lo[axis];
            node.planes[axis][1][i] = range.box.hi[axis];
        }
    }

    Range range(size_t begin, size_t end) const {
        Range r{begin, end, empty_box_f};
        for (size_t i = begin; i < end; ++i) include(r.box, parts_[i].box);
        return r;
    }

    static constexpr int bins = 16;

    /// Reorders the range and returns where its second half begins.
    size_t split(const Range& r, int depth) {
        BoxF middles = empty_box_f;
        for (size_t i = r.begin; i < r.end; ++i) {
            for (int k = 0; k < 3; ++k) {
                middles.lo[k] = std::min(middles.lo[k], parts_[i].middle(k));
                middles.hi[k] = std::max(middles.hi[k], parts_[i].middle(k));
            }
        }
        double best = inf;
        int best_axis = -1;
        int best_bin = 0;
        for (int axis = 0; axis < 3; ++axis) {
            int bin = 0;
            const double cost = best_plane(r, axis, middles, bin);
            if (cost < best) best = cost, best_axis = axis, best_bin = bin;
        }
        // Halves keep the walk's stack short where the heuristic only peels.
        constexpr int deep = 20;
        const auto first = parts_.begin() + static_cast<std::ptrdiff_t>(r.begin);
        const auto last = parts_.begin() + static_cast<std::ptrdiff_t>(r.end);
        if (best_axis < 0 || depth > deep) return r.begin + r.size() / 2;
        const auto middle = std::partition(first, last, [&](const Part& p) {
            return bin_of(p.middle(best_axis), middles.lo[best_axis], middles.hi[best_axis]) <= best_bin;
        });
        return static_cast<size_t>(middle - parts_.begin());
    }

    static int bin_of(float middle, float lo, float hi) {
        return std::min(static_cast<int>((middle - lo) / (hi - lo) * static_cast<float>(bins)), bins - 1);
    }

    /// The bin after which to cut, and the cost of that; infinite if all middles lie together.
    double best_plane(const Range& r, int axis, const BoxF& middles, int& best_bin) const {
        const float lo = middles.lo[axis];
        const float hi = middles.hi[axis];
        double best = inf;
        if (!(hi > lo) || !(hi - lo < inf)) return best;
        std::array<BoxF, bins> boxes;
        std::array<size_t, bins> counts{};
        boxes.fill(empty_box_f);
        for (size_t i = r.begin; i < r.end; ++i) {
            const auto bin = static_cast<size_t>(bin_of(parts_[i].middle(axis), lo, hi));
            include(boxes[bin], parts_[i].box);
            ++counts[bin];
        }
        std::array<double, bins> below{};
        BoxF box = empty_box_f;
        size_t n = 0;
        for (size_t i = 0; i + 1 < bins; ++i) {
            include(box, boxes[i]);
            n += counts[i];
            below[i] = n > 0 ? half_area(box) * static_cast<double>(n) : inf;
        }
        box = empty_box_f;
        n = 0;
        for (size_t i = bins - 1; i > 0; --i) {
            include(box, boxes[i]);
            n += counts[i];
            if (n == 0 || n == r.size()) continue;
            const double cost = below[i - 1] + half_area(box) * static_cast<double>(n);
            if (cost < best) best = cost, best_bin = static_cast<int>(i) - 1;
        }
        return best;
    }

    BoxTree& tree_;
    std::span<const BoxTree::Item> items_;
    std::vector<Part> parts_;
};

BoxTree::BoxTree(std::span<const Item> items) { BoxTreeBuilder(*this, items); }

}  // namespace rb
