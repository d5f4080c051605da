// From URDF to the model.
#pragma once

#include <memory>
#include <optional>

#include "model/kinematic_tree.h"

namespace robcogen::import {

struct UrdfOptions {
  // The root link floats. A root joint of type `floating` says the same.
  bool floating_base = false;
  // Angles within 1e-6 of a multiple of PI/12 become that multiple exactly, with a note on each change. Otherwise one
  // note counts them.
  bool snap_angles = false;
  // A joint that mimics another is a joint of its own; otherwise it is coupled to the other.
  bool free_mimic_joints = false;
  // Damping and friction of joints are part of the dynamics. Otherwise they are constants of the robot only, with a
  // note.
  bool passive_forces = false;
  // Negative masses and inertias are warnings, not errors.
  bool allow_implausible = false;
};

// The kinematic tree of a URDF:
// - The root link is the base. Links on fixed joints are lumped into the link that carries them.
// - A link frame of the model has z along the joint's axis and coincides with the URDF frame when
//   that has z along the axis too. Every URDF link, also the root and lumped ones, is a user frame of its name at its
//   URDF pose.
// - A link `world` that is not declared, but is the parent of joints, is the root when no other link can be, with a
//   warning.
// - Mass properties are those of all lumped bodies, about the origin and in the axes of the model's link frame.
// - Links and joints keep the order of the file; joint positions keep their zero and their sign.
// - A limit of 1e9 or more means no limit: a URDF must give a number.
// - In a name that is not an identifier, `_` replaces other characters; two names that become equal are an error.
// - A joint with the name of a link becomes `<name>_joint`, because the model has frames of both.
// Reports, with places: text that is not XML or not a URDF, joints of types that the model does not have, `mimic`,
// elements that do not form one tree, and invalid names, axes and mass properties. One note lists the elements that
// were ignored. nullopt when an error was reported.
std::optional<model::KinematicTree> urdf(
    std::shared_ptr<const Source> source,
    const UrdfOptions& options,
    Diagnostics& diagnostics);

}  // namespace robcogen::import
