// Recursive Newton-Euler and its special cases.
#include "algorithm/inverse_dynamics.h"
#include "algorithm/composite.h"
#include "algorithm/dynamics.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// One pass down and up the tree, branch by branch: what a branch needs is computed where it is used.
class Recursion {
 public:
  Recursion(const Setup& setup, std::vector<Expression> qd, std::vector<Expression> qdd, const LoadInputs* loads)
      : setup_(setup), qd_(std::move(qd)), qdd_(std::move(qdd)), loads_(loads), tau(qd_.size()) {}

  // The wrench that a link and all beyond it need, about the link's origin.
  Spatial wrench_of(int link, const LinkMotion& motion) {
    Spatial total;
    for (const JointView& joint : setup_.children(link)) {
      const auto j = static_cast<std::size_t>(joint.index);
      const std::string& name = setup_.link_name(joint.child);
      setup_.trace.section(name, "link " + name + ": velocity and acceleration");
      const LinkMotion child = child_motion(setup_.pose(joint.index), joint.revolute, motion, qd_[j], qdd_[j]);
      name_motion(name, child);
      const Spatial wrench = wrench_of(joint.child, child);
      tau[j] = joint.revolute ? wrench.angular[2] : wrench.linear[2];
      if (!setup_.parent_matters(joint.child)) continue;
      total += to_parent(setup_.pose(joint.index), wrench);
    }
    const bool base = setup_.tree().links[static_cast<std::size_t>(link)].parent_joint < 0;
    if (base && !setup_.floating()) return total;
    const std::string& name = setup_.link_name(link);
    setup_.trace.section(name, "link " + name + ": force and moment");
    Spatial own = link_wrench(
        setup_.trace, setup_.mass(link), motion, !base && !setup_.parent_matters(link) && is_revolute(link));
    if (loads_) loads_->subtract_external(setup_, link, own);
    total += own;
    algorithm::name(setup_.trace.graph, total.linear, name + "_f");
    algorithm::name(setup_.trace.graph, total.angular, name + "_n");
    return total;
  }

 private:
  const Setup& setup_;
  std::vector<Expression> qd_, qdd_;
  const LoadInputs* loads_;

  bool is_revolute(int link) const {
    const int joint = setup_.tree().links[static_cast<std::size_t>(link)].parent_joint;
    return setup_.tree().joints[static_cast<std::size_t>(joint)].type == model::JointType::revolute;
  }

  void name_motion(const std::string& link, const LinkMotion& motion) {
    Graph& graph = setup_.trace.graph;
    algorithm::name(graph, motion.angular.w, link + "_w");
    algorithm::name(graph, motion.angular.wd, link + "_wd");
    algorithm::name(graph, motion.a, link + "_a");
  }

 public:
  std::vector<Expression> tau;
};

std::vector<Expression> zeros(const Trace& trace) {
  return std::vector<Expression>(static_cast<std::size_t>(trace.tree.dof()));
}

}  // namespace

Forces bias_forces(
    const Setup& setup,
    const std::vector<Expression>& qd,
    const Spatial& base_velocity,
    const LoadInputs& loads) {
  Recursion recursion(setup, qd, zeros(setup.trace), &loads);
  const Spatial base = recursion.wrench_of(0, base_motion(base_velocity, {}, loads.gravity));
  return {recursion.tau, base};
}

namespace {

void write_forces(Trace& trace, const std::vector<Expression>& tau, const Spatial& base_wrench) {
  trace.output("tau", Role::joint_force, tau);
  if (trace.tree.floating_base) trace.output("base_wrench", Role::base_wrench, base_wrench);
}

}  // namespace

Program newton_euler(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  const auto qd = trace.joint_input("qd", Role::joint_velocity);
  const auto qdd = trace.joint_input("qdd", Role::joint_acceleration);
  Spatial velocity, acceleration;
  if (tree.floating_base) {
    velocity = trace.spatial_input("base_velocity", Role::base_velocity);
    acceleration = trace.spatial_input("base_acceleration", Role::base_acceleration);
  }
  const LoadInputs load(trace, loads);
  const Setup setup(trace, q, formulation);
  Recursion recursion(setup, qd, qdd, &load);
  const Spatial base = recursion.wrench_of(0, base_motion(velocity, acceleration, load.gravity));
  write_forces(trace, recursion.tau, base);
  return trace.program(name);
}

Program bias_forces(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  const auto qd = trace.joint_input("qd", Role::joint_velocity);
  Spatial velocity;
  if (tree.floating_base) velocity = trace.spatial_input("base_velocity", Role::base_velocity);
  const LoadInputs load(trace, loads);
  const Setup setup(trace, q, formulation);
  const Forces forces = bias_forces(setup, qd, velocity, load);
  write_forces(trace, forces.tau, forces.base_wrench);
  return trace.program(name);
}

Program coriolis_forces(const model::KinematicTree& tree, const std::string& name, const Formulation& formulation) {
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  const auto qd = trace.joint_input("qd", Role::joint_velocity);
  Spatial velocity;
  if (tree.floating_base) velocity = trace.spatial_input("base_velocity", Role::base_velocity);
  const Setup setup(trace, q, formulation);
  Recursion recursion(setup, qd, zeros(trace), nullptr);
  const Spatial base = recursion.wrench_of(0, base_motion(velocity, {}, {}));
  write_forces(trace, recursion.tau, base);
  return trace.program(name);
}

Program unactuated_base_inverse_dynamics(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  const auto qd = trace.joint_input("qd", Role::joint_velocity);
  const auto qdd = trace.joint_input("qdd", Role::joint_acceleration);
  const Spatial velocity = trace.spatial_input("base_velocity", Role::base_velocity);
  const LoadInputs load(trace, loads);
  const Setup setup(trace, q, formulation);
  // The motion with the base not accelerating needs a base wrench that nobody supplies …
  Recursion recursion(setup, qd, qdd, &load);
  const Spatial missing = recursion.wrench_of(0, base_motion(velocity, {}, load.gravity));
  // … so the whole robot accelerates like one rigid body by what is missing.
  const std::vector<MassProperties> composite = composite_bodies(setup);
  const Spatial acceleration = rigid_body_acceleration(trace, composite[0], missing);
  std::vector<Expression> tau = recursion.tau;
  add_composite_forces(setup, composite, acceleration, tau);
  trace.output("tau", Role::joint_force, tau);
  trace.output("base_acceleration", Role::base_acceleration, acceleration);
  return trace.program(name);
}

}  // namespace robcogen::algorithm
