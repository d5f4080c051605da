// Converts MuJoCo's MJCF to the model.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "import/shapes.h"
#include "model/changes.h"
#include "model/kinematic_tree.h"

namespace robcogen::import {

struct MjcfOptions {
  // If true, a joint that an `equality` couples to another is an independent joint; otherwise it is coupled.
  bool free_equality_joints = false;
  // The body of the robot, in a scene where several bodies move independently: a floating body, a body of the world
  // that carries joints, or `world` for all of the latter. Empty: there is only one.
  std::string robot = {};
  model::Changes changes = {};
  ShapeOptions shapes = {};
};

struct Mjcf {
  model::KinematicTree tree;
  std::vector<std::filesystem::path> included;  // files, also of meshes
};

// Returns the kinematic tree of an MJCF model in the conventions of MuJoCo: joint positions have MuJoCo's zero and
// sign, and joints have its order.
// - The base is the body with the free joint, or the world. A body without joints is part of its parent. A body with
//   several joints is the last of a chain of links, the others of which have no mass.
// - A link frame of the model has its z axis along the joint axis and its origin on it. Every body and every site is a
//   user frame of the same name.
// - Mass properties come from `inertial`, or from geoms of simple shape and of meshes.
// - Damping, friction, armature, springs and limits come from the joints.
// Paths of included files are relative to the folder of `file`, or else to that of the file that includes them.
// Reports, with places, what the model cannot represent, and notes what was not read. nullopt if an error was reported.
std::optional<Mjcf> mjcf(
    const std::shared_ptr<const Source>& source,
    const std::filesystem::path& file,
    const MjcfOptions& options,
    Diagnostics& diagnostics);

}  // namespace robcogen::import
