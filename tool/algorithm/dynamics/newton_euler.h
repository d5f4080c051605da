// Recursive Newton-Euler as expressions, for algorithms that use its forces.
#pragma once

#include <vector>

#include "algorithm/dynamics/traced_robot.h"

namespace robcogen::algorithm {

struct Forces {
  std::vector<Expression> tau;  // by joint
  Force base_wrench;            // of a floating base
  // By link, about its origin in its axes: its motion, and the wrench that it and all beyond it need. The base has a
  // wrench only if it floats; a link on a fixed base has only the part that its joint feels.
  std::vector<LinkMotion> motions;
  std::vector<Force> wrenches;
};

// The forces of a motion (Featherstone 2008, table 5.1). `loads`: nullptr for none.
Forces newton_euler_forces(
    const TracedRobot& robot,
    const LinkMotion& base,
    const std::vector<Expression>& qd,
    const std::vector<Expression>& qdd,
    const LoadInputs* loads);

// The inverse dynamics of a motion, with passive forces. Declares the inputs of the loads.
struct TracedMotion {
  TracedMotion(Trace& trace, const StateInputs& in, Loads loads, const Formulation& formulation);

  LoadInputs load;
  TracedRobot robot;
  Forces forces;
};

// The forces at zero joint and base acceleration, without passive forces.
Forces bias_forces(const TracedRobot& robot, const StateInputs& in, const LoadInputs& loads);

// The part of the bias forces that velocities cause, and the motions that go with it.
Forces forces_of_velocities(const TracedRobot& robot, const StateInputs& in);

// The forces that accelerate the robot: (- base wrench, tau - needed), an element for each row of the joint-space
// inertia matrix. `tau`: by coordinate.
std::vector<Expression> missing_forces(Trace& trace, const std::vector<Expression>& tau, const Forces& needed);

}  // namespace robcogen::algorithm
