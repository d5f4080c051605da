// Converts SDF, the format of Gazebo, to the model.
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

struct SdfOptions {
  // Angles of poses within 1e-6 of a multiple of PI/12 become that multiple, as in UrdfOptions.
  bool snap_angles = false;
  // A joint that mimics another is an independent joint; otherwise it is coupled to the other.
  bool free_mimic_joints = false;
  // The model that is the robot, in a world of several. Empty: there is only one that is not static.
  std::string robot = {};
  // Folders in which `model://NAME` and `package://NAME` are looked up, before the folders around the file.
  std::vector<std::filesystem::path> folders = {};
  model::Changes changes = {};
  ShapeOptions shapes = {};
};

struct Sdf {
  model::KinematicTree tree;
  std::vector<std::filesystem::path> included;  // files that were read
};

// Returns the kinematic tree of a model in SDF 1.4 to 1.12:
// - If a joint connects the model to the world, the world is the base. Otherwise the link that is no joint's child is
//   the base, which floats unless the model is static.
// - Links on fixed joints are lumped into the link that carries them. Every SDF link and frame is a user frame of the
//   same name.
// - A link frame of the model has its z axis along the joint axis and its origin at that of the joint.
// - Names of nested models have the prefix `model::` in SDF, and `model__` as identifiers.
// - Joint positions keep their zero and their sign. Links and joints keep the order of the file.
// - A joint whose child has a parent already closes a loop.
// - Damping, friction and springs are part of the dynamics.
// Reports, with places, what the model cannot represent, and warns about what is not read. nullopt if an error was
// reported.
std::optional<Sdf> sdf(
    const std::shared_ptr<const Source>& source,
    const std::filesystem::path& file,
    const SdfOptions& options,
    Diagnostics& diagnostics);

}  // namespace robcogen::import
