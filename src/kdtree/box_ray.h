#pragma once
#include "math/bounds.h"
#include "math/ray.h"

#include <algorithm>
#include <cstdint>
#include <emmintrin.h>
#include <limits>

namespace rb {

/// A ray against boxes in single precision: planes are met a little too early or too late, never the other
/// way round. Lengths are measured along the longest component of the direction.
class BoxRay {
public:
    /// `center` is what the boxes are relative to, `reach` the largest of their coordinates.
    BoxRay(const Ray& ray, const Vec3& center, float reach);

    float scaled_down(double t) const { return static_cast<float>(t * (1.0 - margin) * speed_); }
    float scaled_up(double t) const {
        return static_cast<float>(std::min(t * (1.0 + margin) * speed_, most));
    }

    /// Bit i is set if the ray may meet box i of four between `near` and `far`; `near_of[i]` is where, at the
    /// earliest. Planes lie as [axis][low or high][box].
    template <size_t boxes>
    unsigned meets(const float (&planes)[3][2][boxes], float near, float far, float near_of[4],
                   size_t first_box = 0) const {
        __m128 enter = _mm_set1_ps(near);
        __m128 leave = _mm_set1_ps(std::numeric_limits<float>::max());
        const auto cut = [&](size_t axis) {
            const float* axis_planes = planes[axis][0] + first_box;
            const __m128 first = _mm_load_ps(axis_planes + boxes / 4 * high_first_[axis]);
            const __m128 last = _mm_load_ps(axis_planes + boxes / 4 * low_first_[axis]);
            const __m128 a = _mm_mul_ps(_mm_sub_ps(first, enter_from_[axis]), inverse_[axis]);
            const __m128 b = _mm_mul_ps(_mm_sub_ps(last, leave_from_[axis]), inverse_[axis]);
            // NaN (0 times infinity) leaves the second operand.
            enter = _mm_max_ps(a, enter);
            leave = _mm_min_ps(b, leave);
        };
        cut(0);
        cut(1);
        cut(2);
        leave = _mm_mul_ps(leave, _mm_set1_ps(1.0f + static_cast<float>(margin)));
        _mm_store_ps(near_of, enter);
        leave = _mm_min_ps(leave, _mm_set1_ps(far));
        return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(enter, leave)));
    }

private:
    friend class WideBoxRay;
    static void spread(__m128 v, __m128 out[3]) {
        out[0] = _mm_shuffle_ps(v, v, _MM_SHUFFLE(0, 0, 0, 0));
        out[1] = _mm_shuffle_ps(v, v, _MM_SHUFFLE(1, 1, 1, 1));
        out[2] = _mm_shuffle_ps(v, v, _MM_SHUFFLE(2, 2, 2, 2));
    }

    /// Four roundings of the distance to a plane, and room.
    static constexpr double margin = 0x1p-20;
    static constexpr double most = std::numeric_limits<float>::max();

    __m128 enter_from_[3];
    __m128 leave_from_[3];
    __m128 inverse_[3];
    uint32_t high_first_[3];  ///< 4 where the ray enters through the high plane, else 0
    uint32_t low_first_[3];   ///< the other way round
    double speed_;
};

inline BoxRay::BoxRay(const Ray& ray, const Vec3& center, float reach) {
    const Vec3& d = ray.direction;
    speed_ = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    const double unit = 1.0 / speed_;
    const Vec3 o = ray.origin - center;
    const double farthest = std::max({std::abs(o.x), std::abs(o.y), std::abs(o.z)});
    // A component below `tiny` counts as 0: what it moves the ray across the scene is added to the error.
    constexpr float tiny = 1e-30f;
    const float slack = tiny * (static_cast<float>(farthest) + reach) + std::numeric_limits<float>::min();
    const auto narrowed = [](const Vec3& v) {
        return _mm_movelh_ps(_mm_cvtpd_ps(_mm_set_pd(v.y, v.x)), _mm_cvtpd_ps(_mm_set_sd(v.z)));
    };
    const __m128 sign_bit = _mm_set1_ps(-0.0f);
    const __m128 from = narrowed(o);
    const __m128 slope = narrowed(d * unit);
    const __m128 sign = _mm_and_ps(slope, sign_bit);
    const __m128 error =
        _mm_add_ps(_mm_mul_ps(_mm_andnot_ps(sign_bit, from), _mm_set1_ps(0x1p-22f)), _mm_set1_ps(slack));
    const __m128 ahead = _mm_xor_ps(error, sign);
    const __m128 steep = _mm_cmpgt_ps(_mm_andnot_ps(sign_bit, slope), _mm_set1_ps(tiny));
    const __m128 infinite = _mm_or_ps(_mm_set1_ps(std::numeric_limits<float>::infinity()), sign);
    const __m128 inverse =
        _mm_or_ps(_mm_and_ps(steep, _mm_div_ps(_mm_set1_ps(1.0f), slope)), _mm_andnot_ps(steep, infinite));
    spread(_mm_add_ps(from, ahead), enter_from_);
    spread(_mm_sub_ps(from, ahead), leave_from_);
    spread(inverse, inverse_);
    const auto down = static_cast<uint32_t>(_mm_movemask_ps(slope));
    for (uint32_t axis = 0; axis < 3; ++axis) {
        high_first_[axis] = (down >> axis & 1u) * 4u;
        low_first_[axis] = 4u - high_first_[axis];
    }
}

}  // namespace rb
