#pragma once
#include "language/value.h"

#include <vector>

namespace rb {

/// The symbol tables: one global table, one more for each include file and macro call being read. Look-up
/// goes from the innermost outwards through all of them (dynamic scoping).
class Symbols {
public:
    static constexpr size_t limit = 100;

    Symbols() { open(); }

    void open() { tables_.emplace_back(); }
    void close();
    size_t depth() const { return tables_.size(); }

    /// The visible symbol as long as no table changes, or null.
    const Place* look(uint32_t word) const {
        if (word >= entries_.size() || entries_[word].empty()) return nullptr;
        return &entries_[word].back().place;
    }
    /// The visible symbol, or null.
    SlotPtr find(uint32_t word) const;
    /// The array element that a by-reference parameter stands for.
    Place find_place(uint32_t word) const;

    /// A new symbol in the innermost (`level` = depth() - 1) or another table; replaces one of the same name.
    /// Where the table is closed already, the slot belongs to nobody.
    SlotPtr create(uint32_t word, size_t level);
    SlotPtr create_local(uint32_t word) { return create(word, tables_.size() - 1); }
    SlotPtr create_global(uint32_t word) { return create(word, 0); }
    /// The symbol in one table.
    Place find_at(uint32_t word, size_t level) const;
    SlotPtr find_local(uint32_t word) const { return find_at(word, tables_.size() - 1).slot; }
    /// Makes `word` another name of `place` in the innermost table.
    void alias(uint32_t word, const Place& place);
    /// Removes the innermost symbol; false if there is none.
    bool remove(uint32_t word);

    std::vector<uint32_t> visible() const;

private:
    struct Entry {
        size_t level = 0;
        Place place;
    };
    struct Table {
        std::vector<uint32_t> words;
    };
    /// Entries by word, innermost last.
    std::vector<std::vector<Entry>> entries_;
    std::vector<Table> tables_;

    std::vector<Entry>& of(uint32_t word);
    void put(uint32_t word, size_t level, const Place& place);
};

}  // namespace rb
