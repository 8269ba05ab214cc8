#pragma once
#include "kdtree/kdtree.h"
#include "math/wide.h"

#include <bit>

namespace rb {

/// BoxRay for eight boxes.
class WideBoxRay {
public:
    RB_WIDE explicit WideBoxRay(const BoxRay& ray) {
        for (size_t axis = 0; axis < 3; ++axis) {
            enter_from_[axis] = _mm256_set1_ps(_mm_cvtss_f32(ray.enter_from_[axis]));
            leave_from_[axis] = _mm256_set1_ps(_mm_cvtss_f32(ray.leave_from_[axis]));
            inverse_[axis] = _mm256_set1_ps(_mm_cvtss_f32(ray.inverse_[axis]));
            first_[axis] = 16 * axis + 2 * size_t{ray.high_first_[axis]};
            last_[axis] = 16 * axis + 2 * size_t{ray.low_first_[axis]};
        }
    }

    RB_WIDE inline __attribute__((always_inline)) unsigned meets(const KdNode& node, float near, float far,
                                                                 float near_of[8]) const {
        const float* planes = node.planes[0][0];
        __m256 enter = _mm256_set1_ps(near);
        __m256 leave = _mm256_set1_ps(std::numeric_limits<float>::max());
        for (size_t axis = 0; axis < 3; ++axis) {
            const __m256 first = _mm256_load_ps(planes + first_[axis]);
            const __m256 last = _mm256_load_ps(planes + last_[axis]);
            // NaN (0 times infinity) leaves the second operand.
            enter =
                _mm256_max_ps(_mm256_mul_ps(_mm256_sub_ps(first, enter_from_[axis]), inverse_[axis]), enter);
            leave =
                _mm256_min_ps(_mm256_mul_ps(_mm256_sub_ps(last, leave_from_[axis]), inverse_[axis]), leave);
        }
        leave = _mm256_mul_ps(leave, _mm256_set1_ps(1.0f + static_cast<float>(BoxRay::margin)));
        _mm256_store_ps(near_of, enter);
        leave = _mm256_min_ps(leave, _mm256_set1_ps(far));
        return _mm256_cmp_ps_mask(enter, leave, _CMP_LE_OQ);
    }

private:
    __m256 enter_from_[3];
    __m256 leave_from_[3];
    __m256 inverse_[3];
    size_t first_[3];  ///< where in a node the planes lie that the ray enters through
    size_t last_[3];
};

/// Asks for the nodes among several children that are met, before they are needed.
inline void prefetch_nodes(const KdNode* nodes, const KdNode& parent, unsigned met) {
    if ((met & (met - 1)) == 0) return;
    for (; met != 0; met &= met - 1) {
        const uint32_t child = parent.child[std::countr_zero(met)];
        if ((child & KdNode::leaf_bit) != 0) continue;
        const char* node = reinterpret_cast<const char*>(nodes + child);
        for (size_t line = 0; line < 256; line += 64) _mm_prefetch(node + line, _MM_HINT_T0);
    }
}

template <class Leaf>
RB_WIDE bool KdTree::walk_wide(const Ray& ray, double t_min, const double& t_max, Leaf&& leaf) const {
    if (nodes_.empty()) return false;
    Walk walk(*this, ray, t_min, t_max);
    const WideBoxRay wide(walk.slabs);
    for (;;) {
        const KdNode& node = walk.node();
        alignas(32) float near_of[8];
        const unsigned met = wide.meets(node, walk.near, walk.far(), near_of);
        prefetch_nodes(nodes_.data(), node, met);
        if (const auto end = walk.go_on(met, near_of, leaf)) return *end;
    }
}

}  // namespace rb
