#pragma once
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace rb {

/// Bytes [begin, end) of one loaded file. File 0 is "nowhere" (built-in values, command line).
struct SourceRange {
    uint32_t file = 0;
    uint32_t begin = 0;
    uint32_t end = 0;

    bool known() const { return file != 0; }
    friend bool operator==(const SourceRange&, const SourceRange&) = default;
};

/// The smallest range that holds both; `b` is ignored when it lies in another file.
SourceRange cover(SourceRange a, SourceRange b);

/// 1-based line and column (columns count bytes, tabs count as one).
struct LineColumn {
    uint32_t line = 0;
    uint32_t column = 0;
};

/// Keeps the text of every loaded file, so that a place can be shown to the user long after parsing.
/// Lines are found only when something is printed.
class SourceMap {
public:
    /// Takes the text over and returns the file's number (1, 2, ...). Views of the text stay valid.
    uint32_t add(std::string name, std::string text);

    std::string_view name(uint32_t file) const;
    std::string_view text(uint32_t file) const;
    LineColumn position(uint32_t file, uint32_t offset) const;
    /// The line that holds `offset`, without its line end.
    std::string_view line_at(uint32_t file, uint32_t offset) const;
    size_t file_count() const { return files_.size(); }

private:
    struct File {
        std::string name;
        std::string text;
    };
    std::deque<File> files_;
};

}  // namespace rb
