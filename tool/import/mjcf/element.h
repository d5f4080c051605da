// MJCF as elements with places in several files.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "import/xml/located.h"

namespace robcogen::import::from_mjcf {

using xml::Values;
using xml::find;
using Attribute = xml::LocatedAttribute;
using Element = xml::LocatedElement;

// Returns the root element, with each `include` replaced by the content of its file. Paths of included files are
// relative to `file`, or else to the file that includes them, and are appended to `included`. Reports text that is not
// XML, files that cannot be read, files that include themselves and, as MuJoCo does, files that are included twice.
std::optional<Element> read_with_includes(
    const std::shared_ptr<const Source>& source,
    const std::filesystem::path& file,
    std::vector<std::filesystem::path>& included,
    Diagnostics& diagnostics);

// Whether the attribute is one of the five ways to give an orientation.
bool is_orientation(const Attribute& attribute);
bool has_orientation(const Element& element);

// Whether one of the coefficients of a force, one to three numbers, is not zero. Reports malformed values.
bool has_nonzero(const Attribute& attribute, Diagnostics& diagnostics);

// Returns the coefficient of such a force if it is linear, and zero if the attribute is missing. Reports a polynomial.
Number linear_coefficient(const Element& element, const char* attribute, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_mjcf
