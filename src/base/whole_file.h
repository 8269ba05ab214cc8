#pragma once
#include <optional>
#include <string>

namespace rb {

/// The bytes of a regular file of less than 4 GB; nothing if it cannot be read.
std::optional<std::string> read_whole_file(const std::string& path);

}  // namespace rb
