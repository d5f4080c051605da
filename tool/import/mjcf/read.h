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

// Returns the robot of this name; if it is empty, the only one. Reports a name that is not that of a robot, and bodies
// that move but are not part of the only robot.
Robot choose_robot(const Document& document, const std::string& name, Diagnostics& diagnostics);

// Reads the mass properties of the bodies of the robot that move, and of all bodies if their masses are scaled.
void read_masses(Document& document, const Context& context);

// Aligns the frame of a free body with its principal axes, if the document asks for it as MuJoCo does: by `align` of
// its joint or `alignfree`, for bodies without children. Reports bodies whose axes MuJoCo would choose.
void align_free_body(Document& document, const Settings& settings, Diagnostics& diagnostics);

// Adds the armature and the damping of actuators to those of the joints that they drive. Counts the actuators. Reports
// values that the model cannot represent, and warns about those of tendons.
void read_actuators(const Element& section, const Defaults& defaults, Document& document, Diagnostics& diagnostics);

// Replaces each SpringDamper by the stiffness and the damping that MuJoCo computes from it, and from the inertia of the
// robot in the pose of the file.
void resolve_spring_dampers(Document& document, Diagnostics& diagnostics);

// Appends couplings between joints, unless a flag disables constraints. Reports couplings that are not linear.
void read_equalities(
    const Element& section,
    const Settings& settings,
    const Defaults& defaults,
    const MjcfOptions& options,
    Document& document,
    Diagnostics& diagnostics);

// Warns about an element that is not one of the `known` ones.
void report_unknown(const Element& element, const std::vector<std::string>& known, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_mjcf
