#pragma once
#include "kdtree/kdtree.h"
#include "math/wide.h"

#include <array>

namespace rb {

/// For each set of the planes that a ray passes from high to low (bit i: plane i), the children of a treelet
/// from far to near.
inline constexpr auto far_to_near = [] {
    std::array<std::array<uint8_t, 8>, 128> orders{};
    for (uint32_t high_first = 0; high_first < 128; ++high_first) {
        for (uint32_t rank = 0; rank < 8; ++rank) {
            uint32_t node = 0;
            for (uint32_t level = 4; level != 0; level >>= 1) {
                const uint32_t is_far = (rank & level) != 0 ? 0 : 1;
                node = 2 * node + 1 + (is_far ^ (high_first >> node & 1u));
            }
            orders[high_first][rank] = static_cast<uint8_t>(node - 7);
        }
    }
    return orders;
}();

/// The children of a treelet that a ray meets.
class WideRay {
public:
    struct Met {
        __m512d near;  ///< children from far to near
        __m512d far;
        __m512i child;
        unsigned mask;
    };

    RB_WIDE WideRay(const Vec3& origin, const Vec3& slope, double rounding)
        : origin_(_mm512_setr_pd(origin.x, origin.y, origin.z, 0, 0, 0, 0, 0)),
          slope_(_mm512_setr_pd(slope.x, slope.y, slope.z, 0, 0, 0, 0, 0)),
          down_(_mm512_set1_pd(1.0 - rounding)),
          up_(_mm512_set1_pd(1.0 + rounding)) {}

    RB_WIDE inline __attribute__((always_inline)) Met meets(const KdTreelet& treelet, __m512d near,
                                                            __m512d far) const {
        const __m512d inf = _mm512_set1_pd(std::numeric_limits<double>::infinity());
        const __m512d minus_inf = _mm512_set1_pd(-std::numeric_limits<double>::infinity());
        const __m512d nan = _mm512_set1_pd(std::numeric_limits<double>::quiet_NaN());
        const __m512d plane = _mm512_cvtps_pd(_mm256_load_ps(treelet.plane));
        const __m512i axis = _mm512_srlv_epi64(_mm512_set1_epi64(treelet.axes_and_filled),
                                               _mm512_setr_epi64(0, 3, 6, 9, 12, 15, 18, 63));
        const __m512d slope = _mm512_permutexvar_pd(axis, slope_);
        const __m512d t = _mm512_mul_pd(_mm512_sub_pd(plane, _mm512_permutexvar_pd(axis, origin_)), slope);
        const __m512d low = _mm512_mul_pd(t, down_);
        const __m512d high = _mm512_mul_pd(t, up_);
        const __mmask8 high_first = _mm512_movepi64_mask(_mm512_castpd_si512(slope));
        // The child that the ray comes to first ends at the plane, the other one begins there.
        const __m512d low_begins = _mm512_mask_mov_pd(minus_inf, high_first, low);
        const __m512d low_ends = _mm512_mask_mov_pd(high, high_first, inf);
        const __m512d high_begins = _mm512_mask_mov_pd(low, high_first, minus_inf);
        const __m512d high_ends = _mm512_mask_mov_pd(inf, high_first, high);
        // Level by level, which plane and which side of it a child has above it.
        const __m512i top = _mm512_setr_epi64(0, 0, 0, 0, 8, 8, 8, 8);
        const __m512i middle = _mm512_setr_epi64(1, 1, 9, 9, 2, 2, 10, 10);
        const __m512i bottom = _mm512_setr_epi64(3, 11, 4, 12, 5, 13, 6, 14);
        // NaN (the ray runs in the plane) leaves the second operand; so does an empty child's near.
        near = _mm512_mask_mov_pd(nan, static_cast<__mmask8>(treelet.filled()), near);
        near = _mm512_max_pd(_mm512_permutex2var_pd(low_begins, top, high_begins), near);
        far = _mm512_min_pd(_mm512_permutex2var_pd(low_ends, top, high_ends), far);
        near = _mm512_max_pd(_mm512_permutex2var_pd(low_begins, middle, high_begins), near);
        far = _mm512_min_pd(_mm512_permutex2var_pd(low_ends, middle, high_ends), far);
        near = _mm512_max_pd(_mm512_permutex2var_pd(low_begins, bottom, high_begins), near);
        far = _mm512_min_pd(_mm512_permutex2var_pd(low_ends, bottom, high_ends), far);
        const __m512i order = _mm512_cvtepu8_epi64(
            _mm_loadl_epi64(reinterpret_cast<const __m128i*>(&far_to_near[high_first & 127u])));
        Met met;
        met.near = _mm512_permutexvar_pd(order, near);
        met.far = _mm512_permutexvar_pd(order, far);
        met.mask = _mm512_cmp_pd_mask(met.near, met.far, _CMP_LE_OQ);
        met.child = _mm512_permutexvar_epi64(
            order, _mm512_cvtepu32_epi64(_mm256_load_si256(reinterpret_cast<const __m256i*>(treelet.child))));
        return met;
    }

private:
    __m512d origin_;
    __m512d slope_;
    __m512d down_;
    __m512d up_;
};

template <class Leaf>
RB_WIDE bool KdTree::walk_wide(const Ray& ray, double t_min, const double& t_max, Leaf&& leaf) const {
    if (treelets_.empty()) return false;
    const Vec3 inverse = 1.0 / ray.direction;
    double enter = t_min;
    double leave = t_max + t_max * hit_rounding;
    if (!clip_ray(ray, inverse, enter, leave)) return false;
    const WideRay wide(ray.origin, inverse, rounding);
    // What waits, the nearest on top.
    constexpr size_t most = 8 * (most_depth / 3 + 12);
    alignas(64) double nears[most];
    alignas(64) double fars[most];
    alignas(64) uint64_t children[most];
    size_t waiting = 0;
    uint32_t at = 0;
    __m512d near = _mm512_set1_pd(enter);
    __m512d far = _mm512_set1_pd(leave);
    const KdTreelet* treelets = treelets_.data();
    for (;;) {
        while ((at & KdTreelet::leaf_bit) == 0) {
            const WideRay::Met met = wide.meets(treelets[at], near, far);
            const auto mask = static_cast<__mmask8>(met.mask);
            _mm512_storeu_pd(nears + waiting, _mm512_maskz_compress_pd(mask, met.near));
            _mm512_storeu_pd(fars + waiting, _mm512_maskz_compress_pd(mask, met.far));
            _mm512_storeu_si512(children + waiting, _mm512_maskz_compress_epi64(mask, met.child));
            waiting += static_cast<size_t>(std::popcount(met.mask));
            if (met.mask == 0) break;
            --waiting;
            at = static_cast<uint32_t>(children[waiting]);
            near = _mm512_set1_pd(nears[waiting]);
            far = _mm512_set1_pd(fars[waiting]);
        }
        if ((at & KdTreelet::leaf_bit) != 0 &&
            leaf(references_.data() + block_ * KdTreelet::first_block(at),
                 block_ * KdTreelet::block_count(at)))
            return true;
        const double limit = t_max + t_max * hit_rounding;
        do {
            if (waiting == 0) return false;
            --waiting;
        } while (nears[waiting] > limit);
        at = static_cast<uint32_t>(children[waiting]);
        near = _mm512_set1_pd(nears[waiting]);
        far = _mm512_set1_pd(fars[waiting] < limit ? fars[waiting] : limit);
    }
}

}  // namespace rb
