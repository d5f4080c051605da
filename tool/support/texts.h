// Storage for many short texts with one lifetime.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace robcogen {

// Texts that keep their addresses as long as this object lives, even when it is moved. They are stored in long strings,
// because allocating memory for each would take longer than writing it.
class Texts {
 public:
  Texts() = default;
  Texts(Texts&&) = default;  // the texts of a copy would have other addresses

  // Stores the pieces one after another, as one text.
  std::string_view add(std::initializer_list<std::string_view> pieces);

 private:
  std::vector<std::string> blocks_;  // none ever grows beyond its capacity
};

}  // namespace robcogen
