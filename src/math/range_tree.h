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
    explicit RangeTree(const std::vector<Box>& elements) {
        if (elements.empty()) return;
        nodes_.reserve(2 * elements.size() - 1);
        build(elements, 0, static_cast<uint32_t>(elements.size()));
    }

    /// Calls take(index), in order, for every element that stands below boxes which `meets(box)` accepts.
    template <class Meets, class Take>
    void visit(Meets&& meets, Take&& take) const {
        const auto count = static_cast<uint32_t>(nodes_.size());
        for (uint32_t i = 0; i < count;) {
            const Node& node = nodes_[i];
            if (!meets(node.box)) {
                i = node.after;
                continue;
            }
            if (node.element != inner) take(node.element);
            ++i;
        }
    }

private:
    static constexpr uint32_t inner = 0xffffffff;

    /// Followed by what stands below it.
    struct Node {
        Box box;
        uint32_t after = 0;  ///< the first node that does not stand below it
        uint32_t element = inner;
    };

    void build(const std::vector<Box>& elements, uint32_t first, uint32_t last) {
        const size_t node = nodes_.size();
        Box box = elements[first];
        for (uint32_t i = first + 1; i < last; ++i) box.include(elements[i]);
        nodes_.push_back({box, 0, last - first == 1 ? first : inner});
        if (last - first > 1) {
            const uint32_t half = first + (last - first) / 2;
            build(elements, first, half);
            build(elements, half, last);
        }
        nodes_[node].after = static_cast<uint32_t>(nodes_.size());
    }

    std::vector<Node> nodes_;
};

}  // namespace rb
