#include "pattern_text.h"

#include "tests/geometry/statement.h"

namespace rb {

namespace {

const Texture& only_layer(const Object& object) { return object.texture->layers->at(0); }

}  // namespace

WrittenPattern pattern_of(const std::string& text) {
    const ObjectPtr plane = object_from("plane { y, 0 pigment { " + text + " } }");
    const Pigment& pigment = *only_layer(*plane).pigment;
    return {std::get<PatternPtr>(pigment.source), pigment.modifiers};
}

Normal written_normal(const std::string& text) {
    const ObjectPtr plane = object_from("plane { y, 0 normal { " + text + " } }");
    return *only_layer(*plane).normal;
}

}  // namespace rb
