// Values measured with the reference (language spec 26.1 and 26.3).
#include "reading.h"

#include <gtest/gtest.h>

namespace rb {
namespace {

using Values = std::vector<double>;

void expect_values(std::string_view declarations, std::string_view expressions, const Values& expected) {
    const Values found = values_of(declarations, expressions);
    ASSERT_EQ(found.size(), expected.size()) << expressions << "\n" << read_probe(declarations).report;
    for (size_t i = 0; i < expected.size(); ++i)
        EXPECT_NEAR(found[i], expected[i], 1e-6) << expressions << " " << i;
}

std::string text_of(std::string_view declarations, std::string_view expression) {
    const Reading reading =
        read_probe(std::string(declarations) + " #debug concat(" + std::string(expression) + ",\"\\n\")");
    return reading.done ? reading.debug.substr(0, reading.debug.size() - 1) : reading.report;
}

TEST(Expression, RandomStreams) {
    expect_values("#declare R=seed(123); #declare Q=seed(0);", "rand(R);rand(Q);rand(R);R;Q",
                  {0.904773, 0.000003, 0.995138, 0, 1});
    expect_values("#declare R=seed(-1);", "rand(R);rand(R)", {0.578012873553, 0.446006170811});
}

TEST(Expression, Precedence) {
    expect_values("", "1-2-3;8/4/2;-2*-3;!3+1;(1|0&0);(2<3)+(3<2)", {-4, 1, 6, 1, 0, 1});
    expect_values("", "(1=1+1e-11);(1<1+1e-11);(0?5:1?6:7);- -2;+ +3", {1, 1, 6, 2, 3});
}

TEST(Expression, VectorsPromote) {
    expect_values("#declare V=<1,2>*<3,4,5>+1; #declare W=2-u;",
                  "V.x;V.y;V.z;W.x;W.y;-V.y;<1,2,3,4,5>.transmit;<.2,.4,.6>.gray",
                  {4, 9, 1, 1, 2, -9, 5, 0.3634});
    expect_values("#declare V=<1 -2 3>;", "V.x;V.y", {-1, 3});
}

TEST(Expression, FloatFunctions) {
    expect_values(
        "", "int(-2.7);div(7,-2);mod(-7,3);mod(7.5,-2);select(0,1,2,3);select(-1,1,2);bitwise_xor(12,10)",
        {-2, -3, -1, 1.5, 2, 1, 6});
    expect_values("", "asin(2);max(1,5,3);min(4,2);degrees(pi);atan2(1,1)",
                  {1.570796327, 5, 2, 180, 0.785398163});
    expect_values("", "abs(1<2);int(1e12)", {1, -2147483648.0});
}

TEST(Expression, VectorFunctions) {
    EXPECT_EQ(text_of("", "vstr(3,vrotate(<1,2,3>,<30,40,50>),\",\",0,6)"), "1.801281,2.507690,2.113499");
    EXPECT_EQ(text_of("", "vstr(3,vaxis_rotate(<1,2,3>,<1,1,1>,30),\",\",0,6)"),
              "1.422650,1.422650,3.154701");
    EXPECT_EQ(text_of("", "vstr(3,vturbulence(2,.5,6,<.1,.2,.3>),\",\",0,6)"),
              "-0.049192,-0.207178,-0.554875");
    EXPECT_EQ(text_of("", "vstr(3,vturbulence(2,.5,20,<1.1,2.2,3.3>),\",\",0,6)"),
              "-0.488103,-0.248558,0.428097");
}

TEST(Expression, Strings) {
    EXPECT_EQ(
        text_of("",
                R"(str(2.5,0,0),"|",str(-0.4,0,0),"|",str(1/3,0,-1),"|",str(-1.5,8,2),"|",str(-1.5,-8,2))"),
        "2|-0|0.333333|   -1.50|-0001.50");
    EXPECT_EQ(text_of("", R"(vstr(3,5,",",0,1),"|",vstr(5,<1,2>,"/",0,0),"|",substr("hello",2,3))"),
              "5.0,0.0,0.0|1/2/0/0/0|ell");
    EXPECT_EQ(text_of("", "datetime(5000.25)"), "2013-09-09 06:00:00Z");
    EXPECT_EQ(text_of("", R"(strupr("aBc"),strlwr("aBc"),chr(65))"), "ABCabcA");
    expect_values("", R"(val("12abc");asc("A");strcmp("","a");strlen("a\"b\\");("abc"<"abd");("b"="a"))",
                  {12, 65, -97, 4, 1, 0});
}

TEST(Expression, Colours) {
    constexpr std::string_view declarations =
        "#declare C=rgbt <.1,.2,.3,.4>; #declare E=C*2+.5; #declare F=color C filter .25;"
        "#declare G=color 0.5; #declare H=srgb .5;";
    const auto five = [&](std::string_view name) {
        return text_of(declarations, "vstr(5," + std::string(name) + ",\" \",0,6)");
    };
    EXPECT_EQ(five("C"), "0.100000 0.200000 0.300000 0.000000 0.400000");
    EXPECT_EQ(five("E"), "0.700000 0.900000 1.100000 0.500000 1.300000");
    EXPECT_EQ(five("F"), "0.100000 0.200000 0.300000 0.250000 0.400000");
    EXPECT_EQ(five("G"), "0.500000 0.500000 0.500000 0.500000 0.500000");
    EXPECT_EQ(five("H"), "0.214041 0.214041 0.214041 0.000000 0.000000");
    EXPECT_EQ(text_of(declarations, "str(C.x,0,15)"), "0.100000001490116");
}

TEST(Expression, Arrays) {
    expect_values("#declare A=array[2][2]{{1,2},{3,4}} #declare B=A; #declare B[1][0]=9;",
                  "A[1][0];B[1][0];dimensions(A);dimension_size(A,2);dimension_size(A,3)", {3, 9, 2, 2, 0});
    expect_values("#declare A=array[2]{array[2]{1,2},array[2]{3,4}}", "A[1][0];dimensions(A)", {3, 1});
    expect_values("#declare A=array[2.5]; #declare A[0]=<1,2,3>;", "A[0].y;dimension_size(A,1)", {2, 2});
}

TEST(Expression, Splines) {
    constexpr std::string_view p =
        "#declare P=spline{linear_spline 0,<0,0,0> 1,<1,2,0> 3,<2,-1,1> 4,<5,0,2>}";
    const auto at = [&](std::string_view arguments) {
        return text_of(p, "vstr(3,P(" + std::string(arguments) + "),\" \",0,6)");
    };
    EXPECT_EQ(at("2"), "1.500000 0.500000 0.500000");
    EXPECT_EQ(at(".5,quadratic_spline"), "0.541667 1.291667 -0.041667");
    EXPECT_EQ(at("2,quadratic_spline"), "1.666667 1.666667 0.333333");
    EXPECT_EQ(at("3.5,quadratic_spline"), "3.291667 -0.708333 1.458333");
    EXPECT_EQ(at("2,cubic_spline"), "1.250000 0.625000 0.375000");
    EXPECT_EQ(at(".5,cubic_spline"), "1.000000 2.000000 0.000000");
    EXPECT_EQ(at(".5,natural_spline"), "0.593750 1.304688 -0.023438");
    EXPECT_EQ(at("2,natural_spline"), "1.125000 0.687500 0.312500");
    EXPECT_EQ(at("3.5,natural_spline"), "3.312500 -0.757812 1.476562");
    expect_values("#declare S=spline{0,1 1,2 1,5} #declare T=spline{0,1 1,2 2,7 1,5}",
                  "S(.5).x;S(1).x;T(.5).x;T(1).x;T(1.5).x", {1.5, 2, 3, 5, 6});
}

TEST(Function, CallsAndLoops) {
    expect_values("#declare F=function(a,b){a*10+b} #declare G=function{F(x,y)+sum(i,1,3,i*z)}",
                  "F(1,2);G(1,2,3)", {12, 30});
    expect_values("#declare F=function(x,u){x*10+u}", "F(1,2)", {22});
    expect_values("#declare F=function{prod(i,1,x,i)}", "F(5,0,0)", {120});
    expect_values("#declare F=function(n){sum(i,1,n,1)}", "F(1e6)", {1e6});
    expect_values("#declare F=function{select(x,1,2,3)+min(x,y,z)+(x<y & y<z | 0)}", "F(-1,2,3)",
                  {1 - 1 + 1});
}

TEST(Function, ConstantFoldingAsTheReferenceDoes) {
    const auto at_ten = [](std::string_view body) {
        return values_of("#declare F=function{" + std::string(body) + "}", "F(10,0,0)").at(0);
    };
    EXPECT_DOUBLE_EQ(at_ten("x-2*3-1"), 5);
    EXPECT_DOUBLE_EQ(at_ten("x-2*3+1"), 3);
    EXPECT_DOUBLE_EQ(at_ten("x-2*3-x-1"), -7);
    EXPECT_DOUBLE_EQ(at_ten("5*0.5-x-2*2+1"), -12.5);
    EXPECT_DOUBLE_EQ(at_ten("(x-5*0.5+7+0.5)"), 0);
    EXPECT_DOUBLE_EQ(at_ten("x-1-1"), 8);
    EXPECT_DOUBLE_EQ(at_ten("x-(2*3)+1"), 5);
    EXPECT_DOUBLE_EQ(at_ten("2*x/4"), 5);
}

TEST(Function, OfTransformsPatternsAndPigments) {
    EXPECT_EQ(text_of("#declare T=transform{inverse scale 2 translate x} #declare F=function{transform{T}}",
                      "vstr(3,F(1,2,3),\" \",0,6)"),
              "0.000000 1.000000 1.500000");
    expect_values(
        "#declare F=function{pattern{bozo}} #declare G=function{pattern{wood}}"
        "#declare H=function{pattern{gradient x turbulence .5}} #declare N=function{internal(76)}",
        "F(.1,.2,.3);G(.3,0,0);H(.1,.2,.3);N(.1,.2,.3)", {0.417192, 0.6, 0.075404, 0.417192});
    expect_values("#declare F=function{pigment{gradient x color_map{[0 rgb 0][1 rgb <1,.5,0>]}}}",
                  "F(.5,0,0).red;F(.5,0,0).green", {0.5, 0.25});
    expect_values("#declare F=function{spline{0,<1,2> 1,<3,4>}} #declare G=function{F(x).v}",
                  "F(.5).u;G(.5,0,0)", {2, 3});
}

TEST(Function, FractalNoise) {
    expect_values("#declare F=function{internal(59)}",
                  "F(.3,.4,.5,.9,2.1,5,1,2,3);F(.3,.4,.5,.2,2.1,5,1,2,3)", {0.909332663, 0.909332663});
    expect_values("#declare F=function{internal(29)} #declare G=function{internal(58)}",
                  "F(.3,.4,.5,1.1,2.2,4.5,.7,2,2);G(.3,.4,.5,2,4.5,.6,.3,.4,2)", {0.953796892, -0.098899243});
    expect_values("#declare F=function{internal(78)}",
                  "F(.1,.2,.3,0);F(.1,.2,.3,1);F(.1,.2,.3,2);F(.1,.2,.3,3)",
                  {.299242909, .299242909, .417192033, .652260854});
}

}  // namespace
}  // namespace rb
