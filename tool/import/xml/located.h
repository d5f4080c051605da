// XML as elements with places in several files, and the values of their attributes and texts.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "import/xml/xml.h"
#include "support/diagnostics.h"
#include "support/number.h"

namespace robcogen::import::xml {

struct Name {
  std::string text;  // empty if there is none
  Place place;
};

struct LocatedAttribute {
  std::string name;
  std::string value;
  Place place;  // of the value
  Place name_place;
};

struct LocatedElement {
  std::string name;
  Place place;
  std::vector<LocatedAttribute> attributes;
  std::vector<LocatedElement> children;  // in the order of the text
  std::string text;                      // see Element
  Place text_place;
};

// Copies the element without its children.
LocatedElement located_tag(const Element& element, const std::shared_ptr<const Source>& source);
// Copies the element with everything in it.
LocatedElement located(const Element& element, const std::shared_ptr<const Source>& source);

// Returns nullptr if there is none.
const LocatedAttribute* find(const LocatedElement& element, const std::string& attribute);

// The text of an element as a value with the name of the element. The place of an empty text is that of the element.
LocatedAttribute text_of(const LocatedElement& element);

// Reads values of attributes. Malformed values are reported.
class Values {
 public:
  explicit Values(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  // Reads between `least` and `most` numbers; nullopt if the value is malformed.
  std::optional<std::vector<Number>> read(const LocatedAttribute& attribute, std::size_t least, std::size_t most);
  // The same; returns `least` zeros if the value is malformed.
  std::vector<Number> numbers(const LocatedAttribute& attribute, std::size_t least, std::size_t most);
  // Reads a number; returns `otherwise` if the attribute is missing or its value is malformed.
  Number scalar(const LocatedElement& element, const char* attribute, const Number& otherwise = Number());
  std::array<Number, 3> triple(
      const LocatedElement& element,
      const char* attribute,
      const std::array<Number, 3>& otherwise);
  // Reads one of the words and returns its index; `otherwise` if there is no such attribute.
  std::size_t word(
      const LocatedElement& element,
      const char* attribute,
      const std::vector<std::string>& words,
      std::size_t otherwise);

 private:
  Diagnostics& diagnostics_;
};

}  // namespace robcogen::import::xml
