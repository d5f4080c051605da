// Files that a model names by URI: its meshes, and models that it includes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace robcogen::import {

// Returns the file or folder of `model://NAME/PATH` or `package://NAME/PATH`, of `file:///PATH`, or of a path; nullopt
// if there is none. A relative path starts in `folder`, that of the file with the URI, or else in one of `folders`. The
// folder NAME is looked up in `folders` and those of ROS_PACKAGE_PATH and AMENT_PREFIX_PATH, each of which may also be
// NAME itself, and then in `folder`, in `folders` and in the folders around them. A folder with a package.xml has the
// name in it, too.
std::optional<std::filesystem::path> find_resource(
    const std::string& uri,
    const std::filesystem::path& folder,
    const std::vector<std::filesystem::path>& folders);

}  // namespace robcogen::import
