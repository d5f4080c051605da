// The articulated-body algorithm (Featherstone 2008, table 7.1) in two parts. The pass down and up computes velocities,
// the wrench of each link at zero joint and base acceleration (recursive Newton-Euler), and articulated inertias. The
// second pass down computes accelerations relative to those of the first part; it has no velocity terms.
#include "algorithm/dynamics/articulated_body.h"

#include "algorithm/dynamics/composite_rigid_body.h"
#include "algorithm/dynamics/drives.h"
#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {
namespace {

// What the second pass needs of a joint, in the notation of Featherstone.
struct JointState {
  Force U;               // articulated inertia times the joint's motion subspace S
  Expression inverse_D;  // 1 / (S' U + inertia of the drive)
  Expression u;          // tau minus the joint force at zero acceleration
  Vector3 rotor;         // momentum of the rotor at unit rate, in axes of the parent, which carries it
};

class ArticulatedBodies {
 public:
  ArticulatedBodies(const TracedRobot& robot, const StateInputs& in, const LoadInputs& load)
      : robot_(robot), in_(in), load_(load), joints_(in.tau.size()), zeros_(in.tau.size()) {}

  // Passes velocities down from a link to all links beyond it. On the way up, sets the articulated inertia and the bias
  // wrench of the link.
  void collect(int link, const LinkMotion& motion, SpatialInertia& inertia, Force& bias) {
    const std::string& name = robot_.link_name(link);
    SpatialInertia children_inertia;
    Force children_bias;
    for (const Joint& joint : robot_.children(link)) collect_child(joint, motion, children_inertia, children_bias);
    if (robot_.is_base(link) && !robot_.floating()) return;
    robot_.trace.section(name, "link ", ": articulated inertia and bias wrench");
    Force own = link_wrench(robot_.trace, robot_.mass(link), motion, rotor_motions_on(robot_, link, in_.qd, {}));
    robot_.subtract_external(load_, link, own);
    bias = named(name, children_bias + described({name, "own"}, own));
    inertia = named(name, children_inertia + rigid_body_inertia(robot_.mass(link)));
  }

  // Passes accelerations down from a link to all links beyond it.
  void accelerate(int link, const Motion& parent) {
    for (const Joint& joint : robot_.children(link)) {
      const std::string& name = robot_.link_name(joint.child);
      robot_.trace.section(name, "link ", ": acceleration");
      Motion a = described_acceleration({name, "", "carried"}, to_child(robot_.pose(joint.index), parent));
      const JointState& state = joints_[at(joint.index)];
      // Without a drive inertia D = S' U. Then u - U' a, with a = a_0 + S s and its component s along the joint left
      // out, is D (s + qdd): one product with U gives the sum of both. A drive inertia accelerates by qdd alone, so
      // that s is needed in the product.
      if (has_drive_inertia(joint)) {
        const Expression felt = dot(state.U, a) + dot(state.rotor, parent.angular);
        qdd[at(joint.index)] = (state.u - felt) * state.inverse_D;
        add_rate(joint, qdd[at(joint.index)], a);
      } else {
        const Expression carried = take_rate(joint, a);
        const Expression total = (state.u - dot(state.U, a)) * state.inverse_D;
        qdd[at(joint.index)] = total - carried;
        add_rate(joint, total, a);
      }
      accelerate(joint.child, named_acceleration(name, a));
    }
  }

 private:
  const TracedRobot& robot_;
  const StateInputs& in_;
  const LoadInputs& load_;
  std::vector<JointState> joints_;
  std::vector<Expression> zeros_;

  bool has_drive_inertia(const Joint& joint) const { return robot_.tree().joints[at(joint.index)].drive.has_inertia(); }

  // The momentum at unit rate of the joint's rotor, in the parent that carries the rotor; zero if another link carries
  // it, and on a fixed base, which does not turn.
  Vector3 coupling_of_rotor(const Joint& joint) const {
    const int parent = robot_.tree().joints[at(joint.index)].parent;
    if (robot_.is_base(parent) && !robot_.floating()) return {};
    return rotor_momentum(robot_, joint.index, parent);
  }

  static bool are_zero(const Vector3& v) { return v[0].is_zero() && v[1].is_zero() && v[2].is_zero(); }

  // Adds the inertia and the bias wrench of a child to those of a parent that carries the rotor of the joint. The
  // rotor acts in the axes of the parent, so that U does, too.
  void pass_with_rotor(
      const Joint& joint,
      const SpatialInertia& x,
      const Force& p,
      SpatialInertia& inertia,
      Force& bias) {
    const Pose& X_PC = robot_.pose(joint.index);
    const JointState& state = joints_[at(joint.index)];
    const std::string& name = robot_.link_name(joint.child);
    const Force U = described(in_parent(name, "U"), to_parent(X_PC, state.U) + Force{state.rotor, {}});
    const Force gain = described(in_parent(name, "U_by_D"), state.inverse_D * U);
    inertia = inertia + described(in_parent(name), reduced(to_parent(X_PC, x), U, gain));
    const Force p_P = to_parent(X_PC, p);
    bias += described(in_parent(name), p_P + state.u * gain);
  }

  void collect_child(const Joint& joint, const LinkMotion& motion, SpatialInertia& inertia, Force& bias) {
    const Pose& X_PC = robot_.pose(joint.index);
    const std::string& name = robot_.link_name(joint.child);
    robot_.trace.section(name, "link ", ": velocity and bias acceleration");
    const LinkMotion child = named(name, across_joint(joint, X_PC, motion, in_.qd, zeros_));
    SpatialInertia x;
    Force p;
    collect(joint.child, child, x, p);

    const std::string& joint_name = robot_.tree().joints[at(joint.index)].name;
    robot_.trace.section(name, {"joint ", joint_name, ": articulated inertia about its axis"});
    JointState& state = joints_[at(joint.index)];
    state.U = described({name, "U"}, times_subspace(x, joint));
    const Expression D = project(joint, state.U) + drive_inertia(robot_.trace, joint.index);
    state.inverse_D = named("Dinv", name, robot_.trace.graph.one() / D);
    state.rotor = coupling_of_rotor(joint);
    const Expression tau = in_.tau[at(joint.index)];
    state.u = named("u", name, tau - project(joint, p) - dot(state.rotor, motion.angular.wd));
    if (!robot_.parent_matters(joint.child)) return;
    if (!are_zero(state.rotor)) return pass_with_rotor(joint, x, p, inertia, bias);
    const Label free = {name, "", "free"};
    const Force gain = described({name, "U_by_D"}, state.inverse_D * state.U);
    x = described(free, has_drive_inertia(joint) ? reduced(x, state.U, gain) : released(x, joint, state.U, gain));
    p = described(free, p + state.u * gain);
    // A joint whose drive has no inertia passes on exactly tau along its axis.
    if (!has_drive_inertia(joint)) set_projection(joint, tau, p);
    inertia = inertia + described(in_parent(name), to_parent(X_PC, x));
    bias += described(in_parent(name), to_parent(X_PC, p));
  }

 public:
  std::vector<Expression> qdd = std::vector<Expression>(in_.tau.size());
};

}  // namespace

ForwardMotion by_articulated_bodies(const TracedRobot& robot, const StateInputs& in, const LoadInputs& load) {
  ArticulatedBodies bodies(robot, in, load);
  SpatialInertia inertia;
  Force bias;
  bodies.collect(0, described(robot.link_name(0), base_motion(in.base_velocity, {}, load.gravity)), inertia, bias);
  Motion acceleration;
  if (robot.floating()) {
    robot.trace.section(robot.link_name(0), "base: acceleration");
    acceleration = free_acceleration(inertia, bias);
  }
  bodies.accelerate(0, acceleration);
  return {bodies.qdd, acceleration};
}

}  // namespace robcogen::algorithm
