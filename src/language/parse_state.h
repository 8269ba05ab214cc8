#pragma once
#include "language/arithmetic.h"
#include "language/function_builder.h"
#include "language/parser.h"

#include <memory>
#include <string>
#include <vector>

namespace rb {

/// What the actions of the token grammar work on: operands, open calls, open blocks.
class ParseState {
public:
    explicit ParseState(Session& session) : session_(session), functions_(session) {}

    Session& session() { return session_; }
    FunctionBuilder& functions() { return functions_; }

    // Operands.
    void push(Value value, SourceRange where);
    void push(Operand operand) { operands_.push_back(std::move(operand)); }
    void push_name(const Produced& token);
    void push_constant(const Produced& token);
    void push_text(const Produced& token);
    Operand pop();
    Operand& top() { return operands_.back(); }
    size_t operand_count() const { return operands_.size(); }

    // Operators.
    /// Where a sign or bracket stands, for the action at the end of what it opens.
    void open_place(SourceRange where) { places_.push_back(where); }
    void negate();
    /// `+A` is a value, not the variable.
    void close_plus() { top().place = {}; }
    void invert();
    void apply(Operator op);
    void choose();
    void take_component(const Produced& name);
    void close_group(SourceRange where);
    void open_list(SourceRange where, uint32_t word = 0) {
        lists_.push_back({operands_.size(), where, word});
    }
    void close_vector(SourceRange where);
    void close_call(SourceRange where);
    void close_value_call(SourceRange where);
    void close_tuple(SourceRange where);
    void set_spline_type(const Produced& word);
    void take_subscript(SourceRange where);
    bool value_is_array() const;
    bool value_is_callable() const;
    bool value_is_texture() const;
    bool text_stands_alone() const;

    // Colours.
    void open_color(SourceRange where) { colors_.push_back({{}, where, {}}); }
    void add_color_word() { colors_.back().color.color_word = true; }
    void set_color_word(const Produced& word) { colors_.back().word = word; }
    void add_rgb_base();
    void add_channel();
    void add_bare_base();
    WrittenColor take_color(SourceRange& where);

    // Blocks.
    void open_block(std::string_view keyword, SourceRange where);
    std::shared_ptr<const Block> close_block(SourceRange where);
    void close_inner_block(SourceRange where);
    void open_barrier() { blocks_.push_back({}); }
    void close_barrier() { blocks_.pop_back(); }
    bool colors_allowed() const;
    /// The innermost open block, or null.
    const Block* open_block() const { return blocks_.empty() ? nullptr : blocks_.back().block.get(); }
    void add_value();
    void add_terms(const Terms& terms, SourceRange where);
    void add_color();
    void add_run(const Produced& run);
    void add_word(const Produced& word);
    void add_function();
    void add_stray(const Produced& token);
    std::shared_ptr<const Block> take_finished() { return std::move(finished_); }
    /// Keeps the memory of a block that nobody else holds for the next ones.
    void recycle(std::shared_ptr<const Block> block);

    // Right sides.
    void push_color_value();
    void push_block_value();
    void merge_layer();
    void push_transform_value();
    void open_array(SourceRange where);
    void size_array();
    void check_array();
    void open_rows();
    void close_rows(SourceRange where);
    void add_row_item();
    void push_array();
    bool array_has_inner_rows() const;
    void push_spline(SourceRange where);

    // User functions: see FunctionBuilder; these touch operands too.
    void push_function(SourceRange where);
    void set_function_block();
    void set_function_spline() { functions_.set_function(std::get<SplinePtr>(pop().value)); }
    void add_image_value();
    bool value_is_number() const { return image_number_; }
    void open_function_name(const Produced& token);
    void open_function_value();
    void close_function_name();
    bool function_name_is_array() const { return value_is_array(); }
    bool function_name_is_callable() const { return value_is_callable(); }

private:
    struct List {
        size_t base = 0;
        SourceRange where;
        uint32_t word = 0;
        Keyword spline_type = Keyword::count;
    };
    struct OpenBlock {
        std::shared_ptr<Block> block;  ///< null: a barrier, blocks within are not items of the one outside
        int same_shape = 0;
    };
    struct OpenColor {
        WrittenColor color;
        SourceRange where;
        Produced word;
    };
    struct OpenArray {
        ArrayPtr array;
        size_t depth = 0;
        size_t filled = 0;
        std::vector<size_t> counts;
        SourceRange where;  ///< of the last size
        SourceRange word;
    };

    SourceRange take_place() {
        const SourceRange where = places_.back();
        places_.pop_back();
        return where;
    }
    Terms numeric(const Operand& operand) const;
    Item& new_item(Item::Kind kind, SourceRange where);
    Block& open() { return *blocks_.back().block; }

    Session& session_;
    FunctionBuilder functions_;
    std::vector<Operand> operands_;
    std::vector<SourceRange> places_;
    std::vector<List> lists_;
    std::vector<OpenBlock> blocks_;
    std::vector<OpenArray> arrays_;
    std::vector<OpenColor> colors_;
    std::shared_ptr<const Block> finished_;
    std::vector<std::shared_ptr<Block>> spare_;
    enum class NameState { parameter, operand, called };
    bool image_number_ = false;
    std::vector<NameState> names_;  ///< of the user function's identifiers being read
};

}  // namespace rb
