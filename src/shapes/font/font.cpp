#include "shapes/font/font.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include FT_TRUETYPE_TABLES_H

namespace rb {

struct Font::Face {
    std::shared_ptr<const std::string> file;
    FT_Library library = nullptr;
    FT_Face face = nullptr;

    ~Face() {
        if (face) FT_Done_Face(face);
        if (library) FT_Done_FreeType(library);
    }
    double em() const { return face->units_per_EM > 0 ? face->units_per_EM : 1.0; }
};

Font::Font(std::unique_ptr<Face> face) : face_(std::move(face)) {}
Font::Font(Font&&) noexcept = default;
Font::~Font() = default;

std::optional<Font> Font::open(std::shared_ptr<const std::string> file) {
    auto face = std::make_unique<Face>();
    face->file = std::move(file);
    if (FT_Init_FreeType(&face->library) != 0) return std::nullopt;
    const auto* const bytes = reinterpret_cast<const FT_Byte*>(face->file->data());
    const auto size = static_cast<FT_Long>(face->file->size());
    if (FT_New_Memory_Face(face->library, bytes, size, 0, &face->face) != 0) return std::nullopt;
    if (!FT_IS_SCALABLE(face->face)) return std::nullopt;
    return Font(std::move(face));
}

uint32_t Font::glyph_index(char32_t character, bool unicode) const {
    const FT_Face face = face_->face;
    constexpr std::array<int, 3> old_order{1, 3, 0};
    constexpr std::array<int, 3> unicode_order{0, 3, 1};
    for (const int platform : unicode ? unicode_order : old_order) {
        for (int i = 0; i < face->num_charmaps; ++i) {
            const FT_CharMap map = face->charmaps[i];
            if (map->platform_id != platform) continue;
            const FT_Long format = FT_Get_CMap_Format(map);
            if (format != 0 && format != 4 && format != 6) continue;
            FT_Set_Charmap(face, map);
            // Symbol fonts keep their characters in a private area.
            constexpr char32_t symbols = 0xF000;
            const FT_UInt index = FT_Get_Char_Index(face, character);
            if (index != 0 || character >= 0x100) return index;
            return FT_Get_Char_Index(face, character + symbols);
        }
    }
    return 0;
}

double Font::kerning(uint32_t left, uint32_t right) const {
    FT_Vector kern{};
    if (!FT_HAS_KERNING(face_->face)) return 0.0;
    if (FT_Get_Kerning(face_->face, left, right, FT_KERNING_UNSCALED, &kern) != 0) return 0.0;
    return static_cast<double>(kern.x) / face_->em();
}

namespace {

/// Turns one contour's points, on and off the curve, into pieces.
class Contour {
public:
    Contour(const FT_Outline& outline, int first, int last, double em) {
        for (int i = first; i <= last; ++i) {
            const FT_Vector& p = outline.points[i];
            points_.push_back({{static_cast<double>(p.x) / em, static_cast<double>(p.y) / em},
                               FT_CURVE_TAG(outline.tags[i])});
        }
        start_on_curve();
    }

    void add_to(std::vector<CurvePiece>& pieces) const {
        if (points_.size() < 2) return;
        Vec2 pen = points_.front().at;
        for (size_t i = 1; i <= points_.size();) {
            const Point& p = point(i);
            if (p.tag == FT_CURVE_TAG_ON) {
                if (p.at != pen) pieces.push_back({{pen, p.at}, 1});
                pen = p.at;
                ++i;
            } else if (p.tag == FT_CURVE_TAG_CONIC) {
                const Point& next = point(i + 1);
                const bool on = next.tag == FT_CURVE_TAG_ON;
                const Vec2 end = on ? next.at : 0.5 * (p.at + next.at);
                pieces.push_back({{pen, p.at, end}, 2});
                pen = end;
                i += on ? 2 : 1;
            } else {
                pieces.push_back({{pen, p.at, point(i + 1).at, point(i + 2).at}, 3});
                pen = point(i + 2).at;
                i += 3;
            }
        }
    }

private:
    struct Point {
        Vec2 at;
        int tag;
    };
    const Point& point(size_t i) const { return points_[i % points_.size()]; }

    void start_on_curve() {
        size_t i = 0;
        while (i < points_.size() && points_[i].tag != FT_CURVE_TAG_ON) ++i;
        if (i < points_.size()) {
            std::rotate(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(i), points_.end());
        } else if (!points_.empty()) {
            points_.insert(points_.begin(),
                           {0.5 * (points_.front().at + points_.back().at), FT_CURVE_TAG_ON});
        }
    }

    std::vector<Point> points_;
};

}  // namespace

Glyph Font::glyph(uint32_t index) const {
    const FT_Face face = face_->face;
    Glyph glyph;
    if (FT_Load_Glyph(face, index, FT_LOAD_NO_SCALE | FT_LOAD_NO_RECURSE) == 0)
        glyph.composite = face->glyph->format == FT_GLYPH_FORMAT_COMPOSITE;
    if (FT_Load_Glyph(face, index, FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING) != 0) return glyph;
    const double em = face_->em();
    glyph.advance = static_cast<double>(face->glyph->metrics.horiAdvance) / em;
    if (face->glyph->format != FT_GLYPH_FORMAT_OUTLINE) return glyph;
    const FT_Outline& outline = face->glyph->outline;
    int first = 0;
    for (int i = 0; i < outline.n_contours; ++i) {
        Contour(outline, first, outline.contours[i], em).add_to(glyph.pieces);
        first = outline.contours[i] + 1;
    }
    for (int i = 0; i < outline.n_points; ++i) {
        const double x = static_cast<double>(outline.points[i].x) / em;
        glyph.left = i == 0 ? x : std::min(glyph.left, x);
    }
    return glyph;
}

}  // namespace rb
