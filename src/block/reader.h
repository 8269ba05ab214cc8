#pragma once
#include "block/block.h"

namespace rb {

/// Hands out the items of a block in order, typed. Every function that takes something and does not find it
/// throws a SceneError at the place with the language's own wording; what no reader took is reported by
/// `finish()`, so a typo is caught for every kind of block.
class BlockReader {
public:
    BlockReader(const Block& block, const ReadContext& context) : block_(block), context_(context) {}

    const ReadContext& context() const { return context_; }
    Diagnostics& diagnostics() const { return *context_.diagnostics; }
    std::string_view keyword() const { return block_.keyword; }
    SourceRange block_where() const { return block_.where; }
    /// Place of the next item, or of the closing brace.
    SourceRange where() const;

    bool at_end() const { return item_ >= block_.items.size(); }
    bool at_number() const { return at(Item::Kind::numbers); }
    /// A colour expression, or a number that can serve as one.
    bool at_color() const { return at(Item::Kind::color) || at_number(); }
    bool at_text() const { return at(Item::Kind::text); }
    bool at_word() const { return at(Item::Kind::word); }
    bool at_word(std::string_view word) const { return at_word() && item().text == word; }
    bool at_block(std::string_view keyword) const {
        return at(Item::Kind::block) && item().block->keyword == keyword;
    }
    bool at_any_block() const { return at(Item::Kind::block); }
    template <class T>
    bool at_thing() const {
        return at(Item::Kind::thing) && std::holds_alternative<T>(item().thing);
    }

    /// The next word or block keyword without taking it; empty otherwise.
    std::string_view peek_word() const;
    /// The next item whatever it is; only when !at_end().
    const Item& peek() const { return item(); }
    void skip_item();

    /// Takes the word if it is next.
    bool take_word(std::string_view word);
    /// Takes the comma behind a value that was left out, where that is allowed (`radius , 2`).
    bool take_comma();
    std::string_view word();

    /// Numbers: floats spread to vectors, short vectors are filled with 0, long ones are an error.
    double number();
    int integer();
    Vec2 vec2();
    Vec3 vec3();
    Terms terms();
    /// An optional float after a switch such as `hollow`: absent means on, otherwise on when > 0.
    bool optional_switch();
    double positive(std::string_view what);
    /// `count` values of exactly `terms` terms (floats spread), appended packed to `out`.
    void numbers(size_t count, int terms, std::vector<double>& out);

    Color full_color();  ///< five components (pigments, maps, background, fog)
    Rgb rgb_color();     ///< RGB-only contexts (lights, ambient, reflection)
    std::string text();
    /// A string as a file name: only \\" is an escape.
    std::string file_name();

    template <class T>
    T thing() {
        T value = std::get<T>(item().thing);
        skip_item();
        return value;
    }
    const Block& block(std::string_view keyword);

    /// At the next item, with its hint if it is a word that nobody knows.
    [[noreturn]] void fail(std::string message) const;
    [[noreturn]] void fail_at(SourceRange where, std::string message) const;
    /// "No matching } in 'box', undeclared identifier 'foo' found instead", unless everything was taken.
    void finish() const;
    /// The next item in the words of an error message: `undeclared identifier 'foo'`, `float constant`, `}`.
    std::string found() const;

private:
    bool at(Item::Kind kind) const { return !at_end() && item().kind == kind; }
    const Item& item() const { return block_.items[item_]; }
    Terms expect_terms(std::string_view expected);
    WrittenColor written_color();

    const Block& block_;
    const ReadContext& context_;
    size_t item_ = 0;
    uint32_t value_ = 0;  ///< how many values of a numbers item were taken
};

/// Promotes a written colour to five components (language spec 10); `context_terms` is 5 for full colours, 3
/// for RGB-only places.
Color promote(const WrittenColor& color, int context_terms);

}  // namespace rb
