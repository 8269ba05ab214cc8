// density_file df3 "name" [interpolate n] (manual 3.4.7.1.11): samples on a grid that fills the unit cube.
#include "patterns/formula.h"
#include "patterns/line_bound.h"

#include <array>

namespace rb {

namespace {

/// A DF3 file: three sizes, then the samples, x fastest and z slowest; all big-endian.
class DensityGrid {
public:
    static constexpr size_t header = 6;

    DensityGrid(std::shared_ptr<const std::string> bytes, const std::array<uint64_t, 3>& size, size_t width)
        : bytes_(std::move(bytes)),
          size_(size),
          width_(width),
          white_(static_cast<double>((uint64_t{1} << (8 * width)) - 1)) {}

    const std::array<uint64_t, 3>& size() const { return size_; }
    int bits() const { return static_cast<int>(8 * width_); }
    bool is_empty() const { return size_[0] == 0 || size_[1] == 0 || size_[2] == 0; }
    /// From 0 to 1; the place must lie on the grid.
    double sample(uint64_t x, uint64_t y, uint64_t z) const {
        size_t at = header + ((z * size_[1] + y) * size_[0] + x) * width_;
        uint64_t value = 0;
        for (size_t i = 0; i < width_; ++i) value = value << 8 | static_cast<uint8_t>((*bytes_)[at++]);
        return static_cast<double>(value) / white_;
    }

private:
    std::shared_ptr<const std::string> bytes_;
    std::array<uint64_t, 3> size_;
    size_t width_;  ///< of a sample in bytes
    double white_;
};

/// How wide the samples are follows from the length of the file.
DensityGrid grid_of(std::shared_ptr<const std::string> bytes) {
    constexpr size_t header = DensityGrid::header;
    if (bytes->size() < header) throw IoError("it has no header");
    std::array<uint64_t, 3> size{};
    for (size_t axis = 0; axis < 3; ++axis) {
        const auto byte = [&](size_t i) { return uint64_t{static_cast<uint8_t>((*bytes)[2 * axis + i])}; };
        size[axis] = byte(0) << 8 | byte(1);
    }
    const uint64_t count = size[0] * size[1] * size[2];
    const uint64_t rest = bytes->size() - header;
    for (const size_t width : {size_t{1}, size_t{2}, size_t{4}}) {
        if (rest == count * width) return {std::move(bytes), size, width};
    }
    throw IoError(
        fmt::format("{} x {} x {} samples of 1, 2 or 4 bytes do not make the {} bytes behind its header",
                    size[0], size[1], size[2], rest));
}

/// Between b (t = 0) and c (t = 1), with the slopes of a to c and b to d there (Catmull and Rom).
double cubic_between(const std::array<double, 4>& v, double t) {
    const double slope_b = (v[2] - v[0]) / 2.0;
    const double slope_c = (v[3] - v[1]) / 2.0;
    const double e = 2.0 * (v[1] - v[2]) + slope_b + slope_c;
    const double g = -3.0 * (v[1] - v[2]) - 2.0 * slope_b - slope_c;
    return ((e * t + g) * t + slope_b) * t + v[1];
}

enum class GridInterpolation { none, linear, cubic };

class DensityFile final : public PointPattern<DensityFile> {
public:
    DensityFile(const DensityGrid& samples, GridInterpolation chosen)
        : grid(samples), interpolation(chosen) {}
    std::string_view keyword() const override { return "density_file"; }
    std::string describe() const override {
        return fmt::format("density_file {}x{}x{} of {} bits interpolate {}", grid.size()[0], grid.size()[1],
                           grid.size()[2], grid.bits(), static_cast<int>(interpolation));
    }
    double value(const Vec3& p) const {
        if (grid.is_empty()) return 0.0;
        Cell cell;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(p[axis] >= 0.0 && p[axis] < 1.0)) return 0.0;
            const auto k = static_cast<size_t>(axis);
            const double place = p[axis] * static_cast<double>(grid.size()[k]);
            // A number right below 1 times the size may round up to the size.
            cell.index[k] = std::min(static_cast<uint64_t>(place), grid.size()[k] - 1);
            cell.share[k] = place - static_cast<double>(cell.index[k]);
        }
        if (interpolation == GridInterpolation::none)
            return grid.sample(cell.index[0], cell.index[1], cell.index[2]);
        return interpolation == GridInterpolation::linear ? linear(cell) : cubic(cell);
    }

    IntervalSlope bound(const PatternContext&, const LinePlace&) const override {
        return interpolation == GridInterpolation::cubic ? IntervalSlope::any_number()
                                                         : somewhere_in(0.0, 1.0);
    }

    const DensityGrid grid;
    const GridInterpolation interpolation;

private:
    struct Cell {
        std::array<uint64_t, 3> index{};
        std::array<double, 3> share{};
    };

    double linear(const Cell& cell) const {
        double sum = 0.0;
        for (unsigned corner = 0; corner < 8; ++corner) {
            std::array<uint64_t, 3> at = cell.index;
            double weight = 1.0;
            for (size_t axis = 0; axis < 3; ++axis) {
                const bool next = (corner >> axis & 1u) != 0;
                if (next) at[axis] = (at[axis] + 1) % grid.size()[axis];
                weight *= next ? cell.share[axis] : 1.0 - cell.share[axis];
            }
            sum += weight * grid.sample(at[0], at[1], at[2]);
        }
        return sum;
    }

    double cubic(const Cell& cell) const {
        std::array<std::array<uint64_t, 4>, 3> at{};
        for (size_t axis = 0; axis < 3; ++axis) {
            // Before the first sample unsigned 64-bit numbers wrap around, as in the reference: only for
            // sizes that are powers of two that is the last sample.
            for (size_t k = 0; k < 4; ++k) at[axis][k] = (cell.index[axis] + k - 1) % grid.size()[axis];
        }
        std::array<double, 4> along_x{};
        for (size_t i = 0; i < 4; ++i) {
            std::array<double, 4> along_y{};
            for (size_t j = 0; j < 4; ++j) {
                std::array<double, 4> along_z{};
                for (size_t k = 0; k < 4; ++k) along_z[k] = grid.sample(at[0][i], at[1][j], at[2][k]);
                along_y[j] = cubic_between(along_z, cell.share[2]);
            }
            along_x[i] = cubic_between(along_y, cell.share[1]);
        }
        return std::max(0.0, cubic_between(along_x, cell.share[0]));
    }
};

PatternPtr read(BlockReader& in) {
    if (!in.take_word("df3")) in.fail(fmt::format("Expected 'df3', {} found instead", in.found()));
    if (!in.at_text()) in.fail(fmt::format("Expected 'string expression', {} found instead", in.found()));
    const SourceRange where = in.where();
    const std::string name = in.file_name();
    try {
        return std::make_shared<DensityFile>(grid_of(in.context().density_file(in.context(), name, where)),
                                             GridInterpolation::none);
    } catch (const IoError& error) {
        in.fail_at(where, fmt::format("Cannot read density file: {}.", error.what()));
    }
}

PatternPtr read_parameter(BlockReader& in, const PatternPtr& so_far) {
    if (!in.take_word("interpolate")) return nullptr;
    GridInterpolation interpolation = GridInterpolation::cubic;
    // Only the last digit counts, and whatever is neither 0 nor 1 means cubic.
    const int digit = in.integer() % 10;
    if (digit == 0) interpolation = GridInterpolation::none;
    if (digit == 1) interpolation = GridInterpolation::linear;
    return std::make_shared<DensityFile>(static_cast<const DensityFile&>(*so_far).grid, interpolation);
}

}  // namespace

namespace patterns {
extern const PatternKind density_file;
const PatternKind density_file{.keyword = "density_file",
                               .read = read,
                               .read_parameter = read_parameter,
                               .example = "density_file df3 \"knot.df3\" interpolate 1"};
}  // namespace patterns

}  // namespace rb
