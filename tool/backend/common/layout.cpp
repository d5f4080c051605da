#include "backend/common/layout.h"

#include <algorithm>
#include <cmath>

#include "support/concat.h"
#include "support/number.h"

namespace robcogen::backend {

std::string wrapped(
    const ListLayout& layout,
    const std::string& head,
    const std::vector<std::string>& items,
    const std::string& tail) {
  const std::size_t indentation = layout.follows_head ? std::min(head.find_first_not_of(' '), head.size()) : 0;
  const std::string margin(indentation + 4, ' ');
  std::string result, line = head;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string item = concat({items[i], i + 1 < items.size() ? layout.separator : std::string_view(tail)});
    const bool may_break = i > 0 || !layout.keeps_first;
    if (may_break && line.size() + 1 + item.size() + layout.continuation.size() > layout.columns) {
      result.append(line).append(layout.continuation).append("\n");
      line = margin + item;
    } else {
      const bool opens = line.empty() || layout.openers.find(line.back()) != std::string_view::npos;
      line += (opens ? "" : " ") + item;
    }
  }
  return result + line + (items.empty() ? tail : "") + "\n";
}

std::string wrapped_text(std::string text, std::size_t columns, const std::string& first, const std::string& next) {
  std::string result, prefix = first;
  while (text.size() + prefix.size() > columns) {
    const std::size_t begin = text.find_first_not_of(' ');
    std::size_t cut = text.rfind(' ', columns - std::min(columns, prefix.size()));
    if (cut == std::string::npos || begin > cut) cut = text.find(' ', begin);
    if (cut == std::string::npos) break;
    result += prefix + text.substr(0, cut) + "\n";
    text.erase(0, cut + 1);
    prefix = next;
  }
  return result + prefix + text + "\n";
}

std::string subscripted(const std::string& array, std::size_t k) {
  return array + "[" + std::to_string(k) + "]";
}

std::string number(double value, const std::string& not_a_number, const std::string& infinity) {
  if (std::isnan(value)) return not_a_number;
  if (std::isinf(value)) return (value < 0 ? "-" : "") + infinity;
  return print_double(value);
}

std::string short_number(double value, const std::string& not_a_number, const std::string& infinity) {
  const std::string text = number(value, not_a_number, infinity);
  return text.ends_with(".0") ? text.substr(0, text.size() - 2) : text;
}

}  // namespace robcogen::backend
