// Unique names.
#pragma once

#include <string>
#include <unordered_map>

namespace robcogen {

// Names that are taken.
class UniqueNames {
 public:
  bool contains(const std::string& name) const { return taken_.contains(name); }

  // Whether the name was free; it is taken now.
  bool reserve(const std::string& name) { return taken_.try_emplace(name, Numbers{round_}).second; }
  template <class Names>
  void reserve_all(const Names& names) {
    for (const std::string& name : names) reserve(name);
  }

  void release(const std::string& name) {
    taken_.erase(name);
    ++round_;  // its number may be free again
  }

  // The name, or the name with the first number from 2 on that is not taken. It is taken now.
  std::string add(const std::string& wanted) {
    const auto [place, is_free] = taken_.try_emplace(wanted, Numbers{round_});
    if (is_free) return wanted;
    Numbers& numbers = place->second;
    if (numbers.round != round_) numbers = Numbers{round_};
    for (;;) {
      std::string name = wanted + "_" + std::to_string(numbers.next++);
      if (reserve(name)) return name;
    }
  }

 private:
  // All numbers of a name that are smaller than the next are taken, if no name was released since that round.
  struct Numbers {
    int round = 0;
    int next = 2;
  };

  std::unordered_map<std::string, Numbers> taken_;
  int round_ = 0;
};

}  // namespace robcogen
