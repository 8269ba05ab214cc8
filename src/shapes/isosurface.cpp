// isosurface { function { f(x,y,z) } [contained_by { box { <A>, <B> } | sphere { <C>, R } }] [threshold F]
//   [accuracy F] [max_gradient F] [evaluate P0, P1, P2] [open] [max_trace N | all_intersections] }
//   (manual 3.5.1.7)
#include "shapes/isosurface.h"

#include "math/random.h"
#include "shapes/container.h"
#include "shapes/registry.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace rb {

namespace {

constexpr int samples = 64;

Vec3 random_place(const Bounds& box, uint64_t number) {
    const auto share = [&](uint64_t axis) { return unit_random(mixed(number, axis)); };
    return box.lo + box.size() * Vec3{share(0), share(1), share(2)};
}

double positive_or(BlockReader& in, double otherwise, std::string_view what) {
    const SourceRange at = in.where();
    const double value = in.number();
    if (value > 0.0) return value;
    in.diagnostics().warning(at,
                             fmt::format("Isosurface '{}' must be positive: {} is taken.", what, otherwise));
    return otherwise;
}

struct Evaluate {
    double least = 0;
    double over = 1;
};

/// What the reference adapts while it renders, is measured at once: `evaluate` allows that.
void check_gradient(const SourceRange& where, const std::optional<Evaluate>& evaluate, IsosurfaceData& data,
                    Diagnostics& diagnostics) {
    if (!has_loose_bounds(data)) return;
    const double steepest = steepest_slope(data);
    if (evaluate) {
        data.max_gradient =
            std::max({data.max_gradient, evaluate->least, steepest * std::max(evaluate->over, 1.0)});
    } else if (steepest > data.max_gradient && !has_bounded_slopes(data)) {
        diagnostics.warning(
            where, fmt::format("The isosurface's max_gradient is {:.4g}, but a gradient of {:.4g} was "
                               "found: there may be holes.",
                               data.max_gradient, steepest));
    }
}

ShapePtr read(BlockReader& in) {
    IsosurfaceData data;
    const SourceRange at = in.where();
    if (!in.at_thing<FunctionPtr>())
        in.fail(fmt::format("Expected 'function', {} found instead", in.found()));
    data.function = in.thing<FunctionPtr>();
    if (data.function->parameter_count() != 3 || data.function->result_count() != 1) {
        in.fail_at(at, "An isosurface needs a float function of three parameters.");
    }
    SourceRange gradient_at = at;
    std::optional<Evaluate> evaluate;
    for (;;) {
        if (in.at_block("contained_by")) {
            const Container container = take_container(in);
            data.box = container.box;
            data.radius = container.radius;
        } else if (in.take_word("threshold")) {
            data.threshold = in.number();
        } else if (in.take_word("accuracy")) {
            data.accuracy = positive_or(in, data.accuracy, "accuracy");
        } else if (in.take_word("max_gradient")) {
            gradient_at = in.where();
            data.max_gradient = positive_or(in, data.max_gradient, "max_gradient");
        } else if (in.take_word("evaluate")) {
            evaluate.emplace();
            evaluate->least = in.number();
            evaluate->over = in.number();
            in.number();
        } else if (in.take_word("open")) {
            data.open = true;
        } else if (in.take_word("max_trace")) {
            const SourceRange trace_at = in.where();
            const int count = in.integer();
            constexpr int most = 10;
            if (count < 1 || count > most) in.diagnostics().warning(trace_at, "max_trace must be 1 to 10.");
            data.max_trace = static_cast<size_t>(std::clamp(count, 1, most));
        } else if (in.take_word("all_intersections")) {
            data.max_trace = std::numeric_limits<size_t>::max();
        } else {
            break;
        }
    }
    check_gradient(gradient_at, evaluate, data, in.diagnostics());
    return std::make_shared<Isosurface>(std::move(data));
}

}  // namespace

bool has_loose_bounds(const IsosurfaceData& data) {
    const auto width = [&](const Vec3& p, double side) {
        const Interval v = data.bound({p, p + side * data.size()});
        if (v.maybe_nan) return std::numeric_limits<double>::infinity();
        constexpr double rounding = 1e-12;
        return std::max(v.hi - v.lo - rounding * std::max(std::abs(v.lo), std::abs(v.hi)), 0.0);
    };
    // A bound that shrinks with its box becomes a hundredth; twice, lest it is a jump.
    const auto shrinks = [](double wide, double narrow) {
        return std::isfinite(narrow) && narrow <= 0.2 * wide;
    };
    for (uint64_t i = 0; i < samples; ++i) {
        const Vec3 p = random_place(data.box, i);
        const double narrow = width(p, 1e-5);
        if (!shrinks(width(p, 1e-3), narrow) && !shrinks(narrow, width(p, 1e-7))) return true;
    }
    return false;
}

bool has_bounded_slopes(const IsosurfaceData& data) {
    const Vec3 cell = data.box.size() * FunctionCells::cell_share;
    for (uint64_t i = 0; i < samples; ++i) {
        const Vec3 p = random_place(data.box, i);
        LinePlace place;
        for (int k = 0; k < 3; ++k) place[static_cast<size_t>(k)] = {{p[k], p[k] + cell[k]}, Interval(1.0)};
        const Interval slope = data.function->bound_slope(place, 0).slope;
        if (slope.maybe_nan || slope.has_infinity()) return false;
    }
    return true;
}

double steepest_slope(const IsosurfaceData& data) {
    double steepest = 0.0;
    constexpr uint64_t chords = 64;
    const double step = std::max(data.accuracy, 1e-4 * data.size());
    for (uint64_t i = 0; i < chords; ++i) {
        const Vec3 a = random_place(data.box, 2 * i + samples);
        const Vec3 way = random_place(data.box, 2 * i + 1 + samples) - a;
        const double length = glm::length(way);
        const double n = std::min(std::floor(length / step), 32.0);
        double before = data.value(a);
        for (double k = 1; k <= n; ++k) {
            const double f = data.value(a + way * (k / n));
            const double slope = std::abs(f - before) * n / length;
            // Only a change of sign can be missed.
            if (std::isfinite(slope) && (f < 0.0) != (before < 0.0)) steepest = std::max(steepest, slope);
            before = f;
        }
    }
    return steepest;
}

namespace shapes {
extern const ShapeKind isosurface;
const ShapeKind isosurface{"isosurface", read,
                           "isosurface { function { x*x + y*y*y*y + z*z - 0.4 + 0.1*sin(5*x)*sin(4*y) } "
                           "contained_by { box { <-1, -0.6, -0.8>, <1, 0.7, 0.5> } } all_intersections }"};
}  // namespace shapes

}  // namespace rb
