#include "backend/common/c_names.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string_view>
#include <vector>

namespace robcogen::backend::c_family {
namespace {

constexpr std::string_view kKeywords[] = {
#include "backend/common/keywords.inc"
};

// Macros of system headers, of compilers and of platforms, and the types and variables of headers that a local name
// would shadow. Names with a leading underscore need no entry, because no generated identifier has one.
constexpr std::string_view kMacros[] = {
#include "backend/common/macros.inc"
};

constexpr std::string_view kGlobals[] = {
#include "backend/common/globals.inc"
};

// Most words differ in length from all words of the set that begin and end with the same characters.
class Words {
 public:
  void add(std::string_view word) {
    words_.emplace(word);
    lengths_[ends(word)] |= length_bit(word);
  }
  bool contains(std::string_view word) const {
    return !word.empty() && (lengths_[ends(word)] & length_bit(word)) != 0 && words_.contains(word);
  }

 private:
  // A number for the pair of a word's first and last characters, and how many such numbers there are.
  static constexpr std::size_t kEnds = 32 * 32;
  static std::size_t ends(std::string_view word) {
    const auto number = [](char c) { return static_cast<unsigned char>(c) % std::size_t{32}; };
    return 32 * number(word.front()) + number(word.back());
  }
  // The bit for the word's length. All longer words share the last bit.
  static std::uint64_t length_bit(std::string_view word) {
    return std::uint64_t{1} << std::min<std::size_t>(word.size(), 63);
  }

  std::set<std::string, std::less<>> words_;
  std::array<std::uint64_t, kEnds> lengths_{};  // one bit per length
};

// Names, and patterns of names: `SIG_*`, `PRIx*`, and `sin~` for sin, sinf, sinl, sinf32 and so on.
class NameSet {
 public:
  template <class List>
  explicit NameSet(const List& list) {
    for (const std::string_view entry : list) add(entry);
  }

  void add(std::string_view entry) {
    const std::string_view head = entry.substr(0, entry.size() - 1);
    if (entry.back() == '*')
      beginnings_[index(entry.front())].push_back(head);
    else if (entry.back() == '~')
      for (const char* type : {"", "f", "l", "f16", "f32", "f64", "f128", "f32x", "f64x"})
        names_.add(std::string(head) + type);
    else
      names_.add(entry);
  }

  bool contains(std::string_view name) const {
    if (name.empty()) return false;
    const auto begins = [&](std::string_view beginning) { return name.starts_with(beginning); };
    const std::vector<std::string_view>& beginnings = beginnings_[index(name.front())];
    return names_.contains(name) || std::any_of(beginnings.begin(), beginnings.end(), begins);
  }

 private:
  static std::size_t index(char c) { return static_cast<unsigned char>(c); }

  Words names_;
  std::array<std::vector<std::string_view>, 256> beginnings_;  // by the first character
};

}  // namespace

bool is_reserved(const std::string& name) {
  static const NameSet reserved = [] {
    NameSet all(kMacros);
    for (const std::string_view word : kKeywords) all.add(word);
    return all;
  }();
  return reserved.contains(name);
}

bool is_global(const std::string& name) {
  static const NameSet globals(kGlobals);
  return globals.contains(name);
}

}  // namespace robcogen::backend::c_family
