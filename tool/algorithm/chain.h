// The way from one frame to another: stretches of constant primitives, each with what moves at its end.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "algorithm/reached.h"

namespace robcogen::algorithm {

// A joint on the way, passed from parent to child, or back: then its motion counts the other way.
struct Motor {
  int joint = -1;
  bool backward = false;
  bool revolute = true;
};

// A part of the way. Its last primitive is the one that is no constant, so that the others merge with it and it costs
// one sine and cosine. The last stretch has constants alone.
struct Stretch {
  std::vector<model::PrimitiveTransform> primitives;
  std::string subject;         // what values behind it are called after; empty: the last stretch
  std::string passed;          // what it leads past: `joint KFE`, `Rx(a - b)`
  std::optional<Motor> motor;  // of a robot, but for the last stretch
};

// left_X_right, cut behind each joint; for many pairs of frames with the graph of the robot's motions.
std::vector<Stretch> chain(const model::KinematicTree& tree, const model::FramePair& frames);
std::vector<Stretch> chain(
    const model::KinematicTree& tree,
    const model::MotionGraph& motions,
    const model::FramePair& frames);

// The number of the stretch where turning is over: behind the last turn, or the one that turns before it slides.
int behind_last_turn(const std::vector<Stretch>& way);

// Starts the section of a stretch, and makes its pose: of its last frame in its first. `variables`: of the model; for
// robots the joint positions.
Pose pose_of(ProgramTrace& trace, const Stretch& stretch, const std::vector<Expression>& variables);

// Walks the whole way and returns its end. Calls behind(stretch, here) after each but the last; where a joint ends it,
// turning about the z axis or sliding along it has left the joint's axis where it was.
Reached walk(
    ProgramTrace& trace,
    const std::vector<Stretch>& way,
    const std::vector<Expression>& variables,
    const std::function<void(const Stretch&, const Reached&)>& behind,
    int moment_from = Reached::kNoStretch);

// The program of a robot's coordinate_transform (kinematics.h), for a way from left to right.
symbolic::Program transform_along(
    const model::KinematicTree& tree,
    const std::vector<Stretch>& way,
    TransformForm form,
    const std::string& name);

// left_X_right as the output X, for a way from left to right.
void output_transform(
    ProgramTrace& trace,
    const std::vector<Stretch>& way,
    const std::vector<Expression>& variables,
    TransformForm form,
    int moment_from);

}  // namespace robcogen::algorithm
