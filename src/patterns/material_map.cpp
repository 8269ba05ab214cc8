#include "patterns/material_map.h"

#include "patterns/formula.h"

namespace rb {

namespace {

class MaterialMap final : public PointPattern<MaterialMap> {
public:
    MaterialMap(ImageField field, size_t count) : field_(std::move(field)), count_(count) {}
    std::string_view keyword() const override { return "material_map"; }
    double value(const Vec3& p) const {
        const auto place = field_.place(p);
        if (!place) return 0.0;
        // An index equal to the count is not wrapped, and falls on the last texture.
        size_t index = field_.index(*place);
        if (index > count_) index %= count_;
        return static_cast<double>(std::min(index, count_ - 1));
    }

private:
    ImageField field_;
    size_t count_;
};

}  // namespace

PatternPtr material_map_pattern(ImageField field, size_t count) {
    return std::make_shared<MaterialMap>(std::move(field), count);
}

}  // namespace rb
