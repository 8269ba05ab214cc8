#include "language/value.h"

#include "math/transform.h"

namespace rb {

namespace {

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
    std::string operator()(const Thing& thing) const { return kind_name(thing); }
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
