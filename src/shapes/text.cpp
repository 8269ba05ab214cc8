// text { ttf "font.ttf" "string" thickness, <offset> } or text { internal n "string" thickness, <offset> }
// (manual 3.5.1.15)
#include "shapes/extrusion.h"
#include "shapes/font/font.h"
#include "shapes/registry.h"

#include <array>
#include <filesystem>

#include <fmt/format.h>

namespace rb {

namespace {

std::u32string characters(const std::string& utf8) {
    std::u32string out;
    for (size_t i = 0; i < utf8.size();) {
        const auto lead = static_cast<unsigned char>(utf8[i++]);
        const int more = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : lead >= 0xC0 ? 1 : 0;
        char32_t c = more == 0 ? lead : lead & (0x3Fu >> more);
        for (int k = 0; k < more && i < utf8.size(); ++k)
            c = (c << 6) | (static_cast<unsigned char>(utf8[i++]) & 0x3Fu);
        out += c;
    }
    return out;
}

/// The fonts that `internal` numbers are those that come with the language's files.
const FontFile& internal_font(BlockReader& in, int number, SourceRange at) {
    constexpr std::array<const char*, 3> names{"timrom.ttf", "cyrvetic.ttf", "crystal.ttf"};
    const char* name = number >= 1 && number <= 3 ? names[static_cast<size_t>(number - 1)] : "povlogo.ttf";
    for (const char* folder : {"/usr/share/fonts/truetype/povray", "/usr/share/povray-3.7/include",
                               "/usr/local/share/povray-3.7/include"}) {
        const std::filesystem::path path = std::filesystem::path(folder) / name;
        std::error_code error;
        if (std::filesystem::is_regular_file(path, error))
            return in.context().find_font(in.context(), path.string(), at);
    }
    return in.context().find_font(in.context(), name, at);
}

/// Sets the glyphs as the language does (spec: geometry 15.2). A simple glyph's left bearing is where its
/// points begin; a composite one's header counts as 0.
class Typesetter {
public:
    Typesetter(const Font& font, bool unicode, const Vec3& layout, SweptOutlines& out)
        : font_(font), unicode_(unicode), offset_(layout), thickness_(layout.z), out_(out) {}

    void set(const std::u32string& text) {
        for (size_t i = 0; i < text.size(); ++i) {
            const uint32_t index = font_.glyph_index(text[i], unicode_);
            const Glyph glyph = font_.glyph(index);
            const bool first = i == 0;
            const double least = glyph.composite ? std::min(0.0, glyph.left) : glyph.left;
            const double kern = first ? 0.0 : font_.kerning(before_, index);
            const double shift = first ? -least : glyph.left - least + kern;
            place(text[i] == U' ' ? std::vector<CurvePiece>{} : glyph.pieces, pen_ + Vec2{shift, 0.0});
            pen_.x += first ? glyph.advance - glyph.left : glyph.advance + kern;
            pen_ += offset_;
            before_ = index;
        }
    }

private:
    void place(std::vector<CurvePiece> pieces, const Vec2& at) {
        Vec2 lo = at;
        Vec2 hi = at;
        if (!pieces.empty()) {
            for (CurvePiece& piece : pieces) {
                for (Vec2& p : piece.control) p += at;
            }
            const Outline& outline = out_.outlines.emplace_back(std::move(pieces));
            lo = outline.lo();
            hi = outline.hi();
        }
        constexpr double margin = 1e-6;
        out_.extent.include({lo.x, lo.y, -margin});
        out_.extent.include({hi.x, hi.y, thickness_ + margin});
    }

    const Font& font_;
    bool unicode_;
    Vec2 offset_;
    double thickness_;
    SweptOutlines& out_;
    Vec2 pen_{0.0};
    uint32_t before_ = 0;
};

ShapePtr read(BlockReader& in) {
    const SourceRange at = in.where();
    const FontFile* file = nullptr;
    if (in.take_word("internal")) {
        file = &internal_font(in, in.integer(), at);
    } else {
        if (!in.take_word("ttf")) in.fail(fmt::format("Expected 'ttf', {} found instead", in.found()));
        file = &in.context().find_font(in.context(), in.file_name(), at);
    }
    const auto font = Font::open(file->bytes);
    if (!font) in.fail_at(at, fmt::format("Cannot open font file '{}': it is no font.", file->path));
    const std::string text = in.text();
    auto swept = std::make_shared<SweptOutlines>();
    swept->keyword = "text";
    const double thickness = in.number();
    swept->h0 = std::min(0.0, thickness);
    swept->h1 = std::max(0.0, thickness);
    swept->top_inside = true;
    swept->base_normal = -1.0;
    const Vec3 offset = in.vec3();
    Typesetter(*font, in.context().unicode, {offset.x, offset.y, thickness}, *swept).set(characters(text));
    // The language turns every text a little.
    constexpr double turn = 0.001;
    return std::make_shared<Extrusion>(std::move(swept), Transform::rotation_deg(Vec3{turn}));
}

}  // namespace

namespace shapes {
extern const ShapeKind text;
const ShapeKind text{"text", read, "text { internal 1 \"B\" 0.6, 0 }"};
}  // namespace shapes

}  // namespace rb
