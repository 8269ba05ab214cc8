// The map of photons against looking at each of them, and how photons are gathered. Values measured with
// POV-Ray 3.7 on photon maps made by hand (load_file).
#include "math/random.h"
#include "photons/gathering.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace rb {
namespace {

double draw(uint64_t seed, uint64_t purpose) { return unit_random(mixed(seed, purpose)); }

Photon photon_at(double x, double y, double z, float light = 1.0f) {
    Photon photon;
    photon.place = {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
    photon.color = Rgb(light);
    photon.origin = PackedDirection({0, 1, 0});
    return photon;
}

/// In clusters of all sizes, some of them in the same places.
std::vector<Photon> clusters(size_t count) {
    std::vector<Photon> photons;
    for (uint64_t i = 0; i < count; ++i) {
        const uint64_t cluster = i % 7;
        const double size = std::pow(0.1, static_cast<double>(cluster) / 2.0);
        const auto place = [&](uint64_t axis) {
            return draw(cluster, axis) + size * draw(mixed(i - i % 3, 17), axis);
        };
        photons.push_back(photon_at(place(0), place(1), place(2)));
    }
    return photons;
}

std::vector<FoundPhoton> sorted(std::span<FoundPhoton> found) {
    std::ranges::sort(found);
    return {found.begin(), found.end()};
}

TEST(PhotonMap, FindsWhatLookingAtEachFinds) {
    for (const size_t size : {0, 1, 2, 8, 9, 100, 5000}) {
        const PhotonMap map(clusters(size));
        for (uint64_t i = 0; i < 200; ++i) {
            PhotonMetric metric{{2 * draw(i, 1), 2 * draw(i, 2), 2 * draw(i, 3)}};
            if (i % 2 == 0) metric.normal = glm::normalize(Vec3{draw(i, 4) - 0.5, draw(i, 5) - 0.5, 0.1});
            const double radius = std::pow(10.0, 2.0 * draw(i, 6) - 1.5);
            std::vector<FoundPhoton> quick(1 + i % 40);
            std::vector<FoundPhoton> slow(quick.size());
            const size_t count = map.find(metric, radius, quick);
            ASSERT_EQ(count, map.find_slowly(metric, radius, slow));
            ASSERT_EQ(sorted(std::span(quick).first(count)), sorted(std::span(slow).first(count)));
        }
    }
}

/// Goes a long way in short steps. What `find` makes of a metric, a radius and what `keep` was told of the
/// steps before, must be the same photons in the same order, so that sums are the same bits. `keep` is told
/// of the steps that find as many as are looked for.
template <class Find, class Keep>
void walk(bool on_surfaces, Find&& find, Keep&& keep) {
    const PhotonMap map(clusters(5000));
    std::vector<FoundPhoton> quick(30);
    std::vector<FoundPhoton> slow(30);
    PhotonMetric metric{Vec3{0.5}};
    int full = 0;
    for (uint64_t i = 0; i < 2000; ++i) {
        metric.place += 0.01 * Vec3{draw(i, 1) - 0.5, draw(i, 2) - 0.5, draw(i, 3) - 0.5};
        if (on_surfaces) metric.normal = glm::normalize(Vec3{draw(i, 5) - 0.5, draw(i, 6) - 0.5, 0.3});
        const double radius = 10.0 * draw(i, 4);
        const size_t count = map.find(metric, radius, slow);
        ASSERT_EQ(find(map, metric, radius, quick), count);
        ASSERT_TRUE(
            std::equal(quick.begin(), quick.begin() + static_cast<std::ptrdiff_t>(count), slow.begin()));
        if (count < slow.size()) continue;
        ++full;
        keep(metric, slow);
    }
    EXPECT_GT(full, 1000);
}

TEST(PhotonMap, KnownReachesChangeNothing) {
    KnownReaches known;
    int shorter = 0;
    const auto find = [&](const PhotonMap& map, const PhotonMetric& metric, double radius, auto& nearest) {
        const double reach = known.at(metric.place);
        shorter += reach < radius ? 1 : 0;
        return map.find(metric, std::min(radius, reach), nearest);
    };
    walk(false, find, [&](const PhotonMetric& metric, const auto& found) {
        known.add(metric.place, std::sqrt(std::ranges::max(found).square));
    });
    EXPECT_GT(shorter, 1000);
}

TEST(PhotonMap, KnownPhotonsChangeNothing) {
    std::vector<uint32_t> known;
    const auto find = [&](const PhotonMap& map, const PhotonMetric& metric, double radius, auto& nearest) {
        return map.find_near(known, metric, radius, nearest);
    };
    for (const bool on_surfaces : {false, true}) {
        walk(on_surfaces, find, [&](const PhotonMetric&, const auto& found) {
            known.resize(found.size());
            std::ranges::transform(found, known.begin(), &FoundPhoton::index);
        });
    }
}

TEST(PhotonMap, KeepsEveryPhoton) {
    const std::vector<Photon> photons = clusters(3000);
    const PhotonMap map(photons);
    std::vector<std::array<float, 3>> before;
    std::vector<std::array<float, 3>> after;
    for (size_t i = 0; i < photons.size(); ++i) {
        before.push_back(photons[i].place);
        after.push_back(map.place(i));
    }
    std::ranges::sort(before);
    std::ranges::sort(after);
    EXPECT_EQ(before, after);
}

TEST(PackedDirection, KeepsDirections) {
    for (uint64_t i = 0; i < 10000; ++i) {
        const Vec3 d = glm::normalize(Vec3{draw(i, 1) - 0.5, draw(i, 2) - 0.5, draw(i, 3) - 0.5});
        EXPECT_LT(glm::length(PackedDirection(d).unpacked() - d), 1e-4);
    }
    for (const Vec3 d : {Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, -1}}) {
        EXPECT_LT(glm::length(PackedDirection(d).unpacked() - d), 1e-9);
    }
}

/// How many photons of a map are gathered at the origin, and over which radius.
struct Gathered {
    size_t count;
    double radius;
};

Gathered gathered(const std::vector<Photon>& photons, double radius, int min, int max, double increase = 0.2,
                  double few = 35) {
    PhotonSettings settings;
    settings.surface_radius.radius = radius;
    settings.gather_min = min;
    settings.gather_max = max;
    settings.expand_increase = increase;
    settings.expand_count = few;
    const PhotonMaps maps({photons, {}}, settings);
    std::vector<NearPhoton> memory(maps.capacity());
    const GatheredPhotons found = maps.around(Vec3{0.0}, Vec3{0, 1, 0}, memory, nullptr);
    return {found.photons.size(), std::sqrt(found.extent / pi)};
}

std::vector<Photon> row(int count) {
    std::vector<Photon> photons;
    for (int i = 1; i <= count; ++i) photons.push_back(photon_at(0.1 * i, 0, 0));
    return photons;
}

void expect_gathered(const Gathered& found, size_t count, double radius) {
    EXPECT_EQ(found.count, count);
    EXPECT_NEAR(found.radius, radius, 1e-6);
}

TEST(Gathering, FillsTheRadius) {
    expect_gathered(gathered(row(10), 0.25, 1, 20), 2, 0.25);
    expect_gathered(gathered(row(10), 0.35, 1, 20), 3, 0.35);
    expect_gathered(gathered(row(10), 1.5, 1, 11), 10, 1.5);
    expect_gathered(gathered(row(10), 1.5, 1, 10), 10, 1.5);
}

TEST(Gathering, TakesTheNearest) {
    expect_gathered(gathered(row(10), 1.5, 1, 3), 3, 0.3);
    expect_gathered(gathered(row(10), 1.5, 1, 2), 2, 0.2);
}

TEST(Gathering, LooksFartherForFew) {
    expect_gathered(gathered(row(10), 0.25, 5, 20), 7, 0.75);
    expect_gathered(gathered(row(10), 0.35, 5, 20), 10, 1.05);
    expect_gathered(gathered(row(10), 0.55, 5, 20), 5, 0.55);
    expect_gathered(gathered(row(10), 0.55, 11, 20), 10, 1.65);
    expect_gathered(gathered(row(1), 0.09, 1, 5), 1, 0.27);
    expect_gathered(gathered(row(1), 0.09, 0, 5), 0, 0.09);
    expect_gathered(gathered(row(1), 0.09, 1, 5, 0, 0), 0, 0.09);
}

TEST(Gathering, StaysNearWhereItIsDenserBeyond) {
    std::vector<Photon> photons = row(2);
    for (int i = 0; i < 40; ++i) photons.push_back(photon_at(0.3 + 0.01 * i, 0, 0));
    expect_gathered(gathered(photons, 0.25, 5, 100, 0.2, 42), 2, 0.25);
    expect_gathered(gathered(photons, 0.25, 5, 100, 0.2, 43), 42, 0.75);
    expect_gathered(gathered(photons, 0.25, 5, 100, 1.2, 3), 2, 0.25);
    expect_gathered(gathered(photons, 0.25, 5, 100, 1.4, 3), 42, 0.75);
}

TEST(Gathering, FlattensTheBall) {
    for (const double height : {0.1, 0.2, 0.3}) {
        const double reach = height * std::sqrt(1 + 16 * height);
        expect_gathered(gathered({photon_at(0, height, 0)}, 0.99 * reach, 0, 5), 0, 0.99 * reach);
        expect_gathered(gathered({photon_at(0, height, 0)}, 1.01 * reach, 0, 5), 1, 1.01 * reach);
    }
}

TEST(Gathering, FindsARadius) {
    // Ten thousand to the unit of area: a hundred within 0.0564. Few places are thin, at the edges.
    std::vector<Photon> photons;
    for (int i = 0; i < 10000; ++i) {
        const uint64_t seed = static_cast<uint64_t>(i);
        photons.push_back(photon_at((i % 100 + draw(seed, 1)) / 100, 0, (i / 100 + draw(seed, 2)) / 100));
    }
    const double radius = automatic_radius(PhotonMap(photons), 100, false);
    EXPECT_GT(radius, 0.0564);
    EXPECT_LT(radius, 0.3);
}

class PhotonFile : public ::testing::Test {
protected:
    std::string path_ = (std::filesystem::temp_directory_path() / "renderboy_photons.ph").string();
    ~PhotonFile() override { std::filesystem::remove(path_); }
};

TEST_F(PhotonFile, HasTheBytesOfTheReference) {
    // Light <1, .5, .25> * 1.32584 from <0, 20, 0>, as POV-Ray wrote it.
    const Vec3 place{-0.398777, -3.0, 1.0790};
    Photon photon = photon_at(place.x, place.y, place.z);
    photon.color = 1.32584f * Rgb{1.0f, 0.5f, 0.25f};
    photon.origin = PackedDirection(glm::normalize(Vec3{0, 20, 0} - place));
    ASSERT_EQ(write_photons(path_, {{photon}, {}}), "");
    std::ifstream in(path_, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(in)), {});
    ASSERT_EQ(bytes.size(), 28u);
    EXPECT_EQ(bytes.substr(0, 4), std::string("\1\0\0\0", 4));
    EXPECT_EQ(bytes.substr(16, 4), "\xa9\x54\x2a\xfb");
    EXPECT_EQ(bytes.substr(20, 4), std::string("\0\x3d\xcf\0", 4));
    EXPECT_EQ(bytes.substr(24, 4), std::string(4, '\0'));
}

TEST_F(PhotonFile, KeepsPhotons) {
    StoredPhotons written{clusters(100), clusters(50)};
    ASSERT_EQ(write_photons(path_, written), "");
    StoredPhotons read;
    ASSERT_EQ(read_photons(path_, read), "");
    ASSERT_EQ(read.on_surfaces.size(), 100u);
    ASSERT_EQ(read.in_media.size(), 50u);
    for (size_t i = 0; i < 100; ++i) {
        EXPECT_EQ(read.on_surfaces[i].place, written.on_surfaces[i].place);
        EXPECT_EQ(read.on_surfaces[i].color, Rgb(1.0f));
    }
}

TEST_F(PhotonFile, RefusesWhatIsCutOff) {
    ASSERT_EQ(write_photons(path_, {clusters(100), {}}), "");
    std::filesystem::resize_file(path_, 1000);
    StoredPhotons read;
    EXPECT_NE(read_photons(path_, read), "");
    EXPECT_NE(read_photons(path_ + ".missing", read), "");
}

}  // namespace
}  // namespace rb
