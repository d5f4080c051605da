// Unique names.
#pragma once

#include <string>

#include "support/name_table.h"

namespace robcogen {

// A set of names that are taken.
class UniqueNames {
 public:
  bool contains(const std::string& name) const {
    const Use* use = uses_.find(name);
    return use != nullptr && use->is_taken;
  }

  // Takes the name. Returns whether it was free.
  bool reserve(const std::string& name) {
    const auto [use, is_new] = uses_.try_emplace(name, Use{true, round_});
    if (use->is_taken && !is_new) return false;
    *use = Use{true, round_};
    return true;
  }
  template <class Names>
  void reserve_all(const Names& names) {
    for (const std::string& name : names) reserve(name);
  }

  void release(const std::string& name) {
    if (Use* use = uses_.find(name)) use->is_taken = false;
    ++round_;  // its number may be free again
  }

  // Takes and returns the name, or the name with the first number from 2 on that is free.
  std::string add(const std::string& wanted) {
    if (reserve(wanted)) return wanted;
    const Use& use = *uses_.find(wanted);
    int number = use.round == round_ ? use.next : kFirstNumber;
    std::string name;
    do name = wanted + "_" + std::to_string(number++);
    while (!reserve(name));
    *uses_.find(wanted) = {true, round_, number};
    return name;
  }

 private:
  static constexpr int kFirstNumber = 2;

  // If no name was released since `round`, all numbers of the name below `next` are taken.
  struct Use {
    bool is_taken = false;
    int round = 0;
    int next = kFirstNumber;
  };

  NameTable<Use> uses_;  // including names that were released
  int round_ = 0;
};

}  // namespace robcogen
