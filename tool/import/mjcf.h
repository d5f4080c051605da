// From MuJoCo's MJCF to the model.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::import {

struct MjcfOptions {
  // A joint that an `equality` couples to another is a joint of its own; otherwise it is coupled.
  bool free_equality_joints = false;
};

struct Mjcf {
  model::KinematicTree tree;
  std::vector<std::filesystem::path> included;  // files
};

// The kinematic tree of an MJCF model, in the conventions of MuJoCo: positions have its zero and its sign, joints its
// order.
// - The base is the body with the free joint, or the world. Bodies without joints are part of their parents, and a body
//   with several joints is the last of a chain of links, of which the others have no mass.
// - A link frame of the model has z along the joint's axis, and its origin on it. Every body and every site is a user
//   frame of its name.
// - Mass properties are those of `inertial`, or of geoms of simple shape.
// - Damping, friction, armature, springs and limits are those of the joints.
// Paths of included files are relative to the folder of `file`. Reports, with places, what the model does not have, and
// in notes what was not read. nullopt when an error was reported.
std::optional<Mjcf> mjcf(
    const std::shared_ptr<const Source>& source,
    const std::filesystem::path& file,
    const MjcfOptions& options,
    Diagnostics& diagnostics);

}  // namespace robcogen::import
