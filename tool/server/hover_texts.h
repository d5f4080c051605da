// Hover texts about the elements of robots and of coordinate transforms.
#pragma once

#include <string>

#include "server/mechanics.h"

namespace robcogen::server {

// Texts with values of the robot at q = 0, or where its loops are assembled.
class RobotText {
 public:
  explicit RobotText(const model::KinematicTree& tree) : tree_(tree), resting_(tree) {}

  std::string link(int l) const;
  std::string joint(int j) const;
  std::string loop(std::size_t l) const;
  std::string frame(const model::Frame& frame) const;

 private:
  const model::KinematicTree& tree_;
  RestingRobot resting_;

  // The reference of places and directions, such as `in the base at q = 0`.
  std::string in_base() const;
  std::string unknown_parameters() const;
};

// Describes a frame of rigid motions: its pose in the first frame that it is connected to, with all variables at zero,
// and the motion from there. Empty for an unknown name.
std::string text_of_frame(const model::RigidMotions& motions, const std::string& frame);

std::string text_of(const model::Parameter& parameter);

}  // namespace robcogen::server
