#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace rb {

/// Working memory for batches, taken and given back in stack order, so that evaluation needs no heap once it
/// has warmed up. Elements are left uninitialised.
class Scratch {
public:
    /// Gives back at its end what was taken since its beginning.
    class Scope {
    public:
        explicit Scope(Scratch& scratch) : scratch_(scratch), chunk_(scratch.chunk_), used_(scratch.used_) {}
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;
        ~Scope() {
            scratch_.chunk_ = chunk_;
            scratch_.used_ = used_;
        }

        template <class T>
        std::span<T> take(size_t count) {
            static_assert(std::is_trivially_destructible_v<T> && alignof(T) <= alignment);
            void* bytes = scratch_.raw(count * sizeof(T));
            return {static_cast<T*>(bytes), count};
        }
        template <class T>
        std::span<T> take(size_t count, const T& value) {
            const std::span<T> out = take<T>(count);
            std::uninitialized_fill_n(out.data(), count, value);
            return out;
        }

    private:
        Scratch& scratch_;
        size_t chunk_;
        size_t used_;
    };

private:
    static constexpr size_t alignment = 16;
    struct Chunk {
        std::unique_ptr<std::byte[]> bytes;
        size_t size = 0;
    };
    void* raw(size_t bytes);

    std::vector<Chunk> chunks_;
    size_t chunk_ = 0;  ///< the chunk in use
    size_t used_ = 0;   ///< bytes of it
};

/// The calling thread's own.
Scratch& thread_scratch();

}  // namespace rb
