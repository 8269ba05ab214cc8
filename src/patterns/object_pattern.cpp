#include "patterns/object_pattern.h"

#include "patterns/formula.h"

namespace rb {

namespace {

class ObjectPattern final : public PointPattern<ObjectPattern> {
public:
    explicit ObjectPattern(InsideTest inside) : inside_(std::move(inside)) {}
    std::string_view keyword() const override { return "object"; }
    double value(const Vec3& p) const { return inside_(p) ? 1.0 : 0.0; }

private:
    InsideTest inside_;
};

}  // namespace

PatternPtr object_pattern(InsideTest inside) { return std::make_shared<ObjectPattern>(std::move(inside)); }

}  // namespace rb
