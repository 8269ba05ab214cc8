// Long lists read in one go give the blocks that reading them token by token gives.
#include "reading_limits.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace {

/// Every number on a line of its own: how many of them share an item makes no difference.
std::string apart(const std::string& blocks) {
    constexpr std::string_view word = "numbers ";
    std::string out;
    std::istringstream lines(blocks);
    for (std::string line; std::getline(lines, line); out += '\n') {
        const size_t start = line.find_first_not_of(' ');
        const bool is_list = start != std::string::npos && line.compare(start, word.size(), word) == 0;
        if (is_list)
            std::replace(line.begin() + static_cast<ptrdiff_t>(start + word.size()), line.end(), ' ', '\n');
        out += is_list ? line.substr(start + word.size()) : line;
    }
    return out;
}

std::string blocks(const rb::LoadOptions& options, bool& done) {
    rb::SourceMap sources;
    rb::Diagnostics diagnostics;
    std::string out = apart(rb::dump_blocks(options, sources, diagnostics));
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
