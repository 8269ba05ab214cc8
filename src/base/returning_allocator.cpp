#include "base/returning_allocator.h"

#include <new>

#ifndef RB_SANITIZED
#include <oneapi/tbb/scalable_allocator.h>
#endif

namespace rb {

#ifdef RB_SANITIZED
void* allocate_returning(std::size_t bytes) { return ::operator new(bytes); }
void free_returning(void* memory) noexcept { ::operator delete(memory); }
#else
void* allocate_returning(std::size_t bytes) {
    void* memory = scalable_malloc(bytes);
    if (!memory) throw std::bad_alloc();
    return memory;
}
void free_returning(void* memory) noexcept { scalable_free(memory); }
#endif

}  // namespace rb
