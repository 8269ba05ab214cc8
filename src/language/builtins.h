#pragma once
#include "language/parser.h"

#include <span>

namespace rb {

/// "pow(BASE, EXPONENT)": how a function of several arguments is called; empty for the others.
std::string_view usage_of(Keyword function);

/// 0 for x, u, red, ...; -1 if the word is no component.
int component_index(Keyword word);

/// `pi`, `x`, `clock`, ...
Terms constant_value(const Session& session, Keyword word);

/// A built-in float, vector or string function (spec: language 8, 9).
Value call_builtin(Session& session, Keyword word, std::span<const Operand> arguments, SourceRange where);

/// A call of a user function or spline.
Value call_value(const Operand& callee, std::span<const Operand> arguments, Keyword spline_type,
                 SourceRange where);
void check_argument_count(const Function& function, size_t count, SourceRange where);

/// String functions; part of call_builtin.
Value call_text(Session& session, Keyword word, std::span<const Operand> arguments, SourceRange where);

/// The order of two strings by code unit: the difference of the first differing ones.
int compare_texts(const std::string& a, const std::string& b);
std::u16string units_of(const std::string& text);
std::string text_of_units(std::u16string_view units);

/// Turns the base of a colour written with an srgb word into the working space.
void decode_srgb(Session& session, WrittenColor& color, SourceRange where);

/// The words of an error message for a numeric value that begins at `where`: "float function 'sin'", "<".
std::string found_value(Session& session, SourceRange where);

}  // namespace rb
