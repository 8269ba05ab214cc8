#pragma once
#include "app/settings.h"

#include <string_view>

namespace rb {

/// Sets one option by its INI name (`Width`, `Antialias_Threshold`, any case). Throws UsageError for an
/// unknown name or a value that does not fit.
void set_option(Settings& settings, std::string_view name, std::string_view value);

/// Carries out one word of POV-Ray's command line: `+W640`, `-D`, `Width=640`, `scene.pov`,
/// `file.ini[section]`, `dir/`.
void apply_word(Settings& settings, std::string_view word);

/// Reads an INI file; statements before the first section always count, those of `section` if it is named.
/// Nested Include_Ini up to 16 deep. Throws UsageError with file and line.
void read_ini(Settings& settings, const std::string& path, std::string_view section);

/// The INI file that every run starts with, if any exists: POVINI, ./povray.ini, ~/.povray/3.7/povray.ini,
/// /etc/povray/3.7/povray.ini; then POVINC as a library path (language spec 23.1).
void read_initial_ini(Settings& settings);

/// Splits at blanks outside quotes and strips one pair of quotes, as the reference treats each argument.
std::vector<std::string> split_words(std::string_view text);

}  // namespace rb
