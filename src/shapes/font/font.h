#pragma once
#include "shapes/outline.h"

#include <memory>
#include <optional>
#include <string>

namespace rb {

/// One character's shape in units of the em, as the font file places it: the pen at x = 0, the baseline y =
/// 0.
struct Glyph {
    std::vector<CurvePiece> pieces;
    double left = 0;     ///< least x of the points; 0 without any
    double advance = 0;  ///< how far the pen goes on
    bool composite = false;
};

/// Outlines from a TrueType or OpenType file, through FreeType, unhinted.
class Font {
public:
    /// Empty if the file's bytes, which are kept, are no font. Of a collection the first font.
    static std::optional<Font> open(std::shared_ptr<const std::string> file);
    Font(Font&&) noexcept;
    ~Font();

    /// The font's number for a character, 0 if it has none. `unicode`: the character map of that platform is
    /// tried first, else the Macintosh one (spec: geometry 15.4).
    uint32_t glyph_index(char32_t character, bool unicode) const;
    Glyph glyph(uint32_t index) const;
    /// What is added to the advance between two glyphs, in em.
    double kerning(uint32_t left, uint32_t right) const;

private:
    struct Face;
    explicit Font(std::unique_ptr<Face> face);
    std::unique_ptr<Face> face_;
};

}  // namespace rb
