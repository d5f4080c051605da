// The path from one frame to another: segments of constant primitives, each with a joint or a variable at its end.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "algorithm/kinematics/path_pose.h"
#include "algorithm/spatial/joint.h"

namespace robcogen::algorithm {

// A joint on the path, passed from parent to child, or backward: then its motion counts with the opposite sign.
struct JointOnPath {
  int joint = 0;
  bool backward = false;
};

// The last primitive of a segment is the only one that is not constant, so that the others merge with it and the
// segment costs one sine and cosine. The last segment has only constants. A spherical joint that is passed backward
// begins the next segment, so that each segment ends in the child's axes, or on the axis, of its joint.
struct PathSegment {
  std::vector<model::PrimitiveTransform> primitives;
  std::string subject;              // names the values behind it; empty: the last segment
  std::string passed;               // what it passes: `joint KFE`, `Rx(a - b)`
  std::vector<JointOnPath> joints;  // of a robot, except in the last segment: one, or the components of a spherical one
};
using Path = std::vector<PathSegment>;

// left_X_right, cut after each joint. The second form takes the graph of the robot's motions, for many pairs of frames.
Path path_between(const model::KinematicTree& tree, const model::FramePair& frames);
Path path_between(const model::KinematicTree& tree, const model::MotionGraph& motions, const model::FramePair& frames);

// The number of the segment after the last one that rotates, or of that one itself if it translates after its rotation
// or no other segment follows.
int behind_last_turn(const Path& path);

// Starts the section of a segment and returns the pose of its last frame in its first one. `variables`: of the model;
// for robots the joint positions.
Pose pose_of(ProgramTrace& trace, const PathSegment& segment, const std::vector<Expression>& variables);

// Follows the whole path and returns its end. Calls behind(segment, here) after each segment but the last. If a segment
// ends at a joint, the joint's motion subspace is constant in the axes there.
PathPose walk(
    ProgramTrace& trace,
    const Path& path,
    const std::vector<Expression>& variables,
    const std::function<void(const PathSegment&, const PathPose&)>& behind,
    int moment_from = PathPose::kNoSegment);

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

// Outputs a matrix of six rows, given by columns of these joints, with columns of coordinates (kinematics.h:
// chain_coordinates).
void output_columns(
    Trace& trace,
    const std::string& name,
    symbolic::Role role,
    const std::vector<int>& joints,
    const std::vector<Motion>& by_joint);

}  // namespace robcogen::algorithm
