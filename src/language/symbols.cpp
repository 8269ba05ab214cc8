#include "language/symbols.h"

#include <algorithm>

namespace rb {

std::vector<Symbols::Entry>& Symbols::of(uint32_t word) {
    if (word >= entries_.size()) entries_.resize(word + 64);
    return entries_[word];
}

void Symbols::close() {
    const size_t level = tables_.size() - 1;
    for (uint32_t word : tables_.back().words) {
        auto& list = of(word);
        std::erase_if(list, [&](const Entry& entry) { return entry.level == level; });
    }
    tables_.pop_back();
}

Place Symbols::find_place(uint32_t word) const {
    if (word >= entries_.size() || entries_[word].empty()) return {};
    return entries_[word].back().place;
}

SlotPtr Symbols::find(uint32_t word) const {
    if (word >= entries_.size() || entries_[word].empty()) return nullptr;
    return entries_[word].back().place.slot;
}

Place Symbols::find_at(uint32_t word, size_t level) const {
    if (word >= entries_.size()) return {};
    for (const Entry& entry : entries_[word]) {
        if (entry.level == level) return entry.place;
    }
    return {};
}

void Symbols::put(uint32_t word, size_t level, const Place& place) {
    auto& list = of(word);
    const auto at = std::find_if(list.begin(), list.end(), [&](const Entry& e) { return e.level >= level; });
    if (at != list.end() && at->level == level) {
        at->place = place;
        return;
    }
    list.insert(at, {level, place});
    tables_[level].words.push_back(word);
}

SlotPtr Symbols::create(uint32_t word, size_t level) {
    Place place;
    place.slot = std::make_shared<Slot>();
    // A table that has been closed takes no more symbols: this one would be gone, too.
    if (level < tables_.size()) put(word, level, place);
    return place.slot;
}

void Symbols::alias(uint32_t word, const Place& place) { put(word, tables_.size() - 1, place); }

bool Symbols::remove(uint32_t word) {
    auto& list = of(word);
    if (list.empty()) return false;
    list.pop_back();
    return true;
}

std::vector<uint32_t> Symbols::visible() const {
    std::vector<uint32_t> out;
    for (uint32_t word = 0; word < entries_.size(); ++word) {
        if (!entries_[word].empty()) out.push_back(word);
    }
    return out;
}

}  // namespace rb
