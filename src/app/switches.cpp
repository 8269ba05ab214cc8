// POV-Ray's command line: switches, Name=value pairs, file names, and INI files (language spec 23.1 to 23.3).
#include "app/ini_options.h"
#include "base/diagnostics.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

namespace rb {

namespace {

enum class Takes { nothing, value, optional };

struct Switch {
    std::string_view name;  ///< upper case
    Takes takes;
    std::string_view option;  ///< option that gets the value
    std::string_view on_off;  ///< option that gets the sign; empty: none
};

// In the reference's order: the first whose name starts the word, and which has a value if it needs one, is
// meant.
constexpr std::array switches{
    Switch{"AC", Takes::value, "Antialias_Confidence", ""},
    Switch{"AG", Takes::value, "Antialias_Gamma", ""},
    Switch{"AM", Takes::value, "Sampling_Method", ""},
    Switch{"A0", Takes::value, "Antialias_Threshold", "Antialias"},
    Switch{"A", Takes::nothing, "", "Antialias"},
    Switch{"BM", Takes::value, "Bounding_Method", ""},
    Switch{"BS", Takes::value, "Render_Block_Size", ""},
    Switch{"B", Takes::optional, "Buffer_Size", "Buffer_Output"},
    Switch{"C", Takes::nothing, "", "Continue_Trace"},
    Switch{"D", Takes::optional, "Video_Mode", "Display"},
    Switch{"EC", Takes::value, "End_Column", ""},
    Switch{"EF", Takes::value, "Subset_End_Frame", ""},
    Switch{"EP", Takes::value, "Preview_End_Size", ""},
    Switch{"ER", Takes::value, "End_Row", ""},
    Switch{"F", Takes::optional, "Output_File_Type", "Output_To_File"},
    Switch{"GA", Takes::optional, "All_File", "All_Console"},
    Switch{"GD", Takes::optional, "Debug_File", "Debug_Console"},
    Switch{"GF", Takes::optional, "Fatal_File", "Fatal_Console"},
    Switch{"GI", Takes::value, "Create_Ini", ""},
    Switch{"GP", Takes::nothing, "", "Append_File"},
    Switch{"GR", Takes::optional, "Render_File", "Render_Console"},
    Switch{"GS", Takes::optional, "Statistic_File", "Statistic_Console"},
    Switch{"GW", Takes::optional, "Warning_File", "Warning_Console"},
    Switch{"HI", Takes::value, "Include_Header", ""},
    Switch{"HR", Takes::nothing, "", "High_Reproducibility"},
    Switch{"H", Takes::value, "Height", ""},
    Switch{"I", Takes::value, "Input_File_Name", ""},
    Switch{"J", Takes::optional, "Jitter_Amount", "Jitter"},
    Switch{"KC", Takes::nothing, "", "Cyclic_Animation"},
    Switch{"KI", Takes::value, "Initial_Clock", ""},
    Switch{"KFF", Takes::value, "Final_Frame", ""},
    Switch{"KFI", Takes::value, "Initial_Frame", ""},
    Switch{"KF", Takes::value, "Final_Clock", ""},
    Switch{"KLA", Takes::nothing, "", "Clockless_Animation"},
    Switch{"K", Takes::value, "Clock", ""},
    Switch{"L", Takes::value, "Library_Path", ""},
    Switch{"MB", Takes::optional, "Bounding_Threshold", "Bounding"},
    Switch{"MI", Takes::value, "Max_Image_Buffer_Memory", ""},
    Switch{"MV", Takes::value, "Version", ""},
    Switch{"O", Takes::value, "Output_File_Name", ""},
    Switch{"P", Takes::nothing, "", "Pause_When_Done"},
    Switch{"Q", Takes::value, "Quality", ""},
    Switch{"RFI", Takes::nothing, "", "Radiosity_From_File"},
    Switch{"RFO", Takes::nothing, "", "Radiosity_To_File"},
    Switch{"RF", Takes::value, "Radiosity_File_Name", ""},
    Switch{"RS", Takes::value, "Render_Block_Step", ""},
    Switch{"RP", Takes::value, "Render_Pattern", ""},
    Switch{"RTR", Takes::nothing, "", "Real_Time_Raytracing"},
    Switch{"RVP", Takes::nothing, "", "Radiosity_Vain_Pretrace"},
    Switch{"R", Takes::value, "Antialias_Depth", ""},
    Switch{"SC", Takes::value, "Start_Column", ""},
    Switch{"SF", Takes::value, "Subset_Start_Frame", ""},
    Switch{"SM", Takes::value, "Preview_File", ""},  // of the LEGO tools' own POV-Ray
    Switch{"SP", Takes::value, "Preview_Start_Size", ""},
    Switch{"SR", Takes::value, "Start_Row", ""},
    Switch{"STP", Takes::value, "Frame_Step", ""},
    Switch{"SU", Takes::nothing, "", "Split_Unions"},
    Switch{"TH", Takes::optional, "Dither_Method", "Dither"},
    Switch{"UA", Takes::nothing, "", "Output_Alpha"},
    Switch{"UD", Takes::nothing, "", "Draw_Vistas"},
    Switch{"UF", Takes::nothing, "", "Field_Render"},
    Switch{"UL", Takes::nothing, "", "Light_Buffer"},
    Switch{"UO", Takes::nothing, "", "Odd_Field"},
    Switch{"UR", Takes::nothing, "", "Remove_Bounds"},
    Switch{"UV", Takes::nothing, "", "Vista_Buffer"},
    Switch{"V", Takes::nothing, "", "Verbose"},
    Switch{"WL", Takes::value, "Warning_Level", ""},
    Switch{"WT", Takes::value, "Work_Threads", ""},
    Switch{"W", Takes::value, "Width", ""},
    Switch{"X", Takes::optional, "Test_Abort_Count", "Test_Abort"},
};

bool starts_with_switch(std::string_view word, std::string_view name) {
    if (word.size() < name.size()) return false;
    return std::ranges::equal(word.substr(0, name.size()), name, [](char a, char b) {
        return std::toupper(static_cast<unsigned char>(a)) == b;
    });
}

void apply_switch(Settings& settings, std::string_view word) {
    const bool on = word.front() == '+';
    const std::string_view body = word.substr(1);
    for (const Switch& s : switches) {
        if (!starts_with_switch(body, s.name)) continue;
        std::string value(body.substr(s.name.size()));
        if (s.takes == Takes::nothing && !value.empty()) continue;
        if (s.takes == Takes::value && value.empty()) continue;
        if (s.name == "A0") value.insert(0, "0");
        if (!s.on_off.empty()) set_option(settings, s.on_off, on ? "on" : "off");
        // `-F` switches the file off; a letter after it would still name a type.
        if (!s.option.empty() && !value.empty()) set_option(settings, s.option, value);
        return;
    }
    throw UsageError(fmt::format("unknown switch '{}'", word));
}

bool ends_with(std::string_view word, std::string_view ending) {
    if (word.size() < ending.size()) return false;
    return std::ranges::equal(word.substr(word.size() - ending.size()), ending, [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == b;
    });
}

std::string_view trim(std::string_view text) {
    const size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string_view unquoted(std::string_view text) {
    if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front()) {
        return text.substr(1, text.size() - 2);
    }
    return text;
}

/// Cuts a comment that starts outside quotes.
std::string_view without_comment(std::string_view line) {
    char quote = 0;
    for (size_t i = 0; i < line.size(); ++i) {
        if (quote) {
            if (line[i] == quote) quote = 0;
        } else if (line[i] == '"' || line[i] == '\'') {
            quote = line[i];
        } else if (line[i] == ';' || line[i] == '#') {
            return line.substr(0, i);
        }
    }
    return line;
}

std::string find_ini(const Settings& settings, std::string_view name) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    std::vector<std::string> names{std::string(name)};
    if (!ends_with(name, ".ini")) names.insert(names.begin(), std::string(name) + ".ini");
    for (const std::string& candidate : names) {
        if (fs::is_regular_file(candidate, ignored)) return candidate;
        for (const std::string& folder : settings.library_paths) {
            const fs::path path = fs::path(folder) / candidate;
            if (fs::is_regular_file(path, ignored)) return path.string();
        }
    }
    throw UsageError(fmt::format("cannot find INI file '{}'", name));
}

int& ini_depth() {
    static thread_local int depth = 0;
    return depth;
}

}  // namespace

std::vector<std::string> split_words(std::string_view text) {
    std::vector<std::string> words;
    std::string word;
    bool started = false;
    char quote = 0;
    for (const char c : text) {
        if (quote) {
            if (c == quote) {
                quote = 0;
            } else {
                word += c;
            }
        } else if (c == '"' || c == '\'') {
            quote = c;
            started = true;
        } else if (std::isspace(static_cast<unsigned char>(c))) {
            if (started) words.push_back(std::exchange(word, {}));
            started = false;
        } else {
            word += c;
            started = true;
        }
    }
    if (started) words.push_back(word);
    return words;
}

void apply_word(Settings& settings, std::string_view word) {
    if (word.empty()) return;
    if (word.size() > 1 && (word.front() == '+' || word.front() == '-')) {
        apply_switch(settings, word);
        return;
    }
    const size_t equals = word.find('=');
    if (equals != std::string_view::npos && equals > 0) {
        set_option(settings, word.substr(0, equals), unquoted(word.substr(equals + 1)));
        return;
    }
    if (word == "-" || ends_with(word, ".pov")) {
        set_option(settings, "Input_File_Name", word);
        return;
    }
    if (word.back() == '/') {
        set_option(settings, "Library_Path", word);
        return;
    }
    std::string_view section;
    std::string_view file = word;
    if (word.back() == ']') {
        const size_t open = word.find('[');
        if (open != std::string_view::npos) {
            file = word.substr(0, open);
            section = word.substr(open + 1, word.size() - open - 2);
        }
    }
    read_ini(settings, find_ini(settings, file), section);
}

void read_ini(Settings& settings, const std::string& path, std::string_view section) {
    std::ifstream in(path);
    if (!in) throw UsageError(fmt::format("cannot read INI file '{}'", path));
    if (ini_depth() >= 16) throw UsageError(fmt::format("{}: INI files include each other too deeply", path));
    struct Deeper {
        Deeper() { ++ini_depth(); }
        ~Deeper() { --ini_depth(); }
    } const deeper;
    settings.ini_files.push_back(path);
    bool counts = true;
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        const std::string_view text = trim(without_comment(line));
        if (text.empty()) continue;
        try {
            if (text.front() == '[') {
                const size_t close = text.find(']');
                const std::string_view name =
                    trim(text.substr(1, close == std::string_view::npos ? close : close - 1));
                counts = std::ranges::equal(name, section, [](char a, char b) {
                    return std::tolower(static_cast<unsigned char>(a)) ==
                           std::tolower(static_cast<unsigned char>(b));
                });
                continue;
            }
            if (!counts) continue;
            const size_t equals = text.find('=');
            const std::string_view key = trim(text.substr(0, equals));
            const bool is_pair = equals != std::string_view::npos && text.front() != '+' &&
                                 text.front() != '-' && key.find_first_of(" \t") == std::string_view::npos;
            if (is_pair) {
                set_option(settings, key, unquoted(trim(text.substr(equals + 1))));
            } else {
                for (const std::string& word : split_words(text)) apply_word(settings, word);
            }
        } catch (const UsageError& error) {
            throw UsageError(fmt::format("{}:{}: {}", path, number, error.what()));
        }
    }
}

void read_initial_ini(Settings& settings) {
    namespace fs = std::filesystem;
    std::vector<fs::path> candidates;
    if (const char* named = std::getenv("POVINI")) candidates.emplace_back(named);
    candidates.emplace_back("povray.ini");
    if (const char* home = std::getenv("HOME"))
        candidates.push_back(fs::path(home) / ".povray/3.7/povray.ini");
    candidates.emplace_back("/etc/povray/3.7/povray.ini");
    std::error_code ignored;
    for (const fs::path& candidate : candidates) {
        if (!fs::is_regular_file(candidate, ignored)) continue;
        read_ini(settings, candidate.string(), {});
        break;
    }
    if (const char* folder = std::getenv("POVINC")) settings.library_paths.emplace_back(folder);
}

}  // namespace rb
