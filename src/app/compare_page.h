#pragma once
#include "app/scene_comparison.h"

#include <string>
#include <vector>

namespace rb {

/// One HTML file with nothing outside it: a row for each scene with both pictures, their difference and all
/// figures; a click on a column's head sorts by it. Throws IoError.
void write_compare_page(const std::vector<ComparedScene>& scenes, const std::string& summary,
                        const std::string& path);

/// The same figures as a table with tabs. Throws IoError.
void write_compare_table(const std::vector<ComparedScene>& scenes, const std::string& path);

}  // namespace rb
