#pragma once
#include <cstddef>

namespace rb {

/// Memory that is given back to the system once its neighbours are free, too, where malloc keeps the holes;
/// sanitizers get the standard one's, which is all they watch. Aligned for every fundamental type. Throws
/// std::bad_alloc.
void* allocate_returning(std::size_t bytes);
void free_returning(void* memory) noexcept;

/// For std::allocate_shared of what there is a lot of, and what is let go before its neighbours.
template <typename T>
struct ReturningAllocator {
    using value_type = T;
    ReturningAllocator() = default;
    template <typename U>
    ReturningAllocator(const ReturningAllocator<U>&) {}
    T* allocate(std::size_t count) {
        static_assert(alignof(T) <= alignof(std::max_align_t));
        return static_cast<T*>(allocate_returning(count * sizeof(T)));
    }
    void deallocate(T* memory, std::size_t) { free_returning(memory); }
    bool operator==(const ReturningAllocator&) const = default;
};

}  // namespace rb
