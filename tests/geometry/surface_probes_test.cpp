// Sweeps, parametric surfaces and fractals: values measured with the reference program, and what it gets
// wrong.
#include "shapes/julia_orbit.h"
#include "tests/geometry/probe.h"
#include "tests/geometry/shape_cases.h"

namespace rb {
namespace {

TEST(Probes, P32SphereSweepLinear) {
    Probe o("sphere_sweep{linear_spline 3,<0,0,0>,.5,<2,0,0>,.3,<2,2,0>,.2}");
    o.hits({1, .1, -5}, z, {1, .1, -.3893792}, {.1, .2475, -.9637135});
    expect_near(o.extent().hi, {2.3, 2.2, .5}, "max");
}

TEST(Probes, P33SphereSweepBasisSpline) {
    Probe("sphere_sweep{b_spline 4,<0,0,0>,.5,<2,0,0>,.3,<2,2,0>,.2,<0,3,0>,.2}")
        .hits({1.7, .7, -5}, z, {1.7, .7, -.2289884}, {-.5170695, .2878429, -.8060928});
}

TEST(Probes, P34SphereSweepCubic) {
    Probe("sphere_sweep{cubic_spline 4,<0,0,0>,.5,<2,0,0>,.3,<2,2,0>,.2,<0,3,0>,.2}")
        .hits({2.1, 1, -5}, z, {2.1, 1, -.1814683}, {-.6354642, .0284595, -.7716056});
}

TEST(SphereSweep, InsideEveryBallIsInside) {
    Probe o("sphere_sweep{linear_spline 2,<0,0,0>,2,<0.1,0,0>,2}");
    EXPECT_TRUE(o.inside({0, 0, 0}));
    EXPECT_FALSE(o.inside({0, 0, 2.1}));
}

TEST(SphereSweep, OneHoldsTheOther) {
    // The smaller end lies within the larger one: no cone between them.
    Probe o("sphere_sweep{linear_spline 2,<0,0,0>,1,<0.5,0,0>,.1}");
    o.hits({0, 0, -5}, z, {0, 0, -1}, -z);
    o.hits({5, 0, 0}, -x, {1, 0, 0}, x);
}

TEST(SphereSweep, CoincidentNeighbours) {
    Probe o("sphere_sweep{cubic_spline 6,<0,0,0>,1,<0,0,0>,1,<0,0,0>,1,<2,0,0>,1,<2,0,0>,1,<2,0,0>,1}");
    o.hits({1, 0, -5}, z, {1, 0, -1}, -z);
    o.hits({0, 0, 0}, z, {0, 0, 1}, z);
}

TEST(SphereSweep, Refusals) {
    EXPECT_THROW(object_from("sphere_sweep{2,<0,0,0>,1,<1,0,0>,1}"), SceneError);
    EXPECT_THROW(object_from("sphere_sweep{linear_spline 1,<0,0,0>,1}"), SceneError);
    EXPECT_THROW(object_from("sphere_sweep{b_spline 3,<0,0,0>,1,<1,0,0>,1,<2,0,0>,1}"), SceneError);
    EXPECT_THROW(object_from("sphere_sweep{b_spline 400000000,<0,0,0>,1}"), SceneError);
}

TEST(Probes, P42Parametric) {
    // The reference stops within its accuracy of the surface, and takes the normal at a corner of its cell.
    ObjectProbe probe(*std::make_unique<Diagnostics>());
    const ObjectPtr o = object_from(
        "parametric{function{u},function{v},function{u*v} <-1,-1>,<1,1> contained_by{box{-1.1,1.1}} "
        "max_gradient 2 accuracy .0001}");
    const auto traced = probe.trace(o, {.3, .4, -5}, z);
    ASSERT_TRUE(traced.has_value());
    EXPECT_NEAR(traced->point.z, .12, 1e-12);
    const Vec3 measured{-.3577434, -.2683212, .8944403};
    EXPECT_LT(glm::length(traced->normal - measured), 2e-4);
}

TEST(Parametric, SeesNothingBeyondItsContainer) {
    Probe o(
        "parametric{function{u},function{v},function{0} <-1,-1>,<1,1> contained_by{box{-.5,.5}} "
        "accuracy .0001}");
    o.hits({.4, .4, -5}, z, {.4, .4, 0}, z);
    o.misses({.6, .4, -5}, z);
}

TEST(Parametric, EdgesOfASphereAreFound) {
    // Between 0.9 and 1 of the radius both walls are near; max_gradient is of no use there.
    const std::string text =
        "parametric{function{sin(u)*cos(v)},function{sin(u)*sin(v)},function{cos(u)} <0,0>,<pi,2*pi> "
        "contained_by{box{-1.1,1.1}} max_gradient 0.1 accuracy .0001}";
    Diagnostics diagnostics;
    ObjectProbe probe(diagnostics);
    const ObjectPtr o = object_from(text);
    int missed = 0;
    constexpr int rays = 2000;
    for (int i = 0; i < rays; ++i) {
        const double r = 0.9999 - 0.5 * i / rays;
        const double angle = 0.7 * i;
        const Vec3 from{r * std::cos(angle), r * std::sin(angle), -5};
        const auto traced = probe.trace(o, from, z);
        if (!traced || std::abs(traced->point.z + std::sqrt(1 - r * r)) > 1e-9) ++missed;
    }
    EXPECT_EQ(missed, 0);
}

TEST(Parametric, Refusals) {
    const std::string start = "parametric{function{u},function{v},function{u} <0,0>,<1,1> ";
    EXPECT_THROW(object_from(start + "precompute 0, x}"), SceneError);
    EXPECT_THROW(object_from(start + "precompute 21}"), SceneError);
    EXPECT_THROW(object_from("parametric{function{u},function{v} <0,0>,<1,1>}"), SceneError);
    EXPECT_NO_THROW(object_from(start + "precompute 20,x,y,z}"));
    EXPECT_NO_THROW(object_from("parametric{function{1/u},function{ln(v)},function{0/0} <0,0>,<0,1>}"));
}

TEST(Probes, P43JuliaQuaternion) {
    Probe o("julia_fractal{<-.083,0,-.83,-.025> quaternion sqr max_iteration 8 precision 200}");
    o.hits({.1, .2, -5}, z, {.1, .2, -.3413396}, {.8547077, .1417876, -.4993707});
    expect_near(o.extent().hi, {1.8345144, 1.8345144, 1.8345144}, "max");
}

TEST(Probes, P44JuliaCube) {
    Probe("julia_fractal{<.2,.3,-.4,.1> quaternion cube max_iteration 6 precision 100}")
        .hits({.1, .2, -5}, z, {.1, .2, -1.0558198}, {.6210776, .0990495, -.777465});
}

TEST(Probes, P45JuliaHypercomplex) {
    Probe("julia_fractal{<.2,.3,-.4,.1> hypercomplex sqr max_iteration 6 precision 100}")
        .hits({.1, .2, -5}, z, {.1, .2, -.9697077}, {.5132353, .6068729, -.606873});
}

TEST(JuliaFractal, ItsBallIsNoSurface) {
    Probe("julia_fractal{<.2,.3,-.4,.1> hypercomplex ln max_iteration 4}").misses({.1, .2, -5}, z);
}

TEST(JuliaFractal, Refusals) {
    EXPECT_THROW(object_from("julia_fractal{<.1,.2,.3,.4> quaternion exp}"), SceneError);
    EXPECT_THROW(object_from("julia_fractal{<.1,.2,.3,.4> slice 0, 1}"), SceneError);
    EXPECT_THROW(object_from("julia_fractal{<.1,.2,.3,.4> slice <1,0,0,0>, 1}"), SceneError);
    EXPECT_THROW(object_from("julia_fractal{<.1,.2,.3,.4> max_iteration 1e9}"), SceneError);
    EXPECT_NO_THROW(object_from("julia_fractal{<.1,.2,.3> hypercomplex pwr(2,3)}"));
}

TEST(JuliaOrbit, PlacesAtOnceDoAsEachAlone) {
    Dice dice(5);
    const auto quaternion = [&](double size) {
        return Quaternion{dice.between(-size, size), dice.between(-size, size), dice.between(-size, size),
                          dice.between(-size, size)};
    };
    JuliaRule rule;
    uint32_t staying_any = 0;
    for (const auto algebra : {JuliaAlgebra::quaternion, JuliaAlgebra::hypercomplex}) {
        for (const auto function : {JuliaFunction::sqr, JuliaFunction::cube}) {
            rule.algebra = algebra;
            rule.function = function;
            for (size_t i = 0; i < 10 * RB_TEST_SAMPLES; ++i) {
                rule.c = quaternion(0.6);
                rule.steps = 1 + i % 25;
                const JuliaFormula formula(rule);
                std::array<Quaternion, JuliaFormula::places_at_once> places;
                for (Quaternion& q : places) q = quaternion(1.0);
                const JuliaFormula::Orbits orbits = formula.orbits_of(places);
                const uint32_t staying = orbits.staying;
                staying_any |= staying;
                for (size_t k = 0; k < places.size(); ++k) {
                    EXPECT_EQ((staying >> k & 1) != 0, formula.stays(places[k]));
                    EXPECT_EQ(orbits.largest[k] <= formula.escape(), formula.stays(places[k]));
                }
            }
        }
    }
    EXPECT_NE(staying_any, 0u);
}

}  // namespace
}  // namespace rb
