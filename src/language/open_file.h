#pragma once
#include "language/token_file.h"

#include <cstdio>
#include <optional>
#include <string>

namespace rb {

struct OpenFile {
    enum class Mode { read, write, append };

    OpenFile() = default;
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile() { close(); }
    void close() {
        if (out) std::fclose(out);
        out = nullptr;
    }

    Mode mode = Mode::read;
    TokenFilePtr tokens;  ///< of a file open for reading
    size_t at = 0;
    std::FILE* out = nullptr;
};

}  // namespace rb
