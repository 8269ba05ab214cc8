// Functions over intervals hold what functions of points give; over batches they give the same bits.
#include "language/function_code.h"
#include "language/parser.h"
#include "scene/texture.h"

#include <array>
#include <bit>
#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rb {
namespace {

/// The value of a `function { ... }`.
FunctionPtr function_of(const std::string& text) {
    const LoadOptions options;
    SourceMap sources;
    Diagnostics diagnostics;
    Scene scene;
    Session session(options, sources, diagnostics, scene);
    session.default_texture = plain_texture();
    const uint32_t number = sources.add("function", text + ";");
    session.stream.open_file(lex(number, sources.text(number), session.words), {}, false);
    Parser parser(session);
    return std::get<FunctionPtr>(std::get<Thing>(parser.rvalue().value));
}

class Draw {
public:
    explicit Draw(unsigned seed) : random_(seed) {}
    double uniform(double lo, double hi) { return std::uniform_real_distribution(lo, hi)(random_); }
    size_t index(size_t count) { return random_() % count; }
    /// Numbers at which functions do something special, or any.
    double number() {
        constexpr std::array special{0.0, -0.0, 1.0, -1.0, 0.5, 2.0, -2.0, pi, -pi / 2, 1e-300, 1e10, -3e9};
        return index(6) == 0 ? special[index(special.size())] : uniform(-4, 4);
    }
    Interval interval() {
        const double width = std::array{0.0, 1e-12, 1e-3, 0.1, 1.0, 8.0}[index(6)];
        const double at = number();
        const double other = index(2) ? at + width : at - width;
        return {std::min(at, other), std::max(at, other)};
    }
    double member(const Interval& v) {
        const size_t kind = index(6);
        if (kind == 0) return v.lo;
        if (kind == 1) return v.hi;
        if (kind == 2 && v.holds(0)) return index(2) ? 0.0 : -0.0;
        return std::clamp(uniform(0, 1) * (v.hi - v.lo) + v.lo, v.lo, v.hi);
    }

private:
    std::mt19937_64 random_;
};

void expect_bounded(const Function& f, std::span<const Interval> box, Draw& draw, const std::string& name) {
    const Interval bound = f.bound(box, 0);
    std::vector<double> point(box.size());
    std::array<double, 5> out{};
    for (int i = 0; i < 20; ++i) {
        for (size_t k = 0; k < box.size(); ++k) point[k] = draw.member(box[k]);
        f.evaluate(point, {out.data(), static_cast<size_t>(f.result_count())});
        if (bound.holds(out[0])) continue;
        std::string where;
        for (size_t k = 0; k < box.size(); ++k)
            where += fmt::format(" {} in [{}, {}]", point[k], box[k].lo, box[k].hi);
        FAIL() << name << " = " << out[0] << " not in [" << bound.lo << ", " << bound.hi << "] at" << where;
    }
}

const std::vector<std::string> bodies{"x+y-z",
                                      "x*y*z",
                                      "x*x-y*y+z*z*z",
                                      "x/y",
                                      "1/(x-y)",
                                      "x/(y*y+0.1)",
                                      "-x+(-y)",
                                      "abs(x-y)",
                                      "sqrt(x)",
                                      "sqrt(x*x+y*y)-z",
                                      "sin(x*3)+cos(y*5)",
                                      "tan(x)",
                                      "asin(x)",
                                      "acos(x/2)",
                                      "atan(x*y)",
                                      "atan2(y,x)",
                                      "sinh(x)",
                                      "cosh(y)",
                                      "tanh(z)",
                                      "asinh(x)",
                                      "acosh(x)",
                                      "atanh(x)",
                                      "exp(x)*ln(y)",
                                      "log(x+y)",
                                      "pow(x,2)",
                                      "pow(x,3)",
                                      "pow(x,-1)",
                                      "pow(x,-1)",
                                      "pow(x,-2)",
                                      "pow(x,y)",
                                      "pow(abs(x),y)",
                                      "pow(x,0)",
                                      "pow(abs(x),0.5)",
                                      "mod(x,1)",
                                      "mod(x,y)",
                                      "mod(x*5,0.75)",
                                      "div(x,y)",
                                      "floor(x)+ceil(y)+int(z)",
                                      "int(x*1e9)",
                                      "degrees(x)+radians(y)",
                                      "min(x,y,z)",
                                      "max(x,sqrt(y))",
                                      "select(x,y,z)",
                                      "select(x,y,z,1)",
                                      "select(floor(x),1,2,3)",
                                      "select(sqrt(x),1,2,3)",
                                      "(x<y)+2*(x<=y)+4*(x>y)+8*(x>=y)+16*(x=y)+32*(x!=y)",
                                      "(x&y)+2*(x|y)",
                                      "(sqrt(x)<y)+2*(sqrt(x)>=y)",
                                      "sum(i,1,4,sin(i*x))",
                                      "prod(i,1,3,i+x)",
                                      "sum(i,max(x,-9),min(y,9),i)",
                                      "sum(i,1,3,sum(j,1,i,j*x*y))",
                                      "x*x*x*x-2*x*x+y*y-0.5*z",
                                      "sqrt(x*x+z*z)*sin(6*atan2(z,x))-y",
                                      "min(sqrt(x*x+y*y+z*z)-1, max(abs(x),abs(y),abs(z))-0.8)",
                                      "1e308*x*10",
                                      "ln(x)/ln(y)",
                                      "exp(x*200)*exp(-x*200)",
                                      "tan(x*y)/cos(z)"};

TEST(FunctionBound, HoldsWhatInternalFunctionsGive) {
    Draw draw(2);
    const auto generator = std::make_shared<const int>(2);
    for (int number = 0; number <= 78; ++number) {
        for (int i = 0; i < 200; ++i) {
            const FunctionPtr f = internal_function(number, generator);
            std::vector<Interval> box{draw.interval(), draw.interval(), draw.interval()};
            for (int k = 3; k < f->parameter_count(); ++k) {
                // Parameters as scenes have them; octaves, counts and generators stay small.
                const double p = draw.index(4) == 0 ? std::array{0.0, 1.0, 2.0, -1.0}[draw.index(4)]
                                                    : draw.uniform(0.1, 3);
                box.emplace_back(p);
            }
            ASSERT_NO_FATAL_FAILURE(expect_bounded(*f, box, draw, fmt::format("internal({})", number)));
        }
    }
}

TEST(FunctionBound, FunctionsOfFunctions) {
    Draw draw(3);
    const FunctionPtr f = function_of(
        "#declare S = function { internal(61) } #declare N = function { internal(76) } function { S(x,y,z,1) "
        "- 0.2*N(5*x,5*y,5*z) }");
    for (int i = 0; i < 300; ++i) {
        const std::array box{draw.interval(), draw.interval(), draw.interval()};
        ASSERT_NO_FATAL_FAILURE(expect_bounded(*f, box, draw, "sphere with noise"));
    }
    // Far from the surface the sign is known.
    const std::array outside{Interval(1.5, 2), Interval(0, 0.5), Interval(0, 0.5)};
    EXPECT_GT(f->bound(outside, 0).lo, 0);
    const std::array inside{Interval(-0.2, 0.2), Interval(0, 0.5), Interval(0, 0.5)};
    EXPECT_LT(f->bound(inside, 0).hi, 0);
}

/// Along a line: values and difference quotients, but for the rounding of the latter.
void expect_slope_bounded(const Function& f, size_t parameters, Draw& draw, const std::string& name,
                          double precision = 1e-10) {
    const double width = std::array{1e-3, 0.1, 1.0}[draw.index(3)];
    const double from = draw.uniform(-2, 2);
    const Interval t(from, from + width);
    std::array<double, 3> origin, direction;
    std::vector<IntervalSlope> line;
    for (size_t k = 0; k < 3; ++k) {
        origin[k] = draw.uniform(-3, 3);
        direction[k] = draw.index(3) == 0 ? 0.0 : draw.uniform(-1, 1);
        line.push_back({Interval(origin[k]) + t * Interval(direction[k]), Interval(direction[k])});
    }
    for (size_t k = 3; k < parameters; ++k) line.emplace_back(draw.uniform(0.1, 3));
    const IntervalSlope bound = f.bound_slope(line, 0);
    const auto at = [&](double place) {
        std::vector<double> point;
        for (size_t k = 0; k < 3; ++k) point.push_back(origin[k] + place * direction[k]);
        for (size_t k = 3; k < parameters; ++k) point.push_back(line[k].value.lo);
        std::array<double, 5> out{};
        f.evaluate(point, {out.data(), static_cast<size_t>(f.result_count())});
        return out[0];
    };
    for (int i = 0; i < 20; ++i) {
        const double a = draw.uniform(t.lo, t.hi);
        const double b = draw.uniform(t.lo, t.hi);
        const double fa = at(a);
        const double fb = at(b);
        EXPECT_TRUE(bound.value.holds(fa)) << name;
        if (std::abs(b - a) < 0.01 * width || !std::isfinite(fa) || !std::isfinite(fb)) continue;
        const double quotient = (fb - fa) / (b - a);
        const double rounding = precision * (1 + std::abs(fa) + std::abs(fb)) / std::abs(b - a);
        if (bound.slope.maybe_nan) continue;
        ASSERT_GE(quotient, bound.slope.lo - rounding) << name << " from " << a << " to " << b;
        ASSERT_LE(quotient, bound.slope.hi + rounding) << name << " from " << a << " to " << b;
    }
}

TEST(FunctionSlope, HoldsDifferenceQuotientsOfInternalFunctions) {
    Draw draw(5);
    const auto generator = std::make_shared<const int>(2);
    for (int number = 0; number <= 78; ++number) {
        const FunctionPtr f = internal_function(number, generator);
        const auto parameters = static_cast<size_t>(f->parameter_count());
        for (int i = 0; i < 200; ++i) {
            ASSERT_NO_FATAL_FAILURE(
                expect_slope_bounded(*f, parameters, draw, fmt::format("internal({})", number)));
        }
    }
}

/// Every kind of pattern that a function may hold, every wave, and what moves points.
const std::vector<std::string> pattern_bodies{
    "pattern { agate }",
    "pattern { boxed }",
    "pattern { bozo }",
    "pattern { bozo noise_generator 1 frequency 3 }",
    "pattern { brick brick_size <1, 0.6, 0.8> mortar 0.15 }",
    "pattern { bumps frequency 2 phase 0.3 }",
    "pattern { cells scale 0.7 }",
    "pattern { checker translate 0.3 }",
    "pattern { crackle }",
    "pattern { cubic }",
    "pattern { cylindrical }",
    "pattern { dents }",
    "pattern { gradient <1, 2, -1> }",
    "pattern { gradient -x phase -0.4 }",
    "pattern { gradient y triangle_wave frequency 1.7 }",
    "pattern { gradient y sine_wave frequency -1.3 }",
    "pattern { gradient y scallop_wave }",
    "pattern { gradient y cubic_wave phase 0.2 }",
    "pattern { gradient y poly_wave 2.5 }",
    "pattern { granite }",
    "pattern { granite noise_generator 1 scale 3 }",
    "pattern { hexagon scale 0.6 }",
    "pattern { leopard scale 0.3 }",
    "pattern { mandel 10 }",
    "pattern { marble }",
    "pattern { marble turbulence 0.5 }",
    "pattern { onion }",
    "pattern { onion frequency 0 }",
    "pattern { planar rotate 30*x }",
    "pattern { quilted control0 0.2 control1 1.4 }",
    "pattern { radial frequency 4 }",
    "pattern { ripples frequency 2 scale 0.5 }",
    "pattern { spherical scale 2 }",
    "pattern { spiral1 3 }",
    "pattern { spiral2 2 triangle_wave }",
    "pattern { spiral1 2 turbulence 0.3 }",
    "pattern { spotted turbulence 0.4 scale 0.5 }",
    "pattern { waves frequency 2 scale 0.5 }",
    "pattern { wood rotate <20, 30, 40> scale 0.6 }",
    "pattern { wood turbulence 0.1 }",
    "pattern { wrinkles }",
    "pattern { wrinkles noise_generator 1 sine_wave }",
    "pattern { checker warp { repeat x flip y } }",
    "pattern { function { x*y-z } sine_wave }",
    "transform { rotate <10, 20, 30> scale <1, 2, 3> translate y }"};

/// Values in boxes, and slopes along lines.
void expect_all_bounded(const std::vector<std::string>& all, unsigned seed, double precision = 1e-10) {
    Draw draw(seed);
    for (const std::string& body : all) {
        const FunctionPtr f = function_of("function { " + body + " }");
        for (int i = 0; i < 300; ++i) {
            const std::array box{draw.interval(), draw.interval(), draw.interval()};
            ASSERT_NO_FATAL_FAILURE(expect_bounded(*f, box, draw, body));
            ASSERT_NO_FATAL_FAILURE(expect_slope_bounded(*f, 3, draw, body, precision));
        }
    }
}

TEST(FunctionBound, HoldsWhatUserFunctionsGive) { expect_all_bounded(bodies, 1); }

TEST(FunctionBound, HoldsWhatPatternsGive) { expect_all_bounded(pattern_bodies, 6); }

TEST(FunctionBound, HoldsWhatGradientNoiseGives) {
    constexpr double of_places = 1e-9;  // to which ten millions are added first, as in the reference
    expect_all_bounded(
        {"pattern { bozo noise_generator 3 scale 0.4 }", "pattern { granite noise_generator 3 }"}, 8,
        of_places);
}

TEST(FunctionBound, HoldsWhatPigmentsGive) {
    std::vector<std::string> pigments;
    for (const char* map :
         {"color_map { [0.1 rgb <0.2, 0, 0>] [0.4 rgb <0.9, 1, 0>] [0.4 rgb <-0.5, 0, 0>] [0.8 rgb 1] }",
          "color_map { [0.5 rgb <0.2, 0, 0>] [0.2 rgb <0.9, 1, 0>] }", "color_map { [0.5 rgb <0.2, 0, 0>] }",
          "pigment_map { [0 checker rgb 0.5 rgb 0.7] [1 bozo] }"})
        pigments.push_back(fmt::format("pigment {{ gradient x {} }}", map));
    constexpr double of_colors = 1e-6;  // which are of single precision
    expect_all_bounded(pigments, 7, of_colors);
}

TEST(FunctionSlope, OfPatternsIsKnownBetweenTheirJumps) {
    const auto slope = [](const char* body, Interval x) {
        const std::array line{IntervalSlope(x, 1), IntervalSlope(0.3), IntervalSlope(0.3)};
        return function_of(fmt::format("function {{ pattern {{ {} }} }}", body))->bound_slope(line, 0);
    };
    EXPECT_GT(slope("onion", {1.1, 1.2}).slope.lo, 0.5);
    EXPECT_TRUE(slope("onion", {0.8, 1.2}).slope.has_infinity());
    EXPECT_TRUE(is_constant(slope("checker", {0.1, 0.9})));
    EXPECT_TRUE(slope("checker", {0.1, 1.1}).slope.has_infinity());
    EXPECT_TRUE(is_constant(slope("hexagon", {-0.3, 0.3})));
    EXPECT_NEAR(slope("gradient x triangle_wave", {0.1, 0.4}).slope.lo, 2.0, 1e-9);
    EXPECT_LT(slope("bozo", {0.1, 0.11}).slope.hi, 3.0);
    EXPECT_LE(slope("granite", {0.0, 9.0}).value.hi, 1.0);
}

TEST(FunctionSlope, TellsWhetherAFunctionRises) {
    const auto slope = [](const char* body, Interval x) {
        const std::array line{IntervalSlope(x, 1), IntervalSlope(0), IntervalSlope(0)};
        return function_of(fmt::format("function {{ {} }}", body))->bound_slope(line, 0).slope;
    };
    EXPECT_GT(slope("x*x", {1, 2}).lo, 0);
    EXPECT_LT(slope("1/x", {1, 2}).hi, 0);
    EXPECT_GT(slope("exp(x)-1", {-1, 2}).lo, 0);
    EXPECT_LT(slope("cos(x)", {0.5, 3}).hi, 0);
    EXPECT_FALSE(slope("floor(x)", {0.5, 1.5}).hi < infinity);
}

struct Tight {
    const char* body;
    Interval x;
    double lo, hi;
};

TEST(FunctionBound, IsTightForCommonOperations) {
    for (const Tight& t :
         {Tight{"x*x", {-1, 2}, 0, 4}, Tight{"pow(x,2)", {-3, 2}, 0, 9}, Tight{"pow(x,3)", {-1, 2}, -1, 8},
          Tight{"sin(x)", {0, 1}, 0, 0.8414709848}, Tight{"sin(x)", {1, 2}, 0.8414709848, 1},
          Tight{"cos(x)", {3, 4}, -1, -0.6536436209}, Tight{"sin(x)", {0, 9}, -1, 1},
          Tight{"abs(x)", {-3, 2}, 0, 3}, Tight{"sqrt(x)", {1, 4}, 1, 2},
          Tight{"mod(x,1)", {2.25, 2.5}, 0.25, 0.5}, Tight{"mod(x,1)", {0.5, 1.5}, 0, 1},
          Tight{"1/x", {2, 4}, 0.25, 0.5}, Tight{"exp(x)", {0, 1}, 1, 2.7182818285},
          Tight{"select(x,1,2,3)", {0.1, 1}, 3, 3}, Tight{"select(x,1,2,3)", {-1, 1}, 1, 3},
          Tight{"floor(x)", {0.5, 2.5}, 0, 2}, Tight{"min(x,1)", {0, 5}, 0, 1}, Tight{"x<2", {0, 1}, 1, 1}}) {
        const std::array box{t.x, Interval(0), Interval(0)};
        const Interval bound = function_of(fmt::format("function {{ {} }}", t.body))->bound(box, 0);
        EXPECT_NEAR(bound.lo, t.lo, 1e-9) << t.body;
        EXPECT_NEAR(bound.hi, t.hi, 1e-9) << t.body;
        EXPECT_FALSE(bound.maybe_nan) << t.body;
    }
}

TEST(FunctionBound, KnowsDomains) {
    const auto bound = [](const char* body, Interval x) {
        const std::array box{x, Interval(0), Interval(0)};
        return function_of(fmt::format("function {{ {} }}", body))->bound(box, 0);
    };
    EXPECT_TRUE(bound("sqrt(x)", {-1, 1}).maybe_nan);
    EXPECT_TRUE(bound("ln(x)", {-1, 1}).maybe_nan);
    EXPECT_FALSE(bound("ln(x)", {0, 1}).maybe_nan);
    EXPECT_EQ(bound("1/x", {-1, 1}).hi, infinity);
    EXPECT_TRUE(bound("x/x", {-1, 1}).maybe_nan);
    EXPECT_TRUE(bound("x-x", {0, infinity}).maybe_nan);
}

TEST(FunctionRows, GiveTheSameBits) {
    Draw draw(4);
    for (const std::string& body : bodies) {
        const FunctionPtr f = function_of("function { " + body + " }");
        constexpr size_t count = 150;  // two whole batches and a part
        std::array<std::vector<double>, 3> columns;
        for (auto& column : columns) {
            for (size_t i = 0; i < count; ++i) column.push_back(draw.number());
        }
        const std::array<const double*, 3> arguments{columns[0].data(), columns[1].data(), columns[2].data()};
        std::vector<double> rows(count);
        f->evaluate_rows(arguments, rows);
        for (size_t i = 0; i < count; ++i) {
            const std::array point{columns[0][i], columns[1][i], columns[2][i]};
            std::array<double, 1> out{};
            f->evaluate(point, out);
            const bool same = std::bit_cast<uint64_t>(out[0]) == std::bit_cast<uint64_t>(rows[i]);
            ASSERT_TRUE(same || (std::isnan(out[0]) && std::isnan(rows[i]))) << body << " " << i;
        }
    }
}

}  // namespace
}  // namespace rb
