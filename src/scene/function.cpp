#include "scene/function.h"

#include <vector>

namespace rb {

void Function::evaluate_rows(std::span<const double* const> arguments, std::span<double> results) const {
    const auto count = static_cast<size_t>(result_count());
    std::vector<double> all(count * results.size());
    evaluate_all_rows(arguments, all);
    for (size_t i = 0; i < results.size(); ++i) results[i] = all[count * i];
}

void Function::evaluate_all_rows(std::span<const double* const> arguments, std::span<double> results) const {
    std::vector<double> row(arguments.size());
    const auto count = static_cast<size_t>(result_count());
    for (size_t i = 0; count * i < results.size(); ++i) {
        for (size_t k = 0; k < row.size(); ++k) row[k] = arguments[k][i];
        evaluate(row, results.subspan(count * i, count));
    }
}

Interval Function::bound(std::span<const Interval>, int) const { return Interval::everything(); }

IntervalSlope Function::bound_slope(std::span<const IntervalSlope> arguments, int component) const {
    std::vector<Interval> values;
    for (const IntervalSlope& a : arguments) values.push_back(a.value);
    return IntervalSlope::jumping(bound(values, component));
}

}  // namespace rb
