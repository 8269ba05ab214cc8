#include "base/slabs.h"

#include <algorithm>
#include <cstring>
#include <random>
#include <thread>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

namespace rb {
namespace {

/// Pages of this process in memory.
size_t resident_pages() {
    size_t total = 0;
    size_t resident = 0;
    std::FILE* file = std::fopen("/proc/self/statm", "r");
    if (!file) return 0;
    const int got = std::fscanf(file, "%zu %zu", &total, &resident);
    std::fclose(file);
    return got == 2 ? resident : 0;
}

TEST(Slabs, BlocksDoNotOverlap) {
    constexpr size_t size = 200;
    Slabs slabs(size);
    std::mt19937 dice(3);
    std::vector<std::pair<unsigned char*, unsigned char>> blocks;
    for (int i = 0; i < 20'000; ++i) {
        if (!blocks.empty() && dice() % 5 < 2) {
            const size_t k = dice() % blocks.size();
            const auto [block, value] = blocks[k];
            EXPECT_EQ(std::count(block, block + size, value), static_cast<ptrdiff_t>(size));
            slabs.give(block);
            blocks[k] = blocks.back();
            blocks.pop_back();
        } else {
            auto* const block = static_cast<unsigned char*>(slabs.take());
            EXPECT_EQ(reinterpret_cast<uintptr_t>(block) % alignof(std::max_align_t), 0u);
            const auto value = static_cast<unsigned char>(dice());
            std::memset(block, value, size);
            blocks.emplace_back(block, value);
        }
    }
    for (const auto& [block, value] : blocks) {
        EXPECT_EQ(std::count(block, block + size, value), static_cast<ptrdiff_t>(size));
        slabs.give(block);
    }
}

TEST(Slabs, MemoryGoesBack) {
    Slabs slabs(256);
    const size_t before = resident_pages();
    std::vector<void*> blocks(100'000);
    for (void*& block : blocks) block = std::memset(slabs.take(), 1, 256);
    const size_t page = static_cast<size_t>(sysconf(_SC_PAGESIZE));
    const size_t taken = blocks.size() * 256 / page;
    EXPECT_GT(resident_pages(), before + taken * 9 / 10);
    for (void* block : blocks) slabs.give(block);
    EXPECT_LT(resident_pages(), before + taken / 10);
}

TEST(Slabs, ServesThreads) {
    Slabs slabs(64);
    const auto work = [&slabs] {
        std::vector<void*> blocks;
        for (int i = 0; i < 20'000; ++i) blocks.push_back(std::memset(slabs.take(), 2, 64));
        for (void* block : blocks) slabs.give(block);
    };
    std::thread other(work);
    work();
    other.join();
}

}  // namespace
}  // namespace rb
