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

// Adds the armature and the damping of actuators to those of the joints that they drive, and a cylinder for each
// straight tendon that they pull. Counts the other actuators. Reports values that the model cannot represent, and warns
// about those of tendons.
void read_actuators(const Element& section, const Defaults& defaults, Document& document, Diagnostics& diagnostics);

// Replaces each SpringDamper by the stiffness and the damping that MuJoCo computes from it, and from the inertia of the
// robot in the pose of the file.
void resolve_spring_dampers(Document& document, Diagnostics& diagnostics);

// Appends the tendons, which other sections refer to. Lists those that nothing uses as ignored.
void read_tendons(const Element& section, const Defaults& defaults, Document& document, Diagnostics& diagnostics);
void count_unused_tendons(Document& document);
// Adds a cylinder for a straight tendon, if there is none yet. Notes that other tendons have no counterpart. Returns
// whether the tendon has a cylinder.
bool pull_tendon(const Element& actuator, const Attribute& name, Document& document, Diagnostics& diagnostics);

// Appends couplings between joints or fixed tendons, and loops, unless a flag disables constraints. Reports couplings
// of joints that are not linear, and warns about constraints that the model cannot represent.
void read_equalities(
    const Element& section,
    const Settings& settings,
    const Defaults& defaults,
    const MjcfOptions& options,
    Document& document,
    Diagnostics& diagnostics);

// The parts of it: `element` includes its default attributes.
void read_loop(const Element& element, Document& document, Diagnostics& diagnostics);
void read_tendon_equality(const Element& element, Document& document, Diagnostics& diagnostics);
// Appends the loop under the name of the element, or else under that of the loop, or else under those of its ends.
// Warns if it cannot be a loop of the robot; drops it if it is part of another one.
void add_loop(Document& document, const Element& element, Loop loop, Diagnostics& diagnostics);
void ignore_constraint(const Element& constraint, const std::string& reason, Diagnostics& diagnostics);

// Sets the positions of joints in the first `key` that gives them. Returns whether there is one. Warns if their number
// is wrong.
bool read_key(const Element& section, Document& document, Diagnostics& diagnostics);

// Replaces each ball joint that moves a loop by three hinges, with a note.
void split_ball_joints(Document& document, Diagnostics& diagnostics);

// Warns about an element that is not one of the `known` ones.
void report_unknown(const Element& element, const std::vector<std::string>& known, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_mjcf
