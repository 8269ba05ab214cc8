#pragma once
#include "language/load.h"

namespace rb {

/// A scene as a fuzzer reads it: no files, and an end after so many tokens.
inline LoadOptions fuzz_options(const unsigned char* data, size_t size) {
    LoadOptions options;
    options.input_file = "fuzz.pov";
    options.input_text = std::string(reinterpret_cast<const char*>(data), size);
    options.file_access = false;
    options.max_tokens = 20'000;
    return options;
}

}  // namespace rb
