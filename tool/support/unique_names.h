// Unique names.
#pragma once

#include <string>
#include <unordered_map>
#include <unordered_set>

namespace robcogen {

// Names that are taken.
class UniqueNames {
 public:
  bool contains(const std::string& name) const { return taken_.contains(name); }

  // Whether the name was free; it is taken now.
  bool reserve(const std::string& name) { return taken_.insert(name).second; }
  template <class Names>
  void reserve_all(const Names& names) {
    taken_.insert(names.begin(), names.end());
  }

  void release(const std::string& name) {
    taken_.erase(name);
    next_.clear();  // its number may be free again
  }

  // The name, or the name with the first number from 2 on that is not taken. It is taken now.
  std::string add(const std::string& wanted) {
    if (reserve(wanted)) return wanted;
    int& next = next_.try_emplace(wanted, 2).first->second;
    for (;;) {
      const std::string name = wanted + "_" + std::to_string(next++);
      if (reserve(name)) return name;
    }
  }

 private:
  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, int> next_;  // all smaller numbers of a name are taken
};

}  // namespace robcogen
