// Colours and generic blocks.
#include "language/builtins.h"
#include "language/number_run.h"
#include "language/parse_state.h"
#include "language/read.h"

#include <fmt/format.h>

namespace rb {

namespace {

int terms_of(Keyword word) {
    switch (word) {
        case Keyword::rgb:
        case Keyword::srgb:
            return 3;
        case Keyword::rgbf:
        case Keyword::rgbt:
        case Keyword::srgbf:
        case Keyword::srgbt:
            return 4;
        default:
            return 5;
    }
}

bool is_srgb(Keyword word) {
    return word == Keyword::srgb || word == Keyword::srgbf || word == Keyword::srgbt ||
           word == Keyword::srgbft;
}

/// Statements whose items are objects: a finished object in one of them is read at once.
bool holds_objects(std::string_view keyword) {
    constexpr std::string_view keywords[] = {
        "object",     "union",      "merge",      "intersection", "difference",       "composite",
        "bounded_by", "clipped_by", "looks_like", "light_group",  "projected_through"};
    for (std::string_view k : keywords) {
        if (k == keyword) return true;
    }
    return false;
}

}  // namespace

void ParseState::add_rgb_base() {
    const Operand operand = pop();
    OpenColor& open_color = colors_.back();
    const auto keyword = static_cast<Keyword>(open_color.word.word);
    WrittenColor& color = open_color.color;
    color.has_base = true;
    color.word_terms = terms_of(keyword);
    color.transmit_fourth = keyword == Keyword::rgbt || keyword == Keyword::srgbt;
    color.base = numeric(operand);
    if (color.base.count > color.word_terms) {
        session_.warn(operand.where, fmt::format("Suspicious expression after {}.",
                                                 session_.words.spelling(open_color.word.word)));
    }
    if (is_srgb(keyword)) decode_srgb(session_, color, open_color.word.where);
    open_color.where = cover(open_color.where, operand.where);
}

void ParseState::add_channel() {
    const Operand operand = pop();
    OpenColor& open_color = colors_.back();
    const auto keyword = static_cast<Keyword>(open_color.word.word);
    if (keyword == Keyword::alpha)
        session_.warn(open_color.word.where, "Keyword 'alpha' is obsolete: use 'filter'.");
    open_color.color.set[static_cast<size_t>(component_index(keyword))] = to_float(operand);
    open_color.where = cover(open_color.where, operand.where);
}

void ParseState::add_bare_base() {
    const Operand operand = pop();
    OpenColor& open_color = colors_.back();
    open_color.color.has_base = open_color.color.bare = true;
    open_color.color.base = numeric(operand);
    open_color.where = cover(open_color.where, operand.where);
}

WrittenColor ParseState::take_color(SourceRange& where) {
    const WrittenColor color = colors_.back().color;
    where = colors_.back().where;
    colors_.pop_back();
    return color;
}

void ParseState::open_block(std::string_view keyword, SourceRange where) {
    OpenBlock opened;
    if (spare_.empty()) {
        opened.block = std::make_shared<Block>();
        opened.block->items.reserve(6);
        opened.block->numbers.reserve(8);
    } else {
        opened.block = std::move(spare_.back());
        spare_.pop_back();
    }
    opened.block->keyword = keyword;
    opened.block->where = where;
    blocks_.push_back(std::move(opened));
}

void ParseState::recycle(std::shared_ptr<const Block> block) {
    constexpr size_t most_spare = 8;
    constexpr size_t most_items = 64;
    if (block.use_count() != 1 || spare_.size() >= most_spare || block->items.size() > most_items ||
        block->numbers.size() > 4 * most_items) {
        return;
    }
    auto spare = std::const_pointer_cast<Block>(std::move(block));
    for (Item& item : spare->items) {
        if (item.block) recycle(std::move(item.block));
    }
    spare->items.clear();
    spare->numbers.clear();
    spare_.push_back(std::move(spare));
}

std::shared_ptr<const Block> ParseState::close_block(SourceRange where) {
    std::shared_ptr<Block> block = std::move(blocks_.back().block);
    blocks_.pop_back();
    block->where = cover(block->where, where);
    return block;
}

void ParseState::close_inner_block(SourceRange where) {
    std::shared_ptr<const Block> block = close_block(where);
    if (blocks_.empty() || !blocks_.back().block) {
        finished_ = std::move(block);
        return;
    }
    if (holds_objects(open().keyword) && is_object_keyword(block->keyword)) {
        const ReadContext context = session_.context();
        Thing object = read_object(*block, context);
        Item& item = new_item(Item::Kind::thing, block->where);
        item.text = block->keyword;
        item.thing = std::move(object);
        recycle(std::move(block));
        return;
    }
    const SourceRange whole = block->where;
    new_item(Item::Kind::block, whole).block = std::move(block);
}

Item& ParseState::new_item(Item::Kind kind, SourceRange where) {
    blocks_.back().same_shape = 0;
    Item& item = open().items.emplace_back();
    item.kind = kind;
    item.where = where;
    return item;
}

bool ParseState::colors_allowed() const {
    if (blocks_.empty() || !blocks_.back().block) return true;
    // In an image `filter` and `transmit` take palette entries.
    return blocks_.back().block->keyword != "image_map";
}

void ParseState::add_terms(const Terms& terms, SourceRange where) {
    Block& block = open();
    OpenBlock& top_block = blocks_.back();
    const auto append = [&] {
        block.numbers.insert(block.numbers.end(), terms.v.begin(), terms.v.begin() + terms.count);
    };
    if (!block.items.empty() && top_block.same_shape > 0) {
        Item& last = block.items.back();
        // A few values keep their own places for messages; long lists are packed.
        if (last.terms == terms.count && top_block.same_shape >= 8) {
            append();
            ++last.count;
            last.where = cover(last.where, where);
            return;
        }
    }
    const int same =
        !block.items.empty() && top_block.same_shape > 0 && block.items.back().terms == terms.count
            ? top_block.same_shape + 1
            : 1;
    Item& item = new_item(Item::Kind::numbers, where);
    item.first = static_cast<uint32_t>(block.numbers.size());
    item.count = 1;
    item.terms = terms.count;
    append();
    blocks_.back().same_shape = same;
}

void ParseState::add_value() {
    const Operand operand = pop();
    if (const Terms* terms = operand.terms()) return add_terms(*terms, operand.where);
    if (const auto* text = std::get_if<std::string>(&operand.value)) {
        Item& item = new_item(Item::Kind::text, operand.where);
        item.text = *text;
        const std::string_view written = session_.text_of(operand.where);
        if (written.starts_with('"') && written.find('\\') != std::string_view::npos) {
            item.raw = std::make_shared<const std::string>(raw_literal(written));
        }
        return;
    }
    if (const auto* thing = std::get_if<Thing>(&operand.value)) {
        Item& item = new_item(Item::Kind::thing, operand.where);
        item.thing = *thing;
        item.text = std::string(session_.text_of(operand.where));
        return;
    }
    if (const auto* spline = std::get_if<SplinePtr>(&operand.value)) {
        Item& item = new_item(Item::Kind::thing, operand.where);
        item.thing = FunctionPtr(*spline);
        item.text = std::string(session_.text_of(operand.where));
        return;
    }
    const auto* array = std::get_if<ArrayPtr>(&operand.value);
    if (array && (*array)->sizes.empty()) {
        Item& item = new_item(Item::Kind::numbers, operand.where);
        item.first = static_cast<uint32_t>(open().numbers.size());
        item.count = static_cast<uint32_t>((*array)->elements.size());
        item.terms = 1;
        item.bracketed = true;
        for (const Value& element : (*array)->elements)
            open().numbers.push_back(std::get<Terms>(element).v[0]);
        return;
    }
    new_item(Item::Kind::bad, operand.where).text = kind_name(operand.value);
}

void ParseState::add_color() {
    SourceRange where;
    auto color = std::make_shared<const WrittenColor>(take_color(where));
    new_item(Item::Kind::color, where).color = std::move(color);
}

void ParseState::add_run(const Produced& run) {
    Block& block = open();
    Item& item = new_item(Item::Kind::numbers, run.where);
    item.first = static_cast<uint32_t>(block.numbers.size());
    item.terms = static_cast<int>(run.word);
    const std::string_view text = session_.text_of(run.where);
    // A number and its comma take two bytes at least; four is what long lists really have.
    block.numbers.reserve(block.numbers.size() + text.size() / 8);
    parse_number_run(text, block.numbers);
    item.count = static_cast<uint32_t>((block.numbers.size() - item.first) / run.word);
    blocks_.back().same_shape = 8;
}

void ParseState::add_word(const Produced& word) {
    new_item(Item::Kind::word, word.where).text = std::string(session_.words.spelling(word.word));
}

void ParseState::add_image_value() {
    image_number_ = std::holds_alternative<Terms>(top().value);
    add_value();
}

void ParseState::add_function() {
    const Operand operand = pop();
    Item& item = new_item(Item::Kind::thing, operand.where);
    item.text = "function";
    item.thing = std::get<Thing>(operand.value);
}

void ParseState::add_stray(const Produced& token) {
    Item& item = new_item(Item::Kind::bad, token.where);
    item.text = found_text(session_, token);
    if (token.kind != Tok::undeclared) return;
    std::string hint = session_.hint(session_.words.spelling(token.word));
    if (!hint.empty()) item.raw = std::make_shared<const std::string>(std::move(hint));
}

}  // namespace rb
