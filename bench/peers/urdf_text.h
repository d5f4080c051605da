// Within this folder: changes to the text of a URDF before a library reads it.
#pragma once

#include <string>

namespace robcogen::peers {

// The file without comments, <visual> and <collision>: no meshes to look for. Throws std::runtime_error when it cannot
// be read.
std::string dynamics_text(const std::string& path);

// Puts `elements` first into the element <robot>. Throws std::runtime_error when there is none.
std::string with_elements(std::string urdf, const std::string& elements);

// Puts `elements` first into the link. Throws std::runtime_error when the link does not exist.
std::string with_link_elements(std::string urdf, const std::string& link, const std::string& elements);

// The child of a joint. Throws std::runtime_error when the joint does not exist.
std::string child_link(const std::string& urdf, const std::string& joint);

// The first link that is not a child. Throws std::runtime_error when there is none.
std::string root_link(const std::string& urdf);

}  // namespace robcogen::peers
