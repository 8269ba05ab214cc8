// Any bytes become tokens that lie within the text, in order, the last of them the end.
#include "language/number_run.h"
#include "language/token_file.h"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    for (const bool runs : {true, false}) {
        rb::Words words;
        rb::LexOptions options;
        options.runs = runs;
        options.is_main = runs;
        const rb::TokenFilePtr file = rb::lex(1, text, words, options);
        size_t at = 0;
        for (const rb::Token& token : file->tokens) {
            if (token.begin < at || token.begin + token.size > size) std::abort();
            at = token.begin + token.size;
            if (token.kind != rb::Tok::run) continue;
            std::vector<double> numbers;
            rb::parse_number_run(file->spelling(token), numbers);
        }
        if (file->tokens.empty() || file->tokens.back().kind != rb::Tok::end) std::abort();
    }
    return 0;
}
