#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace rb {

/// What waits during a walk through nodes of several boxes each, the nearest on top.
template <size_t capacity>
class WalkStack {
public:
    /// The children whose bits are set in `met` (not 0) are put in order; the nearest of them goes on.
    uint32_t push(const uint32_t* children, unsigned met, const float* near_of) {
        const auto child_in = [&](int lane) { return Waiting{near_of[lane], children[lane]}; };
        Waiting nearest = child_in(std::countr_zero(met));
        const size_t first = count_;
        for (met &= met - 1; met != 0; met &= met - 1) {
            Waiting other = child_in(std::countr_zero(met));
            if (other.near < nearest.near) std::swap(other, nearest);
            size_t place = count_++;
            for (; place > first && waiting_[place - 1].near < other.near; --place)
                waiting_[place] = waiting_[place - 1];
            waiting_[place] = other;
        }
        return nearest.child;
    }
    /// False if nothing is left before `far`.
    bool pop(float far, uint32_t& child) {
        while (count_ > 0) {
            const Waiting& top = waiting_[--count_];
            child = top.child;
            if (top.near <= far) return true;
        }
        return false;
    }

private:
    struct Waiting {
        float near;
        uint32_t child;
    };
    size_t count_ = 0;
    Waiting waiting_[capacity];
};

}  // namespace rb
