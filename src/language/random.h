#pragma once
#include <cstdint>
#include <vector>

namespace rb {

/// The streams of `seed` and `rand` (spec: language 8.4).
class RandomStreams {
public:
    size_t open(double seed) {
        const bool fits = seed > -2147483649.0 && seed < 2147483648.0;
        states_.push_back(fits ? static_cast<uint32_t>(static_cast<int32_t>(seed)) : 0x80000000u);
        return states_.size() - 1;
    }
    bool known(double stream) const { return stream >= 0 && stream < static_cast<double>(states_.size()); }
    double next(size_t stream) {
        states_[stream] = states_[stream] * 1812433253u + 12345u;
        return states_[stream] / 4294967295.0;
    }
    uint32_t state(size_t stream) const { return states_[stream]; }
    void set_state(size_t stream, uint32_t state) { states_[stream] = state; }

private:
    std::vector<uint32_t> states_;
};

}  // namespace rb
