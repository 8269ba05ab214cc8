#include "patterns/made_patterns.h"

#include "patterns/formula.h"
#include "patterns/pigment_program.h"

namespace rb {

namespace {

class FunctionPattern final : public PointPattern<FunctionPattern> {
public:
    explicit FunctionPattern(FunctionPtr function) : function_(std::move(function)) {}
    std::string_view keyword() const override { return "function"; }
    double value(const Vec3& p) const {
        const double arguments[3] = {p.x, p.y, p.z};
        double result = 0;
        function_->evaluate(arguments, {&result, 1});
        return result > 1.0 ? std::fmod(result, 1.0) : result;
    }

private:
    FunctionPtr function_;
};

/// The same, compiled for one scene's settings.
class PreparedPigment final : public Pattern {
public:
    PreparedPigment(const Pigment& pigment, const PatternSettings& settings) : program_(pigment, settings) {}
    std::string_view keyword() const override { return "pigment_pattern"; }
    SurfaceNeed surface_need() const override { return program_.surface_need(); }
    void evaluate(const PatternContext& context, std::span<const Vec3> points,
                  std::span<double> values) const override {
        Scratch::Scope memory(thread_scratch());
        const auto colors = memory.take<Color>(points.size());
        program_.evaluate({points, context.surface, context.rows}, colors);
        for (size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(grey(colors[i].rgb()));
    }

private:
    PigmentProgram program_;
};

class PigmentPattern final : public Pattern {
public:
    explicit PigmentPattern(PigmentPtr pigment) : pigment_(std::move(pigment)) {}
    std::string_view keyword() const override { return "pigment_pattern"; }
    void evaluate(const PatternContext& context, std::span<const Vec3> points,
                  std::span<double> values) const override {
        PreparedPigment(*pigment_, {context.noise_generator, context.number_of_waves})
            .evaluate(context, points, values);
    }
    PatternPtr prepared(int noise_generator, int number_of_waves) const override {
        return std::make_shared<PreparedPigment>(*pigment_,
                                                 PatternSettings{noise_generator, number_of_waves});
    }

private:
    PigmentPtr pigment_;
};

class ObjectPattern final : public PointPattern<ObjectPattern> {
public:
    explicit ObjectPattern(InsideTest inside) : inside_(std::move(inside)) {}
    std::string_view keyword() const override { return "object"; }
    double value(const Vec3& p) const { return inside_(p) ? 1.0 : 0.0; }

private:
    InsideTest inside_;
};

}  // namespace

PatternPtr function_pattern(FunctionPtr function) {
    return std::make_shared<FunctionPattern>(std::move(function));
}
PatternPtr pigment_pattern(PigmentPtr pigment) {
    return std::make_shared<PigmentPattern>(std::move(pigment));
}
PatternPtr object_pattern(InsideTest inside) { return std::make_shared<ObjectPattern>(std::move(inside)); }

}  // namespace rb
