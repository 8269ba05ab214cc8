#pragma once
#include "block/block.h"
#include "language/session.h"

#include <memory>
#include <string>
#include <vector>

namespace rb {

/// A value with the place it was written, and the variable it names if it is nothing but an identifier.
struct Operand {
    Value value;
    Place place;  ///< known() if the expression is exactly one identifier or array element
    SourceRange where;
    size_t pending_dimension = 0;  ///< subscripts taken so far of an array of several dimensions
    size_t pending_index = 0;

    const Terms* terms() const { return std::get_if<Terms>(&value); }
};

class TokenInput;
class ParseState;

/// One parse over the token stream. Parses nest: a directive between two tokens makes its own. Tokens that
/// were looked at but not used go back to the stream when it ends. The home of the token grammar is
/// parser.cpp.
class Parser {
public:
    explicit Parser(Session& session);
    ~Parser();
    Parser(const Parser&) = delete;
    Parser& operator=(const Parser&) = delete;

    const Produced& peek();
    Produced take();
    bool take_if(Tok kind);
    bool at_word(Keyword word);
    void expect(Tok kind, std::string_view spelling);
    [[noreturn]] void fail_expected(std::string_view expected);

    /// "(" full ")" and "(" sum { "," sum } ")", ended by the parenthesis: no token behind it is looked at.
    double condition();
    std::vector<double> numbers_in_parentheses(size_t least, size_t most);

    /// The right side of a declaration, or a macro argument (spec: language 4.2).
    Operand rvalue();
    Operand sum();
    double number();
    std::string text();
    /// A file name: escapes other than \" are not interpreted.
    std::string file_name();

    /// keyword "{" items "}", the keyword already taken.
    std::shared_ptr<const Block> block(const Produced& keyword);
    /// The same if a plain statement comes next; null: nothing was read.
    std::shared_ptr<const Block> plain_statement();
    /// A block that was read: its memory serves the next one.
    void recycle(std::shared_ptr<const Block> block);

    /// Locks directives between an operand and the next operator.
    void lock(bool on);
    Session& session() { return session_; }
    TokenInput& input() { return *input_; }

private:
    Session& session_;
    std::shared_ptr<const Block> rest_of_block(const Produced& keyword);

    std::unique_ptr<TokenInput> input_;
    std::unique_ptr<ParseState>
        blocks_;  ///< empty but for spare memory between blocks; null before the first
    bool saved_lock_;
    bool saved_quiet_;
    int saved_nesting_;
};

/// The value of a string literal, quotes included in `literal`.
std::string unescape(Session& session, std::string_view literal, SourceRange where);
std::string raw_literal(std::string_view literal);

/// Converts or throws with the language's wording.
double to_float(const Operand& operand);
Vec3 to_vec3(const Operand& operand);
const std::string& to_text(const Operand& operand);
/// "(" NAME ")" read raw from the stream: whether NAME is declared.
bool defined_name(Session& session);
size_t checked_subscript(const Operand& operand, size_t size);

}  // namespace rb
