#pragma once
#include "language/arithmetic.h"
#include "language/session.h"

#include <array>
#include <initializer_list>

namespace rb {

/// Numeric expressions, read straight from the tokens of one frame. The grammar is the slow twin: whatever is
/// not plain here (directives, macros, texts, warnings, errors, the end of the frame) makes a reading fail
/// without a trace, and the grammar reads it from the start.
class QuickExpression {
public:
    /// Reads from token `at` on, but not from token `end`.
    QuickExpression(Session& session, const TokenFile& file, uint32_t at, uint32_t end)
        : session_(session), tokens_(file.tokens.data()), file_(file), first_(at), at_(at), end_(end) {}

    /// The grammar's `sum` or `full`, and a token behind it that ends it for sure: one of `ends` if any are
    /// given.
    bool read_sum(std::initializer_list<Tok> ends);
    bool read_full(std::initializer_list<Tok> ends);

    /// `red 0.5` behind a colour goes on with it.
    void leave_channels() { leaves_channels_ = true; }

    const Terms& terms() const { return value_.terms; }
    SourceRange where() const { return {file_.file, value_.begin, value_.end}; }
    /// The token behind the expression.
    uint32_t at() const { return at_; }
    /// What it names if it is nothing but an identifier or array element.
    Place place() const;

private:
    struct Value {
        Terms terms;
        uint32_t begin = 0;  ///< byte range
        uint32_t end = 0;
    };
    static constexpr int deepest = 40;  ///< parentheses and calls within each other
    struct Drawn {
        size_t stream;
        uint32_t state;
    };

    bool full(Value& out);
    bool logical(Value& out);
    bool rel(Value& out);
    bool sum(Value& out);
    bool float_sum(double& out);
    bool float_term(double& out);
    bool float_factor(double& out);
    bool float_component(const Terms& terms, double& out);
    bool term(Value& out);
    bool factor(Value& out);
    bool primary(Value& out);
    bool word(Value& out);
    bool name(const Place& place, Value& out);
    bool elements(const ArrayPtr& array, Value& out);
    bool vector(Value& out);
    bool call_one(Keyword function, Value& out);
    bool call_many(Keyword function, Value& out);
    bool call_float(Keyword function, double a, double& result);
    bool draw(double stream, double& result);
    bool component(Value& out);
    bool apply(Operator op, Value& left, const Value& right);
    bool finish(bool done);
    bool has_ended(std::initializer_list<Tok> ends) const;

    Tok kind() const { return at_ < end_ ? tokens_[at_].kind : Tok::end; }
    bool take(Tok kind) {
        if (this->kind() != kind) return false;
        ++at_;
        return true;
    }

    Session& session_;
    const Token* tokens_;
    const TokenFile& file_;
    uint32_t first_;
    uint32_t at_;
    uint32_t end_;
    int depth_ = 0;
    bool leaves_channels_ = false;
    Value value_;
    // The last identifier read, and the token behind it: it is the whole expression if that is all there is.
    const Place* name_ = nullptr;
    ArrayPtr array_;
    size_t index_ = 0;
    uint32_t name_begin_ = 0;
    uint32_t name_end_ = 0;
    // Draws of random numbers that a failure takes back.
    std::array<Drawn, 8> drawn_;
    size_t draws_ = 0;
};

}  // namespace rb
