#include "symbolic/lane_names.h"

#include <algorithm>
#include <cstddef>
#include <sstream>

namespace robcogen::symbolic {
namespace {

// The number of characters that all texts begin and end with, up to the border of a word. The two parts do not overlap.
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

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

// A name without the shared part: `LF`.
std::string own_part(const std::string& name, const std::string& shared) {
  const std::size_t at = name.find(shared);
  if (shared.empty() || at == std::string::npos) return name;
  std::string own = name.substr(0, at) + name.substr(at + shared.size());
  while (!own.empty() && own.back() == '_') own.pop_back();
  while (!own.empty() && own.front() == '_') own.erase(0, 1);
  return own;
}

std::vector<std::string> without(std::vector<std::string> list, std::size_t k) {
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(k));
  return list;
}

}  // namespace

std::string common_words(const std::vector<std::string>& names) {
  if (all_equal(names)) return names.front();
  const Common c = common(names, "_");
  const std::string& first = names.front();
  std::string tail = first.substr(first.size() - c.tail);
  if (c.head == 0 && !tail.empty()) tail.erase(0, 1);
  std::string result = first.substr(0, c.head) + (c.head > 0 && !tail.empty() ? tail.substr(1) : tail);
  while (!result.empty() && result.back() == '_') result.pop_back();
  if (result.empty() || result[0] == '_') return "";
  return result[0] < '0' || result[0] > '9' ? result : "lanes_" + result;
}

std::string common_name(const std::vector<std::string>& names) {
  std::string shared = common_words(names);
  // A value that one limb shares with another part of the robot is named after that part.
  for (std::size_t odd = 0; shared.empty() && names.size() > 2 && odd < names.size(); ++odd)
    shared = common_words(without(names, odd));
  return shared.empty() ? "lanes" : shared;
}

namespace {

// The common title of limbs: `link hipassembly of LF, RF: force`; empty if the titles differ by more than the limb.
std::string title_of_limbs(const std::vector<std::string>& titles) {
  std::vector<std::vector<std::string>> words;
  for (const std::string& title : titles) words.push_back(words_of(title));
  const auto has_as_many = [&](const std::vector<std::string>& w) { return w.size() == words.front().size(); };
  std::string result, of;
  bool is_shared = std::all_of(words.begin(), words.end(), has_as_many);
  for (std::size_t k = 0; is_shared && k < words.front().size(); ++k) {
    std::vector<std::string> here;
    for (const auto& w : words) here.push_back(w[k]);
    result += k ? " " : "";
    if (all_equal(here)) {
      result += here.front();
      continue;
    }
    const bool has_colon = here.front().ends_with(":");
    if (has_colon)
      for (std::string& word : here) word.pop_back();
    const std::string shared = common_words(here);
    std::vector<std::string> own;
    for (const std::string& word : here) {
      const std::string part = own_part(word, shared);
      if (std::find(own.begin(), own.end(), part) == own.end()) own.push_back(part);
    }
    std::string list;
    for (const std::string& part : own) list += (list.empty() ? "" : ", ") + part;
    is_shared = !shared.empty() && (of.empty() || of == list);
    result += shared + (of.empty() ? " of " + list : "") + (has_colon ? ":" : "");
    of = list;
  }
  return is_shared ? result : "";
}

}  // namespace

std::string common_title(const std::vector<std::string>& titles) {
  if (all_equal(titles)) return titles.front();
  std::string result = title_of_limbs(titles);
  for (std::size_t odd = 0; result.empty() && titles.size() > 2 && odd < titles.size(); ++odd)
    if (const std::vector<std::string> others = without(titles, odd); !all_equal(others))
      result = title_of_limbs(others);
  if (!result.empty()) return result;
  // Otherwise: what all titles begin with, each distinct middle part once, and what all titles end with.
  const Common c = common(titles, " :");
  result = titles.front().substr(0, c.head);
  std::vector<std::string> seen;
  for (const std::string& title : titles) {
    const std::string part = title.substr(c.head, title.size() - c.head - c.tail);
    if (std::find(seen.begin(), seen.end(), part) != seen.end()) continue;
    result += (seen.empty() ? "" : ", ") + part;
    seen.push_back(part);
  }
  return result + titles.front().substr(titles.front().size() - c.tail);
}

}  // namespace robcogen::symbolic
