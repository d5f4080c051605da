// Inverse dynamics of a robot whose base nothing holds (Featherstone 2008, sec. 9.4).
#include "algorithm/dynamics/composite_rigid_body.h"
#include "algorithm/dynamics/drives.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/force_derivatives.h"
#include "algorithm/dynamics/ldl.h"
#include "algorithm/dynamics/newton_euler.h"
#include "algorithm/spatial/couplings.h"

namespace robcogen::algorithm {

using symbolic::Role;

namespace {

// The motion with a base that does not accelerate needs a wrench on the base that nothing supplies; so the whole robot
// accelerates like one rigid body by the wrench that is missing.
struct FreeRobot {
  Forces forces;                          // with a base that does not accelerate
  std::vector<MassProperties> composite;  // by link
  Motion acceleration;                    // of the base
};

FreeRobot free_robot(const TracedRobot& robot, const StateInputs& in, const LoadInputs& load) {
  const LinkMotion base = base_motion(in.base_velocity, {}, load.gravity);
  FreeRobot result{newton_euler_forces(robot, base, in.qd, in.qdd, &load), composite_bodies(robot), {}};
  robot.trace.section(robot.link_name(0), "base: acceleration");
  result.acceleration = free_acceleration(rigid_body_inertia(result.composite[0]), result.forces.base_wrench);
  algorithm::name(robot.trace.graph, result.acceleration.angular, "base_acceleration_w");
  algorithm::name(robot.trace.graph, result.acceleration.linear, "base_acceleration_v");
  return result;
}

}  // namespace

symbolic::Program unactuated_base_inverse_dynamics(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::velocity, State::acceleration, State::base_velocity});
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, formulation);
  const FreeRobot free = free_robot(robot, in, load);
  std::vector<Expression> tau = free.forces.tau;
  add_composite_forces(robot, free.composite, free.acceleration, tau);
  add_passive_forces(trace, in, tau);
  trace.output("tau", Role::joint_force, by_coordinate(trace, tau));
  trace.output("base_acceleration", Role::base_acceleration, free.acceleration);
  return trace.program(name);
}

// With H_bb a + H_bj qdd + … = 0, where the derivatives of the base wrench are those of a given base acceleration:
// da = -H_bb^-1 d(base wrench), d tau = d tau (given a) + H_jb da.
symbolic::Program unactuated_base_inverse_dynamics_derivatives(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  Trace trace(tree);
  StateInputs in(trace, {State::position, State::velocity, State::acceleration, State::base_velocity});
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, formulation);
  const FreeRobot free = free_robot(robot, in, load);
  in.base_acceleration = free.acceleration;
  const LinkMotion base = base_motion(in.base_velocity, in.base_acceleration, load.gravity);
  Forces forces = newton_euler_forces(robot, base, in.qd, in.qdd, &load);
  add_passive_forces(trace, in, forces.tau);
  ForceDerivatives d = force_derivatives(robot, in, load.gravity, forces);
  trace.section(robot.link_name(0), "base: derivatives of the acceleration");
  std::vector<RightSide> right;
  std::vector<std::vector<Expression>*> columns;
  const auto add = [&](const std::string& by, Columns& block, std::size_t count) {
    for (std::size_t j = 0; j < count; ++j) {
      std::vector<Expression> missing;
      for (std::size_t k = 0; k < 6; ++k) missing.push_back(-block[j][k]);
      right.push_back({"_" + by + std::to_string(j), std::move(missing)});
      columns.push_back(&block[j]);
    }
  };
  add("dq", d.q, d.q.size());
  add("dqd", d.qd, d.qd.size());
  add("dqdd", d.qdd, d.qdd.size());
  add("dw", d.base_velocity, 3);
  const SquareMatrix inertia = matrix(rigid_body_inertia(free.composite[0]));
  const auto solutions = solve(inertia, std::move(right), {"wx", "wy", "wz", "vx", "vy", "vz"});
  for (std::size_t c = 0; c < columns.size(); ++c) {
    std::vector<Expression>& column = *columns[c];
    for (std::size_t k = 0; k < 6; ++k) {
      column[k] = solutions[c][k];
      for (std::size_t row = 6; row < column.size(); ++row) column[row] += d.base_acceleration[k][row] * column[k];
    }
  }
  // Rows 3 to 5 alone, whatever the robot: all its parts fall with the same acceleration.
  fill_free_fall(trace, in.base_velocity.angular, load.gravity, d);
  trace.output("tau", Role::joint_force, by_coordinate(trace, forces.tau));
  trace.output("base_acceleration", Role::base_acceleration, free.acceleration);
  const int n = tree.dof(), rows = 6 + n;
  trace.output("d_q", Role::matrix, rows, d.q);
  trace.output("d_qd", Role::matrix, rows, d.qd);
  trace.output("d_qdd", Role::matrix, rows, d.qdd);
  trace.output("d_base_rotation", Role::matrix, rows, d.base_rotation);
  trace.output("d_base_velocity", Role::matrix, rows, d.base_velocity);
  return trace.program(name);
}

}  // namespace robcogen::algorithm
