// The domain model of rigid motions: relative poses of frames as sequences of elementary motions.
#pragma once

#include <string>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

enum class Axis { x = 0, y = 1, z = 2 };

// A translation along, or a rotation about, one coordinate axis; or a general rotation given by a unit quaternion.
struct ElementaryMotion {
  bool rotation = false;
  Axis axis = Axis::x;
  Quantity amount;                        // m or rad
  std::vector<Quantity> quaternion = {};  // w, x, y, z of a rotation, instead of axis and amount; or empty
};

// local: each step refers to the axes of the frame reached so far. fixed: the axes stay parallel to those of the
// initial frame, and rotations are about the moving origin.
enum class MotionConvention { local, fixed };

// `from -> to : steps` moves frame `from` onto frame `to`.
struct Motion {
  std::string from;
  std::string to;
  std::vector<ElementaryMotion> steps;
  std::string name;  // given by the user, or empty
};

// Variables are indices into `variables`, parameters into `parameters`.
struct RigidMotions {
  std::string name;
  MotionConvention convention = MotionConvention::local;
  std::vector<Parameter> parameters;
  std::vector<std::string> variables;
  std::vector<std::string> frames;  // may contain frames that no motion uses
  std::vector<Motion> motions;
};

// Returns the poses of all joint frames, link frames and visible user frames of a robot, from parent to joint frame,
// from joint frame to child, and from link to user frame. Variable i is the position of joint i, named `q_<joint>`; the
// scalar parts of the quaternions follow, in the order of spherical_joints().
// (`fr_<parent> -> fr_<joint>`, `fr_<joint> -> fr_<child>`, `fr_<link> -> <frame>`.)
RigidMotions motions_of(const KinematicTree& tree);

// Returns the motion of a spherical joint, identified by its first component, over these variables.
ElementaryMotion spherical_motion(const KinematicTree& tree, int joint);

// The same with the independent joints as variables; coupled joints follow them. For robots without spherical joints
// and loops.
RigidMotions motions_over_coordinates(const KinematicTree& tree);

}  // namespace robcogen::model
