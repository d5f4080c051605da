// The dynamics of all joints of a tree whose loops are cut and held closed by forces.
#include "algorithm/dynamics/drives.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/loop_constraints.h"
#include "algorithm/dynamics/newton_euler.h"
#include "algorithm/kinematics/all_joints.h"
#include "model/loops.h"

namespace robcogen::algorithm {

using symbolic::Program;
using symbolic::Role;

namespace {

// Inputs by joint; positions are followed by the scalar parts of quaternions.
StateInputs inputs_of_all_joints(Trace& trace, const model::KinematicTree& looped) {
  std::vector<std::string> scalars;
  for (const int first : looped.spherical_joints())
    scalars.push_back(looped.joints[at(first)].declared_name() + model::kQuaternionSuffixes[0]);
  StateInputs in(trace, {});
  in.q = input_of_all_joints(trace, looped, "positions", scalars);
  in.qd = input_of_all_joints(trace, looped, "velocities");
  in.tau = input_of_all_joints(trace, looped, "joint_forces");
  if (looped.floating_base) in.base_velocity = trace.motion_input("base_velocity", Role::base_velocity);
  return in;
}

// The gains that keep loops closed (Baumgarte 1972), and the compliance of the loops.
struct Stabilization {
  explicit Stabilization(Trace& trace) {
    const std::vector<Expression> gains = trace.input("stabilization", Role::value, {"position", "velocity"});
    position = gains[0], velocity = gains[1];
    compliance = trace.input("compliance", Role::contact_compliance, {"c"}).front();
  }

  Expression position, velocity, compliance;
};

}  // namespace

Program loop_constrained_forward_dynamics(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  const model::KinematicTree free = model::with_free_joints(tree);
  Trace trace(free);
  StateInputs in = inputs_of_all_joints(trace, tree);
  const Stabilization stabilization(trace);
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, formulation);
  subtract_passive_forces(trace, in, in.tau);
  const Forces bias = bias_forces(robot, in, load);
  LoopConstraints loops(trace, tree, in.q);
  const std::vector<Expression> of_velocities = loops.bias(in.qd);
  const ConstraintSystem system(robot, loops.rows);
  trace.section("loops", "loops: missing accelerations");
  const std::vector<Expression> halved = system.halved(missing_forces(trace, in.tau, bias));
  const std::vector<Expression> unheld = system.at_rows(halved);
  std::vector<Expression> v(at(tree.floating_base ? 6 : 0));
  v.insert(v.end(), in.qd.begin(), in.qd.end());
  const std::vector<Expression> rates = times(loops.rows, v);
  std::vector<Expression> missing;
  SquareMatrix W = system.inverse_inertia();
  for (std::size_t r = 0; r < rates.size(); ++r) {
    const Expression pull = stabilization.position * loops.error[r] + stabilization.velocity * rates[r];
    missing.push_back(-(pull + of_velocities[r] + unheld[r]));
    const int row = static_cast<int>(r);
    W(row, row) += stabilization.compliance;
  }
  trace.section("loops", "loops: forces");
  const std::vector<Expression> lambda = solve(W, missing, loops.rows.names);
  const LoopConstraints::Forces forces = loops.forces(lambda);
  const std::vector<Expression> a = system.accelerations(halved, lambda);
  const auto first = a.begin() + (tree.floating_base ? 6 : 0);
  output_of_all_joints(trace, tree, "accelerations", {first, a.end()});
  if (tree.floating_base)
    trace.output("base_acceleration", Role::base_acceleration, Motion{{a[0], a[1], a[2]}, {a[3], a[4], a[5]}});
  std::vector<Expression> of_loops;
  for (const std::vector<Expression>& force : forces.of_loops)
    of_loops.insert(of_loops.end(), force.begin(), force.end());
  trace.output("loop_forces", Role::value, of_loops);
  if (!forces.of_couplings.empty()) trace.output("coupling_forces", Role::value, forces.of_couplings);
  return trace.program(name);
}

}  // namespace robcogen::algorithm
