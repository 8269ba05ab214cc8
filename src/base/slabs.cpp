#include "base/slabs.h"

#include <cstdint>
#include <new>
#include <sys/mman.h>

namespace rb {

namespace {

constexpr size_t slab_size = size_t{1} << 16;
constexpr size_t alignment = alignof(std::max_align_t);

size_t rounded_up(size_t size) { return (size + alignment - 1) / alignment * alignment; }

/// A slab's address is a multiple of its size, so that a block tells its slab.
void* new_slab() {
    void* memory = mmap(nullptr, 2 * slab_size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    auto* const begin = static_cast<std::byte*>(memory);
    const size_t before = (slab_size - reinterpret_cast<uintptr_t>(begin) % slab_size) % slab_size;
    if (before > 0) munmap(begin, before);
    munmap(begin + before + slab_size, slab_size - before);
    return begin + before;
}

struct FreeBlock {
    FreeBlock* next;
};

}  // namespace

struct Slabs::Slab {
    Slab* previous = nullptr;
    Slab* next = nullptr;
    FreeBlock* free = nullptr;              ///< blocks that were given back
    size_t cut = rounded_up(sizeof(Slab));  ///< how many bytes are header or have become blocks
    size_t in_use = 0;

    bool has_room(size_t block_size) const { return free || cut + block_size <= slab_size; }
};

Slabs::Slabs(size_t block_size) : block_size_(rounded_up(block_size)) {}

void Slabs::link(Slab* slab) {
    slab->previous = nullptr;
    slab->next = roomy_;
    if (roomy_) roomy_->previous = slab;
    roomy_ = slab;
}

void Slabs::unlink(Slab* slab) {
    (slab->previous ? slab->previous->next : roomy_) = slab->next;
    if (slab->next) slab->next->previous = slab->previous;
}

void* Slabs::take() {
    const std::lock_guard lock(mutex_);
    if (!roomy_) link(new (new_slab()) Slab);
    Slab* const slab = roomy_;
    void* block = slab->free;
    if (block) {
        slab->free = slab->free->next;
    } else {
        block = reinterpret_cast<std::byte*>(slab) + slab->cut;
        slab->cut += block_size_;
    }
    ++slab->in_use;
    if (!slab->has_room(block_size_)) unlink(slab);
    return block;
}

void Slabs::give(void* block) {
    const std::lock_guard lock(mutex_);
    auto* const slab = reinterpret_cast<Slab*>(reinterpret_cast<uintptr_t>(block) / slab_size * slab_size);
    if (!slab->has_room(block_size_)) link(slab);
    slab->free = new (block) FreeBlock{slab->free};
    // One empty slab stays, so that a loop over a single block does not ask the system each time.
    if (--slab->in_use > 0 || (slab == roomy_ && !slab->next)) return;
    unlink(slab);
    munmap(slab, slab_size);
}

}  // namespace rb
