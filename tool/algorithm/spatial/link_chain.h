// The chain of links from the last one that carries both ends of a loop to one of the ends.
#pragma once

#include <vector>

#include "algorithm/spatial/pose.h"
#include "model/loop.h"

namespace robcogen::algorithm {

// For each joint of an end, then for the end's frame: its frame at q = 0 in that of the joint before.
std::vector<Pose> placements_at_zero(Trace& trace, const model::LoopEnd& end);
// For each joint, at these positions: its child link in its parent link; then the end's frame in its link.
std::vector<Pose> poses_along(Trace& trace, const model::LoopEnd& end, const std::vector<Expression>& q);
// The joint's frame in its parent link.
Pose placement_of_joint(Trace& trace, int joint);

// A point, or a direction, of frame k in the frame before the first pose.
Vector3 point_through(const std::vector<Pose>& poses, std::size_t k, Vector3 point);
Vector3 direction_through(const std::vector<Pose>& poses, std::size_t k, Vector3 direction);

// A point of the child, in the parent; and back.
Vector3 point_to_parent(const Pose& X_PC, Vector3 point);
Vector3 point_to_child(const Pose& X_PC, const Vector3& point);

}  // namespace robcogen::algorithm
