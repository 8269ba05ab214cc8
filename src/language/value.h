#pragma once
#include "block/block.h"
#include "language/spline.h"
#include "language/token_file.h"

#include <cstdio>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace rb {

struct Array;
using ArrayPtr = std::shared_ptr<Array>;

/// A macro: where its body stands. It is read again from there at each call.
struct Macro {
    std::string name;
    std::vector<uint32_t> parameters;
    std::vector<bool> optional;  ///< by parameter: it may be left out, and is then undeclared in the body
    TokenFilePtr file;
    uint32_t body_begin = 0;
    uint32_t body_end = 0;
};
using MacroPtr = std::shared_ptr<const Macro>;

/// A file opened by #fopen.
struct OpenFile;
using OpenFilePtr = std::shared_ptr<OpenFile>;

/// The value of a declaration that failed: using it fails too, but says nothing more.
struct Poison {};

/// Whatever an identifier can hold.
using Value = std::variant<std::monostate, Terms, std::string, ArrayPtr, SplinePtr, MacroPtr, OpenFilePtr,
                           Thing, Poison>;

/// Up to five dimensions, all elements of one kind once the first one is set.
struct Array {
    std::vector<size_t> sizes;
    std::vector<Value> elements;
};

/// A place that holds a value: a variable, or what a macro parameter refers to.
struct Slot {
    Value value;
    std::string deprecated;  ///< what to say at a use; empty: nothing
    bool deprecated_once = false;
};
using SlotPtr = std::shared_ptr<Slot>;

/// A variable or an array element.
struct Place {
    SlotPtr slot;
    ArrayPtr array;  ///< null for a plain variable
    size_t index = 0;

    bool known() const { return slot != nullptr; }
    Value& value() const { return array ? array->elements[index] : slot->value; }
};

bool is_set(const Value& value);
bool is_function(const Value& value);
/// Copies what must not be shared (arrays).
Value deep_copy(const Value& value);

/// "float identifier", "object identifier", ...: the language's own names of kinds. Two values may stand in
/// one array if the names are equal.
std::string kind_name(const Value& value);

/// Colours are kept in single precision.
Terms stored(const Terms& terms);

}  // namespace rb
