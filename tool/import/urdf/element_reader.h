// Attributes and elements of XML, as names and numbers with their places.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "import/urdf/document.h"

namespace robcogen::import::from_urdf {

// Of attributes or elements.
using Names = std::vector<const char*>;

// Elements inside another one, by name.
using Parts = std::map<std::string, const Element*>;

// What a number may be: below 1e15, as quantities of robots are, or any finite one.
enum class Range { of_a_robot, any };

// nullptr when there is none.
const Attribute* find(const Element& element, const char* attribute);

// `did you mean 'x'?` for a name that is not known here: the nearest of `candidates` that is not among `found`.
template <class Items>
std::string suggestion(const std::string& name, const Items& found, const Names& candidates, const Names& known) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return "";
  std::vector<std::string> absent;
  for (const char* candidate : candidates)
    if (std::none_of(found.begin(), found.end(), [&](const auto& item) { return item.name == candidate; }))
      absent.emplace_back(candidate);
  return did_you_mean(name, absent);
}

// Of the elements that have attributes which must be there.
const Names& known_attributes();

// Reports what is malformed, missing or misspelt in the elements of one document, and counts those that it ignores.
class ElementReader {
 public:
  ElementReader(std::shared_ptr<const Source> source, Diagnostics& diagnostics)
      : source_(std::move(source)), diagnostics_(diagnostics) {}

  Diagnostics& diagnostics() const { return diagnostics_; }
  Place place(const Span& span) const { return {source_, span}; }

  const Attribute* require(const Element& element, const char* attribute);

  void report_missing_attributes(const Element& element, const Names& missing);

  // Warns of an attribute that is not read, when it may be a misspelt one of `optional`, or always when `known` are all
  // attributes of such an element.
  void check_attributes(const Element& element, const Names& optional, const Names& known, bool is_all);

  // Counts an element that is not read, or warns of it when it is a misspelt one of `names`. A misspelt element that
  // must be there is reported as missing.
  void ignore(const Element& child, const Element& parent, const Names& names);

  Name name(const Element& element, const char* attribute);

  // The elements of these names, each at most once. Other elements are ignored.
  Parts parts(const Element& element, const Names& names);

  const Element* require_part(const Element& element, const Parts& parts, const char* part);

  // At the element that is probably a misspelt `part`, else at the owner.
  Diagnostic& report_missing_element(const Element& owner, const char* part, const std::string& message);

  // One error at most about the words: the first one that is not a number may be why their count is wrong.
  std::vector<Number> numbers(const Attribute& attribute, std::size_t count, Range range = Range::of_a_robot);

  std::array<Number, 3> triple(const Attribute& attribute);

  Number scalar(const Element& element, const char* attribute);

  // Of the part `origin`; the identity where there is none.
  Origin origin(const Parts& parts);

  // How many elements of each name were not read.
  const std::map<std::string, int>& ignored() const { return ignored_; }

 private:
  std::shared_ptr<const Source> source_;
  Diagnostics& diagnostics_;
  std::map<std::string, int> ignored_;

  // A word of an attribute.
  struct Word {
    std::string text;
    Span span;
  };

  // Between blanks. Each has its own place, unless the value has entities.
  static std::vector<Word> words(const Attribute& attribute);
  // The name stands before `=` and the value.
  Span name_span(const Attribute& attribute) const;
  Number number(const Word& word, Range range);
  void report_not_a_number(const Word& word);
};

}  // namespace robcogen::import::from_urdf
