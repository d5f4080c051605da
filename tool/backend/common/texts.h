// Memory of many short texts that end together.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace robcogen::backend {

// Texts that stay where they are as long as this lives, and when it is moved: side by side in long strings, for to get
// and to free memory for each would take longer than to write it.
class Texts {
 public:
  Texts() = default;
  Texts(Texts&&) = default;  // texts of a copy would be others

  // The pieces one after another.
  std::string_view add(std::initializer_list<std::string_view> pieces);

 private:
  std::vector<std::string> blocks_;  // none ever grows beyond its capacity
};

}  // namespace robcogen::backend
