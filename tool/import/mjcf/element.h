// MJCF as elements with places in several files, and the values of their attributes.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "support/diagnostics.h"
#include "support/number.h"

namespace robcogen::import::from_mjcf {

struct Attribute {
  std::string name;
  std::string value;
  Place place;  // of the value
  Place name_place;
};

struct Element {
  std::string name;
  Place place;
  std::vector<Attribute> attributes;
  std::vector<Element> children;  // in the order of the text
};

// Returns the root element, with each `include` replaced by the content of its file. Paths of included files are
// relative to `file`, or else to the file that includes them, and are appended to `included`. Reports text that is not
// XML, files that cannot be read, files that include themselves and, as MuJoCo does, files that are included twice.
std::optional<Element> read_with_includes(
    const std::shared_ptr<const Source>& source,
    const std::filesystem::path& file,
    std::vector<std::filesystem::path>& included,
    Diagnostics& diagnostics);

// Returns nullptr if there is none.
const Attribute* find(const Element& element, const std::string& attribute);

// Whether the attribute is one of the five ways to give an orientation.
bool is_orientation(const Attribute& attribute);
bool has_orientation(const Element& element);

// Whether one of the coefficients of a force, one to three numbers, is not zero. Reports malformed values.
bool has_nonzero(const Attribute& attribute, Diagnostics& diagnostics);

// Reads values of attributes. Malformed values are reported.
class Values {
 public:
  explicit Values(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  // Reads between `least` and `most` numbers; nullopt if the value is malformed.
  std::optional<std::vector<Number>> read(const Attribute& attribute, std::size_t least, std::size_t most);
  // The same; returns `least` zeros if the value is malformed.
  std::vector<Number> numbers(const Attribute& attribute, std::size_t least, std::size_t most);
  // Reads a number; returns `otherwise` if the attribute is missing or its value is malformed.
  Number scalar(const Element& element, const char* attribute, const Number& otherwise = Number());
  std::array<Number, 3> triple(const Element& element, const char* attribute, const std::array<Number, 3>& otherwise);
  // Reads one of the words and returns its index; `otherwise` if there is no such attribute.
  std::size_t word(
      const Element& element,
      const char* attribute,
      const std::vector<std::string>& words,
      std::size_t otherwise);

 private:
  Diagnostics& diagnostics_;
};

}  // namespace robcogen::import::from_mjcf
