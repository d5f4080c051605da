// MJCF as elements with places in several files, and what their attributes say.
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

// The root element, in which the content of included files stands for each `include`. Their paths are relative to
// `file`, and appended to `included`. Reports text that is not XML, files that cannot be read or that include
// themselves, and files that are included twice, as MuJoCo does.
std::optional<Element> read_with_includes(
    const std::shared_ptr<const Source>& source,
    const std::filesystem::path& file,
    std::vector<std::filesystem::path>& included,
    Diagnostics& diagnostics);

// nullptr when there is none.
const Attribute* find(const Element& element, const std::string& attribute);

// Whether it is one of the five ways to give an orientation.
bool is_orientation(const Attribute& attribute);
bool has_orientation(const Element& element);

// Values of attributes. What is malformed is reported, and read as zeros.
class Values {
 public:
  explicit Values(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  // Between `least` and `most` numbers.
  std::vector<Number> numbers(const Attribute& attribute, std::size_t least, std::size_t most);
  // The number, or `otherwise` without such an attribute.
  Number scalar(const Element& element, const char* attribute, const Number& otherwise = Number());
  std::array<Number, 3> triple(const Element& element, const char* attribute, const std::array<Number, 3>& otherwise);
  // One of the words, by index; `otherwise` without such an attribute.
  std::size_t word(
      const Element& element,
      const char* attribute,
      const std::vector<std::string>& words,
      std::size_t otherwise);

 private:
  Diagnostics& diagnostics_;
};

}  // namespace robcogen::import::from_mjcf
