// The inputs of a dynamics program: the state, gravity and external wrenches.
#pragma once

#include <vector>

#include "algorithm/spatial/pose.h"
#include "model/kinematic_tree.h"

namespace robcogen::algorithm {

// How gravity and external wrenches enter a program.
enum class Loads {
  standard_gravity,      // (0, 0, -9.81) m/s^2 in base coordinates, folded
  gravity,               // `gravity` is an input
  gravity_and_external,  // `external` is an input, too
};

// The loads of the first overload of a function.
inline Loads default_loads(const model::KinematicTree& tree) {
  return tree.floating_base ? Loads::gravity : Loads::standard_gravity;
}

inline constexpr double kStandardGravity = 9.81;  // m/s^2, along -z of the base frame

enum class State { position, velocity, acceleration, force, base_pose, base_velocity, base_acceleration };

// The state inputs: by joint, but forces by coordinate; the last two are of a floating base.
struct StateInputs {
  // Declares the listed inputs, in this order; velocity and acceleration of the base only if it floats.
  StateInputs(Trace& trace, const std::vector<State>& list);

  std::vector<Expression> q, qd, qdd, tau;
  Matrix3 base_rotation;  // base axes to world axes
  Vector3 base_position;  // in the world
  Motion base_velocity, base_acceleration;
};

// Positions, velocities and accelerations of the joints, velocity and acceleration of the base.
StateInputs motion_inputs(Trace& trace);

// Gravity and external wrenches of a program. The constructor declares its inputs: call it after all others.
struct LoadInputs {
  LoadInputs(Trace& trace, Loads loads);

  Vector3 gravity;
  std::vector<Force> external;  // by link, in the model's link frame; empty when there are none
};

}  // namespace robcogen::algorithm
