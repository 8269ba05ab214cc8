#include "base/parallel.h"
#include "kdtree/pack.h"

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

Bounds widened(const BoxF& b) { return {{b.lo[0], b.lo[1], b.lo[2]}, {b.hi[0], b.hi[1], b.hi[2]}}; }

constexpr int most_bad_refines = 3;
constexpr double empty_bonus = 0.8;
/// References from which on both children are worth a thread.
constexpr size_t many = 1 << 14;

/// What is left of the bounds on the way down.
struct Allowance {
    int depth;
    int bad_refines;
    double references;  ///< that the subtree may make: a bound on duplicates that acts everywhere alike
};

bool is_sound(const BoxF& box) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(box.lo[axis] <= box.hi[axis]) || !(box.lo[axis] > -inf && box.hi[axis] < inf)) return false;
    }
    return true;
}

}  // namespace

/// Depth first. The references of the node at work lie at the end of one array; a split reorders them to
/// [left only | both | both again | right only], so a level costs only its duplicates. Large high children
/// have a builder of their own, whose nodes are put behind the others: the same tree with any number of
/// threads.
class KdBuilder {
public:
    KdBuilder(const KdOptions& options, const KdTree::Clip& clip, std::vector<Reference> references)
        : options_(options), clip_(clip), references_(std::move(references)) {
        for (size_t n = 0; n < block_costs_.size(); ++n) {
            const auto w = static_cast<size_t>(options.block);
            const auto blocks = (n + w - 1) / w;
            block_costs_[n] = options.element_cost * static_cast<double>(blocks);
        }
    }

    /// Of all references; the first node is the root.
    void build(const BoxF& hull, const Allowance& allowance) {
        nodes_.emplace_back();
        build(0, 0, hull, allowance);
        references_ = {};
    }
    const std::vector<BinaryNode>& nodes() const { return nodes_; }
    const std::vector<uint32_t>& in_leaves() const { return in_leaves_; }

private:
    double block_cost(size_t n) const {
        if (n < block_costs_.size()) return block_costs_[n];
        return options_.element_cost / options_.block * static_cast<double>(n);
    }

    void make_leaf(uint32_t node, size_t begin) {
        const size_t count = references_.size() - begin;
        const auto first = static_cast<uint32_t>(in_leaves_.size());
        for (size_t i = begin; i < references_.size(); ++i) in_leaves_.push_back(references_[i].element);
        references_.resize(begin);
        nodes_[node].first = first;
        nodes_[node].count = static_cast<uint32_t>(count);
    }

    void build(uint32_t node, size_t begin, const BoxF& hull, Allowance allowance) {
        const size_t n = references_.size() - begin;
        nodes_[node].hull = hull;
        if (n == 0 || allowance.depth == 0 || static_cast<double>(n) >= allowance.references) {
            return make_leaf(node, begin);
        }
        const double leaf_cost = block_cost(n);
        const Split split = best_split(begin, hull);
        if (split.cost >= leaf_cost) ++allowance.bad_refines;
        if (split.axis < 0 || allowance.bad_refines > most_bad_refines ||
            (split.cost > 4.0 * leaf_cost && n < 16) ||
            (n <= static_cast<size_t>(options_.block) && split.cost >= leaf_cost)) {
            return make_leaf(node, begin);
        }
        BoxF low_cell = hull;
        BoxF high_cell = hull;
        low_cell.hi[split.axis] = split.plane;
        high_cell.lo[split.axis] = split.plane;
        BoxF low_hull = empty_box_f;
        BoxF high_hull = empty_box_f;
        const size_t middle = partition(begin, split, low_cell, high_cell, low_hull, high_hull);

        const auto low = static_cast<uint32_t>(nodes_.size());
        nodes_.resize(nodes_.size() + 2);
        nodes_[node].first = low;
        nodes_[node].count = BinaryNode::inner;
        const auto n_high = static_cast<double>(references_.size() - middle);
        const auto n_low = static_cast<double>(middle - begin);
        --allowance.depth;
        const double share = allowance.references / std::max(n_low + n_high, 1.0);
        Allowance high_allowance = allowance;
        high_allowance.references = share * n_high;
        allowance.references = share * n_low;
        if (n < many) {
            build(low + 1, middle, high_hull, high_allowance);
            build(low, begin, low_hull, allowance);
            return;
        }
        const auto first_high = references_.begin() + static_cast<std::ptrdiff_t>(middle);
        KdBuilder high(options_, clip_, {first_high, references_.end()});
        references_.resize(middle);
        parallel_invoke([&] { high.build(high_hull, high_allowance); },
                        [&] { build(low, begin, low_hull, allowance); });
        graft(low + 1, high);
    }

    /// Makes another builder's root a node of this tree.
    void graft(uint32_t node, const KdBuilder& other) {
        const auto behind = static_cast<uint32_t>(nodes_.size()) - 1;
        const auto first_leaf = static_cast<uint32_t>(in_leaves_.size());
        const auto moved = [&](BinaryNode n) {
            n.first += n.count == BinaryNode::inner ? behind : first_leaf;
            return n;
        };
        nodes_[node] = moved(other.nodes_.front());
        for (size_t i = 1; i < other.nodes_.size(); ++i) nodes_.push_back(moved(other.nodes_[i]));
        in_leaves_.insert(in_leaves_.end(), other.in_leaves_.begin(), other.in_leaves_.end());
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

    /// The parts of a reference at a plane.
    struct Parts {
        Reference low;
        Reference high;
        bool in_low;
        bool in_high;
    };
    /// References that the children would have.
    struct Share {
        size_t low;
        size_t high;
    };

    static double area(const BoxF& box) { return box.lo[0] <= box.hi[0] ? half_area(box) : 0.0; }
    static double area_with(BoxF box, const BoxF& other) {
        include(box, other);
        return half_area(box);
    }

    /// Into `parts_`: cuts the references in [begin, end) at a plane. A child's box may as well become larger
    /// and hold one whole (Stich, Friedrich and Dietrich 2009); `low` and `high` hold what lies on one side.
    void share_out(size_t begin, size_t end, const BoxF& low_cell, const BoxF& high_cell, const BoxF& low,
                   const BoxF& high, const Share& n) {
        cuts_.clear();
        BoxF all_low = low;
        BoxF all_high = high;
        for (size_t i = begin; i < end; ++i) {
            Parts& parts = cuts_.emplace_back(Parts{references_[i], references_[i], false, false});
            parts.in_low = cut(parts.low, low_cell);
            parts.in_high = cut(parts.high, high_cell);
            if (parts.in_low) include(all_low, parts.low.box);
            if (parts.in_high) include(all_high, parts.high.box);
        }
        parts_ = cuts_;
        const double cost = share_out(begin, all_low, all_high, low, high, n);
        // Without the parts themselves in the boxes fewer are cut; where most are, that is a bad guess.
        std::swap(parts_, cuts_);
        if (share_out(begin, low, high, low, high, n) > cost) std::swap(parts_, cuts_);
    }

    /// By boxes that grow from `low` and `high`; returns the cost by those that grow from the pure ones.
    double share_out(size_t begin, BoxF low, BoxF high, BoxF pure_low, BoxF pure_high, Share n) {
        for (size_t i = 0; i < parts_.size(); ++i) {
            Parts& parts = parts_[i];
            if (parts.in_low && parts.in_high) {
                const BoxF& whole = references_[begin + i].box;
                const auto n_low = static_cast<double>(n.low);
                const auto n_high = static_cast<double>(n.high);
                const double in_both =
                    area_with(low, parts.low.box) * n_low + area_with(high, parts.high.box) * n_high;
                const double all_low = area_with(low, whole) * n_low + area(high) * (n_high - 1.0);
                const double all_high = area(low) * (n_low - 1.0) + area_with(high, whole) * n_high;
                if (n.high > 1 && all_low <= in_both && all_low <= all_high) {
                    parts.low = references_[begin + i];
                    parts.in_high = false;
                    --n.high;
                } else if (n.low > 1 && all_high <= in_both) {
                    parts.high = references_[begin + i];
                    parts.in_low = false;
                    --n.low;
                }
            }
            if (parts.in_low) include(low, parts.low.box), include(pure_low, parts.low.box);
            if (parts.in_high) include(high, parts.high.box), include(pure_high, parts.high.box);
        }
        return area(pure_low) * static_cast<double>(n.low) + area(pure_high) * static_cast<double>(n.high);
    }

    size_t partition(size_t begin, const Split& split, const BoxF& low_cell, const BoxF& high_cell,
                     BoxF& low_hull, BoxF& high_hull) {
        const int a = split.axis;
        const float p = split.plane;
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
        // Now [low | both | high]. What goes low stays, what goes high goes to the end; holes are filled from
        // there.
        const Share n{high_begin - begin, references_.size() - low_end};
        share_out(low_end, high_begin, low_cell, high_cell, low_hull, high_hull, n);
        size_t middle = low_end;
        for (size_t i = low_end; i < high_begin; ++i) {
            const Parts& parts = parts_[i - low_end];
            if (parts.in_high) {
                include(high_hull, parts.high.box);
                references_.push_back(parts.high);
            }
            if (parts.in_low) {
                include(low_hull, parts.low.box);
                references_[middle++] = parts.low;
            }
        }
        for (size_t hole = middle; hole < high_begin; ++hole) {
            if (references_.size() > high_begin) {
                references_[hole] = references_.back();
                references_.pop_back();
            } else {
                references_.resize(hole);
                break;
            }
        }
        return middle;
    }

    /// The planes of one axis: the children's areas are linear in the plane.
    struct Axis {
        int axis;
        float lo, hi;
        double base, rate;  ///< area of a slab of thickness x over the cell's: base + rate x
    };
    static Axis axis_of(const BoxF& cell, int axis) {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        const double a = static_cast<double>(cell.hi[u]) - static_cast<double>(cell.lo[u]);
        const double b = static_cast<double>(cell.hi[v]) - static_cast<double>(cell.lo[v]);
        const double inverse = 1.0 / half_area(cell);
        return {axis, cell.lo[axis], cell.hi[axis], a * b * inverse, (a + b) * inverse};
    }

    void consider(Split& best, const Axis& axis, float plane, size_t n_low, size_t n_high) const {
        if (!(plane > axis.lo && plane < axis.hi)) return;
        const double low = axis.base + axis.rate * static_cast<double>(plane - axis.lo);
        const double high = axis.base + axis.rate * static_cast<double>(axis.hi - plane);
        double cost = options_.traversal_cost + low * block_cost(n_low) + high * block_cost(n_high);
        if (n_low == 0 || n_high == 0) cost *= empty_bonus;
        if (cost < best.cost) best = {cost, axis.axis, plane};
    }

    template <int bins>
    Split best_binned(size_t begin, const BoxF& hull) const {
        uint32_t starts[3][bins] = {};
        uint32_t ends[3][bins] = {};
        float scale[3];
        for (int a = 0; a < 3; ++a) {
            const float width = hull.hi[a] - hull.lo[a];
            // Just below the bin count, so that the far end falls into the last bin.
            scale[a] = width > 0.0f ? (static_cast<float>(bins) * 0.99999f) / width : 0.0f;
            if (!(scale[a] < inf)) scale[a] = 0.0f;
        }
        for (size_t i = begin; i < references_.size(); ++i) {
            const BoxF& b = references_[i].box;
            for (int a = 0; a < 3; ++a) {
                ++starts[a][static_cast<int>((b.lo[a] - hull.lo[a]) * scale[a])];
                ++ends[a][static_cast<int>((b.hi[a] - hull.lo[a]) * scale[a])];
            }
        }
        const size_t n = references_.size() - begin;
        Split best;
        for (int a = 0; a < 3; ++a) {
            const Axis axis = axis_of(hull, a);
            if (scale[a] == 0.0f) continue;
            const float width = 1.0f / scale[a];
            size_t n_low = 0;
            size_t n_high = n;
            for (int k = 1; k < bins; ++k) {
                n_low += starts[a][k - 1];
                n_high -= ends[a][k - 1];
                consider(best, axis, hull.lo[a] + static_cast<float>(k) * width, n_low, n_high);
            }
        }
        return best;
    }

    Split best_split(size_t begin, const BoxF& hull) const {
        const size_t n = references_.size() - begin;
        if (n > 512) return best_binned<32>(begin, hull);
        return n > 32 ? best_binned<16>(begin, hull) : best_binned<8>(begin, hull);
    }

    const KdOptions& options_;
    const KdTree::Clip& clip_;
    std::array<double, 128> block_costs_{};  ///< by element count; rounding to blocks matters for few
    std::vector<BinaryNode> nodes_;
    std::vector<uint32_t> in_leaves_;
    std::vector<Reference> references_;
    std::vector<Parts> parts_;
    std::vector<Parts> cuts_;
};

KdTree::KdTree(uint32_t count, const BoxOf& box_of, const KdOptions& options, const Clip& clip)
    : block_(static_cast<uint32_t>(options.block)) {
    BoxF hull = empty_box_f;
    std::vector<Reference> references;
    references.reserve(count + count / 8);
    for (uint32_t i = 0; i < count; ++i) {
        const BoxF box = box_of(i);
        if (!is_sound(box)) continue;
        references.push_back({box, i});
        include(hull, box);
    }
    if (references.empty()) return;
    bounds_ = widened(hull);
    for (int axis = 0; axis < 3; ++axis)
        reach_ = std::max({reach_, std::abs(hull.lo[axis]), std::abs(hull.hi[axis])});
    const auto n = static_cast<double>(references.size());
    const int depth = options.depth >= 0 ? options.depth : static_cast<int>(8.0 + 1.3 * std::log2(n));
    KdBuilder builder(options, clip, std::move(references));
    builder.build(hull, {std::min(depth, most_depth), 0, options.most_references * n + 4096.0});
    KdPacker(*this, builder.nodes(), builder.in_leaves());
}

KdTree::KdTree(const std::vector<BoxF>& boxes, const KdOptions& options, const Clip& clip)
    : KdTree(
          static_cast<uint32_t>(boxes.size()), [&](uint32_t i) { return boxes[i]; }, options, clip) {}

}  // namespace rb
