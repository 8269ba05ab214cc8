#include "language/value.h"

#include "math/transform.h"

namespace rb {

namespace {

struct ThingName {
    std::string operator()(std::monostate) const { return "undeclared identifier"; }
    std::string operator()(const ObjectPtr&) const { return "object identifier"; }
    std::string operator()(const TexturePtr&) const { return "texture identifier"; }
    std::string operator()(const PigmentPtr&) const { return "pigment identifier"; }
    std::string operator()(const NormalPtr&) const { return "normal identifier"; }
    std::string operator()(const FinishPtr&) const { return "finish identifier"; }
    std::string operator()(const InteriorPtr&) const { return "interior identifier"; }
    std::string operator()(const std::shared_ptr<const Material>&) const { return "material identifier"; }
    std::string operator()(const std::shared_ptr<const Camera>&) const { return "camera identifier"; }
    std::string operator()(const std::shared_ptr<const Transform>&) const { return "transform identifier"; }
    std::string operator()(const std::shared_ptr<const ColorMap>&) const { return "color_map identifier"; }
    std::string operator()(const PigmentMapPtr&) const { return "pigment_map identifier"; }
    std::string operator()(const NormalMapPtr&) const { return "normal_map identifier"; }
    std::string operator()(const TextureMapPtr&) const { return "texture_map identifier"; }
    std::string operator()(const SlopeMapPtr&) const { return "slope_map identifier"; }
    std::string operator()(const std::shared_ptr<const Fog>&) const { return "fog identifier"; }
    std::string operator()(const std::shared_ptr<const SkySphere>&) const { return "sky_sphere identifier"; }
    std::string operator()(const FunctionPtr& f) const {
        return f && f->result_count() > 1 ? "vector function identifier" : "float function identifier";
    }
    std::string operator()(const ParsedOnlyPtr& p) const { return p->keyword + " identifier"; }
};

struct ValueName {
    std::string operator()(std::monostate) const { return "undeclared identifier"; }
    std::string operator()(const Terms& t) const {
        constexpr const char* names[] = {"float identifier", "uv vector identifier", "vector identifier",
                                         "4d vector identifier", "colour identifier"};
        return names[t.count - 1];
    }
    std::string operator()(const std::string&) const { return "string identifier"; }
    std::string operator()(const ArrayPtr&) const { return "array identifier"; }
    std::string operator()(const SplinePtr&) const { return "spline identifier"; }
    std::string operator()(const MacroPtr&) const { return "macro identifier"; }
    std::string operator()(const OpenFilePtr&) const { return "file identifier"; }
    std::string operator()(const Thing& thing) const { return std::visit(ThingName{}, thing); }
    std::string operator()(Poison) const { return "undeclared identifier"; }
};

}  // namespace

bool is_set(const Value& value) { return !std::holds_alternative<std::monostate>(value); }

bool is_function(const Value& value) {
    const auto* thing = std::get_if<Thing>(&value);
    return thing && std::holds_alternative<FunctionPtr>(*thing);
}

Value deep_copy(const Value& value) {
    const auto* array = std::get_if<ArrayPtr>(&value);
    if (!array) return value;
    auto copy = std::make_shared<Array>();
    copy->sizes = (*array)->sizes;
    copy->elements.reserve((*array)->elements.size());
    for (const Value& element : (*array)->elements) copy->elements.push_back(deep_copy(element));
    return copy;
}

std::string kind_name(const Value& value) { return std::visit(ValueName{}, value); }

Terms stored(const Terms& terms) {
    if (terms.count < 5) return terms;
    Terms out = terms;
    for (double& v : out.v) v = static_cast<double>(static_cast<float>(v));
    return out;
}

}  // namespace rb
