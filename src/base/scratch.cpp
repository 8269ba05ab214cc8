#include "base/scratch.h"

#include <algorithm>

namespace rb {

void* Scratch::raw(size_t bytes) {
    constexpr size_t smallest_chunk = size_t{1} << 20;
    bytes = (bytes + alignment - 1) / alignment * alignment;
    while (chunk_ < chunks_.size() && used_ + bytes > chunks_[chunk_].size) {
        ++chunk_;
        used_ = 0;
    }
    if (chunk_ == chunks_.size()) {
        const size_t size = std::max(bytes, smallest_chunk);
        chunks_.push_back({std::make_unique_for_overwrite<std::byte[]>(size), size});
        used_ = 0;
    }
    void* start = chunks_[chunk_].bytes.get() + used_;
    used_ += bytes;
    return start;
}

Scratch& thread_scratch() {
    thread_local Scratch scratch;
    return scratch;
}

}  // namespace rb
