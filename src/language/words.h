#pragma once
#include "grammar/token.h"

#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace rb {

/// Every word of a scene by number, so that tokens are small and comparing words is comparing numbers.
/// Reserved words have the numbers of `Keyword`.
class Words {
public:
    Words();

    uint32_t number(std::string_view spelling);
    std::string_view spelling(uint32_t word) const { return spellings_[word]; }
    size_t size() const { return spellings_.size(); }

    static bool is_keyword(uint32_t word) { return word < static_cast<uint32_t>(Keyword::count); }
    static Tok kind(uint32_t word) { return is_keyword(word) ? keyword_kinds[word] : Tok::undeclared; }

private:
    std::unordered_map<std::string_view, uint32_t> numbers_;
    std::deque<std::string> kept_;
    std::vector<std::string_view> spellings_;
};

inline constexpr uint32_t word_of(Keyword keyword) { return static_cast<uint32_t>(keyword); }

}  // namespace rb
