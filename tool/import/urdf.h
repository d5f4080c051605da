// Converts URDF to the model.
#pragma once

#include <memory>
#include <optional>

#include "import/shapes.h"
#include "model/changes.h"
#include "model/kinematic_tree.h"

namespace robcogen::import {

struct UrdfOptions {
  // The root link is a floating base. A root joint of type `floating` has the same effect.
  bool floating_base = false;
  // Angles within 1e-6 of a multiple of PI/12 become that multiple exactly, with a note on each change. If false, a
  // single note counts such angles.
  bool snap_angles = false;
  // A joint that mimics another is an independent joint; otherwise it is coupled to the other.
  bool free_mimic_joints = false;
  // Damping and friction of joints are part of the dynamics. If false, they are only constants of the robot, with a
  // note.
  bool passive_forces = false;
  // The velocity (rad/s, m/s) of smooth friction: friction times qd / sqrt(qd^2 + velocity^2). Zero: the sign of qd.
  double friction_velocity = 0;
  // Negative masses and inertias are warnings, not errors.
  bool allow_implausible = false;
  model::Changes changes = {};
  ShapeOptions shapes = {};
};

// Returns the kinematic tree of a URDF:
// - The root link is the base. Links on fixed joints are lumped into the link that carries them.
// - A link frame of the model has its z axis along the joint axis, and coincides with the URDF frame if that frame has
//   z along the axis too. Every URDF link, including the root and lumped links, is a user frame of the same name at its
//   URDF pose.
// - An undeclared link `world` that is the parent of joints becomes the root if no other link can be, with a warning.
// - Mass properties include all lumped bodies, about the origin and in the axes of the model's link frame.
// - Links and joints keep the order of the file; joint positions keep their zero and their sign.
// - A limit of 1e9 or more means no limit, because a URDF must give a number, and so does a negative effort or
// velocity.
// - A robot without a name gets that of its file.
// - In a name that is not an identifier, `_` replaces the other characters. Two names that become equal are an error.
// - A joint with the name of a link becomes `<name>_joint`, because the model has frames of both.
// Reports, with places: text that is not XML or not a URDF, joint types that the model does not have, invalid `mimic`,
// elements that do not form one tree, and invalid names, axes and mass properties. Elements and attributes that are not
// read cause warnings, once for each name, unless they are known to have no effect; one note lists the elements of the
// latter kind. nullopt if an error was reported.
std::optional<model::KinematicTree> urdf(
    std::shared_ptr<const Source> source,
    const UrdfOptions& options,
    Diagnostics& diagnostics);

}  // namespace robcogen::import
