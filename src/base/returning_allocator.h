#pragma once
#include <memory>

#include <oneapi/tbb/scalable_allocator.h>

namespace rb {

/// For std::allocate_shared of what there is a lot of, and what is let go before its neighbours: gives the
/// memory back, where malloc keeps the holes. (Sanitizers watch only the standard one.)
#ifdef RB_SANITIZED
template <typename T>
using ReturningAllocator = std::allocator<T>;
#else
template <typename T>
using ReturningAllocator = tbb::scalable_allocator<T>;
#endif

}  // namespace rb
