#include "kdtree/box_list.h"

#include <cmath>

namespace rb {

namespace {

/// A bundle against boxes in single precision. A box is met while, on each axis, the bundle's lower line is
/// below the box's high plane and its upper line above the low plane: six linear conditions on s.
class BoxBundle {
public:
    BoxBundle(const RayBundle& bundle, const Vec3& center, float reach)
        : axes_{bounds(bundle, center, reach, 0), bounds(bundle, center, reach, 1),
                bounds(bundle, center, reach, 2)},
          far_(static_cast<float>(std::min(bundle.far, most)) * (1.0f + margin)) {}

    unsigned meets(const float planes[3][2][4], float near_of[4]) const {
        __m128 enter = _mm_setzero_ps();
        __m128 leave = _mm_set1_ps(far_);
        for (size_t axis = 0; axis < 3; ++axis) {
            const Axis& a = axes_[axis];
            const __m128 low = a.lower.reaches(_mm_load_ps(planes[axis][1]));
            const __m128 high = a.upper.reaches(_mm_load_ps(planes[axis][0]));
            // NaN (0 times infinity) leaves the second operand.
            if (a.lower.rises) {
                leave = _mm_min_ps(low, leave);
            } else {
                enter = _mm_max_ps(low, enter);
            }
            if (a.upper.rises) {
                enter = _mm_max_ps(high, enter);
            } else {
                leave = _mm_min_ps(high, leave);
            }
        }
        _mm_store_ps(near_of, enter);
        return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(enter, leave)));
    }

private:
    static constexpr double most = std::numeric_limits<float>::max() / 2;
    static constexpr float margin = 0x1p-19f;

    struct Line {
        Line(double at_0, double slope)
            : from(_mm_set1_ps(static_cast<float>(at_0))),
              inverse(_mm_set1_ps(1.0f / static_cast<float>(slope))),
              rises(!std::signbit(static_cast<float>(slope))) {}
        /// The parameter at which the line comes to each of four planes.
        __m128 reaches(__m128 plane) const { return _mm_mul_ps(_mm_sub_ps(plane, from), inverse); }
        __m128 from;
        __m128 inverse;
        bool rises;
    };
    struct Axis {
        Line lower;
        Line upper;
    };
    static Axis bounds(const RayBundle& bundle, const Vec3& center, float reach, int axis) {
        const double lo = bundle.origins.lo[axis] - center[axis];
        const double hi = bundle.origins.hi[axis] - center[axis];
        // Far more than what single precision rounds away above.
        const double error = margin * (std::max(std::abs(lo), std::abs(hi)) + static_cast<double>(reach));
        const double down = bundle.lower[axis];
        const double up = bundle.upper[axis];
        const double slope_error = margin * std::max(std::abs(down), std::abs(up));
        return {Line(lo - error, down - slope_error), Line(hi + error, up + slope_error)};
    }

    std::array<Axis, 3> axes_;
    float far_;
};

}  // namespace

void BoxList::add(const Node& node, size_t lane, float near) {
    // Insertion keeps the nearest first.
    size_t place = count_++;
    const auto copy = [](const Node& from, size_t i, Node& to, size_t j) {
        for (int axis = 0; axis < 3; ++axis) {
            to.planes[axis][0][j] = from.planes[axis][0][i];
            to.planes[axis][1][j] = from.planes[axis][1][i];
        }
        to.child[j] = from.child[i];
        to.mask[j] = from.mask[i];
    };
    for (; place > 0 && near_[place - 1] > near; --place) {
        near_[place] = near_[place - 1];
        copy(nodes_[(place - 1) / 4], (place - 1) % 4, nodes_[place / 4], place % 4);
    }
    near_[place] = near;
    copy(node, lane, nodes_[place / 4], place % 4);
}

bool BoxList::gather(const BoxTree& tree, const RayBundle& bundle, RayMask mask, uint32_t without) {
    count_ = 0;
    if (tree.is_empty()) return true;
    center_ = tree.center_;
    reach_ = tree.reach_;
    const BoxBundle slabs(bundle, center_, reach_);
    constexpr size_t most_visits = 48;
    std::array<uint32_t, 4 * most_visits> waiting;
    size_t waiting_count = 0;
    waiting[waiting_count++] = 0;
    for (size_t visits = 0; waiting_count > 0; ++visits) {
        if (visits == most_visits) return false;
        const Node& node = tree.nodes_[waiting[--waiting_count]];
        alignas(16) float near_of[4];
        for (unsigned met = slabs.meets(node.planes, near_of); met != 0; met &= met - 1) {
            const auto i = static_cast<size_t>(std::countr_zero(met));
            if ((node.mask[i] & mask) == 0) continue;
            if ((node.child[i] & BoxTree::element_bit) == 0) {
                waiting[waiting_count++] = node.child[i];
            } else if (node.child[i] == (without | BoxTree::element_bit)) {
                continue;
            } else if (count_ < most) {
                add(node, i, near_of[i]);
            } else {
                return false;
            }
        }
    }
    close();
    return true;
}

void BoxList::gather(const BoxList& wider, const RayBundle& bundle, uint32_t without) {
    count_ = 0;
    if (wider.is_empty()) return;
    center_ = wider.center_;
    reach_ = wider.reach_;
    const BoxBundle slabs(bundle, center_, reach_);
    for (size_t k = 0; 4 * k < wider.count_; ++k) {
        alignas(16) float near_of[4];
        for (unsigned met = slabs.meets(wider.nodes_[k].planes, near_of); met != 0; met &= met - 1) {
            const auto i = static_cast<size_t>(std::countr_zero(met));
            if (wider.nodes_[k].child[i] == (without | BoxTree::element_bit)) continue;
            add(wider.nodes_[k], i, near_of[i]);
        }
    }
    close();
}

/// Lanes without an element are never met.
void BoxList::close() {
    for (size_t lane = count_; lane % 4 != 0; ++lane) {
        for (auto& axis : nodes_[lane / 4].planes) {
            axis[0][lane % 4] = std::numeric_limits<float>::infinity();
            axis[1][lane % 4] = -std::numeric_limits<float>::infinity();
        }
        nodes_[lane / 4].mask[lane % 4] = 0;
    }
}

}  // namespace rb
