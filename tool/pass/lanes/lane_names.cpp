#include "pass/lanes/lane_names.h"

#include <algorithm>

namespace robcogen::pass {
namespace {

// How many characters all texts begin and end with, up to the border of a word; both parts fit into each text.
struct Common {
  std::size_t head = 0, tail = 0;
};

Common common(const std::vector<std::string>& texts, const std::string& borders) {
  const std::string& first = texts.front();
  std::size_t shortest = first.size(), head = 0, tail = 0;
  for (const std::string& text : texts) shortest = std::min(shortest, text.size());
  const auto all_have = [&](auto character) {
    return std::all_of(
        texts.begin(), texts.end(), [&](const std::string& t) { return character(t) == character(first); });
  };
  const auto from_front = [&](const std::string& t) { return t[head]; };
  const auto from_back = [&](const std::string& t) { return t[t.size() - 1 - tail]; };
  while (head < shortest && all_have(from_front)) ++head;
  while (head + tail < shortest && all_have(from_back)) ++tail;
  const auto is_border = [&](char c) { return borders.find(c) != std::string::npos; };
  while (head > 0 && !is_border(first[head - 1])) --head;
  while (tail > 0 && !is_border(first[first.size() - tail])) --tail;
  return {head, tail};
}

bool all_equal(const std::vector<std::string>& texts) {
  return std::all_of(texts.begin(), texts.end(), [&](const std::string& t) { return t == texts.front(); });
}

}  // namespace

std::string common_name(const std::vector<std::string>& names) {
  if (all_equal(names)) return names.front();
  const Common c = common(names, "_");
  const std::string& first = names.front();
  std::string tail = first.substr(first.size() - c.tail);
  if (c.head == 0 && !tail.empty()) tail.erase(0, 1);
  std::string result = first.substr(0, c.head) + (c.head > 0 && !tail.empty() ? tail.substr(1) : tail);
  while (!result.empty() && result.back() == '_') result.pop_back();
  const bool starts_well = !result.empty() && result[0] != '_' && (result[0] < '0' || result[0] > '9');
  return starts_well ? result : "lanes" + (result.empty() ? "" : "_" + result);
}

std::string common_title(const std::vector<std::string>& titles) {
  if (all_equal(titles)) return titles.front();
  const Common c = common(titles, " :");
  std::string result = titles.front().substr(0, c.head);
  for (std::size_t k = 0; k < titles.size(); ++k) {
    const std::string& title = titles[k];
    result += (k ? ", " : "") + title.substr(c.head, title.size() - c.head - c.tail);
  }
  return result + titles.front().substr(titles.front().size() - c.tail);
}

}  // namespace robcogen::pass
