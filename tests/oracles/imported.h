// URDFs as the tests of their import read them.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "model/coordinate_transforms.h"
#include "model/kinematic_tree.h"

namespace robcogen::oracles {

// Returns the URDFs of all given folders that exist.
std::set<std::filesystem::path> urdfs_in(const std::set<std::filesystem::path>& folders);

std::string contents(const std::filesystem::path& file);

enum class MimicJoints { coupled, free };

// Throws std::runtime_error with the messages if the URDF is refused.
model::KinematicTree imported(const std::filesystem::path& file, bool floating, MimicJoints mimic);

// Jacobians from the base to one frame on each leaf: the last one of the file, which is farthest out.
model::DesiredTransforms jacobians_of_leaves(const model::KinematicTree& tree);

// Characters that an identifier cannot have are imported as underscores. Returns all names of the file with such
// characters, by identifier.
std::map<std::string, std::string> changed_names(const std::string& urdf);

}  // namespace robcogen::oracles
