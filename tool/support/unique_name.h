// Unique names.
#pragma once

#include <string>
#include <unordered_set>

namespace robcogen {

// The name, or the name with the first number from 2 on that is not taken. Adds it to `taken`.
inline std::string unique_name(const std::string& wanted, std::unordered_set<std::string>& taken) {
  std::string name = wanted;
  for (int k = 2; !taken.insert(name).second; ++k) name = wanted + "_" + std::to_string(k);
  return name;
}

}  // namespace robcogen
