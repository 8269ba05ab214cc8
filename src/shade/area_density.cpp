#include "shade/area_density.h"

#include <algorithm>

namespace rb {

namespace {

/// The reference averages the corners of cells and quarters them to the end: along one axis a cell gives half
/// of its weight to either half, and halves of odd cells share their middle.
void spread(size_t first, size_t last, double weight, std::vector<double>& weights) {
    if (last - first <= 1) {
        weights[first] += 0.5 * weight;
        weights[last] += 0.5 * weight;
        return;
    }
    spread(first, (first + last) / 2, 0.5 * weight, weights);
    spread((first + last + 1) / 2, last, 0.5 * weight, weights);
}

}  // namespace

AxisDensity::AxisDensity(int size) {
    std::vector<double> weights(static_cast<size_t>(std::max(size, 1)));
    spread(0, weights.size() - 1, 1.0, weights);
    before_.reserve(weights.size() + 1);
    double sum = 0;
    for (const double weight : weights) {
        before_.push_back(sum);
        sum += weight;
    }
    before_.push_back(1.0);
    guide_.resize(4 * weights.size());
    size_t index = 0;
    for (size_t i = 0; i < guide_.size(); ++i) {
        index = index_from(index, static_cast<double>(i) / static_cast<double>(guide_.size()));
        guide_[i] = static_cast<uint32_t>(index);
    }
}

size_t AxisDensity::index_from(size_t index, double u) const {
    while (index + 2 < before_.size() && before_[index + 1] <= u) ++index;
    return index;
}

double AxisDensity::place(double u) const {
    const auto near = static_cast<size_t>(u * static_cast<double>(guide_.size()));
    const size_t index = index_from(guide_[near], u);
    const double share = (u - before_[index]) / (before_[index + 1] - before_[index]);
    return static_cast<double>(index) + share - 0.5;
}

}  // namespace rb
