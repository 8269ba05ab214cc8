#include "language/parser.h"

#include "language/parse_actions.h"

namespace rb {

namespace {

namespace pegtl = tao::pegtl;

/// `nested` has only its last rule fail in a way that can be named: the closing sign.
template <class Rule>
bool run(TokenInput& in, ParseState& state) {
    return pegtl::parse<Rule, action, control>(in, state);
}

}  // namespace

bool TokenInput::take_defined() {
    if (!at_keyword(Keyword::defined)) return false;
    Produced& token = ring_[at_ % kept];
    // The name in parentheses is read raw: a macro must not be called. Nothing behind the word was looked at.
    if (at_ + 1 != produced_) return false;
    token.number = defined_name(session_) ? 1 : 0;
    bump();
    return true;
}

Parser::Parser(Session& session)
    : session_(session),
      input_(std::make_unique<TokenInput>(session)),
      saved_lock_(session.stream.locked),
      saved_quiet_(session.stream.quiet),
      saved_nesting_(session.nesting) {
    session.stream.locked = session.stream.quiet = false;
}

Parser::~Parser() {
    session_.stream.locked = saved_lock_;
    session_.stream.quiet = saved_quiet_;
    session_.nesting = saved_nesting_;
}

const Produced& Parser::peek() { return input_->peek(); }

Produced Parser::take() {
    Produced token = input_->peek();
    input_->bump();
    return token;
}

bool Parser::take_if(Tok kind) {
    if (input_->kind() != kind) return false;
    input_->bump();
    return true;
}

bool Parser::at_word(Keyword word) { return input_->at_keyword(word); }

void Parser::fail_expected(std::string_view expected) {
    const Produced& token = input_->peek();
    std::string message =
        fmt::format("Expected '{}', {} found instead", expected, found_text(session_, token));
    if (token.kind == Tok::undeclared) message += session_.hint(session_.words.spelling(token.word));
    session_.fail(token.where, std::move(message));
}

void Parser::expect(Tok kind, std::string_view spelling) {
    if (!take_if(kind)) fail_expected(spelling);
}

void Parser::lock(bool on) { session_.stream.locked = on; }

double Parser::condition() {
    expect(Tok::lparen, "(");
    ParseState state(session_);
    lock(true);
    if (!run<pegtl::seq<grammar::open_next, grammar::full>>(*input_, state))
        fail_expected("numeric expression");
    expect(Tok::rparen, ")");
    return to_float(state.top());
}

std::vector<double> Parser::numbers_in_parentheses(size_t least, size_t most) {
    expect(Tok::lparen, "(");
    std::vector<double> values;
    lock(true);
    while (values.size() < most) {
        values.push_back(number());
        if (values.size() < most) take_if(Tok::comma);
        if (values.size() >= least && peek().kind == Tok::rparen) break;
    }
    expect(Tok::rparen, ")");
    return values;
}

Operand Parser::rvalue() {
    ParseState state(session_);
    if (!run<grammar::rvalue>(*input_, state)) {
        const Produced& token = input_->peek();
        if (token.kind == Tok::undeclared) {
            session_.fail(token.where,
                          fmt::format("Expected 'RValue', {} found instead{}", found_text(session_, token),
                                      session_.hint(session_.words.spelling(token.word))));
        }
        fail_expected("RValue to declare");
    }
    Operand operand = state.pop();
    if (operand.pending_dimension != 0) fail_expected("[");
    const auto* array = std::get_if<ArrayPtr>(&operand.value);
    if (array && (*array)->sizes.empty()) {
        session_.fail(operand.where, "Expected '>': a vector has at most five components.");
    }
    return operand;
}

Operand Parser::sum() {
    ParseState state(session_);
    if (!run<grammar::sum>(*input_, state)) fail_expected("numeric expression");
    return state.pop();
}

double Parser::number() { return to_float(sum()); }

std::string Parser::text() {
    ParseState state(session_);
    // What follows a string must not run before the string is used.
    peek();
    const bool locked = session_.stream.locked;
    lock(true);
    if (!run<grammar::sum>(*input_, state)) fail_expected("string expression");
    lock(locked);
    return to_text(state.top());
}

std::string Parser::file_name() {
    if (peek().kind == Tok::text) {
        const Produced token = take();
        return raw_literal(session_.text_of(token.where));
    }
    return text();
}

std::shared_ptr<const Block> Parser::block(const Produced& keyword) {
    if (input_->take_quick_brace()) return rest_of_block(keyword);
    if (peek().kind != Tok::lbrace) {
        session_.fail(peek().where,
                      fmt::format("Missing {{ after '{}', {} found instead",
                                  session_.words.spelling(keyword.word), found_text(session_, peek())));
    }
    take();
    return rest_of_block(keyword);
}

std::shared_ptr<const Block> Parser::plain_statement() {
    Produced keyword;
    return input_->take_quick_statement(keyword) ? rest_of_block(keyword) : nullptr;
}

std::shared_ptr<const Block> Parser::rest_of_block(const Produced& keyword) {
    if (!blocks_) blocks_ = std::make_unique<ParseState>(session_);
    blocks_->open_block(session_.words.spelling(keyword.word), keyword.where);
    if (!run<grammar::inner>(*input_, *blocks_)) fail_expected("}");
    return blocks_->take_finished();
}

void Parser::recycle(std::shared_ptr<const Block> block) { blocks_->recycle(std::move(block)); }

}  // namespace rb
