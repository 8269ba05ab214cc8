#include "app/create_ini.h"

#include "app/write_access.h"
#include "base/diagnostics.h"

#include <algorithm>
#include <cctype>
#include <fstream>

#include <fmt/format.h>

namespace rb {

namespace {

/// `output_file_name` as users write it.
std::string spelled(std::string key) {
    bool starts = true;
    for (char& c : key) {
        if (starts) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        starts = c == '_';
    }
    return key;
}

bool is_list(std::string_view key) { return key == "library_path" || key == "declare"; }

}  // namespace

void create_ini(const Settings& settings) {
    if (settings.create_ini.empty()) return;
    if (!WriteAccess(settings).allows(settings.create_ini)) {
        throw IoError(fmt::format("writing to {} is not allowed: see --allow-write", settings.create_ini));
    }
    std::vector<std::pair<std::string, std::string>> options;
    for (const auto& [key, value] : settings.given) {
        const auto before = std::ranges::find(options, key, &std::pair<std::string, std::string>::first);
        if (before == options.end() || is_list(key)) {
            options.emplace_back(key, value);
        } else {
            before->second = value;
        }
    }
    std::ranges::stable_sort(options, {}, &std::pair<std::string, std::string>::first);
    std::ofstream out(settings.create_ini);
    for (const auto& [key, value] : options) {
        const bool quotes = key != "declare" && value.find_first_of(" ;#") != std::string::npos;
        out << spelled(key) << '=' << (quotes ? "\"" + value + "\"" : value) << '\n';
    }
    if (!out.flush()) throw IoError(fmt::format("cannot write '{}'", settings.create_ini));
}

}  // namespace rb
