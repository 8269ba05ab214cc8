// Functions as patterns, and patterns, pigments and transforms as functions.
#include "language/read_pattern.h"
#include "patterns/line_bound.h"
#include "patterns/pattern_field.h"
#include "patterns/pigment_program.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

namespace rb {

namespace {

PatternSettings settings_of(const GlobalSettings& settings) {
    return {settings.noise_generator, settings.number_of_waves};
}

class FunctionPattern final : public Pattern {
public:
    explicit FunctionPattern(FunctionPtr function) : function_(std::move(function)) {}
    std::string_view keyword() const override { return "function"; }
    void evaluate(const PatternContext&, std::span<const Vec3> points,
                  std::span<double> values) const override {
        std::vector<double> columns(3 * points.size());
        const std::array<double*, 3> column{columns.data(), columns.data() + points.size(),
                                            columns.data() + 2 * points.size()};
        for (size_t i = 0; i < points.size(); ++i) {
            column[0][i] = points[i].x;
            column[1][i] = points[i].y;
            column[2][i] = points[i].z;
        }
        const std::array<const double*, 3> arguments{column[0], column[1], column[2]};
        function_->evaluate_rows({arguments.data(), static_cast<size_t>(function_->parameter_count())},
                                 values);
    }
    IntervalSlope bound(const PatternContext&, const LinePlace& place) const override {
        return function_->bound_slope(
            std::span(place).first(static_cast<size_t>(function_->parameter_count())), 0);
    }

private:
    FunctionPtr function_;
};

class PigmentPattern final : public Pattern {
public:
    PigmentPattern(const Pigment& pigment, const GlobalSettings& settings)
        : program_(pigment, settings_of(settings)) {}
    std::string_view keyword() const override { return "pigment_pattern"; }
    SurfaceNeed surface_need() const override { return program_.surface_need(); }
    void evaluate(const PatternContext& context, std::span<const Vec3> points,
                  std::span<double> values) const override {
        std::vector<Color> colors(points.size());
        program_.evaluate({points, context.surface, context.rows}, colors);
        for (size_t i = 0; i < points.size(); ++i) values[i] = static_cast<double>(grey(colors[i].rgb()));
    }

private:
    PigmentProgram program_;
};

std::vector<Vec3> points_of(std::span<const double* const> coordinates, size_t count) {
    std::vector<Vec3> points(count);
    for (size_t i = 0; i < count; ++i) points[i] = {coordinates[0][i], coordinates[1][i], coordinates[2][i]};
    return points;
}

/// A function of a place: f(x, y, z).
class PlaceFunction : public Function {
public:
    int parameter_count() const final { return 3; }
    Interval bound(std::span<const Interval> a, int component) const final {
        const LinePlace standing{{{a[0], 0.0}, {a[1], 0.0}, {a[2], 0.0}}};
        return bound_along(standing, component).value;
    }
    IntervalSlope bound_slope(std::span<const IntervalSlope> a, int component) const final {
        return bound_along({a[0], a[1], a[2]}, component);
    }

protected:
    virtual IntervalSlope bound_along(const LinePlace& place, int component) const = 0;
};

class PatternFunction final : public PlaceFunction {
public:
    PatternFunction(PatternPtr pattern, const PatternModifiers& modifiers, const GlobalSettings& settings)
        : field_(std::move(pattern), modifiers, settings_of(settings)) {}
    int result_count() const override { return 1; }
    void evaluate(std::span<const double> a, std::span<double> result) const override {
        std::array<Vec3, 1> point{Vec3{a[0], a[1], a[2]}};
        field_.carry(point);
        field_.values({point}, result);
    }
    void evaluate_rows(std::span<const double* const> arguments, std::span<double> results) const override {
        std::vector<Vec3> points = points_of(arguments, results.size());
        field_.carry(points);
        field_.values({points}, results);
    }

private:
    IntervalSlope bound_along(const LinePlace& place, int) const override { return field_.bound(place); }

    PatternField field_;
};

class PigmentFunction final : public PlaceFunction {
public:
    PigmentFunction(const Pigment& pigment, const GlobalSettings& settings)
        : program_(pigment, settings_of(settings)) {}
    int result_count() const override { return 5; }
    void evaluate(std::span<const double> a, std::span<double> result) const override {
        const std::array<Vec3, 1> point{Vec3{a[0], a[1], a[2]}};
        std::array<Color, 1> color;
        program_.evaluate({point}, color);
        write(color[0], result);
    }
    void evaluate_all_rows(std::span<const double* const> arguments,
                           std::span<double> results) const override {
        const std::vector<Vec3> points = points_of(arguments, results.size() / 5);
        std::vector<Color> colors(points.size());
        program_.evaluate({points}, colors);
        for (size_t i = 0; i < colors.size(); ++i) write(colors[i], results.subspan(5 * i, 5));
    }

private:
    IntervalSlope bound_along(const LinePlace& place, int component) const override {
        return program_.bound(place, component);
    }

    /// As many of its terms as there is room for.
    static void write(const Color& c, std::span<double> to) {
        const auto terms = c.terms();
        std::copy_n(terms.begin(), std::min(terms.size(), to.size()), to.begin());
    }

    PigmentProgram program_;
};

class TransformFunction final : public PlaceFunction {
public:
    explicit TransformFunction(const Transform& map) : map_(map) {}
    int result_count() const override { return 3; }
    void evaluate(std::span<const double> a, std::span<double> result) const override {
        const Vec3 p = map_.point({a[0], a[1], a[2]});
        for (size_t i = 0; i < 3 && i < result.size(); ++i) result[i] = p[static_cast<int>(i)];
    }

private:
    IntervalSlope bound_along(const LinePlace& place, int component) const override {
        return carried(place, map_.forward)[static_cast<size_t>(component)];
    }

    Transform map_;
};

FunctionPtr pattern_function(const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    PatternModifiers modifiers;
    const TakenPattern taken = take_pattern(in, "pattern", modifiers);
    if (!taken.taken || taken.average)
        in.fail(fmt::format("Expected 'pattern', {} found instead", in.found()));
    PatternPtr pattern = taken.pattern;
    constexpr std::array<std::string_view, 7> refused{"facets", "square",   "triangular", "aoi",
                                                      "slope",  "pavement", "tiling"};
    for (std::string_view word : refused) {
        if (pattern->keyword() == word)
            in.fail_at(block.where, fmt::format("'{}' cannot be used in a function.", word));
    }
    while (take_parameter(in, pattern) || take_modifier(in, modifiers)) {
    }
    check_parameters(in, pattern);
    in.finish();
    if (const auto* unknown = dynamic_cast<const UnsupportedPattern*>(pattern.get())) {
        context.diagnostics->unsupported(unknown->where,
                                         fmt::format("pattern {} in a function", pattern->keyword()),
                                         "it gives 0.5 everywhere");
    }
    return std::make_shared<PatternFunction>(pattern, modifiers, *context.settings);
}

}  // namespace

PatternPtr function_pattern(const FunctionPtr& function) {
    return std::make_shared<FunctionPattern>(function);
}

PatternPtr pigment_pattern(const PigmentPtr& pigment, const GlobalSettings& settings) {
    return std::make_shared<PigmentPattern>(*pigment, settings);
}

FunctionPtr read_function_block(Session& session, const Block& block) {
    const ReadContext context = session.context();
    if (block.keyword == "pattern") return pattern_function(block, context);
    if (block.keyword == "pigment") {
        const PigmentPtr pigment = read_pigment(block, context, context.default_texture->front().pigment);
        if (pigment->uv_mapping) session.fail(block.where, "uv_mapping cannot be used in a function.");
        return std::make_shared<PigmentFunction>(*pigment, *context.settings);
    }
    if (block.keyword == "transform")
        return std::make_shared<TransformFunction>(*read_transform(block, context));
    session.fail(block.where, fmt::format("Expected 'function body', {} found instead", block.keyword));
}

}  // namespace rb
