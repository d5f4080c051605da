// From URDF to the model.
#pragma once

#include <memory>
#include <optional>

#include "model/kinematic_tree.h"

namespace robcogen::import {

struct UrdfOptions {
  // The root link floats. A root joint of type `floating` says the same.
  bool floating_base = false;
  // Angles within 1e-6 of a multiple of PI/12 become that multiple exactly; each is noted with the size of the change.
  // Without it, one note counts them.
  bool snap_angles = false;
  // A joint that mimics another is a joint of its own; otherwise it is an error.
  bool free_mimic_joints = false;
  // Masses and inertias that no body has are warnings; otherwise those that are negative are errors.
  bool allow_implausible = false;
};

// What of a URDF a kinematic tree can say, exactly:
// - The root link is the base. Links on fixed joints are lumped into the link that carries them.
// - A link frame of the model has z along the joint's axis and coincides with URDF's own frame where that is so
// already.
//   Every URDF link, the root and lumped ones too, is a user frame of its name at its URDF pose.
// - A link `world` that joints refer to and that is not declared is the root, where nothing else can be: with a warning.
// - Mass properties are those of all lumped bodies, about the origin and in the axes of the model's link frame.
// - Links and joints keep the order of the file; joint positions keep their zero and their sign.
// - Limits of 1e9 and beyond are none: that is how a URDF says so where it must give a number.
// - Names that are no identifiers get `_` for what does not fit; two names that become one are an error. A joint that
// has
//   a link's name becomes `<name>_joint`, as the model has frames of both.
// Reports, with places: text that is no XML or no URDF, joints of types that the model does not have, `mimic`, elements
// that do not form one tree, names, axes and mass properties that no robot has. A note says once what was ignored.
// nullopt when an error was reported.
std::optional<model::KinematicTree> urdf(
    std::shared_ptr<const Source> source,
    const UrdfOptions& options,
    Diagnostics& diagnostics);

}  // namespace robcogen::import
