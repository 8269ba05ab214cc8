#pragma once
#include "render/camera_rays.h"
#include "shade/integrator.h"

#include <span>
#include <vector>

namespace rb {

/// What the samples of one picture position have given so far.
struct LensSum {
    Radiance light;                ///< sum over the rays that exist
    std::array<double, 4> sums{};  ///< red, green, blue, transmit over all samples
    std::array<double, 4> squares{};
    int count = 0;
};

/// Focal blur: rays to a point in the plane of focus from points spread over the lens, more of them where
/// they differ (geometry spec 19).
class Lens {
public:
    Lens(const Camera& camera, const PatternSettings& patterns);

    /// False for a pinhole.
    bool is_open() const { return !points_.empty(); }

    /// How many more samples follow `count`; 0 if that is all.
    int next_chunk(int count) const;
    /// The ray of sample `index` at a picture position (as for CameraRays::at). False where the camera makes
    /// none.
    bool ray(const CameraRays& rays, double x, double y, int index, Ray& out) const;
    /// The ray through a picture position and a place of the lens, evenly in [0, 1)^2: without the
    /// reference's jitter. False as above.
    bool ray(const CameraRays& rays, const Vec2& position, const Vec2& place, Ray& out) const;
    void add(LensSum& sum, const CameraRay& ray, const Radiance& light) const;
    /// True if after this chunk no more samples are needed.
    bool is_settled(const LensSum& sum) const;

private:
    /// From a point in units of the radius.
    bool ray_from(const CameraRays& rays, const Vec2& position, const Vec2& point, Ray& out) const;
    void lay_grid(int count);
    void lay_bokeh(const Pigment& pigment, const PatternSettings& patterns, int count);

    std::vector<Vec2> points_;        ///< in the unit disc's half size, [-0.5, 0.5]
    std::vector<double> thresholds_;  ///< variance that ends the sampling, by number of samples less one
    std::span<const int> chunks_;
    bool has_bokeh_ = false;
    double radius_ = 0;
    double jitter_ = 0;  ///< of a point, in units of the grid
    double focal_distance_ = 1;
    int least_ = 0;
    Vec3 location_{0.0};
    Vec3 across_{0.0};
    Vec3 upward_{0.0};
    double direction_length_ = 1;
};

}  // namespace rb
