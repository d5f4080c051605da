// What the pictures of a robot are made of: its constants and its functions.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "backend/library.h"
#include "driver/load.h"

namespace robcogen::view {

// A frame of the robot, and the function that gives its pose in the base.
struct ViewedFrame {
  enum class Kind { link, joint, user };
  Kind kind = Kind::link;
  std::string name;
  int index = 0;      // of the link, the joint (Library::all_joints) or the user frame
  int link = 0;       // that it moves with
  int function = -1;  // of Library::functions; -1: it is that of the base
};

// A joint that closes a loop, between two of ViewedRobot::frames.
struct ViewedLoop {
  std::string name;
  std::array<std::size_t, 2> frames{};
};

// The robot with its base held, whether it floats or not: gravity acts along -z of the base.
struct ViewedRobot {
  // Functions: homogeneous transforms base_X_frame; gravity_forces and forward_dynamics as far as the mass properties
  // allow them; joint_positions where joints follow others; `numbers` of robots with parameters
  // (algorithm/catalogue/model_numbers.h).
  backend::Library library;
  std::vector<ViewedFrame> frames;  // of links, of joints, then those of the user
  std::vector<ViewedLoop> loops;
  bool floats = false;  // in the document

  bool has_function(const std::string& name) const;
};

// Of a model that is a robot. A Failure when it is too large for straight-line programs.
ViewedRobot viewed(const driver::Model& model);

// Rows of base_X_frame: axes and origin of the frame in the base.
using Pose = std::array<std::array<double, 4>, 4>;

// The robot in one position, from the interpreter.
struct Posture {
  std::vector<Pose> frames;                    // in the order of ViewedRobot::frames
  std::vector<double> masses;                  // of links, kg
  std::vector<std::array<double, 3>> centres;  // of mass of links, in the base, m
};

// `q` has an element a coordinate, `parameters` one a parameter.
Posture posture(const ViewedRobot& robot, const std::vector<double>& q, const std::vector<double>& parameters);

}  // namespace robcogen::view
