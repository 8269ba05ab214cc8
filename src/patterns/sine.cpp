#include "patterns/sine.h"

#include "patterns/quad.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

/// Up to here multiples of quarter turns are subtracted without loss.
constexpr double reduction_limit = 1e6;

/// A quarter turn in three parts, of which the first two have room for a factor of 20 bits.
constexpr double quarter[3] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e037073p-69};

/// The sine of numbers within the limit: the Taylor series of sine or cosine within an eighth of a turn.
template <class Lanes>
RB_INLINE void take_sine(typename Lanes::Numbers& x) {
    using Numbers = typename Lanes::Numbers;
    constexpr double turns_to_bits = 0x1.8p52;  // what is added to it ends in whole numbers
    const Numbers shifted = x * 0.63661977236758134308 + turns_to_bits;
    const Numbers turns = shifted - turns_to_bits;
    const Numbers r = x - turns * quarter[0] - turns * quarter[1] - turns * quarter[2];
    const Numbers s = r * r;
    const Numbers odd =
        r + r * s *
                (-1.0 / 6 +
                 s * (1.0 / 120 +
                      s * (-1.0 / 5040 +
                           s * (1.0 / 362880 + s * (-1.0 / 39916800 +
                                                    s * (1.0 / 6227020800 - s * (1.0 / 1307674368000)))))));
    const Numbers even =
        1.0 -
        s * (0.5 - s * (1.0 / 24 -
                        s * (1.0 / 720 - s * (1.0 / 40320 - s * (1.0 / 3628800 -
                                                                 s * (1.0 / 479001600 -
                                                                      s * (1.0 / 87178291200 -
                                                                           s * (1.0 / 20922789888000))))))));
    typename Lanes::Bits number;
    std::memcpy(&number, &shifted, sizeof number);
    const Numbers chosen = (number & 1) == 0 ? odd : even;
    typename Lanes::Bits bits;
    std::memcpy(&bits, &chosen, sizeof bits);
    bits ^= (number & 2) << 62;
    std::memcpy(&x, &bits, sizeof x);
}

template <class Lanes>
RB_INLINE void sines_in(std::span<double> values) {
    constexpr size_t n = Lanes::count;
    for (size_t first = 0; first < values.size(); first += n) {
        const size_t count = std::min(n, values.size() - first);
        double from[n] = {};
        std::copy_n(&values[first], count, from);
        typename Lanes::Numbers x;
        load(from, x);
        typename Lanes::Numbers magnitude;
        set_magnitude(x, magnitude);
        double sum = 0;
        for (size_t i = 0; i < n; ++i) sum += magnitude[i];
        take_sine<Lanes>(x);
        double to[n];
        store(x, to);
        if (!(sum < reduction_limit)) {
            for (size_t i = 0; i < count; ++i) {
                if (!(std::abs(from[i]) < reduction_limit)) to[i] = std::sin(from[i]);
            }
        }
        std::copy_n(to, count, &values[first]);
    }
}

}  // namespace

RB_FOR_EACH_WIDTH(sines, (std::span<double> values), (values))

}  // namespace rb
