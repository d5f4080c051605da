// Reads the sections of a model into the document, and counts the elements that are not read.
#pragma once

#include "import/mjcf/document.h"

namespace robcogen::import::from_mjcf {

// Appends the bodies of the world, parents before children, depth first.
void read_bodies(
    const Element& worldbody,
    const Settings& settings,
    const Defaults& defaults,
    Document& document,
    Diagnostics& diagnostics);

// Appends couplings between joints, unless a flag disables constraints. Reports couplings that are not linear.
void read_equalities(
    const Element& section,
    const Settings& settings,
    const Defaults& defaults,
    const Options& options,
    Document& document,
    Diagnostics& diagnostics);

// Warns about an element that is not one of the `known` ones.
void report_unknown(const Element& element, const std::vector<std::string>& known, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_mjcf
