// Arrays of constants as members of generated structures.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "backend/cpp/layout.h"

namespace robcogen::backend::cpp {

// `static constexpr std::array<type, n> name = {{…}};`, on as few lines as possible, or with a line and a remark for
// each item.
inline std::string member_array(
    const std::string& type,
    const std::string& name,
    const std::vector<std::string>& items,
    const std::vector<std::string>& remarks = {}) {
  const std::string head =
      "  static constexpr std::array<" + type + ", " + std::to_string(items.size()) + "> " + name + " = ";
  if (items.empty()) return head + "{};\n";
  const std::string margin(6, ' ');
  std::string text = head + "{{\n", row = margin;  // braces around the class, and around the array in it
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!remarks.empty()) {
      text += margin + items[i] + ",  // " + remarks[i] + "\n";
      continue;
    }
    if (row.size() > margin.size() && row.size() + items[i].size() + 2 > kColumns)
      text += std::exchange(row, margin) + "\n";
    row += (row.size() > margin.size() ? " " : "") + items[i] + ",";
  }
  return text + (remarks.empty() ? row + "\n" : "") + "  }};\n";
}

}  // namespace robcogen::backend::cpp
