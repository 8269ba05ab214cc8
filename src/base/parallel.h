#pragma once
#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>

namespace rb {

/// Runs `body(i)` for i in [0, count) on up to `threads` threads (0: all that the machine grants); the order
/// of calls is unspecified. An exception thrown by a body stops the rest and is thrown again here. The home
/// of oneTBB.
void parallel_for(size_t count, int threads, const std::function<void(size_t)>& body);

/// The same; what has not begun when `stop` becomes true is left out.
void parallel_for(size_t count, int threads, const std::atomic<bool>& stop,
                  const std::function<void(size_t)>& body);

/// Runs both, possibly at the same time, and waits for both. May be nested.
void parallel_invoke(const std::function<void()>& a, const std::function<void()>& b);

/// While it lives, parallel_invoke, too, uses at most so many threads (0: all that the machine grants).
class ThreadLimit {
public:
    explicit ThreadLimit(int threads);
    ~ThreadLimit();

private:
    struct Control;
    std::unique_ptr<Control> control_;
};

/// Number of threads that parallel_for uses for `threads` = 0: cores that this process may run on.
int default_thread_count();

}  // namespace rb
