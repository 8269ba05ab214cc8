// #declare, #local.
#include "language/parser.h"

#include <algorithm>

#include <fmt/format.h>

namespace rb {

namespace {

constexpr std::string_view semicolon_message =
    "All #declares of float, vector, and color require semi-colon ';' at end if the language version is set "
    "to "
    "3.5 or higher.";

/// Whether nothing but blanks and a comment follows on the line.
bool ends_its_line(std::string_view text, size_t at) {
    at = std::min(text.find_first_not_of(" \t\r", at), text.size());
    return at == text.size() || text[at] == '\n' || text.substr(at, 2) == "//";
}

/// An error from version 3.5 on. At the end of a line it is a trifle: nothing else could be meant.
void missing_semicolon(Session& session, SourceRange value) {
    const SourceRange end{value.file, value.end, value.end};
    if (session.language_version < 310) return;
    const bool trifle =
        session.language_version < 350 ||
        (!session.options.strict && ends_its_line(session.sources.text(value.file), value.end));
    if (!trifle) session.fail(end, std::string(semicolon_message));
    session.diagnostics.report({Severity::possible_error, end, std::string(semicolon_message), {}});
}

[[noreturn]] void fail_unknown(const Session& session, SourceRange where, std::string_view word) {
    const std::string message = "Cannot assign uninitialized identifier.";
    if (word == "dictionary")
        throw SceneError(where, message, "dictionaries of version 3.8 are not supported yet");
    throw SceneError(where, message + session.hint(word));
}

void check_kind(const Array& array, SourceRange where, const Value& value) {
    for (const Value& element : array.elements) {
        if (!is_set(element)) continue;
        const std::string have = kind_name(element);
        const std::string want = kind_name(value);
        if (have != want) {
            throw SceneError(where, fmt::format("Attempted to redefine {} as {}.", have, want));
        }
        return;
    }
}

}  // namespace

Place TokenStream::raw_element(const Place& array, SourceRange where) {
    Place place = array;
    while (raw_peek().kind == Tok::lbracket && std::holds_alternative<ArrayPtr>(place.value())) {
        const ArrayPtr elements = std::get<ArrayPtr>(place.value());
        size_t index = 0;
        for (const size_t size : elements->sizes) {
            raw_expect(Tok::lbracket, "[");
            Operand subscript;
            if (quick_sum(subscript, {Tok::rbracket})) {
                index = index * size + checked_subscript(subscript, size);
                raw_next();
            } else {
                Parser parser(session_);
                subscript = parser.sum();
                index = index * size + checked_subscript(subscript, size);
                parser.expect(Tok::rbracket, "]");
            }
            where = cover(where, subscript.where);
        }
        place.array = elements;
        place.index = index;
    }
    return place;
}

size_t checked_subscript(const Operand& operand, size_t size) {
    const double value = to_float(operand) + 1e-10;
    const auto fail = [&](const char* message) {
        throw SceneError(
            operand.where, message,
            fmt::format("the subscript is {:g}; this dimension has 0..{}", to_float(operand), size - 1));
    };
    if (value < 0) fail("Negative subscript");
    if (!(value < static_cast<double>(size))) fail("Array subscript out of range");
    return static_cast<size_t>(value);
}

Place TokenStream::declared_place(uint32_t word, size_t level, bool local, SourceRange where,
                                  const Value& value, const Place& before) {
    Symbols& symbols = session_.symbols;
    Place place;
    if (level >= symbols.depth()) {
        place = before;
    } else if (local) {
        place = symbols.find_at(word, level);
    } else {
        for (size_t at = level + 1; at-- > 0 && !place.known();) place = symbols.find_at(word, at);
    }
    if (!place.known()) {
        place.slot = symbols.create(word, local ? level : 0);
        return place;
    }
    if (std::holds_alternative<MacroPtr>(place.value())) {
        session_.fail(where, "Expected 'undeclared identifier', macro identifier found instead");
    }
    if (is_function(place.value()) && is_function(value)) {
        session_.fail(where, "Redeclaring functions is not allowed - #undef the function first!");
    }
    return place;
}

void TokenStream::store(const Place& place, SourceRange where, Value value) {
    if (auto* terms = std::get_if<Terms>(&value)) *terms = stored(*terms);
    if (place.array) check_kind(*place.array, where, value);
    place.value() = std::move(value);
}

void TokenStream::do_declare(bool local, SourceRange) {
    std::string deprecated;
    bool once = false;
    if (raw_peek().kind == Tok::word && raw_peek().aux == word_of(Keyword::deprecated)) {
        raw_next();
        if (raw_peek().kind == Tok::word && raw_peek().aux == word_of(Keyword::once)) {
            raw_next();
            once = true;
        }
        deprecated = "?";
        if (raw_peek().kind == Tok::text) {
            const Token text = raw_next();
            deprecated = unescape(session_, top().tokens->spelling(text), range(text));
        }
    }
    const SourceRange where = range(raw_peek());
    const uint32_t word = raw_name("undeclared identifier");
    if (deprecated == "?") {
        deprecated = fmt::format("Identifier '{}' was declared deprecated.", session_.words.spelling(word));
    }
    try {
        Place element;
        if (raw_peek().kind == Tok::lbracket) {
            const Place array = session_.symbols.find_place(word);
            if (array.known() && std::holds_alternative<ArrayPtr>(array.value())) {
                element = raw_element(array, where);
            }
        }
        raw_expect(Tok::equals, "=");
        // Macro calls on the right side may still be open when the value is known.
        const size_t level = session_.symbols.depth() - 1;
        // A macro may end behind its last declaration before the value is stored: its names are gone then.
        const Place before =
            local ? session_.symbols.find_at(word, level) : session_.symbols.find_place(word);
        Operand right;
        if (!quick_sum(right, {Tok::semicolon})) {
            Parser parser(session_);
            if (parser.peek().kind == Tok::undeclared) {
                fail_unknown(session_, parser.peek().where, session_.words.spelling(parser.peek().word));
            }
            parser.lock(true);
            right = parser.rvalue();
        }
        const bool numeric = std::holds_alternative<Terms>(right.value);
        if (right.place.known()) right.value = deep_copy(right.value);
        const Place place =
            element.known() ? element : declared_place(word, level, local, where, right.value, before);
        store(place, where, std::move(right.value));
        place.slot->deprecated = deprecated;
        place.slot->deprecated_once = once;
        const bool ended = take_semicolon();
        if (!numeric) return;
        if (!ended) missing_semicolon(session_, right.where);
        if (ended) take_semicolon();
    } catch (const SceneError&) {
        const Place known = session_.symbols.find_place(word);
        if (!known.known()) session_.symbols.create_global(word)->value = Poison{};
        throw;
    }
}

}  // namespace rb
