#include "shade/stream_state.h"

namespace rb {

InteriorList InteriorPool::add(std::span<const uint32_t> items) {
    const InteriorList list{static_cast<uint32_t>(items_.size()), static_cast<uint32_t>(items.size())};
    items_.insert(items_.end(), items.begin(), items.end());
    return list;
}

InteriorList InteriorPool::with(InteriorList list, uint32_t interior) {
    const auto first = static_cast<uint32_t>(items_.size());
    for (uint32_t i = 0; i < list.count; ++i) items_.push_back(items_[list.first + i]);
    items_.push_back(interior);
    return {first, list.count + 1};
}

InteriorList InteriorPool::without(InteriorList list, size_t position) {
    if (position + 1 == list.count) return {list.first, list.count - 1};
    const auto first = static_cast<uint32_t>(items_.size());
    for (uint32_t i = 0; i < list.count; ++i) {
        if (i != position) items_.push_back(items_[list.first + i]);
    }
    return {first, list.count - 1};
}

}  // namespace rb
