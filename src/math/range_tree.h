#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rb {

/// Boxes over ranges of a sequence whose neighbours lie side by side (pieces of a curve): the sequence is
/// halved again and again, and every range keeps the box of its elements. `Box` has `include(const Box&)`.
template <class Box>
class RangeTree {
public:
    RangeTree() = default;
    explicit RangeTree(const std::vector<Box>& elements) : count_(static_cast<uint32_t>(elements.size())) {
        if (count_ == 0) return;
        boxes_.resize(2 * elements.size() - 1);
        build(elements, 0, 0, count_);
    }

    /// Calls take(index), in order, for every element that stands below boxes which `meets(box)` accepts.
    template <class Meets, class Take>
    void visit(Meets&& meets, Take&& take) const {
        if (count_ > 0) visit(meets, take, 0, 0, count_);
    }

private:
    // The node of [first, last) is followed by those of its first half, then by those of its second half.
    static uint32_t middle(uint32_t first, uint32_t last) { return first + (last - first) / 2; }

    void build(const std::vector<Box>& elements, uint32_t node, uint32_t first, uint32_t last) {
        Box box = elements[first];
        for (uint32_t i = first + 1; i < last; ++i) box.include(elements[i]);
        boxes_[node] = box;
        if (last - first == 1) return;
        const uint32_t half = middle(first, last);
        build(elements, node + 1, first, half);
        build(elements, node + 2 * (half - first), half, last);
    }

    template <class Meets, class Take>
    void visit(Meets& meets, Take& take, uint32_t node, uint32_t first, uint32_t last) const {
        if (!meets(boxes_[node])) return;
        if (last - first == 1) {
            take(first);
            return;
        }
        const uint32_t half = middle(first, last);
        visit(meets, take, node + 1, first, half);
        visit(meets, take, node + 2 * (half - first), half, last);
    }

    uint32_t count_ = 0;
    std::vector<Box> boxes_;
};

}  // namespace rb
