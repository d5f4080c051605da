// Reads attributes and elements of XML as names and numbers with their places.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "import/urdf/document.h"
#include "import/urdf/unread.h"

namespace robcogen::import::from_urdf {

// Names of attributes or elements.
using Names = std::vector<const char*>;

// Child elements, by name.
using Parts = std::map<std::string, const Element*>;

// The range of a number: below 1e15, like all quantities of robots, or any finite number.
enum class Range { of_a_robot, any };

// Returns nullptr if there is none.
const Attribute* find(const Element& element, const char* attribute);

// Returns `did you mean 'x'?` for a name that is not known here: the nearest of the `candidates` that is not among
// `found`.
template <class Items>
std::string suggestion(const std::string& name, const Items& found, const Names& candidates, const Names& known) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return "";
  std::vector<std::string> absent;
  for (const char* candidate : candidates)
    if (std::none_of(found.begin(), found.end(), [&](const auto& item) { return item.name == candidate; }))
      absent.emplace_back(candidate);
  return did_you_mean(name, absent);
}

// The attributes of the elements that have mandatory attributes.
const Names& known_attributes();

// Reads the elements of one document. Reports malformed, missing or misspelt items, and counts the elements that it
// ignores.
class ElementReader {
 public:
  ElementReader(std::shared_ptr<const Source> source, Diagnostics& diagnostics)
      : source_(std::move(source)), diagnostics_(diagnostics) {}

  Diagnostics& diagnostics() const { return diagnostics_; }
  Place place(const Span& span) const { return {source_, span}; }

  const Attribute* require(const Element& element, const char* attribute);

  void report_missing_attributes(const Element& element, const Names& missing);

  // Warns about attributes that are not read and not known to be without effect. One that may be a misspelling of a
  // missing attribute is reported with that.
  void check_attributes(const Element& element);

  // Counts an element that is not read, or warns about it if it is a misspelling of one of `names`, affects kinematics
  // or dynamics, or is unknown. A misspelt mandatory element is reported as missing instead.
  void ignore(const Element& child, const Element& parent, const Names& names);

  Name name(const Element& element, const char* attribute);

  // Returns the elements with these names, at most one of each. Other elements are ignored.
  Parts parts(const Element& element, const Names& names);

  const Element* require_part(const Element& element, const Parts& parts, const char* part);

  // Returns the child that is probably a misspelt `part`; nullptr if there is none.
  static const Element* misspelt(const Element& owner, const char* part);

  // Reads `count` numbers. Reports at most one error about the words, because the first one that is not a number may be
  // why their count is wrong.
  std::vector<Number> numbers(const Attribute& attribute, std::size_t count, Range range = Range::of_a_robot);

  std::array<Number, 3> triple(const Attribute& attribute);

  // Warns about an angle of this many turns or more, which is probably in degrees.
  void check_angle(const Number& angle, const Place& place, double turns);

  Number scalar(const Element& element, const char* attribute);

  // Reads the part `origin`; the identity if there is none.
  Origin origin(const Parts& parts);

  // Warns about what is unknown, once for each name.
  void report_unread();

  // The number of elements of each name that were not read.
  const std::map<std::string, int>& ignored() const { return ignored_; }

 private:
  std::shared_ptr<const Source> source_;
  Diagnostics& diagnostics_;
  std::map<std::string, int> ignored_;
  std::vector<Unread> unread_;

  // A word of an attribute.
  struct Word {
    std::string text;
    Span span;
  };

  // Splits a value at blanks. Each word has its own place, unless the value contains entities.
  static std::vector<Word> words(const Attribute& attribute);
  // Whether the value consists of zeros.
  static bool is_zero(const Attribute& attribute);
  // The name precedes `=` and the value.
  Span name_span(const Attribute& attribute) const;
  Number number(const Word& word, Range range);
  void report_not_a_number(const Word& word);
};

}  // namespace robcogen::import::from_urdf
