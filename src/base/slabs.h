#pragma once
#include <cstddef>
#include <memory>
#include <mutex>

#if defined(__SANITIZE_ADDRESS__)
#define RB_CHECKS_ADDRESSES
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define RB_CHECKS_ADDRESSES
#endif
#endif

namespace rb {

/// Blocks of one size, cut from slabs of 64 KiB that go back to the system once nothing in them is used. For
/// what there is a lot of and what is let go before its neighbours: malloc would keep the holes. Any thread
/// may call.
class Slabs {
public:
    /// In bytes, well below 64 KiB; blocks are aligned as with malloc.
    explicit Slabs(size_t block_size);
    /// Throws std::bad_alloc.
    void* take();
    void give(void* block);

private:
    struct Slab;
    void link(Slab* slab);
    void unlink(Slab* slab);

    const size_t block_size_;
    std::mutex mutex_;
    Slab* roomy_ = nullptr;  ///< those with room, a list
};

/// For std::allocate_shared.
template <typename T>
struct SlabAllocator {
    using value_type = T;

    SlabAllocator() = default;
    template <typename U>
    SlabAllocator(const SlabAllocator<U>&) {}

#ifdef RB_CHECKS_ADDRESSES
    T* allocate(size_t count) { return std::allocator<T>().allocate(count); }
    void deallocate(T* memory, size_t count) { std::allocator<T>().deallocate(memory, count); }
#else
    T* allocate(size_t count) {
        return count == 1 ? static_cast<T*>(slabs().take()) : std::allocator<T>().allocate(count);
    }
    void deallocate(T* memory, size_t count) {
        if (count == 1) {
            slabs().give(memory);
        } else {
            std::allocator<T>().deallocate(memory, count);
        }
    }
#endif
    bool operator==(const SlabAllocator&) const = default;

private:
    /// Never destroyed: what is static may be let go after it.
    static Slabs& slabs() {
        static_assert(alignof(T) <= alignof(std::max_align_t));
        static Slabs& shared = *new Slabs(sizeof(T));
        return shared;
    }
};

}  // namespace rb
