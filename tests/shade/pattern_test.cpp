#include "pattern_text.h"
#include "pattern_values.h"
#include "patterns/normal_program.h"
#include "patterns/pigment_program.h"
#include "patterns/registry.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rb {
namespace {

constexpr std::array<Vec3, 4> places{Vec3{0.3, 0.7, -0.4}, Vec3{1.25, -2.5, 3.75}, Vec3{-3.1, 4.2, -5.3},
                                     Vec3{12.34, -7.65, 8.9}};

TEST(Patterns, MatchTheMeasuredValues) {
    for (const PatternRow& row : pattern_rows) {
        const WrittenPattern written = pattern_of(row.text);
        const PatternField field(written.pattern, written.modifiers, {});
        std::array<Vec3, 4> points = places;
        std::array<double, 4> values{};
        field.carry(points);
        field.values({points, nullptr, {}}, values);
        for (size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(values[i], row.value[i], 2e-9) << row.text << " point " << i;
    }
}

TEST(Patterns, ExamplesOfTheRegistryCanBeReadAndEvaluated) {
    for (const PatternKind* kind : all_patterns()) {
        // Some are normals only, others pigments only.
        WrittenPattern written;
        try {
            const Normal normal = written_normal(std::string(kind->example));
            written = {normal.pattern, normal.modifiers};
        } catch (const SceneError&) {
            written = pattern_of(std::string(kind->example));
        }
        ASSERT_TRUE(written.pattern) << kind->keyword;
        EXPECT_EQ(written.pattern->keyword(), kind->keyword);
        std::array<double, 4> values{};
        PatternField(written.pattern, written.modifiers, {}).values({places, nullptr, {}}, values);
        for (const double v : values) EXPECT_TRUE(std::isfinite(v)) << kind->keyword;
    }
}

/// z^2 + c step by step, as the manual has it; `interior`: 1 or 2.
double followed_plainly(const Vec3& p, int iterations, int interior) {
    double x = p.x;
    double y = p.y;
    double smallest = x * x + y * y;
    for (int k = 0; k < iterations; ++k) {
        const double re = x * x - y * y;
        const double im = x * y + y * x;
        x = re + p.x;
        y = im + p.y;
        const double norm = x * x + y * y;
        smallest = std::min(smallest, norm);
        if (norm > 4.0) return static_cast<double>(k) / iterations;
    }
    return interior == 1 ? std::sqrt(smallest) : x;
}

TEST(Patterns, OrbitsOfFractalsAreTheSameBitsSideBySideAndInCycles) {
    for (const int interior : {1, 2}) {
        for (const int iterations : {7, 64, 200, 3001}) {
            const WrittenPattern mandel =
                pattern_of(fmt::format("mandel {} interior {}, 1", iterations, interior));
            std::array<Vec3, 333> points;
            for (size_t i = 0; i < points.size(); ++i) {
                const auto t = static_cast<double>(i);
                points[i] = {-0.6 + 1.6 * std::sin(1.7 * t), 1.2 * std::cos(2.3 * t), 0.0};
            }
            std::array<double, points.size()> together{};
            const PatternContext context{mandel.modifiers};
            mandel.pattern->evaluate(context, points, together);
            for (size_t i = 0; i < points.size(); ++i) {
                double alone = 0;
                mandel.pattern->evaluate(context, {&points[i], 1}, {&alone, 1});
                ASSERT_EQ(alone, together[i]) << i;
                ASSERT_EQ(alone, followed_plainly(points[i], iterations, interior)) << i;
            }
        }
    }
}

TEST(Pigments, DefaultMapsMatchTheMeasuredColours) {
    for (const PigmentRow& row : default_map_rows) {
        const WrittenPattern written = pattern_of(row.text);
        Pigment pigment;
        pigment.source = written.pattern;
        pigment.modifiers = written.modifiers;
        std::array<Color, 4> colors;
        PigmentProgram(pigment, {}).evaluate({places, nullptr, {}}, colors);
        for (size_t i = 0; i < 4; ++i) {
            EXPECT_NEAR(colors[i].red, row.color[i][0], 5.1e-5) << row.text;
            EXPECT_NEAR(colors[i].green, row.color[i][1], 5.1e-5) << row.text;
            EXPECT_NEAR(colors[i].blue, row.color[i][2], 5.1e-5) << row.text;
        }
    }
}

// gradient x with [0.2 .1][0.4 .2][0.4 .6][0.8 .9][0.8 0]: 0.8 is stored as 0.800000012.
TEST(Pigments, MapLookupFollowsTheWrittenOrder) {
    const WrittenPattern written = pattern_of("gradient x");
    Pigment pigment;
    pigment.source = written.pattern;
    const auto grey_of = [](float v) { return Color{v, v, v, 0, 0}; };
    pigment.map = ColorMap{{0.2f, grey_of(0.1f)},
                           {0.4f, grey_of(0.2f)},
                           {0.4f, grey_of(0.6f)},
                           {0.8f, grey_of(0.9f)},
                           {0.8f, grey_of(0.0f)}};
    const PigmentProgram program(pigment, {});
    constexpr double expected[][2] = {{0.1, 0.1},      {0.2, 0.1},  {0.3, 0.15}, {0.4, 0.2},
                                      {0.400001, 0.6}, {0.6, 0.75}, {0.8, 0.9},  {0.9, 0.0}};
    for (const auto& row : expected) {
        const Vec3 point{row[0], 0.0, 0.0};
        Color color;
        program.evaluate({{&point, 1}, nullptr, {}}, {&color, 1});
        EXPECT_NEAR(color.red, row[1], 1e-5) << row[0];
    }
}

TEST(Pigments, AverageAndChildrenBlend) {
    const auto plain = [](const Color& color) {
        auto p = std::make_shared<Pigment>();
        p->source = color;
        return p;
    };
    auto child = std::make_shared<Pigment>();
    child->source = pattern_of("gradient y").pattern;
    Pigment average;
    average.average = true;
    average.map = BlendMap<PigmentPtr>{{1.0f, plain({1, 0, 0, 0, 0})}, {3.0f, plain({0, 0, 1, 0, 0.5f})}};
    Pigment blend;
    blend.source = pattern_of("gradient x").pattern;
    blend.map = BlendMap<PigmentPtr>{{0.0f, child}, {1.0f, plain({0, 0, 1, 0, 0})}};
    const Vec3 point{0.25, 0.5, 0.0};
    Color color;
    PigmentProgram(average, {}).evaluate({{&point, 1}, nullptr, {}}, {&color, 1});
    EXPECT_EQ(color, (Color{0.25f, 0, 0.75f, 0, 0.375f}));
    PigmentProgram(blend, {}).evaluate({{&point, 1}, nullptr, {}}, {&color, 1});
    EXPECT_EQ(color, (Color{0.375f, 0.375f, 0.625f, 0, 0}));
}

constexpr std::array<Vec3, 3> plane_points{Vec3{0.5, 0, 1.5}, Vec3{-2.5, 0, 0.5}, Vec3{1.5, 0, -3.5}};

void expect_normals(const Normal& normal, const double (&expected)[3][3], const char* text) {
    std::array<Vec3, 3> normals;
    normals.fill({0.0, 1.0, 0.0});
    NormalProgram(normal, {}).perturb({plane_points, nullptr, {}}, normals);
    for (size_t i = 0; i < 3; ++i) {
        const Vec3 n = glm::normalize(normals[i]);
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(n[axis], expected[i][axis], 1.2e-4) << text << ' ' << i;
    }
}

TEST(Normals, MatchTheMeasuredValues) {
    for (const NormalRow& row : normal_rows) expect_normals(written_normal(row.text), row.normal, row.text);
}

TEST(Normals, SlopeMapIsFollowedByGenericPatternsOnly) {
    Normal crackle = written_normal("crackle 1");
    crackle.map =
        BlendMap<HeightSlope>{{0.0f, {0, 1}}, {0.3f, {0.5f, 0.2f}}, {0.6f, {0.2f, -1}}, {1.0f, {0.4f, 0}}};
    expect_normals(crackle,
                   {{-0.5557, 0.8026, -0.2170}, {-0.0307, 0.9990, -0.0315}, {-0.0473, 0.9909, 0.1258}},
                   "crackle");
    Normal bumps = written_normal("bumps 1");
    bumps.map = BlendMap<HeightSlope>{{0.0f, {0, 1}}, {1.0f, {1, 0}}};
    expect_normals(bumps, {{-0.2798, 0.9580, 0.0624}, {-0.1451, 0.9776, -0.1523}, {0.0538, 0.9985, -0.0140}},
                   "bumps");
}

NormalPtr shared_normal(const char* text) { return std::make_shared<Normal>(written_normal(text)); }

TEST(Normals, MapsListsAndAveragesMatchTheMeasuredValues) {
    Normal map = written_normal("gradient x scale 4");
    map.map = BlendMap<NormalPtr>{{0.2f, shared_normal("bumps 0.6")},
                                  {0.8f, shared_normal("ripples 0.5 scale 0.5")}};
    expect_normals(map, {{-0.0146, 0.9782, -0.2070}, {-0.0673, 0.9977, 0.0018}, {-0.1888, 0.9487, 0.2538}},
                   "normal_map");
    Normal average = written_normal("bozo translate 0.1");
    average.pattern = nullptr;
    average.average = true;
    average.map =
        BlendMap<NormalPtr>{{1.0f, shared_normal("bumps 0.6")}, {3.0f, shared_normal("gradient x 0.3")}};
    expect_normals(average,
                   {{-0.0767, 0.9970, 0.0085}, {-0.0481, 0.9987, -0.0187}, {-0.0094, 0.9997, -0.0220}},
                   "average");
    Normal list = written_normal("checker translate 0.01");
    list.map = BlendMap<NormalPtr>{{0.0f, shared_normal("bumps 0.6")}, {1.0f, shared_normal("waves 0.2")}};
    expect_normals(list, {{-0.1789, 0.9831, 0.0401}, {-0.0923, 0.9913, -0.0942}, {0.0392, 0.9991, -0.0181}},
                   "checker list");
}

}  // namespace
}  // namespace rb
