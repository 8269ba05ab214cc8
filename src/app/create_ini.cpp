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

/// The letter of Output_File_Type; none for what only -o can ask for.
std::string_view letter_of(FileType type) {
    switch (type) {
        case FileType::png:
            return "N";
        case FileType::ppm:
            return "P";
        case FileType::tga:
            return "C";
        case FileType::tga_uncompressed:
            return "T";
        case FileType::jpeg:
            return "J";
        case FileType::bmp:
            return "B";
        case FileType::exr:
            return "E";
        case FileType::hdr:
            return "H";
        case FileType::tiff:
            return "";
    }
    return "";
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
    // -o decides the type without an option of its own.
    const std::string_view letter = letter_of(settings.file_type);
    const bool is_said = std::ranges::any_of(options, [&](const auto& option) {
        return option.first == "output_file_type" && spelled(option.second).starts_with(letter);
    });
    if (!is_said && !letter.empty()) {
        std::erase_if(options, [](const auto& option) { return option.first == "output_file_type"; });
        options.emplace_back("output_file_type", letter);
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
