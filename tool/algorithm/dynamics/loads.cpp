#include "algorithm/dynamics/loads.h"

#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {

using symbolic::Role;

StateInputs::StateInputs(Trace& trace, const std::vector<State>& list) {
  for (const State state : list) {
    switch (state) {
      case State::position:
        q = trace.joint_input("q", Role::joint_position);
        break;
      case State::velocity:
        qd = trace.joint_input("qd", Role::joint_velocity);
        break;
      case State::acceleration:
        qdd = trace.joint_input("qdd", Role::joint_acceleration);
        break;
      case State::force:
        tau = trace.coordinate_input("tau", Role::joint_force);
        break;
      case State::base_pose: {
        const std::vector<Expression> pose = trace.base_pose_input();
        trace.section("base", "pose of the base");
        base_rotation =
            described("R", "base", *rotation_by_quaternion(trace.graph, {pose[0], pose[1], pose[2], pose[3]}).matrix);
        base_position = {pose[4], pose[5], pose[6]};
        break;
      }
      case State::base_velocity:
        if (trace.tree.floating_base) base_velocity = trace.motion_input("base_velocity", Role::base_velocity);
        break;
      case State::base_acceleration:
        if (trace.tree.floating_base)
          base_acceleration = trace.motion_input("base_acceleration", Role::base_acceleration);
        break;
    }
  }
}

StateInputs motion_inputs(Trace& trace) {
  return {
      trace, {State::position, State::velocity, State::acceleration, State::base_velocity, State::base_acceleration}};
}

LoadInputs::LoadInputs(Trace& trace, Loads loads) {
  // Read as a decimal, so that products with exact numbers of the model stay exact.
  const Number g = *Number::parse(print_double(kStandardGravity));
  gravity = loads == Loads::standard_gravity ? Vector3{Expression(), Expression(), trace.graph.constant(-g)}
                                             : trace.vector_input("gravity", Role::gravity);
  if (loads == Loads::gravity_and_external) external = trace.link_wrench_input();
}

}  // namespace robcogen::algorithm
