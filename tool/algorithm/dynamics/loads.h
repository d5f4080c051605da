// Gravity and external wrenches, and the state that a program of the dynamics starts from, as inputs.
#pragma once

#include <vector>

#include "algorithm/spatial/pose.h"
#include "model/kinematic_tree.h"

namespace robcogen::algorithm {

// How gravity and external wrenches enter a program.
enum class Loads {
  standard_gravity,      // (0, 0, -9.81) m/s^2 in base coordinates, folded
  gravity,               // `gravity` is an input
  gravity_and_external,  // and so is `external`
};

// Of the first overload of a function.
inline Loads default_loads(const model::KinematicTree& tree) {
  return tree.floating_base ? Loads::gravity : Loads::standard_gravity;
}

inline constexpr double kStandardGravity = 9.81;  // m/s^2, along -z of the base frame

enum class State { position, velocity, acceleration, force, base_pose, base_velocity, base_acceleration };

// By joint, forces by coordinate; the last two are of a floating base.
struct StateInputs {
  // Declares those that are listed, in this order; velocity and acceleration of the base only where it floats.
  StateInputs(Trace& trace, const std::vector<State>& list);

  std::vector<Expression> q, qd, qdd, tau;
  Matrix3 base_rotation;  // base axes to world axes
  Vector3 base_position;  // in the world
  Motion base_velocity, base_acceleration;
};

// Positions, velocities and accelerations of the joints, velocity and acceleration of the base.
StateInputs motion_inputs(Trace& trace);

// Gravity and external wrenches of a program. Declares its inputs: call after all other inputs.
struct LoadInputs {
  LoadInputs(Trace& trace, Loads loads);

  Vector3 gravity;
  std::vector<Force> external;  // by link, in the model's link frame; empty when there are none
};

}  // namespace robcogen::algorithm
