#include "patterns/pavement_tables.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace rb {

namespace {

using Repeat = PavementLayout::Repeat;

/// No shift: `lines` rows of `length` cells.
constexpr Repeat rows(int length, int lines) { return {false, length, lines, 0, 1, lines}; }
/// One list of cells that serves every row, each shifted by `shift` against the one before.
constexpr Repeat sheared(int length, int shift, int period) { return {false, length, 1, shift, 1, period}; }
constexpr Repeat shifted_rows(int length, int lines, int shift, int step, int period) {
    return {false, length, lines, shift, step, period};
}
/// Columns that shift up after every `lines`.
constexpr Repeat shifted_columns(int length, int lines, int shift, int period) {
    return {true, length, lines, shift, lines, period};
}

// Masks in hexadecimal; of sides 6 by the letters of `letter_masks`.
// clang-format off
constexpr PavementLayout layouts[] = {
    {3, 1, 1, rows(1, 1), "007"},
    {3, 2, 1, rows(1, 1), "166"},
    {3, 3, 1, sheared(6, 3, 2), "215 344 126 126 344 215"},
    {3, 4, 1, shifted_rows(4, 2, 1, 1, 4), "126 126 144 144 126 126 144 144"},
    {3, 4, 2, shifted_rows(4, 2, 1, 1, 4), "611 344 126 423 611 344 126 423"},
    {3, 4, 3, shifted_rows(4, 2, 1, 1, 4), "005 000 006 003 000 005 003 006"},
    {3, 5, 1, sheared(10, 5, 2), "215 244 004 144 126 126 144 004 244 215"},
    {3, 5, 2, sheared(10, 5, 2), "215 244 244 611 611 244 244 215 423 423"},
    {3, 5, 3, sheared(10, 5, 2), "146 126 344 611 611 344 126 146 522 522"},
    {3, 5, 4, sheared(10, 3, 10), "005 000 244 215 003 003 215 244 000 005"},
    {3, 6, 1, sheared(6, 5, 6), "215 244 004 004 244 215 215 244 004 004 244 215"},
    {3, 6, 2, sheared(6, 5, 6), "413 522 144 004 244 215 413 522 144 004 244 215"},
    {3, 6, 3, sheared(6, 3, 2), "003 126 144 000 244 215 003 126 144 000 244 215"},
    {3, 6, 4, shifted_rows(6, 2, 14, 2, 6), "215 244 004 000 006 003 004 244 215 003 006 000"},
    {3, 6, 5, shifted_rows(6, 2, 8, 2, 6), "005 000 244 215 245 211 005 211 245 215 244 000"},
    {3, 6, 6, rows(6, 2), "245 211 215 244 244 211 245 211 244 244 215 211"},
    {3, 6, 7, shifted_rows(4, 3, -1, 3, 12), "215 244 244 611 522 146 146 522 611 244 244 215"},
    {3, 6, 8, shifted_rows(4, 3, -1, 3, 12), "005 000 244 215 146 122 122 146 215 244 000 005"},
    {3, 6, 9, shifted_rows(6, 2, 8, 2, 6), "005 000 006 126 344 211 005 211 344 126 006 000"},
    {3, 6, 10, sheared(6, 5, 6), "215 344 122 122 344 215 215 344 122 122 344 215"},
    {3, 6, 11, sheared(6, 3, 2), "005 000 006 006 000 005 006 000 005 005 000 006"},
    {3, 6, 12, sheared(6, 3, 2), "691 3C4 5A2 5A2 3C4 691 5A2 3C4 691 691 3C4 5A2"},
    {4, 1, 1, rows(1, 1), "0F"},
    {4, 2, 1, rows(1, 2), "0E 0B"},
    {4, 3, 1, rows(3, 2), "0D 05 07 0D 05 07"},
    {4, 3, 2, rows(3, 2), "0E 0D 16 49 07 0B"},
    {4, 4, 1, rows(4, 4), "0D 05 05 07 0D 05 05 07 0D 05 05 07 0D 05 05 07"},
    {4, 4, 2, rows(4, 4), "0E 0D 05 16 49 05 07 0B 0E 0D 05 16 49 05 07 0B"},
    {4, 4, 3, rows(4, 4), "0D 34 07 0B 07 0B 0D 34 0D 34 07 0B 07 0B 0D 34"},
    {4, 4, 4, rows(4, 4), "0C 06 0C 06 09 03 09 03 0C 06 0C 06 09 03 09 03"},
    {4, 4, 5, rows(4, 4), "07 2C 07 2C 0D 83 0D 83 2C 07 2C 07 83 0D 83 0D"},
    {4, 5, 1, rows(5, 2), "0D 05 05 05 07 0D 05 05 05 07"},
    {4, 5, 2, rows(5, 2), "0E 0D 05 05 16 49 05 05 07 0B"},
    {4, 5, 3, shifted_rows(5, 2, 3, 2, 10), "07 0C 06 0C 24 0D 81 03 09 03"},
    {4, 5, 4, sheared(5, 2, 5), "0D 05 34 07 0B"},
    {4, 5, 5, sheared(5, 2, 5), "0D F0 07 0B 0E"},
    {4, 5, 6, sheared(10, 1, 10), "0E 0A 49 05 07 0D 05 16 0A 0B"},
    {4, 5, 7, sheared(10, 1, 10), "0B 0E 49 16 49 07 0D 16 49 16"},
    {4, 5, 8, sheared(10, 3, 10), "2C 05 16 0B 0E 0B 0E 49 05 83"},
    {4, 5, 9, sheared(10, 1, 10), "0E 49 05 16 0B 0E 49 05 16 0B"},
    {4, 5, 10, shifted_rows(5, 2, 3, 2, 10), "0E 0D C1 16 0B 49 34 07 0B 0E"},
    {4, 5, 11, shifted_rows(5, 2, 4, 2, 10), "07 2C 05 07 2C 0D 83 0D 05 83"},
    {4, 5, 12, sheared(10, 8, 10), "0D 34 07 0D C1 07 0A 0B 0E 0A"},
    {4, 6, 1, rows(6, 2), "0D 05 05 05 05 07 0D 05 05 05 05 07"},
    {4, 6, 2, rows(6, 2), "2C 05 05 05 07 0E 0B 0D 05 05 05 83"},
    {4, 6, 3, rows(6, 2), "0D 34 05 05 07 0E 07 0B 0D 05 05 C1"},
    {4, 6, 4, rows(6, 2), "0D 05 34 05 07 0E 05 07 0B 0D 05 C1"},
    {4, 6, 5, sheared(6, 5, 6), "0D 83 2C 05 05 07"},
    {4, 6, 6, rows(6, 2), "0C 24 05 07 0C 06 09 03 0D 05 81 03"},
    {4, 6, 7, rows(6, 2), "07 0C 06 0D 14 24 0D 81 41 07 09 03"},
    {4, 6, 8, sheared(6, 5, 6), "0D 05 83 2C 05 07"},
    {4, 6, 9, rows(6, 2), "07 0C 24 07 0C 24 0D 81 03 0D 81 03"},
    {4, 6, 10, rows(6, 2), "0C 04 06 0C 04 06 09 01 03 09 01 03"},
    {4, 6, 11, rows(4, 3), "0E 0D 14 06 48 06 09 12 09 41 07 0B"},
    {4, 6, 12, sheared(6, 1, 6), "0D 05 16 49 16 0B"},
    {4, 6, 13, rows(4, 3), "0D 34 05 16 0E 0B 0E 0B 49 05 C1 07"},
    {4, 6, 14, rows(3, 4), "0D 34 07 16 0A 0D 0A 49 07 C1 07 0D"},
    {4, 6, 15, shifted_rows(3, 2, 2, 2, 6), "0D 14 82 0E 09 03"},
    {4, 6, 16, shifted_columns(3, 2, 1, 6), "0E 0D D0 06 09 03"},
    {4, 6, 17, shifted_rows(6, 2, 1, 2, 12), "0D F0 05 07 0E 0B 0E 0B 0D 05 F0 07"},
    {4, 6, 18, shifted_rows(6, 2, 1, 2, 12), "0E 0B 0D 05 05 92 68 05 05 07 0E 0B"},
    {4, 6, 19, sheared(6, 1, 6), "0E 49 05 16 0A 0B"},
    {4, 6, 20, sheared(6, 5, 6), "0B 2C 05 05 83 0E"},
    {4, 6, 21, sheared(6, 5, 6), "0B 0A 2C 05 05 07"},
    {4, 6, 22, rows(4, 3), "2C 05 05 16 0B 0E 0E 0B 05 83 49 05"},
    {4, 6, 23, rows(4, 3), "0A 0D C1 16 49 34 07 0A 0E 0B 0E 0B"},
    {4, 6, 24, shifted_rows(6, 2, 4, 2, 12), "0D 16 0D 05 92 0B 0E 68 05 07 49 07"},
    {4, 6, 25, rows(4, 3), "0D 16 0D 16 16 49 16 49 49 07 49 07"},
    {4, 6, 26, rows(4, 3), "0C 06 0C 06 09 12 09 12 07 49 07 49"},
    {4, 6, 27, rows(4, 3), "2C 07 2C 07 92 0D 92 0D 49 07 49 07"},
    {4, 6, 28, sheared(6, 1, 6), "0E 49 05 16 49 07"},
    {4, 6, 29, shifted_rows(6, 2, 4, 2, 12), "0D 16 0B 0E 49 07 16 49 05 83 2C 05"},
    {4, 6, 30, shifted_rows(6, 2, 3, 2, 4), "07 0E 49 34 07 49 0D C1 16 0B 0D 16"},
    {4, 6, 31, shifted_rows(6, 2, 3, 2, 4), "2C 05 C1 07 0E 0B 0B 0D 34 05 83 0E"},
    {4, 6, 32, sheared(6, 4, 3), "0E 0B 0D 34 C1 07"},
    {4, 6, 33, rows(3, 4), "0D 05 16 2C 07 0A 0A 0D 83 49 05 07"},
    {4, 6, 34, sheared(12, 7, 12), "2C C1 05 07 0E 0B 0E 0B 0D 05 34 83"},
    {4, 6, 35, shifted_rows(4, 3, 2, 3, 6), "0A 0D 05 92 68 05 07 0A 0B 0E 0E 0B"},
    {6, 1, 1, sheared(6, 3, 2), "abccba"},
    {6, 2, 1, rows(6, 2), "abggbacikkic"},
    {6, 3, 1, rows(6, 6), "abccbacbadefdeffedfeddefdeffedfedabc"},
    {6, 3, 2, shifted_columns(6, 6, 2, 18), "abggbacimnnfajmoodcbhhbcdoomjafnnmic"},
    {6, 3, 3, rows(18, 2), "abggbhhbccikkqlljacikkqlljaabggbhhbc"},
    {6, 4, 1, rows(6, 8), "abccbacbadefdeffedfeddefdeffedfeddefdeffedfedabc"},
    {6, 4, 2, shifted_columns(8, 6, 2, 12), "ajmopnmjahbgmicgbhcimnpoajmopnmjahbgmicgbhcimnpo"},
    {6, 4, 3, rows(12, 2), "ajllqkkqlljacbhhbggbhhbcajllqkkqlljacbhhbggbhhbc"},
    {6, 4, 4, shifted_columns(8, 6, -2, 24), "abcfedgbaabckicgbacikkicdescikfeddesdeffedfeddef"},
    {6, 4, 5, shifted_columns(8, 6, -2, 24), "abgcikljadeshbcfercbhajlajlljagbarefkicsedcikkic"},
    {6, 4, 6, shifted_columns(8, 6, -2, 24), "abcsedcimnnfajmoodcbhhbcdoomjafnnmicdescbafeddef"},
    {6, 4, 7, rows(12, 4), "abcgbarescbhlqkkicfedajlrescbhabcgbafedajllqkkic"},
    {6, 5, 1, rows(6, 10), "abccbacbadefdeffedfeddefdeffedfeddefdeffedfeddefdeffedfedabc"},
    {6, 5, 2, shifted_columns(10, 6, -2, 30), "kicgbacikkicdescikfeddesdeffedfeddefdeffedfeddefabcfedgbaabc"},
    {6, 5, 3, rows(6, 10), "abggbacimnnfajmoodcbarefdeffedfeddefdeffedferabcdoomjafnnmic"},
    {6, 5, 4, rows(6, 10), "abcsedcimnnfajmoodcbarefdeffedferabcdoomjafnnmicdescbafeddef"},
    {6, 5, 5, shifted_columns(10, 6, -2, 30), "kicsedcikkicdescikfeddesdeffedfeddefabcfedcbaabcdefcbaseddef"},
    {6, 5, 6, rows(6, 10), "abggbacimnnfdoppodfnnmicdescbafeddefabcsedcimnnfdoppodfnnmic"},
    {6, 5, 7, rows(6, 10), "ajmoodcbhhbcdoomjafnppnfdoppodfnnmicabggbacimnnfdoppodfnppnf"},
    {6, 5, 8, shifted_columns(20, 3, -7, 60), "kiccimajmmjamiccikabgcikdesferdoofnnabggbannfoodrefsedkicgba"},
    {6, 5, 9, shifted_columns(10, 6, 2, 30), "kqlljhcbhhjlajlljaljarefreffedfeddefabcsedcikkicabgcikgbhabg"},
    {6, 5, 10, shifted_columns(10, 6, -2, 30), "abggbalqkkichbggbhcikkqldescbateddefabcsedlqkkichbggbhcikkql"},
    {6, 5, 11, shifted_columns(10, 6, 2, 30), "abggbacimnnfdopporfnnmqlabgcbhljaajlhbcgbalqmnnfroppodfnnmic"},
    {6, 5, 12, shifted_columns(10, 6, -6, 30), "hbcgbamqmnnfmqmoodcbhhbcdoomqmfnnmqmabgcbhgbadoonnffnnoodabg"},
    {6, 5, 13, shifted_columns(10, 6, 6, 30), "ajlljaljarefhbcsedlqkkichbggbhcikkqldescbhferajlajlljacbhhbc"},
    {6, 5, 14, shifted_columns(10, 6, 2, 30), "abccbacbadefdefferferajlajlljhljhhjlhjlljaljarefreffedfedabc"},
    {6, 5, 15, shifted_columns(10, 6, 2, 30), "hbccbacbadefdeffedfeddefdefferferajlajlljhljhhjlhjlljaljahbc"},
    {6, 5, 16, shifted_columns(10, 6, 2, 30), "ajllqmgbahjmnnfcbaooddefrefferfeddooabcfnnmjhabgmqlljacbhhbc"},
    {6, 5, 17, shifted_columns(10, 6, -6, 30), "miggimcikkqmabgcbagbadefnnfferooddooreffnnfedabgabcgbamqkkic"},
    {6, 5, 18, shifted_columns(10, 6, 2, 30), "hbggbhcikkqlabgcbaljadefreffedfeddefdefferfedajlabcgbalqkkic"},
    {6, 5, 19, shifted_columns(10, 6, 6, 30), "refcbafeddefabcsercikkqlabggbalqkkicrescbafeddefabcferljaajl"},
    {6, 5, 20, rows(6, 10), "abggbacimnnfajmoorljahjlrefcbafeddefabcferljhajlroomjafnnmic"},
    {6, 5, 21, shifted_columns(10, 6, 2, 30), "hbccbacbadefdefferferajlajlljaljarefrefferferajlajlljaljahbc"},
    {6, 5, 22, shifted_columns(10, 6, 2, 30), "abgcbhljaajlhbcgbalqkkicrescbafeddefdeffedfeddefabcsercikkql"},
};
// clang-format on

constexpr std::array<uint16_t, 20> letter_masks{0x691,  0x3C4, 0x5A2, 0x491,  0x3080, 0x4A2,  0x1A2,
                                                0x291,  0x1C4, 0x2C4, 0x6080, 0x5080, 0x4080, 0x2080,
                                                0x1080, 0x80,  0xC4,  0x91,   0xA2,   0x6A2};

int64_t modulo(int64_t a, int64_t b) {
    const int64_t rest = a % b;
    return rest < 0 ? rest + b : rest;
}

}  // namespace

size_t PavementLayout::Repeat::index(int64_t i, int64_t j) const {
    const int64_t line = modulo(shifts_columns ? i : j, period);
    const int64_t along = modulo(modulo(shifts_columns ? j : i, length) + shift * (line / step), length);
    const int64_t in_list = shifts_columns ? line % lines + lines * along : along + length * (line % lines);
    return static_cast<size_t>(in_list);
}

std::vector<uint16_t> PavementLayout::decoded() const {
    std::vector<uint16_t> list;
    if (sides == 6) {
        for (const char letter : masks) list.push_back(letter_masks.at(static_cast<size_t>(letter - 'a')));
        return list;
    }
    for (const char *at = masks.data(), *end = at + masks.size(); at < end; ++at) {
        uint16_t mask = 0;
        at = std::from_chars(at, end, mask, 16).ptr;
        list.push_back(mask);
    }
    return list;
}

const PavementLayout* find_pavement(int sides, int tiles, int pattern) {
    const auto* at = std::ranges::find_if(layouts, [&](const PavementLayout& l) {
        return l.sides == sides && l.tiles == tiles && l.pattern == pattern;
    });
    return at == std::end(layouts) ? nullptr : at;
}

int most_pavement_tiles(int sides) {
    int most = 0;
    for (const PavementLayout& layout : layouts) {
        if (layout.sides == sides) most = std::max(most, layout.tiles);
    }
    return most;
}

}  // namespace rb
