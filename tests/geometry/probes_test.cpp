// Values measured with the reference program (trace, inside, min_extent, max_extent).
#include "tests/geometry/probe.h"

namespace rb {
namespace {

TEST(Probes, P1Sphere) {
    Probe o("sphere{<0,0,0>,1}");
    o.hits({.3, .2, -5}, z, {.3, .2, -.9327379}, {.3, .2, -.9327379});
    o.misses({1, 0, -5}, z);
    o.hits({0, 0, -1.00005}, z, {0, 0, 1}, {0, 0, 1});
    o.hits({0, 0, -1.0002}, z, {0, 0, -1}, {0, 0, -1});
    EXPECT_FALSE(o.inside({1, 0, 0}));
    EXPECT_TRUE(o.inside({.99999999, 0, 0}));
}

TEST(Probes, P2Ellipsoid) {
    Probe o("sphere{<1,2,3>,1 scale <1,2,3>}");
    o.hits({1.3, 4.2, -5}, z, {1.3, 4.2, 6.1539501}, {.6837635, .1139606, -.72075});
    expect_near(o.extent().lo, {0, 2, 6}, "min");
    expect_near(o.extent().hi, {2, 6, 12}, "max");
}

TEST(Probes, P3BoxSidesAndTies) {
    Probe o("box{<-1,-2,-3>,<1,2,3>}");
    o.hits({1, .2, -5}, z, {1, .2, -3}, {0, 0, -1});
    o.hits({0, 0, 0}, z, {0, 0, 3}, {0, 0, 1});
    o.hits({-5, -5, -5}, {4, 3, 2}, {-1, -2, -3}, {-1, 0, 0});
    EXPECT_TRUE(o.inside({1, 2, 3}));
}

TEST(Probes, P4PlaneDistance) {
    Probe o("plane{<0,3,0>,2}");
    o.hits({.3, 10, -5}, -y, {.3, 2, -5}, {0, 1, 0});
    EXPECT_TRUE(o.inside({0, 2, 0}));
    EXPECT_FALSE(o.inside({0, 2.0000001, 0}));
}

TEST(Probes, P5PlaneScaledAndRotated) {
    Probe o("plane{y,2 scale <1,3,1> rotate <0,0,45>}");
    o.hits({0, 0, 0}, y, {0, 8.4852814, 0}, {-.7071068, .7071068, 0});
}

TEST(Probes, P6CylinderClosed) {
    Probe o("cylinder{<0,0,0>,<0,2,0>,1}");
    o.hits({.3, 1, -5}, z, {.3, 1, -.9539392}, {.3, 0, -.9539392});
    o.hits({.3, 5, 0}, -y, {.3, 2, 0}, {0, 1, 0});
    EXPECT_FALSE(o.inside({0, 2, 0}));
    EXPECT_TRUE(o.inside({.9999999999, 1, 0}));
}

TEST(Probes, P7CylinderOpen) {
    Probe o("cylinder{<0,0,0>,<0,2,0>,1 open}");
    o.misses({.3, 5, 0}, -y);
    EXPECT_TRUE(o.inside({0, 2, 0}));
    EXPECT_TRUE(o.inside({1, 1, 0}));
}

TEST(Probes, P8Cone) {
    Probe o("cone{<0,0,0>,1,<0,2,0>,0.5}");
    o.hits({.3, 1, -5}, z, {.3, 1, -.6873864}, {.388057, .2425356, -.8891503});
    expect_near(o.extent().hi, {1, 2, 1}, "max");
}

TEST(Probes, P9DoubleCone) {
    Probe o("cone{<0,0,0>,1,<0,2,0>,-1}");
    o.hits({.2, .5, -5}, z, {.2, .5, -.4582576}, {.2828427, .7071068, -.6480741});
    o.hits({.2, 1.5, -5}, z, {.2, 1.5, -.4582576}, {.2828427, -.7071068, -.6480741});
}

TEST(Probes, P10DiscWithHole) {
    Probe o("disc{<0,0,0>,y,1,0.5}");
    o.hits({.7, 3, 0}, -y, {.7, 0, 0}, {0, 1, 0});
    o.misses({.3, 3, 0}, -y);
    EXPECT_TRUE(o.inside({9, -1, 0}));
    EXPECT_FALSE(o.inside({0, 0, 0}));
}

TEST(Probes, P11Torus) {
    Probe o("torus{2,0.5}");
    o.hits({2, 3, .1}, -y, {2, .4999938, .1}, {.0049906, .9999875, .0002495});
    o.hits({5, .1, .2}, -x, {2.4818525, .1, .2}, {.9766299, .2, .0787017});
    EXPECT_TRUE(o.inside({2.5, 0, 0}));
}

TEST(Probes, P37QuadricBoxes) {
    Probe o("quadric{<1,0,1>,<0,0,0>,<0,0,0>,-1 clipped_by{box{-2,2}}}");
    expect_near(o.extent().lo, {-1, -2, -1}, "min");
    expect_near(o.extent().hi, {1, 2, 1}, "max");
}

TEST(Probes, TurnedQuadricsWithoutACentre) {
    Probe paraboloid("quadric{<1,0,1>,<0,0,0>,<0,-1,0>,0 scale 8 rotate <-40,0,0>}");
    paraboloid.hits({1, 2, -50}, z, {1, 2, -13.3456551}, {.1015953, -.8949816, -.4343804});
    paraboloid.misses({3, -50, 4}, y);
    paraboloid.misses({-60, 3, 2}, x);
    Probe planes("quadric{<1,0,0>,<0,0,0>,<0,0,0>,-1 rotate <10,20,30>}");
    planes.hits({1, 2, -50}, z, {1, 2, 2.2030583}, {.8137977, .4698463, -.3420201});
    Probe cylinder("quadric{<1,1,0>,<0,0,0>,<0,0,0>,-1 rotate <10,20,30>}");
    cylinder.hits({.3, .4, -50}, glm::normalize(Vec3{.01, .01, 1}), {.8076617, .9076617, .7661699},
                  {.4173644, .8890726, -.1880345});
}

TEST(Probes, P67InvertedQuadricKeepsItsNormal) {
    Probe o("quadric{<1,1,1>,<0,0,0>,<0,0,0>,-1 inverse}");
    o.hits({.3, .4, -5}, z, {.3, .4, -.8660254}, {.3, .4, -.8660254});
    EXPECT_FALSE(o.inside({0, 0, 0}));
}

TEST(Probes, P12TriangleOrientation) {
    Probe o("triangle{<0,0,0>,<1,0,0>,<0,1,0>}");
    o.hits({.2, .2, -5}, z, {.2, .2, 0}, {0, 0, -1});
    o.hits({.5, .5, -5}, z, {.5, .5, 0}, {0, 0, -1});
}

TEST(Probes, P13TriangleOrientation2) {
    Probe("triangle{<0,0,0>,<0,1,0>,<1,0,0>}").hits({.2, .2, -5}, z, {.2, .2, 0}, {0, 0, 1});
}

TEST(Probes, P14TriangleTurnedByATransformation) {
    // The reference turns it at any transformation; here the identity is none.
    Probe o("triangle{<0,0,0>,<0,1,0>,<1,0,0> translate <0,0,1>}");
    o.hits({.2, .2, -5}, z, {.2, .2, 1}, {0, 0, -1});
}

TEST(Probes, P15SmoothTriangle) {
    Probe o("smooth_triangle{<0,0,0>,<-1,0,-1>,<1,0,0>,<1,0,-1>,<0,1,0>,<0,1,-1>}");
    o.hits({.2, .1, -5}, z, {.2, .1, 0}, {-.4454354, .0890871, -.8908708});
}

TEST(Probes, P16SmoothTriangleRejected) {
    Probe o("smooth_triangle{<0,0,0>,<-1,0,-1>,<1,0,0>,<1,0,1>,<0,1,0>,<0,1,-1>}");
    o.misses({1. / 3, 1. / 3, -5}, z);
}

TEST(Probes, P17Mesh2Smooth) {
    Probe o(
        "mesh2{vertex_vectors{4,<0,0,0>,<1,0,0>,<1,1,0>,<0,1,0>} "
        "normal_vectors{4,<-1,-1,-1>,<1,-1,-1>,<1,1,-1>,<-1,1,-1>} face_indices{2,<0,1,2>,<0,2,3>}}");
    o.hits({.6, .2, -5}, z, {.6, .2, 0}, {.1690309, -.5070926, -.8451543});
}

TEST(Probes, P18Mesh2Solid) {
    Probe o(
        "mesh2{vertex_vectors{4,<0,0,0>,<1,0,0>,<0,1,0>,<0,0,1>} "
        "face_indices{4,<0,1,2>,<0,1,3>,<0,2,3>,<1,2,3>} inside_vector <.3,.4,.5>}");
    EXPECT_TRUE(o.inside({.1, .1, .1}));
    EXPECT_FALSE(o.inside({1, 1, 1}));
    o.hits({.1, .1, 5}, -z, {.1, .1, .8}, {-.5773503, -.5773503, -.5773503});
}

TEST(Probes, P22BlobSphere) {
    Probe o("blob{threshold 0.5 sphere{0,2,1}}");
    o.hits({.3, .1, -5}, z, {.3, .1, -1.035168}, {.2771639, .092388, -.9563706});
    // The reference misses what is nearer than 0.01.
    o.hits({0, 0, -1.1024}, z, {0, 0, -1.0823922}, {0, 0, -1});
}

TEST(Probes, P23BlobCylinder) {
    Probe o("blob{threshold 0.5 cylinder{0,<0,2,0>,1,1}}");
    o.hits({.1, 1, -5}, z, {.1, 1, -.5318771}, {.1847759, 0, -.9827807});
    o.hits({0, 5, 0}, -y, {0, 2.5411961, 0}, {0, 1, 0});
    expect_near(o.extent().hi, {1.4142135, 3, 1.4142135}, "max");
}

TEST(Probes, P24BlobOfTwo) {
    Probe o("blob{threshold 0.6 sphere{0,1,1} sphere{<.9,0,0>,1,1}}");
    o.hits({.45, .1, -5}, z, {.45, .1, -.4896707}, {0, .2000891, -.9797777});
}

TEST(Probes, P39IsosurfaceFindsTheRootBeyondItsAccuracy) {
    // The reference stops within its accuracy, at -0.8652344; both take the normal by differences of that
    // size.
    Probe o("isosurface{function{x*x+y*y+z*z-1} contained_by{box{<-2,-2,-2>,<2,2,2>}} max_gradient 4}");
    o.hits({.3, .4, -5}, z, {.3, .4, -.8660254}, {.3005248, .4005331, -.8655969});
}

TEST(Probes, P40IsosurfaceContainer) {
    Probe o("isosurface{function{x*x+y*y+z*z-1} contained_by{box{<-.5,-.5,-.5>,<.5,.5,.5>}} max_gradient 4}");
    o.hits({.3, .4, -5}, z, {.3, .4, -.5}, {0, 0, -1});
}

TEST(Probes, P41IsosurfaceNormalsAreDifferencesOverItsAccuracy) {
    // The reference stops at -0.8125.
    Probe o(
        "isosurface{function{x*x+y*y+z*z-1} contained_by{box{<-2,-2,-2>,<2,2,2>}} max_gradient 4 accuracy "
        ".1}");
    o.hits({.3, .4, -5}, z, {.3, .4, -.8660254}, {0.3516039, 0.4520622, -0.8197649});
}

TEST(Probes, P66IsosurfaceScaled) {
    // The reference's depths are within its accuracy; none of them is nearer than the surface.
    const ObjectPtr object = object_from(
        "isosurface{function{x*x+y*y+z*z-1+0.1*sin(10*x)*sin(7*y)} contained_by{box{<-2,-2,-2>,<2,2,2>}} "
        "max_gradient 5 accuracy 0.01 scale 2}");
    Diagnostics diagnostics;
    ObjectProbe probe(diagnostics);
    const struct {
        Vec3 origin, direction, point;
    } rays[] = {{{.31, .42, -7}, {.05, .03, 1}, {.57015625, .57609375, -1.796875}},
                {{1.3, .2, -7}, {.01, .02, 1}, {1.35625, .3125, -1.375}},
                {{.1, .2, .3}, {.3, .5, 1}, {.5222061, .9036768, 1.7073537}},
                {{-3, -2.5, -6}, {.4, .35, 1}, {-1.15, -.88125, -1.375}}};
    for (const auto& ray : rays) {
        const auto traced = probe.trace(object, ray.origin, ray.direction);
        ASSERT_TRUE(traced.has_value());
        EXPECT_NEAR(traced->point.z, ray.point.z, 0.02);
        EXPECT_LE(traced->point.z, ray.point.z);
    }
}

TEST(Probes, P56IsosurfaceInADifferenceNeedsAllIntersections) {
    Probe o("difference{sphere{0,1} isosurface{function{x} contained_by{box{<-2,-2,-2>,<2,2,2>}}}}");
    o.hits({-5, 0, 0}, x, {1, 0, 0}, {1, 0, 0});
}

// The reference, whose point lies behind the jump, takes (1, 0, 0) for the normals towards -y and -z.
TEST(Probes, IsosurfaceOfAFunctionThatJumps) {
    Probe o("isosurface{function{select(max(abs(x-.1),abs(y),abs(z))-1,-1,1)} contained_by{box{-2,2}}}");
    o.hits({.3, .4, -5}, z, {.3, .4, -1}, {0, 0, -1});
    o.hits({.3, .4, 5}, -z, {.3, .4, 1}, {0, 0, 1});
    o.hits({-5, .4, .3}, x, {-.9, .4, .3}, {-1, 0, 0});
    o.hits({.3, 5, .3}, -y, {.3, 1, .3}, {0, 1, 0});
    o.misses({.3, 1.1, -5}, z);
}

TEST(Probes, P57IsosurfaceInADifference) {
    Probe o(
        "difference{sphere{0,1} isosurface{function{x} contained_by{box{<-2,-2,-2>,<2,2,2>}} "
        "all_intersections}}");
    o.hits({-5, 0, 0}, x, {0, 0, 0}, {-1, 0, 0});
}

TEST(Probes, P35Superellipsoid) {
    Probe("superellipsoid{<.25,2>}")
        .hits({.3, .4, -5}, z, {.3, .4, -.5952008}, {.0900042, .6742704, -.7329793});
}

TEST(Probes, P36SuperellipsoidSharp) {
    Probe o("superellipsoid{<.25,.25>}");
    o.hits({.3, .4, -5}, z, {.3, .4, -.9999098}, {.0002188, .0016394, -.9999986});
    o.hits({5, 5, 5}, {-1, -1, -1}, {.8716855, .8716855, .8716855}, {.5773503, .5773503, .5773503});
}

TEST(Probes, P38CubicWithTheCoefficientsOfASphere) {
    Probe o("cubic{<0,0,0,1,0,0,0,0,0,0, 0,0,1,0,0,0, 0,1,0,-1>}");
    o.hits({.3, .4, -5}, z, {.3, .4, -.8660254}, {.3, .4, -.8660254});
    EXPECT_TRUE(o.inside({.99999999, 0, 0}));
}

TEST(Probes, P49Ovus) {
    Probe o("ovus{1,0.6}");
    o.hits({0, 5, .1}, -y, {0, 1.591608, .1}, {0, .9860133, .1666667});
    o.hits({5, .5, .1}, -x, {.9364215, .5, .1}, {.9652844, .24, .1030823});
    expect_near(o.extent().hi, {1.0002, 1.6, 1.0002}, "max");
}

TEST(Probes, P55PatchInDifference) {
    Probe o("difference{sphere{0,1} triangle{<-1,-1,0>,<1,-1,0>,<0,1,0>}}");
    o.hits({0, 0, -5}, z, {0, 0, 0}, {0, 0, -1});
}

TEST(Probes, P25LatheCubic) {
    Probe o("lathe{cubic_spline 5,<1,-1>,<1,0>,<.5,1>,<1,2>,<0,3>}");
    o.hits({.2, .5, -5}, z, {.2, .5, -.6903634}, {.2292986, .5665288, -.7914968});
    o.hits({.2, 1.5, -5}, z, {.2, 1.5, -.7552162}, {.1986852, -.6305926, -.7502514});
    expect_near(o.extent().hi, {1.0081482, 2, 1.0081482}, "max");
}

TEST(Probes, P26LatheQuadratic) {
    Probe o("lathe{quadratic_spline 5,<1,-1>,<1,0>,<.5,1>,<1,2>,<0,3>}");
    o.hits({.2, .5, -5}, z, {.2, .5, -.7875}, {.2201667, .4472136, -.8669064});
    o.hits({.2, 1.5, -5}, z, {.2, 1.5, -.592136}, {.2862167, -.4472136, -.847396});
}

TEST(Probes, P27LatheBezier) {
    Probe o("lathe{bezier_spline 4,<1,0>,<2,0>,<2,1>,<1,1>}");
    o.hits({.2, .5, -5}, z, {.2, .5, -1.7385339}, {.1142857, 0, -.9934479});
    EXPECT_FALSE(o.inside({.5, .5, 0}));
    EXPECT_TRUE(o.inside({1.5, .5, 0}));
}

TEST(Probes, P28Sor) {
    Probe o("sor{5,<.5,-1>,<1,0>,<.5,1>,<.8,2>,<.5,3>}");
    o.hits({.2, .5, -5}, z, {.2, .5, -.7729812}, {.2062842, .5672817, -.7972693});
    o.hits({.2, 5, 0}, -y, {.2, 2, 0}, {0, 1, 0});
}

TEST(Probes, P29PrismCubic) {
    Probe o("prism{cubic_spline 0,1,7,<0,1>,<0,0>,<1,0>,<1,1>,<0,1>,<0,0>,<1,0>}");
    o.hits({.3, .4, -5}, z, {.3, .4, -.1116345}, {-.1384182, 0, -.9903739});
    expect_near(o.extent().lo, {-.125, 0, -.125}, "min");
    expect_near(o.extent().hi, {1.125, 1, 1.125}, "max");
}

TEST(Probes, P30PrismConic) {
    Probe o("prism{conic_sweep linear_spline 0.5,1,5,<-1,-1>,<1,-1>,<1,1>,<-1,1>,<-1,-1>}");
    o.hits({.3, .7, -5}, z, {.3, .7, -.7}, {0, -.7071068, -.7071068});
    o.hits({.3, -5, .4}, y, {.3, .5, .4}, {0, 1, 0});
    expect_near(o.extent().lo, {-1, .5, -1}, "min");
}

TEST(Probes, P31PrismBoundaries) {
    Probe o("prism{0,1,5,<0,0>,<1,0>,<1,1>,<0,1>,<0,0>}");
    EXPECT_FALSE(o.inside({.3, 1, .5}));
    EXPECT_TRUE(o.inside({.3, 0, .5}));
    // Along a wall.
    o.misses({0, .5, -5}, z);
    o.misses({1, .5, -5}, z);
    o.hits({-5, .5, 0}, x, {0, .5, 0}, {-1, 0, 0});
    o.hits({-5, .5, 1}, x, {0, .5, 1}, {-1, 0, 0});
}

TEST(Probes, P46TextKerning) {
    Probe o("text{internal 1 \"AV\" 1,0}");
    expect_near(o.extent().lo, {-.0000121, -.0160175, -.0000236}, "min");
    expect_near(o.extent().hi, {1.2780178, .6960223, 1.0000131}, "max");
}

TEST(Probes, P47TextOffset) {
    Probe o("text{internal 1 \"AAA\" 1,<0.1,0.2,0.3>}");
    expect_near(o.extent().hi, {2.4360175, 1.0960425, 1.0000201}, "max");
    // A negative thickness behind the string is no subtraction.
    expect_near(Probe("text{internal 1 \"AV\" -0.3,0}").extent().lo, {-.0000174, -.016, -.3000216}, "min");
    expect_near(Probe("text{internal 2 \" a b\" 0.3,<0.1,0,0>}").extent().hi, {1.9040054, .7280332, .3000137},
                "max");
}

TEST(Probes, P48TextFaces) {
    Probe o("text{internal 2 \"o\" 0.3,0}");
    o.hits({.05, .2, -5}, z, {.05, .2, .0000026}, {-.0000175, .0000175, -1});
    o.hits({-5, .25, .1}, x, {.0001262, .25, .1}, {.9996641, .0259179, -.000017});
    EXPECT_TRUE(o.inside({.05, .2, .1}));
    EXPECT_FALSE(o.inside({.25, .25, .1}));
}

TEST(Probes, P19PolygonWithHole) {
    Probe o("polygon{10,<0,0>,<1,0>,<1,1>,<0,1>,<0,0>,<.2,.2>,<.8,.2>,<.8,.8>,<.2,.8>,<.2,.2>}");
    o.hits({.1, .4, -5}, z, {.1, .4, 0}, {0, 0, 1});
    o.misses({.5, .5, -5}, z);
}

constexpr const char* patch_points =
    "<0,0,0>,<1,0,0>,<2,0,0>,<3,0,0>,<0,1,0>,<1,1,1>,<2,1,1>,<3,1,0>,"
    "<0,2,0>,<1,2,1>,<2,2,1>,<3,2,0>,<0,3,0>,<1,3,0>,<2,3,0>,<3,3,0>}";

TEST(Probes, P20BicubicPatchTwoSteps) {
    Probe o("bicubic_patch{type 1 flatness 0 u_steps 2 v_steps 2 " + std::string(patch_points));
    o.hits({1.5, 1.4, -5}, z, {1.5, 1.4, .54375}, {0, .0471648, -.9988871});
    o.hits({.5, 1.1, -5}, z, {.5, 1.1, .2601562}, {.3832156, .0527727, -.9221501});
    expect_near(o.extent().hi, {3, 3, 1}, "max");
}

TEST(Probes, P21BicubicPatchDefaultSteps) {
    Probe o("bicubic_patch{type 1 " + std::string(patch_points));
    o.hits({1.5, 1.4, -5}, z, {1.5, 1.4, 0}, {0, 0, -1});
}

TEST(Probes, P50CoincidentBoxes) {
    Probe o("difference{box{0,1} box{0,1}}");
    o.hits({.3, .4, -5}, z, {.3, .4, 0}, {0, 0, 1});
    EXPECT_FALSE(o.inside({.5, .5, .5}));
}

TEST(Probes, P51MergeOfIdenticalBoxes) { Probe("merge{box{0,1} box{0,1}}").misses({.3, .4, -5}, z); }

TEST(Probes, P52MergeSharesAFace) {
    Probe("merge{box{0,1} box{x,<2,1,1>}}").hits({.5, .4, .3}, x, {2, .4, .3}, {1, 0, 0});
}

TEST(Probes, P53PlanesMakeABox) {
    Probe o(
        "intersection{plane{y,1} plane{<0,-1,0>,1} plane{x,1} plane{<-1,0,0>,1} plane{z,1} "
        "plane{<0,0,-1>,1}}");
    expect_near(o.extent().lo, {-1, -1, -1}, "min");
    o.hits({.1, .2, -5}, z, {.1, .2, -1}, {0, 0, -1});
}

TEST(Probes, P54InverseUnion) {
    Probe o("union{sphere{0,1} sphere{<0.5,0,0>,1} inverse}");
    EXPECT_FALSE(o.inside({0, 0, 0}));
    EXPECT_TRUE(o.inside({9, 9, 9}));
    o.hits({0, 0, -5}, z, {0, 0, -1}, {0, 0, 1});
}

TEST(Probes, P58Clipping) {
    Probe o("sphere{0,1 clipped_by{plane{y,0}}}");
    o.misses({0, .5, -5}, z);
    o.hits({0, 5, 0}, -y, {0, -1, 0}, {0, -1, 0});
    EXPECT_FALSE(o.inside({0, .5, 0}));
}

TEST(Probes, P59BoundCutsByRay) {
    Probe o("sphere{0,1 bounded_by{box{-.5,.5}}}");
    o.hits({.2, .2, -5}, z, {.2, .2, -.9591663}, {.2, .2, -.9591663});
    o.misses({.8, .2, -5}, z);
    expect_near(o.extent().hi, {.5, .5, .5}, "max");
}

TEST(Probes, P60RotationSense) {
    Probe("sphere{x,.1 rotate <0,90,0>}").hits({0, 5, -1}, -y, {0, .1, -1}, {0, 1, 0});
}

TEST(Probes, P61MatrixOrder) {
    Probe o("sphere{<1,2,3>,.1 matrix <1,2,3,4,5,6,7,8,10,11,12,13> scale 0.01}");
    expect_near(o.extent().lo, {.398, .465, .561}, "min");
    expect_near(o.extent().hi, {.422, .495, .599}, "max");
}

TEST(Probes, P67InvertedSphereTurnsItsNormal) {
    Probe("sphere{0,1 inverse}").hits({.3, .2, -5}, z, {.3, .2, -.9327379}, {-.3, -.2, .9327379});
}

}  // namespace
}  // namespace rb
