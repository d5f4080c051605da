#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "import/magnitudes.h"
#include "import/mjcf/element.h"

namespace robcogen::import::from_mjcf {

namespace {

std::vector<std::string> words_of(const std::string& value) {
  constexpr const char* kBlanks = " \t\n\r";
  std::vector<std::string> words;
  for (std::size_t at = 0; (at = value.find_first_not_of(kBlanks, at)) != std::string::npos;) {
    const std::size_t end = std::min(value.find_first_of(kBlanks, at), value.size());
    words.push_back(value.substr(at, end - at));
    at = end;
  }
  return words;
}

}  // namespace

const Attribute* find(const Element& element, const std::string& attribute) {
  const auto found = std::find_if(
      element.attributes.begin(), element.attributes.end(), [&](const Attribute& a) { return a.name == attribute; });
  return found == element.attributes.end() ? nullptr : &*found;
}

bool is_orientation(const Attribute& attribute) {
  constexpr std::array kNames = {"quat", "axisangle", "euler", "xyaxes", "zaxis"};
  return std::find(kNames.begin(), kNames.end(), attribute.name) != kNames.end();
}

bool has_orientation(const Element& element) {
  return std::any_of(element.attributes.begin(), element.attributes.end(), is_orientation);
}

bool has_nonzero(const Attribute& attribute, Diagnostics& diagnostics) {
  const std::vector<Number> n = Values(diagnostics).numbers(attribute, 1, 3);
  return std::any_of(n.begin(), n.end(), [](const Number& x) { return !x.is_zero(); });
}

std::optional<std::vector<Number>> Values::read(const Attribute& attribute, std::size_t least, std::size_t most) {
  constexpr std::size_t kMaxShown = 40;
  std::vector<Number> result;
  for (const std::string& word : words_of(attribute.value)) {
    const std::optional<Number> number = Number::parse(word);
    if (!number) {
      diagnostics_.error(
          "not-a-number", attribute.place,
          fmt::format("'{}' is not a finite decimal number", word.substr(0, kMaxShown)));
      return std::nullopt;
    }
    if (std::abs(number->value()) >= kTooLarge) {
      diagnostics_.error("too-large", attribute.place, too_large(word));
      return std::nullopt;
    }
    result.push_back(std::abs(number->value()) < kZero ? Number() : *number);
  }
  if (result.size() >= least && result.size() <= most) return result;
  const std::string count = least == most ? std::to_string(least) : fmt::format("{} to {}", least, most);
  diagnostics_.error(
      "component-count", attribute.place,
      fmt::format("'{}' needs {} number{}, found {}", attribute.name, count, most == 1 ? "" : "s", result.size()));
  return std::nullopt;
}

std::vector<Number> Values::numbers(const Attribute& attribute, std::size_t least, std::size_t most) {
  return read(attribute, least, most).value_or(std::vector<Number>(least));
}

Number Values::scalar(const Element& element, const char* attribute, const Number& otherwise) {
  const Attribute* found = find(element, attribute);
  return found == nullptr ? otherwise : read(*found, 1, 1).value_or(std::vector<Number>{otherwise})[0];
}

std::array<Number, 3> Values::triple(
    const Element& element,
    const char* attribute,
    const std::array<Number, 3>& otherwise) {
  const Attribute* found = find(element, attribute);
  if (found == nullptr) return otherwise;
  const std::optional<std::vector<Number>> n = read(*found, 3, 3);
  return n ? std::array<Number, 3>{(*n)[0], (*n)[1], (*n)[2]} : otherwise;
}

std::size_t Values::word(
    const Element& element,
    const char* attribute,
    const std::vector<std::string>& words,
    std::size_t otherwise) {
  const Attribute* found = find(element, attribute);
  if (found == nullptr) return otherwise;
  const auto at = std::find(words.begin(), words.end(), found->value);
  if (at != words.end()) return static_cast<std::size_t>(at - words.begin());
  diagnostics_
      .error(
          "unknown-word", found->place,
          fmt::format(
              "'{}' of this '{}' is '{}', not one of {}", attribute, element.name, found->value,
              fmt::join(words, ", ")))
      .hint = did_you_mean(found->value, words);
  return otherwise;
}

}  // namespace robcogen::import::from_mjcf
