// The sections of a model, read into the document, where what is not read is counted.
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

// Appends couplings of joints. Reports those that are not linear.
void read_equalities(const Element& section, const Options& options, Document& document, Diagnostics& diagnostics);

// Warns of an element that is none of the `known` ones.
void report_unknown(const Element& element, const std::vector<std::string>& known, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_mjcf
