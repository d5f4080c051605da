// Internal to this folder: changes to the text of a URDF before a library reads it.
#pragma once

#include <string>

namespace robcogen::peers {

// The file without comments, <visual> and <collision>, so that libraries do not look for meshes. Throws
// std::runtime_error if it cannot be read.
std::string dynamics_text(const std::string& path);

// Inserts `elements` at the beginning of the element <robot>. Throws std::runtime_error if there is none.
std::string with_elements(std::string urdf, const std::string& elements);

// Inserts `elements` at the beginning of the link. Throws std::runtime_error if the link does not exist.
std::string with_link_elements(std::string urdf, const std::string& link, const std::string& elements);

// The child link of a joint. Throws std::runtime_error if the joint does not exist.
std::string child_link(const std::string& urdf, const std::string& joint);

// The first link that is not a child. Throws std::runtime_error if there is none.
std::string root_link(const std::string& urdf);

}  // namespace robcogen::peers
