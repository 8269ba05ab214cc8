#include "base/parallel.h"

#include <algorithm>

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>
#include <oneapi/tbb/task_arena.h>

namespace rb {

void parallel_for(size_t count, int threads, const std::function<void(size_t)>& body) {
    if (threads == 1) {
        for (size_t i = 0; i < count; ++i) body(i);
        return;
    }
    tbb::task_arena arena(threads > 0 ? threads : default_thread_count());
    arena.execute([&] { tbb::parallel_for(size_t{0}, count, body, tbb::simple_partitioner{}); });
}

void parallel_for(size_t count, int threads, const std::atomic<bool>& stop,
                  const std::function<void(size_t)>& body) {
    parallel_for(count, threads, [&](size_t i) {
        if (!stop.load(std::memory_order_relaxed)) body(i);
    });
}

void parallel_invoke(const std::function<void()>& a, const std::function<void()>& b) {
    tbb::parallel_invoke(a, b);
}

struct ThreadLimit::Control {
    tbb::global_control most;
};

ThreadLimit::ThreadLimit(int threads) {
    if (threads <= 0) return;
    control_ = std::make_unique<Control>(
        Control{tbb::global_control(tbb::global_control::max_allowed_parallelism,
                                    static_cast<size_t>(std::min(threads, default_thread_count())))});
}

ThreadLimit::~ThreadLimit() = default;

int default_thread_count() { return tbb::info::default_concurrency(); }

}  // namespace rb
