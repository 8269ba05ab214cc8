// Right sides: colours, arrays, splines, finished blocks.
#include "language/builtins.h"
#include "language/parse_state.h"
#include "language/read.h"

#include <cmath>

#include <fmt/format.h>

namespace rb {

void ParseState::push_color_value() {
    SourceRange where;
    const WrittenColor written = take_color(where);
    const Color c = promote(written, 5);
    push(Terms{{c.red, c.green, c.blue, c.filter, c.transmit}, 5}, where);
}

void ParseState::push_block_value() {
    const std::shared_ptr<const Block> block = std::move(finished_);
    const ReadContext context = session_.context();
    push(read_value(session_, *block, context), block->where);
}

void ParseState::merge_layer() {
    const std::shared_ptr<const Block> block = std::move(finished_);
    const ReadContext context = session_.context();
    const TexturePtr layer = read_texture(*block, context);
    Thing& below = std::get<Thing>(top().value);
    below = layered(std::get<TexturePtr>(below), layer, block->where);
    top().where = cover(top().where, block->where);
}

void ParseState::push_transform_value() {
    const auto* thing = std::get_if<Thing>(&top().value);
    if (!thing || !std::holds_alternative<std::shared_ptr<const Transform>>(*thing)) {
        session_.fail(top().where, fmt::format("Expected 'transform identifier', {} found instead",
                                               kind_name(top().value)));
    }
    top().place = {};
}

void ParseState::open_array(SourceRange where) {
    OpenArray opened;
    opened.word = where;
    opened.array = std::make_shared<Array>();
    arrays_.push_back(std::move(opened));
}

void ParseState::size_array() {
    const Operand operand = pop();
    const double size = std::trunc(to_float(operand));
    if (!(size >= 1)) session_.fail(operand.where, "Invalid dimension size for an array");
    Array& array = *arrays_.back().array;
    if (array.sizes.size() == 5) session_.fail(operand.where, "Too many dimensions for an array");
    double total = size;
    for (size_t s : array.sizes) total *= static_cast<double>(s);
    if (!(total <= 50e6)) session_.fail(operand.where, "The array is too large.");
    array.sizes.push_back(static_cast<size_t>(size));
    arrays_.back().where = operand.where;
}

void ParseState::check_array() {
    Array& array = *arrays_.back().array;
    size_t total = 1;
    for (size_t s : array.sizes) total *= s;
    array.elements.resize(total);
}

bool ParseState::array_has_inner_rows() const {
    const OpenArray& opened = arrays_.back();
    return opened.depth < opened.array->sizes.size();
}

void ParseState::open_rows() {
    OpenArray& opened = arrays_.back();
    if (opened.depth > 0) ++opened.counts.back();
    ++opened.depth;
    opened.counts.push_back(0);
}

void ParseState::close_rows(SourceRange where) {
    OpenArray& opened = arrays_.back();
    const size_t wanted = opened.array->sizes[opened.depth - 1];
    if (opened.counts.back() != wanted) {
        session_.fail(where, opened.counts.back() < wanted ? "Insufficent number of initializers"
                                                           : "No matching } in '{': too many initializers");
    }
    opened.counts.pop_back();
    --opened.depth;
}

void ParseState::add_row_item() {
    Operand operand = pop();
    OpenArray& opened = arrays_.back();
    Array& array = *opened.array;
    if (++opened.counts.back() > array.sizes.back() || opened.filled == array.elements.size()) {
        session_.fail(operand.where,
                      fmt::format("No matching }} in '{{', {} found instead", kind_name(operand.value)));
    }
    if (operand.place.known()) operand.value = deep_copy(operand.value);
    if (auto* terms = std::get_if<Terms>(&operand.value)) *terms = stored(*terms);
    if (opened.filled > 0) {
        const std::string first = kind_name(array.elements[0]);
        const std::string now = kind_name(operand.value);
        if (first != now) {
            session_.fail(operand.where, fmt::format("Attempted to redefine {} as {}.", first, now));
        }
    }
    array.elements[opened.filled++] = std::move(operand.value);
}

void ParseState::push_array() {
    const SourceRange where = arrays_.back().word;
    ArrayPtr array = std::move(arrays_.back().array);
    arrays_.pop_back();
    push(std::move(array), where);
}

void ParseState::push_spline(SourceRange where) {
    const List list = lists_.back();
    lists_.pop_back();
    auto spline = std::make_shared<Spline>();
    size_t i = list.base;
    if (i < operands_.size()) {
        if (const auto* base = std::get_if<SplinePtr>(&operands_[i].value)) {
            *spline = **base;
            ++i;
        }
    }
    switch (list.spline_type) {
        case Keyword::linear_spline:
            spline->kind = SplineKind::linear;
            break;
        case Keyword::quadratic_spline:
            spline->kind = SplineKind::quadratic;
            break;
        case Keyword::cubic_spline:
            spline->kind = SplineKind::cubic;
            break;
        case Keyword::natural_spline:
            spline->kind = SplineKind::natural;
            break;
        default:
            break;
    }
    for (; i + 1 < operands_.size(); i += 2) {
        const double parameter = to_float(operands_[i]);
        Terms value = numeric(operands_[i + 1]);
        if (value.count == 1) {
            value.v[1] = value.v[0];
            value.count = 2;
        }
        spline->add(parameter, value.v.data(), value.count);
    }
    if (i < operands_.size()) session_.fail(where, "Expected 'vector', } found instead");
    if (spline->empty()) session_.fail(where, "Spline must have at least one entry.");
    operands_.resize(list.base);
    session_.experimental.insert("spline");
    push(SplinePtr(std::move(spline)), cover(list.where, where));
}

void ParseState::set_function_block() {
    const std::shared_ptr<const Block> block = std::move(finished_);
    functions_.set_function(read_function_block(session_, *block));
}

void ParseState::open_function_name(const Produced& token) {
    if (functions_.push_parameter(token)) {
        names_.push_back(NameState::parameter);
        // Nothing that follows may look at an older operand.
        push(std::monostate{}, token.where);
        return;
    }
    names_.push_back(NameState::operand);
    if (token.kind == Tok::name) return push_name(token);
    if (token.kind == Tok::constant) return push_constant(token);
    session_.fail(token.where,
                  fmt::format("Expected 'operand', {} found instead{}", found_text(session_, token),
                              session_.hint(session_.words.spelling(token.word))));
}

void ParseState::open_function_value() {
    names_.back() = NameState::called;
    functions_.open_value_call(top());
}

void ParseState::close_function_name() {
    const NameState kind = names_.back();
    names_.pop_back();
    const Operand operand = pop();
    if (kind == NameState::operand) functions_.push_operand(operand);
}

void ParseState::push_function(SourceRange where) { push(Thing(functions_.finish(where)), where); }

}  // namespace rb
