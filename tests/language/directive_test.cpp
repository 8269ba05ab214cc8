// Directives and macros (language spec 3 to 5, 26.2).
#include "reading.h"

#include <gtest/gtest.h>

namespace rb {
namespace {

/// What `#debug` said; the report if there were errors.
std::string said(std::string_view text) {
    const Reading reading = read_probe(std::string("#macro D(N) #debug concat(str(N,0,-1),\" \") #end ") +
                                       std::string(text) + " #debug \"\\n\"");
    if (!reading.done) return reading.report;
    std::string out = reading.debug;
    while (!out.empty() && (out.back() == '\n' || out.back() == ' ')) out.pop_back();
    return out;
}

std::string numbers(std::string_view declarations, std::string_view names) {
    std::string text(declarations);
    size_t start = 0;
    while (start < names.size()) {
        const size_t end = std::min(names.find(';', start), names.size());
        text += " #debug concat(str(" + std::string(names.substr(start, end - start)) + ",0,2),\" \")";
        start = end + 1;
    }
    return said(text);
}

TEST(Macro, BodyReplacesTheCall) {
    EXPECT_EQ(numbers("#macro M(A) A+1 #end #macro Q(X) X*X #end", "2*M(3);Q(1+2)"), "7.00 9.00");
    EXPECT_EQ(numbers("#macro V() <1,2,3> #end #declare C=V()*2;", "C.z"), "6.00");
}

TEST(Macro, ArgumentsGoByReferenceIfTheyAreIdentifiers) {
    EXPECT_EQ(
        numbers("#macro Sw(A,B) #local T=A; #declare A=B; #declare B=T; #end #declare P=1; #declare S=2;"
                "Sw(P,S) #declare U=5; Sw((P),U)",
                "P;S;U"),
        "2.00 1.00 2.00");
    EXPECT_EQ(numbers("#macro L(N) #local N=9; #end #declare K=1; L(K)", "K"), "9.00");
    EXPECT_EQ(numbers("#macro L(N) #declare N=9; #end #declare A=array[2]{1,2} L(A[1])", "A[0];A[1]"),
              "1.00 9.00");
    EXPECT_EQ(numbers("#macro L(N) #declare N=9; #end #declare A=<1,2>; L(A.x) ", "A.x"), "1.00");
}

// Measured: a sign makes a value of a variable.
TEST(Macro, SignedArgumentsGoByValue) {
    constexpr const char* inc = "#macro Inc(A) #declare A=A+1; #end #declare B=array[2]{1,2} #declare V=1; ";
    EXPECT_EQ(numbers(std::string(inc) + "Inc(+V)", "V"), "1.00");
    EXPECT_EQ(numbers(std::string(inc) + "Inc(++V) Inc(-V) Inc((V)) Inc(V+0)", "V"), "1.00");
    EXPECT_EQ(numbers(std::string(inc) + "Inc(+B[0]) Inc(B[1])", "B[0];B[1]"), "1.00 3.00");
}

TEST(Macro, OptionalParametersMayBeMissing) {
    constexpr const char* macro =
        "#macro W(N) #debug concat(str(N,0,0),\" \") #end #macro M(A, optional B, optional C) W(A) #ifdef(B) "
        "W(B) #else W(-1) #end #ifndef(C) #local C=7; #end "
        "W(C) #end ";
    EXPECT_EQ(said(std::string(macro) + "M(1) M(1,2) M(1,2,3) M(1,,3) M(1,) M(1,,)"),
              "1 -1 7 1 2 7 1 2 3 1 -1 3 1 -1 7 1 -1 7");
    EXPECT_EQ(said(std::string(macro) + "#declare B=5; M(1) W(B)"), "1 -1 7 5");
    EXPECT_EQ(said(std::string(macro) + "#macro N(optional B) M(4,B) #end N() N(6)"), "4 -1 7 4 6 7");
    EXPECT_EQ(said("#macro M(optional) #debug str(optional,0,0) #end M(3)"), "3");
    EXPECT_EQ(first_error(std::string(macro) + "M()"), "Expected 3 parameters but only 0 found.");
    EXPECT_EQ(first_error("#macro R(A) #end #macro M(optional B) R(B) #end M()"),
              "Cannot pass uninitialized identifier as macro parameter. Initialize identifier first.");
    EXPECT_EQ(first_error("#macro M(optional B) sphere { 0, B } #end M()"),
              "Expected 'numeric expression', undeclared identifier found instead");
}

TEST(Macro, ScopeIsDynamic) {
    EXPECT_EQ(said("#macro In() #declare G=G+1; #end #macro Out() #local G=10; In() D(G) #end #declare G=1; "
                   "Out() D(G)"),
              "11.000000 1.000000");
}

TEST(Macro, LastLocalSurvives) {
    EXPECT_EQ(numbers("#macro M() #local R=<1,2,3>; R #end #declare V=M();", "V.y"), "2.00");
    EXPECT_EQ(numbers("#macro S(T) #local Out=concat(T,\"!\"); Out #end", "strlen(S(\"ab\"))"), "3.00");
}

TEST(Macro, SemicolonMayBelongToTheBody) {
    EXPECT_EQ(numbers("#macro Q() 5; #end #declare A=Q(); #macro M() #local B=2; #end M();", "A"), "5.00");
}

TEST(Macro, BreakReturns) {
    EXPECT_EQ(said("#macro M(A) D(1) #if (A) #break #end D(2) #end M(0) M(1)"), "1.000000 2.000000 1.000000");
}

TEST(Macro, MayLeaveBracesOpen) {
    const Reading reading =
        read_probe("#macro Open() sphere { 0, #end #macro Close() } #end Open() 2 Close()");
    EXPECT_TRUE(reading.done) << reading.report;
    EXPECT_EQ(reading.scene.objects.size(), 2u);
}

TEST(Macro, RecursesDeeplyButNotForever) {
    EXPECT_EQ(numbers("#macro F(N) #if (N<=1) 1 #else (N*F(N-1)) #end #end #declare A=(F(5));", "A"),
              "120.00");
    EXPECT_EQ(first_error("#macro F(N) F(N+1) #end F(1)"), "Too many nested symbol tables");
}

TEST(Macro, ArgumentCount) {
    EXPECT_EQ(first_error("#macro M(A,B) #end M(1)"), "Expected 2 parameters but only 1 found.");
    EXPECT_EQ(first_error("#macro M(A) #end M(1,2)").substr(0, 12), "Expected ')'");
    EXPECT_EQ(first_error("#macro M(A) #end M(Nope)"),
              "Cannot pass uninitialized identifier as macro parameter. Initialize identifier first.");
}

TEST(Macro, NumericArgumentsAreSums) {
    EXPECT_NE(first_error("#macro M(A) A #end #declare X=M(1=1);"), "");
    EXPECT_EQ(numbers("#macro M(A) A #end #declare X=M((1=1));", "X"), "1.00");
}

TEST(Loop, For) {
    EXPECT_EQ(numbers("#for(I,1,3) #end #for(J,1,0,-.25) #end", "I;J"), "4.00 -0.25");
    EXPECT_EQ(said("#for(I,1,3) D(I) #if (I=2) #break #end #end"), "1.000000 2.000000");
    EXPECT_EQ(said("#for(I,3,1) D(I) #end"), "");
    EXPECT_EQ(first_error("#for(I,1,2,0) #end"), "#for loop increment must be non-zero.");
}

TEST(Loop, While) {
    EXPECT_EQ(said("#declare I=0; #while (I<3) D(I) #declare I=I+1; #end"), "0.000000 1.000000 2.000000");
    EXPECT_EQ(said("#declare I=0; #while (1) #declare I=I+1; #if (I>2) #break #end D(I) #end"),
              "1.000000 2.000000");
}

TEST(Switch, FallsThroughIntoElse) {
    EXPECT_EQ(
        said("#switch(5) #case(5) #debug \"five \" #range(7,9) #debug \"r \" #else #debug \"else \" #end"),
        "five r else");
    EXPECT_EQ(said("#switch(9) #case(1) #debug \"1 \" #else #debug \"E \" #case(9) #debug \"N\" #end"),
              "E N");
    EXPECT_EQ(said("#switch(2) #declare Q=1; #case(1) #debug \"1\" #break #case(2) #debug \"2\" #break #else "
                   "#debug \"e\" #end"),
              "2");
    EXPECT_EQ(first_error("#switch(1) sphere #case(1) #end"), "#switch not followed by #case or #range.");
}

TEST(Conditional, Branches) {
    EXPECT_EQ(said("#ifdef(Nope) a #elseif(1) #debug \"b\" #else c #end"), "b");
    EXPECT_EQ(said("#ifndef(Nope) #debug \"y\" #end #ifdef(sin) #debug \"n\" #end"), "y");
    EXPECT_EQ(said("#declare A=array[2]; #declare A[1]=3; #ifdef(A[0]) D(0) #end #ifdef(A[1]) D(1) #end"),
              "1.000000");
    EXPECT_EQ(said("#if (0) ( { [ garbage #if (1) #else #end #elseif (0) x #else #debug \"e\" #end"), "e");
    EXPECT_EQ(first_error("#end"), "Mis-matched '#end'.");
    EXPECT_EQ(first_error("#else"), "Mis-matched '#else'.");
    EXPECT_EQ(first_error("#if (1) "), "End of file reached but #end expected.");
}

TEST(Lock, DirectivesBetweenOperandAndOperator) {
    EXPECT_EQ(numbers("#declare A=#if(0) 3; #else 4; #end #declare B=(1 #if(1) +2 #end);", "A;B"),
              "4.00 3.00");
    EXPECT_NE(first_error("#declare A=1 #if(1)+2 #end;"), "");
    EXPECT_NE(first_error("#declare A = #if(1) 3 #else 4 #end;"), "");
    EXPECT_EQ(numbers("#declare A = (#if(1) 3 #else 4 #end); #declare V=<1 #if(1)+2 #end, 2>; "
                      "#declare W=abs(1 #if(1)+1 #end);",
                      "A;V.x;W"),
              "3.00 3.00 2.00");
    EXPECT_EQ(first_error("#macro M(A) A #end #declare X=M(1 #if(1)+1 #end);"),
              "Expected ')', # found instead");
    EXPECT_EQ(first_error("#if(1 #if(1)+1 #end) #end"), "Expected ')', # found instead");
    EXPECT_EQ(said("#debug concat(\"a\" #if(1) ,\"b\" #end)"), "ab");
    EXPECT_TRUE(read_probe("sphere{ 0, 1 #if(1) *3 #end }").done);
    EXPECT_TRUE(read_probe("#macro M(O) O #end M(sphere{0,1 #if(1) scale 2 #end})").done);
}

TEST(Lock, StringsDoNotRunWhatFollows) {
    EXPECT_EQ(said("#debug \"a\" #debug \"b\" #declare S=\"c\" #debug S #debug \"d\""), "abcd");
}

TEST(Declare, ThousandsInARowDoNotNest) {
    std::string text;
    for (int i = 0; i < 20000; ++i) text += "#declare A" + std::to_string(i) + "=" + std::to_string(i) + "; ";
    for (int i = 0; i < 5000; ++i) text += "#declare O" + std::to_string(i) + "=sphere{0,1} ";
    EXPECT_EQ(numbers(text, "A19999"), "19999.00");
}

TEST(Declare, TextureBeforeAMacroThatUsesIt) {
    const Reading reading = read_probe(
        "#macro Use(T) sphere { 0, 1 texture { T } } #end "
        "#declare T1 = texture { pigment { rgb 1 } } Use(T1) "
        "#declare T2 = texture { T1 } texture { pigment { rgbt 1 } } Use(T2)");
    EXPECT_TRUE(reading.done) << reading.report;
}

TEST(Declare, LocalOfAMacroResult) {
    const Reading reading = read_probe(
        "#macro T(A) #local M = A; transform { translate M } #end "
        "#macro Go() #local M = T(x) sphere { 0, 1 transform M } #end Go()");
    EXPECT_TRUE(reading.done) << reading.report;
}

TEST(Declare, KindsAndErrors) {
    EXPECT_EQ(first_error("#declare A=Nope;").substr(0, 39), "Cannot assign uninitialized identifier.");
    EXPECT_EQ(first_error("#declare A=array[2]{1,2} #declare A[0]=<1,2,3>;"),
              "Attempted to redefine float identifier as vector identifier.");
    EXPECT_EQ(first_error("#declare F=function{x} #declare F=function{y}"),
              "Redeclaring functions is not allowed - #undef the function first!");
    EXPECT_EQ(first_error("#declare sphere=1;"), "Expected 'undeclared identifier', sphere found instead");
    EXPECT_EQ(first_error("#declare A=array[2]{1}"), "Insufficent number of initializers");
    EXPECT_EQ(first_error("#declare A=array[2]{1,2} #declare B=A[2];"), "Array subscript out of range");
    EXPECT_EQ(first_error("#declare A=array[2]; #declare B=A[-1];"), "Negative subscript");
    EXPECT_EQ(first_error("#declare A=array[1e9];"), "The array is too large.");
}

TEST(Files, WriteAndReadBack) {
    const std::string name = std::string(RB_BINARY_DIR) + "/language_test_data.txt";
    const std::string text =
        "#fopen F \"" + name +
        "\" write #write(F,1/3,\",\",<1,2,3>,\",\",\"\\\"hi\\\"\\n\") #fclose F "
        "#fopen F \"" +
        name +
        "\" read #read(F,A,B,C) "
        "#debug concat(str(A,0,6),\" \",vstr(3,B,\",\",0,0),\" \",C,\" \",str(defined(F),0,0))";
    EXPECT_EQ(said(text), "0.333333 1,2,3 hi 0");
}

TEST(Files, IncludesAreReadAgainAfterTheyWereWritten) {
    const std::string name = std::string(RB_BINARY_DIR) + "/language_test_written.inc";
    const std::string text =
        "#macro Parse(T) #fopen F \"" + name + "\" write #write(F,T) #fclose F #include \"" + name +
        "\" #end Parse(\"#declare A = 1;\") D(A) Parse(\"#declare A = 2;\") D(A) #include \"" + name +
        "\" D(A)";
    EXPECT_EQ(said(text), "1.000000 2.000000 2.000000");
}

TEST(Files, DensityFilesAreReadAgainAfterTheyWereWritten) {
    const std::string name = std::string(RB_BINARY_DIR) + "/language_test_written.df3";
    const std::string text = "#macro Write(V) #fopen F \"" + name +
                             "\" write #write(F, uint16be 1, uint16be 1, uint16be 1, uint8 V) #fclose F #end "
                             "#macro Read() function { pigment { density_file df3 \"" +
                             name +
                             "\" color_map { [0 rgb 0] [1 rgb 1] } } } #end "
                             "Write(255) #declare P = Read() Write(0) #declare Q = Read() D(P(.5, .5, "
                             ".5).gray) D(Q(.5, .5, .5).gray)";
    EXPECT_EQ(said(text), "1.000000 0.000000");
}

TEST(Version, DecidesGamma) {
    const Reading none = read_scene("sphere { 0, 1 }");
    EXPECT_EQ(none.scene.effective_version, 362);
    EXPECT_FALSE(none.scene.has_gamma_handling());
    const Reading modern = read_scene("#version 3.7; sphere { 0, 1 }");
    EXPECT_EQ(modern.scene.effective_version, 370);
    EXPECT_TRUE(modern.scene.has_gamma_handling());
    const Reading old = read_scene("#version 3.6; global_settings { assumed_gamma 2.2 } sphere { 0, 1 }");
    EXPECT_TRUE(old.scene.has_gamma_handling());
    const Reading last = read_scene("#version 3.7; sphere { 0, 1 } #version 3.5;");
    EXPECT_FALSE(last.scene.has_gamma_handling());
    EXPECT_FALSE(read_scene("#version 3.8; sphere { 0, 1 }").done);
    EXPECT_EQ(read_scene("#version 3.7; global_settings { assumed_gamma srgb } sphere { 0, 1 }").report, "");
}

TEST(Options, DeclaresAndClock) {
    LoadOptions options;
    options.clock = 0.1;
    options.declares = {{"Size", 2.5}, {"Name", std::string("abc")}, {"Size", 7.0}};
    options.image_width = 640;
    const Reading reading = read_scene(
        "#version 3.7; global_settings{assumed_gamma 1} sphere{0,1} "
        "#debug concat(str(Size,0,1),\" \",Name,\" \",str(clock,0,15),\" \",str(image_width,0,0),\"\\n\")",
        options);
    EXPECT_EQ(reading.debug, "2.5 abc 0.100000001490116 640\n");
}

TEST(Options, EndlessLoopsEnd) {
    LoadOptions options;
    options.max_tokens = 100000;
    EXPECT_FALSE(read_scene("#while (1) #end", options).done);
}

}  // namespace
}  // namespace rb
