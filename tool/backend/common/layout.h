// Lines that are not too long: lists that continue on further lines, and texts that break at blanks.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace robcogen::backend {

// How a language continues a list.
struct ListLayout {
  std::size_t columns = 100;
  std::string_view openers = "([";     // no blank stands between one of these and the first item
  std::string_view separator = ",";    // after each item but the last
  std::string_view continuation = "";  // at the end of a line that another one continues
  bool keeps_first = true;             // the first item follows the head, however long it is
  bool follows_head = true;            // further lines are indented by four more than the head; otherwise by four
};

// `head item, item tail`, continued on further lines where it is too long.
std::string wrapped(
    const ListLayout& layout,
    const std::string& head,
    const std::vector<std::string>& items,
    const std::string& tail);

// Breaks a text at blanks into lines of at most `columns`. The first line starts with `first`, the others with `next`.
std::string wrapped_text(std::string text, std::size_t columns, const std::string& first, const std::string& next);

// `array[k]`
std::string subscripted(const std::string& array, std::size_t k);

// A number that may be NaN or infinite. short_number prints the shortest form, `2` where that is enough.
std::string number(double value, const std::string& not_a_number, const std::string& infinity);
std::string short_number(double value, const std::string& not_a_number, const std::string& infinity);

}  // namespace robcogen::backend
