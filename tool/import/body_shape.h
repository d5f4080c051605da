// Shapes while they are read: what is wrong with them, and where they are on their bodies.
#pragma once

#include <array>
#include <string>

#include "import/pose.h"
#include "model/geometry.h"
#include "support/diagnostics.h"

namespace robcogen::import {

// A shape without its link.
struct BodyShape {
  model::Shape shape;
  Pose pose;  // in the frame of its body
};

// The shape as one of the link that carries its body at this pose.
model::Shape placed(const BodyShape& own, const std::string& body, const Pose& body_in_link);

// Sets the shape to the capsule that contains the ellipsoid with these half axes and touches it, and moves its pose.
void set_ellipsoid(BodyShape& shape, const std::array<double, 3>& half_axes);

// Why this is not a length (m) of a shape, completing `'x' of a shape …`; empty if it is one.
std::string fault_of_length(double length);

// Whether a vertex of the mesh is farther from its origin than lengths of shapes may be, or not at a finite place.
bool is_too_large(const model::TriangleMesh& mesh, const std::array<double, 3>& scale);

// Adds what was found in a shape, unless it is already there. Returns whether the shape is used: if it is needed, what
// is wrong with it is an error; otherwise, it is left out with a warning.
bool add_findings(const Diagnostics& found, bool is_needed, Diagnostics& diagnostics);

}  // namespace robcogen::import
