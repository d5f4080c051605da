// What a document consists of, read from its elements.
#pragma once

#include "import/urdf/element_reader.h"

namespace robcogen::import::from_urdf {

Link read_link(const Element& element, ElementReader& reader);

// What has no meaning for the type of the joint is not read.
Joint read_joint(const Element& element, ElementReader& reader);

// URDF+.
Loop read_loop(const Element& element, ElementReader& reader);
Coupling read_coupling(const Element& element, ElementReader& reader);

}  // namespace robcogen::import::from_urdf
