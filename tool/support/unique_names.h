// Unique names.
#pragma once

#include <string>

#include "support/name_table.h"

namespace robcogen {

// Names that are taken.
class UniqueNames {
 public:
  bool contains(const std::string& name) const {
    const Use* use = uses_.find(name);
    return use != nullptr && use->is_taken;
  }

  // Whether the name was free; it is taken now.
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

  // The name, or the name with the first number from 2 on that is not taken. It is taken now.
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

  // All numbers of a name that are smaller than the next are taken, if no name was released since that round.
  struct Use {
    bool is_taken = false;
    int round = 0;
    int next = kFirstNumber;
  };

  NameTable<Use> uses_;  // also of names that were released
  int round_ = 0;
};

}  // namespace robcogen
