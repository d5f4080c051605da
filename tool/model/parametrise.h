// Makes quantities of a description parameters, whose default values are the numbers of the document.
#pragma once

#include <vector>

#include "model/changes.h"

namespace robcogen::model {

// Each pattern is `element.quantity`, such as `link3.mass`, `*.inertia`, `tool0.placement`, `joint2.rotor`:
// - of links: mass, com, and inertia, which is both with the moments; of a pattern, links with mass properties that
// move
// - of user frames: inertia, that of a further body at the frame, which is zero by default; of names only
// - of joints and user frames: translation, rotation, and placement, which is both
// - of joints: damping, friction, armature, stiffness, rest, and rotor, its inertia and ratio
// The parameters are called `<element>_mass`, `<element>_com_x`, `<element>_ixx`, `<element>_x`, `<element>_rx`,
// `<element>_damping`, `<element>_rotor_inertia`, … Quantities that depend on parameters already remain as they are.
// Reports patterns that name nothing.
void add_parameters(Description& description, const std::vector<NamePattern>& patterns, Diagnostics& diagnostics);

}  // namespace robcogen::model
