#pragma once
#include "base/source.h"
#include "language/words.h"

#include <memory>
#include <string>
#include <vector>

namespace rb {

/// One token of a file, 16 bytes.
struct Token {
    uint32_t begin = 0;
    uint32_t size = 0;
    uint32_t aux =
        0;  ///< word: its number; number: index of its value; hash: see TokenFile; run: terms a vector
    Tok kind = Tok::end;
};

struct LexicalError {
    uint32_t token = 0;  ///< index of the `invalid` token
    std::string message;
};

/// The tokens of one file, lexed once. `#` tokens of directives that open or continue a conditional know the
/// next branch of the same conditional (`aux` is its token index, 0 if there is none).
struct TokenFile {
    uint32_t file = 0;
    std::string_view text;
    std::vector<Token> tokens;
    std::vector<double> numbers;
    std::vector<LexicalError> errors;

    SourceRange range(const Token& token) const { return {file, token.begin, token.begin + token.size}; }
    std::string_view spelling(const Token& token) const { return text.substr(token.begin, token.size); }
};
using TokenFilePtr = std::shared_ptr<const TokenFile>;

/// #if, #while, #macro, ...: directives that an #end closes.
bool opens_branches(Keyword word);

struct LexOptions {
    bool quick = true;     ///< false: leave every token to the grammar (slow; for tests)
    bool runs = true;      ///< keep long lists of plain vectors as one token
    bool is_main = false;  ///< bytes >= 128 at the start are skipped
    uint32_t begin = 0;    ///< part of the text that is lexed
    uint32_t end = 0xffffffff;
};

TokenFilePtr lex(uint32_t file, std::string_view text, Words& words, const LexOptions& options = {});

}  // namespace rb
