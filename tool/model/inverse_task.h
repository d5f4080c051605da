// What inverse kinematics is asked for.
#pragma once

namespace robcogen::model {

struct InverseTask {
  // The pose of the right frame; only the position of its origin; that and the direction of its z axis; only its
  // orientation.
  enum class Kind { pose, point, axis, orientation };
  Kind kind = Kind::pose;
  int given = -1;          // a joint of the chain whose position is an argument
  bool by_swivel = false;  // the swivel angle of an arm of seven joints is an argument
  // How far axes may be off (rad, and m per metre of reach) for a chain that has no closed form itself, but a nominal
  // one has; 0: none.
  double tolerance = 0.0;
  friend bool operator==(const InverseTask&, const InverseTask&) = default;
};

}  // namespace robcogen::model
