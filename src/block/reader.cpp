#include "block/reader.h"

#include <cmath>

#include <fmt/format.h>

namespace rb {

SourceRange BlockReader::where() const {
    if (!at_end()) return item().where;
    const SourceRange& all = block_.where;
    return {all.file, all.end > all.begin ? all.end - 1 : all.end, all.end};
}

std::string_view BlockReader::peek_word() const {
    if (at_end()) return {};
    if (item().kind == Item::Kind::word) return item().text;
    if (item().kind == Item::Kind::block) return item().block->keyword;
    return {};
}

void BlockReader::skip_item() {
    ++item_;
    value_ = 0;
}

bool BlockReader::take_word(std::string_view word) {
    if (!at_word(word)) return false;
    skip_item();
    return true;
}

bool BlockReader::take_comma() {
    if (!at(Item::Kind::bad) || item().text != ",") return false;
    skip_item();
    return true;
}

std::string_view BlockReader::word() {
    if (!at_word()) fail(fmt::format("Expected a keyword, {} found instead", found()));
    const std::string_view text = item().text;
    skip_item();
    return text;
}

Terms BlockReader::expect_terms(std::string_view expected) {
    if (!at_number()) {
        if (at(Item::Kind::color))
            fail(fmt::format("Expected '{}', colour expression found instead", expected));
        fail(fmt::format("Expected '{}', {} found instead", expected, found()));
    }
    const Item& numbers = item();
    Terms terms;
    terms.count = numbers.terms;
    const size_t start = numbers.first + static_cast<size_t>(value_) * static_cast<size_t>(numbers.terms);
    for (size_t i = 0; i < static_cast<size_t>(numbers.terms); ++i) terms.v[i] = block_.numbers[start + i];
    if (++value_ >= numbers.count) skip_item();
    return terms;
}

double BlockReader::number() {
    const SourceRange at = where();
    const Terms terms = expect_terms("numeric expression");
    if (terms.count != 1) fail_at(at, "Float expected but vector or color expression found.");
    return terms.v[0];
}

int BlockReader::integer() {
    const double value = number();
    constexpr double limit = 2147483647.0;
    if (!(std::abs(value) <= limit)) return -2147483647 - 1;
    return static_cast<int>(value);
}

Vec2 BlockReader::vec2() {
    const SourceRange at = where();
    const Terms t = expect_terms("vector");
    if (t.count > 2) fail_at(at, "UV_Vector expected but vector or color expression found.");
    return t.count == 1 ? Vec2{t.v[0], t.v[0]} : Vec2{t.v[0], t.v[1]};
}

Vec3 BlockReader::vec3() {
    const SourceRange at = where();
    const Terms t = expect_terms("vector");
    if (t.count > 3) fail_at(at, "Vector expected but color expression found.");
    return t.count == 1 ? Vec3{t.v[0]} : Vec3{t.v[0], t.v[1], t.v[2]};
}

Terms BlockReader::terms() { return expect_terms("numeric expression"); }

bool BlockReader::optional_switch() { return !at_number() || number() > 0.0; }

double BlockReader::positive(std::string_view what) {
    const SourceRange at = where();
    const double value = number();
    if (!(value > 0.0)) fail_at(at, fmt::format("{} must be positive, but is {}", what, value));
    return value;
}

void BlockReader::numbers(size_t count, int terms, std::vector<double>& out) {
    const auto width = static_cast<size_t>(terms);
    // The count comes from the scene: let what is really there decide how much memory is taken.
    while (count > 0) {
        if (at_number() && item().terms == terms) {
            const size_t take = std::min<size_t>(count, item().count - value_);
            const auto start =
                block_.numbers.begin() +
                static_cast<std::ptrdiff_t>(item().first + static_cast<size_t>(value_) * width);
            out.insert(out.end(), start, start + static_cast<std::ptrdiff_t>(take * width));
            value_ += static_cast<uint32_t>(take);
            if (value_ >= item().count) skip_item();
            count -= take;
            continue;
        }
        const SourceRange at = where();
        const Terms value = expect_terms(terms == 1 ? "numeric expression" : "vector");
        if (value.count > terms) {
            fail_at(at, terms == 1 ? "Float expected but vector or color expression found."
                                   : "Vector expected but color expression found.");
        }
        for (size_t i = 0; i < width; ++i) out.push_back(value.count == 1 ? value.v[0] : value.v[i]);
        --count;
    }
}

WrittenColor BlockReader::written_color() {
    if (at(Item::Kind::color)) {
        const WrittenColor color = *item().color;
        skip_item();
        return color;
    }
    WrittenColor color;
    color.has_base = color.bare = true;
    color.base = expect_terms("color");
    // `Red filter 0.5`: channels that follow a bare colour belong to it.
    if (value_ == 0 && at(Item::Kind::color) && !item().color->has_base && !item().color->color_word) {
        color.set = item().color->set;
        skip_item();
    }
    return color;
}

Color BlockReader::full_color() { return promote(written_color(), 5); }

Rgb BlockReader::rgb_color() {
    const SourceRange at = where();
    const Color color = promote(written_color(), 3);
    if (color.filter != 0.0f || color.transmit != 0.0f) {
        diagnostics().warning(
            at,
            "Expected pure RGB color expression, unexpected filter and transmit components will "
            "have no effect.");
    }
    return color.rgb();
}

std::string BlockReader::text() {
    if (!at_text()) fail(fmt::format("Expected 'string expression', {} found instead", found()));
    std::string value = item().text;
    skip_item();
    return value;
}

std::string BlockReader::file_name() {
    if (at_text() && item().raw) {
        std::string name = *item().raw;
        skip_item();
        return name;
    }
    return text();
}

const Block& BlockReader::block(std::string_view keyword) {
    if (!at_block(keyword)) fail(fmt::format("Expected '{}', {} found instead", keyword, found()));
    const Block& inner = *item().block;
    skip_item();
    return inner;
}

void BlockReader::fail(std::string message) const {
    if (!at_end() && item().kind == Item::Kind::bad && item().raw) message += *item().raw;
    fail_at(where(), std::move(message));
}

void BlockReader::fail_at(SourceRange where, std::string message) const {
    throw SceneError(where, std::move(message));
}

void BlockReader::finish() const {
    if (at_end()) return;
    if (block_.keyword == "[") fail(fmt::format("Expected ']', {} found instead", found()));
    fail(fmt::format("No matching }} in '{}', {} found instead", block_.keyword, found()));
}

std::string BlockReader::found() const {
    if (at_end()) return "}";
    switch (item().kind) {
        case Item::Kind::numbers:
            if (item().count == 1 && !item().bracketed && context_.found_value) {
                if (std::string text = context_.found_value(context_, item().where); !text.empty())
                    return text;
            }
            return item().terms == 1 ? "float function 'float constant'" : "<";
        case Item::Kind::color:
            return "color expression";
        case Item::Kind::text:
            return "string";
        case Item::Kind::thing:
            return kind_name(item().thing);
        case Item::Kind::block:
            return item().block->keyword;
        case Item::Kind::word:
        case Item::Kind::bad:
            return item().text;
    }
    return item().text;
}

Color promote(const WrittenColor& written, int context_terms) {
    std::array<double, 5> c{};
    if (written.has_base) {
        const Terms& base = written.base;
        // A float spreads over all the terms that the word or the context asks for.
        const int wanted = written.word_terms > 0 ? written.word_terms : context_terms;
        if (base.count == 1) {
            for (size_t i = 0; i < static_cast<size_t>(wanted); ++i) c[i] = base.v[0];
        } else {
            for (size_t i = 0; i < static_cast<size_t>(base.count); ++i) c[i] = base.v[i];
        }
        if (written.transmit_fourth) {
            c[4] = c[3];
            c[3] = 0;
        }
    }
    for (size_t i = 0; i < 5; ++i) {
        if (written.set[i]) c[i] = *written.set[i];
    }
    return {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]),
            static_cast<float>(c[3]), static_cast<float>(c[4])};
}

}  // namespace rb
