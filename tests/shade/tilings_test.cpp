// tiling and pavement: every tiling and every tile of the language at measured points (tilings.txt).
#include "pattern_text.h"
#include "patterns/pattern_field.h"

#include <array>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

namespace rb {
namespace {

TEST(Tilings, MatchTheMeasuredValues) {
    std::ifstream in(RB_SOURCE_DIR "/tests/shade/tilings.txt");
    int rows = 0;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with('#')) continue;
        const size_t colon = line.find(" : ");
        const std::string text = line.substr(0, colon);
        const WrittenPattern written = pattern_of(text);
        const PatternField field(written.pattern, written.modifiers, {});
        std::istringstream numbers(line.substr(colon + 3));
        double x = 0;
        double z = 0;
        double expected = 0;
        for (char comma = ','; comma == ',' && numbers >> x >> z >> expected;) {
            const std::array<Vec3, 1> point{Vec3{x, 0.5, z}};
            std::array<double, 1> value{};
            field.values({point, nullptr, {}}, value);
            // They went through a colour, in single precision.
            EXPECT_NEAR(value[0], expected, 7e-8) << text << " at " << x << ' ' << z;
            if (!(numbers >> comma)) break;
        }
        ++rows;
    }
    EXPECT_GT(rows, 27 + 112);
}

}  // namespace
}  // namespace rb
