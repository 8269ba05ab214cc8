#pragma once
#include "language/load.h"

#include <string>
#include <string_view>
#include <vector>

namespace rb {

/// What reading a text as a scene gave.
struct Reading {
    bool done = false;
    std::string debug;                  ///< text of #debug
    std::vector<std::string> errors;    ///< "line: message"
    std::vector<std::string> warnings;  ///< messages
    std::string report;                 ///< everything as the user sees it
    Scene scene;
};

Reading read_scene(std::string_view text, LoadOptions options = {});

/// With the header that the measured probes have, and an object at the end.
Reading read_probe(std::string_view text);

/// The first error of such a text, without its line; empty if there is none.
std::string first_error(std::string_view text);

/// The numbers that `expressions` (comma separated) have in the language, behind `declarations`.
std::vector<double> values_of(std::string_view declarations, std::string_view expressions);

}  // namespace rb
