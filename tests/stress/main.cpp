// The numerical stress suite. usage: stress [--share S] [--from S] [--case PART_OF_NAME] [--solid NAME]
// [FAMILY ...]; share 1 (all) is hours, 0.001 is the everyday run; `from` leaves out what a run with that
// share has tried, `solid` the rays of all other solids. Exit code 1 if anything failed.
#include "base/parallel.h"
#include "stress.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>
#include <vector>

#include <fmt/format.h>

namespace rb::stress {

void Table::run(const std::string& what, uint64_t count, const std::function<Trial(Dice&)>& trial) {
    if (!is_wanted(what)) return;
    constexpr uint64_t block = 256;
    const auto begin = static_cast<uint64_t>(done_ * static_cast<double>(count));
    std::mutex lock;
    uint64_t tried = 0;
    uint64_t failed = 0;
    uint64_t first_at = count;
    std::string first;
    std::map<std::string, uint64_t> by_name;
    parallel_for((count - begin + block - 1) / block, 0, [&](size_t b) {
        uint64_t block_tried = 0;
        uint64_t block_failed = 0;
        uint64_t block_first = count;
        std::string text;
        std::map<std::string, uint64_t> names;
        const uint64_t first_of_block = begin + b * block;
        for (uint64_t i = first_of_block; i < std::min(first_of_block + block, count); ++i) {
            Dice dice(i);
            Trial result = trial(dice);
            block_tried += result.counts ? 1 : 0;
            if (result.failure.empty()) continue;
            ++names[result.failure.substr(0, result.failure.find(':'))];
            if (block_failed++ == 0) {
                block_first = i;
                text = std::move(result.failure);
            }
        }
        const std::lock_guard guard(lock);
        tried += block_tried;
        failed += block_failed;
        for (const auto& [name, n] : names) by_name[name] += n;
        if (block_first < first_at) {
            first_at = block_first;
            first = text;
        }
    });
    if (by_name.size() > 1) {
        first += "  all:";
        for (const auto& [name, n] : by_name) first += fmt::format(" {} {}", name, n);
    }
    print(what, tried, failed, first);
}

void Table::run_listed(const std::string& what, size_t count, const std::function<Trial(size_t)>& trial) {
    if (!is_wanted(what)) return;
    uint64_t failed = 0;
    std::string first;
    for (size_t i = 0; i < count; ++i) {
        const Trial result = trial(i);
        if (result.failure.empty()) continue;
        if (failed++ == 0) first = result.failure;
    }
    print(what, count, failed, first);
}

void Table::print(const std::string& what, uint64_t tried, uint64_t failed, const std::string& first) {
    fmt::print("  {:<44} {:>12} {:>9}{}{}\n", what, tried, failed, first.empty() ? "" : "  first: ", first);
    std::fflush(stdout);
    failures_ += failed;
}

}  // namespace rb::stress

int main(int argc, char** argv) {
    using namespace rb::stress;
    constexpr std::array<const Family*, 5> families{&solvers, &leaks, &placement, &hard_cases, &specks};
    Effort effort;
    double from = 0.0;
    std::string_view wanted_case;
    std::vector<std::string_view> wanted;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--share" && i + 1 < argc) {
            effort.share = std::strtod(argv[++i], nullptr);
        } else if (word == "--from" && i + 1 < argc) {
            from = std::strtod(argv[++i], nullptr);
        } else if (word == "--case" && i + 1 < argc) {
            wanted_case = argv[++i];
        } else if (word == "--solid" && i + 1 < argc) {
            effort.solid = argv[++i];
        } else {
            wanted.push_back(word);
        }
    }
    if (!(from >= 0.0 && from < effort.share)) {
        fmt::print(stderr, "--from must be below the share\n");
        return 2;
    }
    for (const std::string_view name : wanted) {
        if (std::ranges::find(families, name, &Family::name) != families.end()) continue;
        fmt::print(stderr, "no family {}\n", name);
        return 2;
    }
    uint64_t failures = 0;
    for (const Family* family : families) {
        if (!wanted.empty() && std::ranges::find(wanted, family->name) == wanted.end()) continue;
        fmt::print("{} ({})\n  {:<44} {:>12} {:>9}\n", family->title, family->name, "case", "tried",
                   "failed");
        const auto start = std::chrono::steady_clock::now();
        Table table(wanted_case, from / effort.share);
        family->run(effort, table);
        failures += table.failures();
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
        fmt::print("  {} failures, {:.1f} s\n\n", table.failures(), spent.count());
    }
    fmt::print("{} failures at share {}\n", failures, effort.share);
    return failures == 0 ? 0 : 1;
}
