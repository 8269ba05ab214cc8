// Media where the reference draws random numbers (its mean, and less noise), and the pieces of a lit way.
// Measured values: tests/images/probes.txt.
#include "patterns/registry.h"
#include "scene_maker.h"
#include "shade/light_span.h"

#include <cmath>

#include <gtest/gtest.h>

namespace rb {
namespace {

/// Looks along z through a box from z = 0 to 2 that `media` fill.
struct Container {
    explicit Container(const Media& media) {
        Interior interior;
        interior.media = {std::make_shared<Media>(media)};
        maker.add("box{<-3,-3,0>,<3,3,2>}", {plain({0, 0, 0, 0, 1}, dark_finish())}, interior).hollow = true;
    }
    /// Red, as many rays see it.
    std::vector<double> looks(size_t count) const {
        std::vector<CameraRay> rays(count);
        for (size_t i = 0; i < count; ++i) {
            rays[i].ray = {{0, 0, -5}, {0, 0, 1}};
            rays[i].seed = i;
        }
        std::vector<double> red;
        for (const Radiance& seen : maker.look_all(rays)) red.push_back(static_cast<double>(seen.rgb.x));
        return red;
    }
    SceneMaker maker;
};

/// From 0 at z = 0 to 1 at `z_of_one`.
DensityPtr rising(double z_of_one = 2) {
    class Rising final : public Pattern {
    public:
        explicit Rising(double z_of_one) : z_of_one_(z_of_one) {}
        std::string_view keyword() const override { return "rising"; }
        void evaluate(const PatternContext&, std::span<const Vec3> points,
                      std::span<double> values) const override {
            for (size_t i = 0; i < points.size(); ++i) values[i] = points[i].z / z_of_one_;
        }

    private:
        double z_of_one_;
    };
    auto density = std::make_shared<Density>();
    density->source = PatternPtr(std::make_shared<Rising>(z_of_one));
    density->map = ColorMap{{0.0f, grey_color(0)}, {1.0f, grey_color(1)}};
    return density;
}

double mean_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double v : values) sum += v;
    return sum / static_cast<double>(values.size());
}

double deviation_of(const std::vector<double>& values) {
    const double mean = mean_of(values);
    double sum = 0;
    for (const double v : values) sum += (v - mean) * (v - mean);
    return std::sqrt(sum / static_cast<double>(values.size()));
}

Media random_media(int samples) {
    Media media;
    media.method = 1;
    media.min_samples = media.max_samples = samples;
    media.emission = Rgb(0.5f);
    return media;
}

TEST(Media, ConstantMediaOfMethodOneAreExact) {
    Media media = random_media(1);
    media.absorption = Rgb(0.7f);
    for (const double seen : Container(media).looks(5)) {
        EXPECT_NEAR(seen, 0.5 * (1 - std::exp(-1.4)) / 0.7, 1e-6);
    }
}

TEST(Media, RandomSamplesHaveTheRightMean) {
    Media media = random_media(1);
    media.densities = {rising()};
    // Emission 0.5 over a length of 2 with a mean density of one half.
    const auto one = Container(media).looks(4000);
    EXPECT_NEAR(mean_of(one), 0.5, 0.015);
    EXPECT_NEAR(deviation_of(one), 1.0 / std::sqrt(12.0), 0.02);
    media.min_samples = media.max_samples = 16;
    const auto many = Container(media).looks(1000);
    EXPECT_NEAR(mean_of(many), 0.5, 0.003);
    // Independent samples would deviate by 0.072.
    EXPECT_LT(deviation_of(many), 0.025);
}

TEST(Media, MoreSamplesAreTakenWhereTheyDiffer) {
    Media media = random_media(4);
    media.densities = {rising()};
    const double few = deviation_of(Container(media).looks(500));
    media.max_samples = 64;
    media.variance = 1e-6;
    const auto more = Container(media).looks(500);
    EXPECT_LT(deviation_of(more), 0.4 * few);
    EXPECT_NEAR(mean_of(more), 0.5, 0.004);
}

TEST(Media, JitterOfMethodTwoGoesForward) {
    Media media = random_media(8);
    media.method = 2;
    media.jitter = 1;
    media.densities = {rising(4)};
    const auto seen = Container(media).looks(1000);
    // Measured: from the middle of each eighth on, by up to an eighth.
    EXPECT_NEAR(mean_of(seen), 0.25 + 0.25 / 8, 0.002);
    EXPECT_GT(deviation_of(seen), 0.003);
}

TEST(LightSpan, ConesAndCylinders) {
    Light light;
    light.location = {0, 10, 5};
    light.point_at = {0, 0, 5};
    const Ray ray{{0, 0, 0}, {0, 0, 1}};
    EXPECT_EQ(lit_span(light, ray, 20)->to, 20);
    light.kind = LightKind::spotlight;
    light.falloff = std::atan(0.2) * 180 / pi;
    const auto cone = lit_span(light, ray, 20);
    ASSERT_TRUE(cone);
    EXPECT_NEAR(cone->from, 3, 1e-9);
    EXPECT_NEAR(cone->to, 7, 1e-9);
    EXPECT_NEAR(lit_span(light, ray, 6)->to, 6, 1e-9);
    EXPECT_FALSE(lit_span(light, ray, 2));
    // Only the cone in front of the light counts.
    EXPECT_FALSE(lit_span(light, {{0, 20, 0}, {0, 0, 1}}, 20));
    const auto inside = lit_span(light, {{0, 12, 5}, {0, -1, 0}}, 20);
    ASSERT_TRUE(inside);
    EXPECT_NEAR(inside->from, 2, 1e-9);
    EXPECT_NEAR(inside->to, 20, 1e-9);
    light.kind = LightKind::cylinder;
    light.falloff = 1.5;
    const auto tube = lit_span(light, ray, 20);
    ASSERT_TRUE(tube);
    EXPECT_NEAR(tube->from, 3.5, 1e-9);
    EXPECT_NEAR(tube->to, 6.5, 1e-9);
    EXPECT_NEAR(lit_span(light, {{1, 12, 5}, {0, -1, 0}}, 20)->from, 2, 1e-9);
    EXPECT_FALSE(lit_span(light, {{2, 12, 5}, {0, -1, 0}}, 20));
    light.media_interaction = false;
    EXPECT_FALSE(lit_span(light, ray, 20));
}

TEST(LightSpan, PiecesCoverTheWay) {
    std::vector<MediaPiece> pieces;
    cut_by_light({}, 9, pieces);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_FALSE(pieces[0].lit);
    const std::vector<LightSpan> spans{{2, 4, 0}, {3, 5, 1}, {7, 9, 2}};
    cut_by_light(spans, 9, pieces);
    ASSERT_EQ(pieces.size(), 4u);
    double reached = 0;
    for (size_t i = 0; i < pieces.size(); ++i) {
        EXPECT_EQ(pieces[i].lit, i % 2 == 1);
        EXPECT_EQ(pieces[i].from, reached);
        reached = pieces[i].to;
    }
    EXPECT_EQ(reached, 9);
    EXPECT_EQ(pieces[1].to, 5);
}

}  // namespace
}  // namespace rb
