// A table of names.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "support/texts.h"

namespace robcogen {

// A map from names to values. The table keeps a copy of each name. All names and entries are in a few large blocks of
// memory: a program has thousands of names, and allocating them one by one would take longer than looking them up.
template <class Value>
class NameTable {
 public:
  // nullptr if the table does not have the name. Values stay where they are until the next name is added.
  Value* find(std::string_view name) { return const_cast<Value*>(std::as_const(*this).find(name)); }
  const Value* find(std::string_view name) const {
    if (slots_.empty()) return nullptr;
    const std::size_t entry = slots_[slot(name, hash_of(name))];
    return entry == kFree ? nullptr : &entries_[entry].value;
  }

  // The value of the name, and whether the name is new. A new name gets this value.
  std::pair<Value*, bool> try_emplace(std::string_view name, const Value& value) {
    if (2 * (entries_.size() + 1) > slots_.size()) grow();
    const std::size_t hash = hash_of(name);
    std::size_t& known = slots_[slot(name, hash)];
    const bool is_new = known == kFree;
    if (is_new) {
      known = entries_.size();
      entries_.push_back({texts_.add({name}), hash, value});
    }
    return {&entries_[known].value, is_new};
  }

 private:
  struct Entry {
    std::string_view name;
    std::size_t hash;
    Value value;
  };
  static constexpr std::size_t kFree = static_cast<std::size_t>(-1), kFirstSlots = 64;

  Texts texts_;
  std::vector<Entry> entries_;
  std::vector<std::size_t> slots_;  // indices of entries by hash: open addressing, a power of two, at most half full

  static std::size_t hash_of(std::string_view name) { return std::hash<std::string_view>()(name); }

  std::size_t slot(std::string_view name, std::size_t hash) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t place = hash & mask;
    while (slots_[place] != kFree && (entries_[slots_[place]].hash != hash || entries_[slots_[place]].name != name))
      place = (place + 1) & mask;
    return place;
  }

  void grow() {
    slots_.assign(slots_.empty() ? kFirstSlots : 2 * slots_.size(), kFree);
    for (std::size_t i = 0; i < entries_.size(); ++i) slots_[slot(entries_[i].name, entries_[i].hash)] = i;
  }
};

}  // namespace robcogen
