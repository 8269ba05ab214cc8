// Sweeps: values measured with the reference program, and what it gets
// wrong.
#include "tests/geometry/probe.h"

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

}  // namespace
}  // namespace rb
