#include "import/xml/located.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "import/magnitudes.h"

namespace robcogen::import::xml {

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

// The name precedes `=` and the value.
Span name_span(const Attribute& attribute, std::string_view text) {
  const std::size_t equals = text.rfind('=', attribute.span.begin);
  const std::size_t begin = equals == std::string_view::npos ? equals : text.rfind(attribute.name, equals);
  return begin == std::string_view::npos ? attribute.span : Span{begin, begin + attribute.name.size()};
}

}  // namespace

LocatedElement located_tag(const Element& element, const std::shared_ptr<const Source>& source) {
  LocatedElement result;
  result.name = element.name;
  result.place = {source, element.span};
  result.text = element.text;
  result.text_place = {source, element.text_span};
  for (const Attribute& a : element.attributes)
    result.attributes.push_back({a.name, a.value, {source, a.span}, {source, name_span(a, source->text())}});
  return result;
}

LocatedElement located(const Element& element, const std::shared_ptr<const Source>& source) {
  LocatedElement result = located_tag(element, source);
  for (const Element& child : element.children) result.children.push_back(located(child, source));
  return result;
}

const LocatedAttribute* find(const LocatedElement& element, const std::string& attribute) {
  const auto found = std::find_if(
      element.attributes.begin(), element.attributes.end(), [&](const LocatedAttribute& a) { return a.name == attribute; });
  return found == element.attributes.end() ? nullptr : &*found;
}

LocatedAttribute text_of(const LocatedElement& element) {
  return {element.name, element.text, element.text.empty() ? element.place : element.text_place, element.place};
}

std::optional<std::vector<Number>> Values::read(const LocatedAttribute& attribute, std::size_t least, std::size_t most) {
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

std::vector<Number> Values::numbers(const LocatedAttribute& attribute, std::size_t least, std::size_t most) {
  return read(attribute, least, most).value_or(std::vector<Number>(least));
}

Number Values::scalar(const LocatedElement& element, const char* attribute, const Number& otherwise) {
  const LocatedAttribute* found = find(element, attribute);
  return found == nullptr ? otherwise : read(*found, 1, 1).value_or(std::vector<Number>{otherwise})[0];
}

std::array<Number, 3> Values::triple(
    const LocatedElement& element,
    const char* attribute,
    const std::array<Number, 3>& otherwise) {
  const LocatedAttribute* found = find(element, attribute);
  if (found == nullptr) return otherwise;
  const std::optional<std::vector<Number>> n = read(*found, 3, 3);
  return n ? std::array<Number, 3>{(*n)[0], (*n)[1], (*n)[2]} : otherwise;
}

std::size_t Values::word(
    const LocatedElement& element,
    const char* attribute,
    const std::vector<std::string>& words,
    std::size_t otherwise) {
  const LocatedAttribute* found = find(element, attribute);
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

}  // namespace robcogen::import::xml
