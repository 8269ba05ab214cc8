#include "language/words.h"

namespace rb {

Words::Words() {
    for (std::string_view spelling : keyword_spellings) {
        numbers_.emplace(spelling, static_cast<uint32_t>(spellings_.size()));
        spellings_.push_back(spelling);
    }
}

uint32_t Words::number(std::string_view spelling) {
    if (const auto known = numbers_.find(spelling); known != numbers_.end()) return known->second;
    kept_.emplace_back(spelling);
    const auto number = static_cast<uint32_t>(spellings_.size());
    numbers_.emplace(kept_.back(), number);
    spellings_.push_back(kept_.back());
    return number;
}

}  // namespace rb
