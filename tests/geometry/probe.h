#pragma once
#include "compile/probe.h"
#include "tests/geometry/statement.h"

#include <gtest/gtest.h>

namespace rb {

inline void expect_near(const Vec3& got, const Vec3& wanted, const char* what) {
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(got[i], wanted[i], 2e-7 * (1.0 + std::abs(wanted[i]))) << what << " " << i;
}

/// What the language asks of an object, against values measured with the reference program.
class Probe {
public:
    explicit Probe(std::string_view text) : object_(object_from(text)) {}

    void hits(const Vec3& origin, const Vec3& direction, const Vec3& point, const Vec3& normal) {
        const auto traced = probe_.trace(object_, origin, direction);
        ASSERT_TRUE(traced.has_value());
        expect_near(traced->point, point, "point");
        expect_near(traced->normal, normal, "normal");
    }
    void misses(const Vec3& origin, const Vec3& direction) {
        const auto traced = probe_.trace(object_, origin, direction);
        EXPECT_FALSE(traced.has_value()) << (traced ? traced->point.z : 0.0);
    }
    bool inside(const Vec3& p) { return probe_.inside(object_, p); }
    Bounds extent() { return probe_.extent(object_); }

private:
    ObjectPtr object_;
    Diagnostics diagnostics_;
    ObjectProbe probe_{diagnostics_};
};

inline const Vec3 x{1, 0, 0};
inline const Vec3 y{0, 1, 0};
inline const Vec3 z{0, 0, 1};

}  // namespace rb
