// Points and axes of bodies, which loops and tendons refer to by the names of bodies and sites.
#pragma once

#include "import/mjcf/document.h"

namespace robcogen::import::from_mjcf {

// The anchors at the frames of the bodies or sites of this name: several if it is copied. An empty name of a body is
// the world. Reports a name that is not declared.
std::vector<Anchor> anchors_at_bodies(const Document& document, const Name& name, Diagnostics& diagnostics);
std::vector<Anchor> anchors_at_sites(const Document& document, const Name& name, Diagnostics& diagnostics);

// Returns pairs of an anchor of the first list and one of the second: of the same copy, or the only one.
std::vector<std::array<Anchor, 2>> paired(
    const Document& document,
    const std::vector<Anchor>& first,
    const std::vector<Anchor>& second);

// The last body that carries both.
std::size_t common_ancestor(const Document& document, std::size_t first, std::size_t second);
// The bodies from this one towards the ancestor, which is not among them.
std::vector<std::size_t> path(const Document& document, std::size_t body, std::size_t ancestor);
// Returns the pose of the second body in the frame of the first one, as the file draws them.
Pose drawn_pose(const Document& document, std::size_t first, std::size_t second);

// Returns why these anchors cannot be the ends of a constraint or of a cylinder, as a clause, or an empty text.
// `is_outside` is set if neither end is part of the robot.
std::string fault_of(const Document& document, const std::array<Anchor, 2>& ends, bool& is_outside);

}  // namespace robcogen::import::from_mjcf
