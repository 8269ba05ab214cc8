#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rb {

/// Where the samples of area lights lie: as the scene says (on its grid, or with `jitter` by the grid's
/// density); on the grid; by the density; evenly over the axes, whatever the grid.
enum class AreaLightMode : uint8_t { as_written, grid, smooth, true_area };

/// How much of an area light's light comes from where along one of its axes: the weights that the
/// reference's recursion over the whole grid gives to the grid's places, each spread over one step of the
/// grid. (Measured: a light of 4 x 4 is 29 % wider than its axes say, in its standard deviation.)
class AxisDensity {
public:
    explicit AxisDensity(int size = 1);

    /// Inverse of the distribution: for `u` in [0, 1) a place in [-0.5, size - 0.5), in steps of the grid.
    double place(double u) const;
    double weight(int index) const {
        const auto i = static_cast<size_t>(index);
        return before_[i + 1] - before_[i];
    }

private:
    /// The place that `u` falls on, not before `index`.
    size_t index_from(size_t index, double u) const;

    std::vector<double> before_;   ///< each place: the weight of those before it; then 1
    std::vector<uint32_t> guide_;  ///< of equal parts of [0, 1): the place that their beginning falls on
};

}  // namespace rb
