// Long lists read in one go give the blocks that reading them token by token gives.
#include "reading_limits.h"

#include <cstdlib>

namespace {

std::string blocks(const rb::LoadOptions& options, bool& done) {
    rb::SourceMap sources;
    rb::Diagnostics diagnostics;
    std::string out = rb::dump_blocks(options, sources, diagnostics);
    done = diagnostics.error_count() == 0;
    return out;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    rb::LoadOptions options = rb::fuzz_options(data, size);
    bool fast_done = false;
    bool slow_done = false;
    const std::string fast = blocks(options, fast_done);
    options.number_runs = false;
    options.max_tokens *= 10;
    const std::string slow = blocks(options, slow_done);
    if (fast_done && slow_done && fast != slow) std::abort();
    return 0;
}
