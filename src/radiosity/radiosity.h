#pragma once
#include "radiosity/cached_light.h"

#include <functional>
#include <memory>

namespace rb {

/// How the light between diffuse surfaces is found (`--gi`).
enum class GiMode {
    automatic,  ///< points
    off,        ///< not at all: as without radiosity{}
    points,     ///< a cache; what gathers meet is shaded once for all that see it about as large
    cache,      ///< a cache; gathers shade all that they meet
    brute,      ///< rays over the hemisphere of every place, at every bounce
};

/// Gathers at every place that asks, and at every surface that the rays meet.
class BruteLight final : public IndirectLight {
public:
    explicit BruteLight(const RayGather& rays) : rays_(rays) {}
    void gather(std::span<const IndirectPlace> places, int depth, std::span<Rgb> mean) const override;

private:
    const RayGather& rays_;
};

/// Lists the places that ask along camera rays `step` pixels apart (1: what every pixel sees, or some place
/// of it where the picture looks at several), without those that `known` (or null) has records of.
using PictureSurvey =
    std::function<std::vector<IndirectPlace>(int step, const CachedLight* known, Coverage coverage)>;

/// Files that what is found comes from and goes to; empty: none.
struct RadiosityFiles {
    std::string load;
    std::string save;
};

/// What finding the indirect light took.
struct RadiosityReport {
    std::vector<size_t> records;  ///< by bounce; none under GiMode::brute
    std::vector<size_t> surfels;  ///< shaded to be kept, by bounce
    std::vector<size_t> cells;    ///< that hold them, likewise
    size_t surfel_bytes = 0;
    uint64_t gathers = 0;
    uint64_t interpolations = 0;
    double error_estimate = 0;       ///< see CachedLight
    std::array<uint64_t, 2> gaps{};  ///< places without a record: seen by the eye, and by gathers
    uint64_t rays = 0;               ///< that gathered, but for what they sent on
    uint64_t shadow_rays = 0;
};

/// The indirect light of a scene with radiosity{}.
class Radiosity {
public:
    /// `error`: see GatherQuality. `photons`: what surfaces show of them, or null.
    Radiosity(const World& world, const ShadingOptions& options, GiMode mode, double error = 0,
              std::shared_ptr<const PhotonLight> photons = nullptr);

    /// Before light() is asked. Ends soon once `stop` is true. What is loaded is all that is known, unless it
    /// is to be saved again: then the picture adds what it lacks. Throws IoError where a file is not what it
    /// should be. GiMode::brute has no use for files. `longer_side`: of the picture, in pixels.
    void prepare(const PictureSurvey& survey, int longer_side, int threads, const std::atomic<bool>& stop,
                 const RadiosityFiles& files = {});

    const IndirectLight& light() const;

    /// The light of the smallest surfel that is known where a ray meets a surface, as seen at the first
    /// bounce; false if it meets none, or nothing is known there.
    bool find_surfel(const Ray& ray, Rgb& light) const;

    /// What was done so far.
    RadiosityReport report() const;

private:
    void load(const std::string& path);
    void learn(const PictureSurvey& survey, int longer_side, int threads, const std::atomic<bool>& stop);
    void learn_later_bounces(std::vector<IndirectPlace> places, int threads, const std::atomic<bool>& stop);
    std::vector<IndirectPlace> met_from(std::span<const IndirectPlace> places, int depth, int threads,
                                        const std::atomic<bool>& stop) const;

    RayGather rays_;
    BruteLight brute_;
    std::unique_ptr<CachedLight> cached_;  ///< null under GiMode::brute
};

}  // namespace rb
