#pragma once
#include "tests/geometry/shape_cases.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace rb::stress {

/// How much of the full run to do.
struct Effort {
    double share = 1;        ///< 1 is all of it
    std::string_view solid;  ///< leaks: the only one whose rays are followed; empty: all
    /// At least one.
    uint64_t of(double full) const { return static_cast<uint64_t>(std::max(1.0, full * share)); }
};

/// What one trial came to.
struct Trial {
    bool counts = true;   ///< false: the dice gave nothing to try (a ray that missed)
    std::string failure;  ///< empty: passed

    static Trial nothing() { return {false, {}}; }
};

/// Prints a row for each kind of case: tried, failed, and the first failure (of the lowest number).
class Table {
public:
    /// Only cases whose name contains `wanted` are run, without the first part of their trials (a share of
    /// them), which an earlier run has done.
    Table(std::string_view wanted, double done) : wanted_(wanted), done_(done) {}

    /// Runs `trial` with the numbers up to `count` on all threads, with dice seeded by the trial's number:
    /// the same cases whatever the number of threads.
    void run(const std::string& what, uint64_t count, const std::function<Trial(Dice&)>& trial);
    /// The same for cases that stand in a list.
    void run_listed(const std::string& what, size_t count, const std::function<Trial(size_t)>& trial);

    uint64_t failures() const { return failures_; }

private:
    bool is_wanted(const std::string& what) const { return what.find(wanted_) != std::string::npos; }
    void print(const std::string& what, uint64_t tried, uint64_t failed, const std::string& first);

    std::string_view wanted_;
    double done_;
    uint64_t failures_ = 0;
};

/// One kind of stress; each has its own file.
struct Family {
    std::string_view name;
    std::string_view title;
    void (*run)(const Effort& effort, Table& table);
};

extern const Family solvers;
extern const Family leaks;
extern const Family placement;
extern const Family hard_cases;
extern const Family specks;

}  // namespace rb::stress
