// Kinetic and potential energy.
#include <functional>

#include "algorithm/composite.h"
#include "algorithm/dynamics.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// m v v + 2 v (w x h) + w I w, all about the link's origin.
Expression twice_energy(const MassProperties& m, const Spatial& twist) {
  const Vector3 &w = twist.angular, &v = twist.linear;
  const Vector3 sliding = m.mass * v, twice_h = m.first_moment + m.first_moment;
  const Expression linear = dot(v, sliding + cross(w, twice_h));
  return linear + dot(w, multiply(inertia_tensor(m), w));
}

}  // namespace

Program kinetic_energy(const model::KinematicTree& tree, const std::string& name, const Formulation& formulation) {
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  const auto qd = trace.joint_input("qd", Role::joint_velocity);
  Spatial base;
  if (tree.floating_base) base = trace.spatial_input("base_velocity", Role::base_velocity);
  const Setup setup(trace, q, formulation);

  Expression twice;
  const std::function<void(int, const Spatial&)> visit = [&](int link, const Spatial& twist) {
    twice += twice_energy(setup.mass(link), twist);
    for (const JointView& joint : setup.children(link)) {
      const std::string& child = setup.link_name(joint.child);
      trace.section(child, "link " + child + ": velocity and energy");
      const Spatial moved =
          child_twist(setup.pose(joint.index), joint.revolute, twist, qd[static_cast<std::size_t>(joint.index)]);
      algorithm::name(trace.graph, moved.angular, child + "_w");
      algorithm::name(trace.graph, moved.linear, child + "_v");
      visit(joint.child, moved);
    }
  };
  visit(0, base);
  trace.output("T", Role::energy, std::vector<Expression>{0.5 * twice});
  return trace.program(name);
}

Program potential_energy(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const TypicalLinks& typical) {
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  const LoadInputs load(trace, loads);
  const Setup setup(trace, q, typical);
  const MassProperties body = moving_body(setup, composite_bodies(setup));
  trace.output("V", Role::energy, std::vector<Expression>{-dot(load.gravity, body.first_moment)});
  return trace.program(name);
}

}  // namespace robcogen::algorithm
