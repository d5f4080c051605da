// Gravity forces from the first moments of composite bodies: half the work of a Newton-Euler pass at rest.
#include <functional>

#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/traced_robot.h"
#include "algorithm/spatial/describe.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// Mass and first moment about the link's origin.
struct PointMass {
  Expression mass;
  Vector3 moment;
};

// Of an acceleration.
Force wrench_of(const PointMass& body, const Vector3& a) {
  return {cross(body.moment, a), body.mass * a};
}

}  // namespace

Program gravity_forces(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position});
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, formulation);
  std::vector<Expression> tau(at(tree.dof()));

  // Down: the acceleration that holds a link against gravity, -g in link axes. Up: masses and first moments.
  const std::function<PointMass(int, const Vector3&)> visit = [&](int link, const Vector3& lift) {
    PointMass total{robot.mass(link).mass, robot.mass(link).first_moment};
    for (const Joint& joint : robot.children(link)) {
      const std::string& child = robot.link_name(joint.child);
      const Pose& X_PC = robot.pose(joint.index);
      trace.section(child, "link " + child + ": gravity and first moment");
      const Vector3 child_lift = to_child(X_PC.rotation, lift);
      algorithm::name(trace.graph, child_lift, child + "_a");
      PointMass body = visit(joint.child, child_lift);
      algorithm::name(trace.graph, body.moment, child + "_h");
      tau[at(joint.index)] = project(joint, wrench_of(body, child_lift));
      body.moment[2] += body.mass * X_PC.slide;
      const Vector3 turned = to_parent(X_PC.rotation, body.moment);
      describe(turned, child + "_h", "_P");
      total.moment += turned + body.mass * X_PC.offset;
      total.mass += body.mass;
    }
    return total;
  };
  const PointMass whole = visit(0, -load.gravity);
  trace.output("tau", Role::joint_force, tau);
  if (tree.floating_base) trace.output("base_wrench", Role::base_wrench, wrench_of(whole, -load.gravity));
  return trace.program(name);
}

}  // namespace robcogen::algorithm
