#pragma once
#include "app/settings.h"

#include <filesystem>
#include <string>
#include <vector>

namespace rb {

/// Where a scene may write: below the current directory, the picture's directory, the temporary ones, and
/// what
/// --allow-write names. Links are followed before the comparison.
class WriteAccess {
public:
    explicit WriteAccess(const Settings& settings);
    bool allows(const std::string& path) const;

private:
    std::vector<std::filesystem::path> roots_;
};

}  // namespace rb
