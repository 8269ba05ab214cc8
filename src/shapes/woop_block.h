#pragma once
#include "math/wide.h"
#include "shapes/triangle_block.h"
#include "shapes/woop.h"

namespace rb {

/// WoopRay::hits() for eight triangles at once; the same bits.
class WoopBlockRay {
public:
    RB_WIDE explicit WoopBlockRay(const WoopRay& ray)
        : ox_(_mm512_set1_pd(ray.ox_)),
          oy_(_mm512_set1_pd(ray.oy_)),
          oz_(_mm512_set1_pd(ray.oz_)),
          sx_(_mm512_set1_pd(ray.sx_)),
          sy_(_mm512_set1_pd(ray.sy_)),
          sz_(_mm512_set1_pd(ray.sz_)),
          kx_(ray.kx_),
          ky_(ray.ky_),
          kz_(ray.kz_) {}

    struct Hits {
        alignas(64) double t[TriangleBlock::size];
        alignas(64) double x[TriangleBlock::size];
        alignas(64) double y[TriangleBlock::size];
        TriangleHit operator[](size_t i) const { return {t[i], {x[i], y[i]}}; }
    };

    /// The triangles that are met in (t_min, t_max], one bit each; only their `hits` are written.
    RB_WIDE inline __attribute__((always_inline)) unsigned meets(const TriangleBlock& block, double t_min,
                                                                 double t_max, Hits& hits) const {
        const Corner a = shear(block.corners[0]);
        const Corner b = shear(block.corners[1]);
        const Corner c = shear(block.corners[2]);
        const __m512d u = _mm512_sub_pd(_mm512_mul_pd(c.x, b.y), _mm512_mul_pd(c.y, b.x));
        const __m512d v = _mm512_sub_pd(_mm512_mul_pd(a.x, c.y), _mm512_mul_pd(a.y, c.x));
        const __m512d w = _mm512_sub_pd(_mm512_mul_pd(b.x, a.y), _mm512_mul_pd(b.y, a.x));
        const __m512d zero = _mm512_setzero_pd();
        const __m512d least = _mm512_min_pd(_mm512_min_pd(u, v), w);
        const __m512d most = _mm512_max_pd(_mm512_max_pd(u, v), w);
        __mmask8 met =
            _mm512_cmp_pd_mask(least, zero, _CMP_GE_OQ) | _mm512_cmp_pd_mask(most, zero, _CMP_LE_OQ);
        if (met == 0) return 0;
        const __m512d sum = _mm512_add_pd(_mm512_add_pd(u, v), w);
        const __m512d inverse = _mm512_div_pd(_mm512_set1_pd(1.0), sum);
        const __m512d height =
            _mm512_add_pd(_mm512_add_pd(_mm512_mul_pd(u, a.z), _mm512_mul_pd(v, b.z)), _mm512_mul_pd(w, c.z));
        const __m512d t = _mm512_mul_pd(sz_, _mm512_mul_pd(height, inverse));
        met &= _mm512_cmp_pd_mask(sum, zero, _CMP_NEQ_UQ);
        met &= _mm512_cmp_pd_mask(t, _mm512_set1_pd(t_min), _CMP_GT_OQ);
        met &= _mm512_cmp_pd_mask(t, _mm512_set1_pd(t_max), _CMP_LE_OQ);
        if (met == 0) return 0;
        _mm512_store_pd(hits.t, t);
        _mm512_store_pd(hits.x, _mm512_mul_pd(v, inverse));
        _mm512_store_pd(hits.y, _mm512_mul_pd(w, inverse));
        return met;
    }

private:
    struct Corner {
        __m512d x;
        __m512d y;
        __m512d z;
    };
    RB_WIDE inline __attribute__((always_inline)) Corner shear(
        const float (&corner)[3][TriangleBlock::size]) const {
        const __m512d z = _mm512_sub_pd(_mm512_cvtps_pd(_mm256_load_ps(corner[kz_])), oz_);
        const __m512d x = _mm512_sub_pd(_mm512_cvtps_pd(_mm256_load_ps(corner[kx_])), ox_);
        const __m512d y = _mm512_sub_pd(_mm512_cvtps_pd(_mm256_load_ps(corner[ky_])), oy_);
        return {_mm512_sub_pd(x, _mm512_mul_pd(sx_, z)), _mm512_sub_pd(y, _mm512_mul_pd(sy_, z)), z};
    }

    __m512d ox_, oy_, oz_;
    __m512d sx_, sy_, sz_;
    int kx_, ky_, kz_;
};

}  // namespace rb
