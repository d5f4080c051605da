// The constants and functions of a robot from which its pictures are made.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "backend/library.h"
#include "driver/load.h"

namespace robcogen::view {

// A frame of the robot.
struct ViewedFrame {
  enum class Kind { link, joint, user };
  Kind kind = Kind::link;
  std::string name;
  int index = 0;  // of the link, the joint (model::independent_joints_first) or the user frame
  int link = 0;   // the link that it moves with
};

// A joint that closes a loop, between two of ViewedRobot::frames.
struct ViewedLoop {
  std::string name;
  std::array<std::size_t, 2> frames{};
};

// The robot with its base held, whether it floats or not. Gravity acts along -z of the base.
struct ViewedRobot {
  // The functions are frame_poses (algorithm/kinematics/frame_poses.h); for pages, gravity_forces and forward_dynamics,
  // as far as the mass properties allow them; joint_positions and close_loops, if joints follow others; and `numbers`,
  // if the robot has parameters (algorithm/catalogue/model_numbers.h).
  backend::Library library;
  std::vector<ViewedFrame> frames;  // of links, of joints, then user frames: the columns of frame_poses
  std::vector<ViewedLoop> loops;
  bool floats = false;  // whether it floats in the document

  bool has_function(const std::string& name) const;
};

// A drawing shows one position, and a page moves the robot.
enum class Purpose { drawing, page };

// The robot of a model, which must be one. Throws a Failure if it is too large for straight-line programs.
ViewedRobot viewed(const driver::Model& model, Purpose purpose);

// The rows of base_X_frame: the axes and the origin of the frame in the base.
using Pose = std::array<std::array<double, 4>, 4>;

// The robot in one position, computed by the interpreter.
struct Posture {
  std::vector<Pose> frames;                    // in the order of ViewedRobot::frames
  std::vector<double> masses;                  // of links, kg
  std::vector<std::array<double, 3>> centres;  // of mass of links, in the base, m
};

// `q` has one element per coordinate, `parameters` one per parameter.
Posture posture(const ViewedRobot& robot, const std::vector<double>& q, const std::vector<double>& parameters);

}  // namespace robcogen::view
