// The path from one frame to another: segments of constant primitives, each with a joint or a variable at its end.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "algorithm/kinematics/reached.h"
#include "algorithm/spatial/joint.h"

namespace robcogen::algorithm {

// A joint on the path, passed from parent to child, or backward: then its motion counts the other way.
struct JointOnPath {
  int joint = 0;
  bool backward = false;
};

// The last primitive of a segment is the one that is not constant, so that the others merge with it and it costs one
// sine and cosine. The last segment has constants alone. A spherical joint that is passed backward begins the next
// segment: at the end of each segment are the child's axes, or the axis, of its joint.
struct PathSegment {
  std::vector<model::PrimitiveTransform> primitives;
  std::string subject;              // names the values behind it; empty: the last segment
  std::string passed;               // what it leads past: `joint KFE`, `Rx(a - b)`
  std::vector<JointOnPath> joints;  // of a robot, but for the last segment: one, or the components of a spherical one
};
using Path = std::vector<PathSegment>;

// left_X_right, cut behind each joint; for many pairs of frames with the graph of the robot's motions.
Path path_between(const model::KinematicTree& tree, const model::FramePair& frames);
Path path_between(const model::KinematicTree& tree, const model::MotionGraph& motions, const model::FramePair& frames);

// The number of the segment from which on nothing rotates: behind the last rotation, or the one that rotates before it
// translates.
int behind_last_turn(const Path& path);

// Starts the section of a segment and returns its pose: of its last frame in its first. `variables`: of the model; for
// robots the joint positions.
Pose pose_of(ProgramTrace& trace, const PathSegment& segment, const std::vector<Expression>& variables);

// Follows the whole path and returns its end. Calls behind(segment, here) after each but the last; where a segment ends
// at a joint, its motion subspace is constant in the axes there.
Reached walk(
    ProgramTrace& trace,
    const Path& path,
    const std::vector<Expression>& variables,
    const std::function<void(const PathSegment&, const Reached&)>& behind,
    int moment_from = Reached::kNoSegment);

// The program of a robot's coordinate_transform (kinematics.h), for a path from left to right.
symbolic::Program transform_along(
    const model::KinematicTree& tree,
    const Path& path,
    TransformForm form,
    const std::string& name);

// left_X_right as the output X, for a path from left to right.
void output_transform(
    ProgramTrace& trace,
    const Path& path,
    const std::vector<Expression>& variables,
    TransformForm form,
    int moment_from);

// A matrix of six rows by its columns of these joints, as columns of coordinates (kinematics.h: chain_coordinates).
void output_columns(
    Trace& trace,
    const std::string& name,
    symbolic::Role role,
    const std::vector<int>& joints,
    const std::vector<Motion>& by_joint);

}  // namespace robcogen::algorithm
