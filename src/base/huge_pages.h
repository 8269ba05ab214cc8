#pragma once
#include <cstdlib>
#include <memory>
#include <new>
#include <sys/mman.h>

namespace rb {

/// Allocates large arrays on huge pages where the system has them: touching a picture's memory for the first
/// time costs one page fault for each 2 MiB instead of 512.
template <typename T>
struct HugePages {
    using value_type = T;

    HugePages() = default;
    template <typename U>
    HugePages(const HugePages<U>&) {}

    T* allocate(size_t count) {
        const size_t size = count * sizeof(T);
        if (size < page) return std::allocator<T>().allocate(count);
        const size_t whole = (size + page - 1) / page * page;
        void* memory = whole < size ? nullptr : std::aligned_alloc(page, whole);
        if (!memory) throw std::bad_alloc();
        // A hint: where it is refused the memory is as good.
        (void)madvise(memory, whole, MADV_HUGEPAGE);
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, size_t count) {
        if (count * sizeof(T) < page) {
            std::allocator<T>().deallocate(memory, count);
        } else {
            std::free(memory);
        }
    }
    bool operator==(const HugePages&) const = default;

private:
    static constexpr size_t page = size_t{1} << 21;
};

}  // namespace rb
