// Gravity forces from the first moments of composite bodies: half the work of a Newton-Euler pass at rest.
#include <functional>

#include "algorithm/dynamics.h"
#include "algorithm/setup.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// Mass and first moment about the link's origin.
struct PointMass {
  Expression mass;
  Vector3 moment;
};

}  // namespace

Program gravity_forces(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  const LoadInputs load(trace, loads);
  const Setup setup(trace, q, formulation);
  std::vector<Expression> tau(static_cast<std::size_t>(tree.dof()));

  // Down: what holds a unit mass against gravity, -g in link axes. Up: masses and first moments.
  const std::function<PointMass(int, const Vector3&)> visit = [&](int link, const Vector3& lift) {
    PointMass total{setup.mass(link).mass, setup.mass(link).first_moment};
    for (const JointView& joint : setup.children(link)) {
      const std::string& child = setup.link_name(joint.child);
      const Pose& pose = setup.pose(joint.index);
      trace.section(child, "link " + child + ": gravity and first moment");
      const Vector3 child_lift = to_child(pose.rotation, lift);
      algorithm::name(trace.graph, child_lift, child + "_a");
      PointMass body = visit(joint.child, child_lift);
      algorithm::name(trace.graph, body.moment, child + "_h");
      tau[static_cast<std::size_t>(joint.index)] =
          joint.revolute ? cross(body.moment, child_lift)[2] : body.mass * child_lift[2];
      body.moment[2] += body.mass * pose.slide;
      total.moment += to_parent(pose.rotation, body.moment) + body.mass * pose.offset;
      total.mass += body.mass;
    }
    return total;
  };
  const PointMass robot = visit(0, -load.gravity);
  trace.output("tau", Role::joint_force, tau);
  if (tree.floating_base)
    trace.output(
        "base_wrench", Role::base_wrench, Spatial{cross(robot.moment, -load.gravity), robot.mass * -load.gravity});
  return trace.program(name);
}

}  // namespace robcogen::algorithm
