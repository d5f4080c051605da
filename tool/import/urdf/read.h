// Reads the elements of a document.
#pragma once

#include "import/urdf/element_reader.h"

namespace robcogen::import::from_urdf {

Link read_link(const Element& element, ElementReader& reader);

// Child elements that have no meaning for the type of the joint are not read.
Joint read_joint(const Element& element, ElementReader& reader);

// Elements of URDF+.
Loop read_loop(const Element& element, ElementReader& reader);
Coupling read_coupling(const Element& element, ElementReader& reader);

}  // namespace robcogen::import::from_urdf
