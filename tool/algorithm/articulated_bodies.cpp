// Articulated-body algorithm in two parts: the wrenches at zero joint and base acceleration by Newton-Euler, then a
// homogeneous pass for what the accelerations add. No velocity term remains in the second part.
//
// The articulated inertia of a link relates the added acceleration (wd', a') to the added wrench (n, f):
//     n = A wd' + B a',   f = B' wd' + M a',   A and M symmetric.
#include "algorithm/articulated_bodies.h"
#include "algorithm/dynamics.h"

namespace robcogen::algorithm {
namespace {

struct ArticulatedInertia {
  Matrix3 a;
  Matrix3 b;
  Matrix3 m;
};

ArticulatedInertia operator+(const ArticulatedInertia& x, const ArticulatedInertia& y) {
  return {x.a + y.a, x.b + y.b, x.m + y.m};
}

ArticulatedInertia rigid(const MassProperties& body) {
  ArticulatedInertia result{inertia_tensor(body), skew(body.first_moment), {}};
  for (std::size_t i = 0; i < 3; ++i) result.m[i][i] = body.mass;
  return result;
}

// About a point displaced by -p: B' = B + [p]x M, A' = A - B' [p]x + [p]x B'.
ArticulatedInertia displaced(const ArticulatedInertia& x, const Vector3& p) {
  if (is_zero(p)) return x;
  const Matrix3 k = skew(p);
  ArticulatedInertia result = x;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) result.b[r][c] = x.b[r][c] + dot(k[r], x.m[c]);
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = r; c < 3; ++c) {
      result.a[r][c] = x.a[r][c];
      result.a[r][c] += dot(k[c], r == c ? result.b[r] + x.b[r] : result.b[r]);
      if (r != c) result.a[r][c] += dot(k[r], x.b[c]);
      result.a[c][r] = result.a[r][c];
    }
  }
  return result;
}

ArticulatedInertia to_parent(const Pose& pose, const ArticulatedInertia& child) {
  const ArticulatedInertia slid = displaced(child, {Expression(), Expression(), pose.slide});
  return displaced(
      {symmetric_to_parent(pose.rotation, slid.a), general_to_parent(pose.rotation, slid.b),
       symmetric_to_parent(pose.rotation, slid.m)},
      pose.offset);
}

// What the passes know of a joint.
struct JointState {
  Spatial column;      // articulated inertia times the joint's axis
  Expression inverse;  // 1 / (axis' column)
  Expression surplus;  // tau minus the force that the bias motion needs
};

class ArticulatedBodies {
 public:
  ArticulatedBodies(const Setup& setup, std::vector<Expression> qd, std::vector<Expression> tau, const LoadInputs& load)
      : setup_(setup), qd_(std::move(qd)), tau_(std::move(tau)), load_(load), joints_(tau_.size()) {}

  // Down with velocities, up with inertias and bias wrenches, of one link and all beyond it.
  void collect(int link, const LinkMotion& motion, ArticulatedInertia& inertia, Spatial& bias) {
    const std::string& name = setup_.link_name(link);
    ArticulatedInertia children_inertia;
    Spatial children_bias;
    for (const JointView& joint : setup_.children(link)) collect_child(joint, motion, children_inertia, children_bias);
    const bool base = setup_.tree().links[static_cast<std::size_t>(link)].parent_joint < 0;
    if (base && !setup_.floating()) return;
    setup_.trace.section(name, "link " + name + ": articulated inertia and bias wrench");
    Spatial own = link_wrench(setup_.trace, setup_.mass(link), motion);
    load_.subtract_external(setup_, link, own);
    bias = {children_bias.angular + own.angular, children_bias.linear + own.linear};
    inertia = children_inertia + rigid(setup_.mass(link));
    name_inertia(name, inertia);
    algorithm::name(graph(), bias.angular, name + "_n");
    algorithm::name(graph(), bias.linear, name + "_f");
  }

  // Down with accelerations.
  void accelerate(int link, const Spatial& parent) {
    for (const JointView& joint : setup_.children(link)) {
      const std::string& name = setup_.link_name(joint.child);
      setup_.trace.section(name, "link " + name + ": acceleration");
      const Pose& pose = setup_.pose(joint.index);
      Spatial a;
      a.angular = to_child(pose.rotation, parent.angular);
      a.linear = to_child(pose.rotation, parent.linear - cross(pose.offset, parent.angular));
      if (!pose.slide.is_zero()) {
        a.linear[0] += pose.slide * a.angular[1];
        a.linear[1] -= pose.slide * a.angular[0];
      }
      const JointState& state = joints_[static_cast<std::size_t>(joint.index)];
      // Leaving the axis component out of the product gives the link's own component, joint acceleration included.
      Spatial off_axis = a;
      Expression& along = joint.revolute ? off_axis.angular[2] : off_axis.linear[2];
      const Expression carried = along;
      along = Expression();
      const Expression total = (state.surplus - dot(state.column, off_axis)) * state.inverse;
      qdd[static_cast<std::size_t>(joint.index)] = total - carried;
      (joint.revolute ? a.angular[2] : a.linear[2]) = total;
      algorithm::name(graph(), a.angular, name + "_dw");
      algorithm::name(graph(), a.linear, name + "_da");
      accelerate(joint.child, a);
    }
  }

 private:
  const Setup& setup_;
  std::vector<Expression> qd_, tau_;
  const LoadInputs& load_;
  std::vector<JointState> joints_;

  Graph& graph() { return setup_.trace.graph; }

  void collect_child(const JointView& joint, const LinkMotion& motion, ArticulatedInertia& inertia, Spatial& bias) {
    const auto j = static_cast<std::size_t>(joint.index);
    const std::string& name = setup_.link_name(joint.child);
    setup_.trace.section(name, "link " + name + ": velocity and bias acceleration");
    const LinkMotion child = child_motion(setup_.pose(joint.index), joint.revolute, motion, qd_[j], Expression());
    algorithm::name(graph(), child.angular.w, name + "_w");
    algorithm::name(graph(), child.angular.wd, name + "_wd");
    algorithm::name(graph(), child.a, name + "_a");
    ArticulatedInertia x;
    Spatial p;
    collect(joint.child, child, x, p);

    setup_.trace.section(name, "joint " + setup_.tree().joints[j].name + ": articulated inertia about its axis");
    const std::size_t z = 2;
    JointState& state = joints_[j];
    state.column = joint.revolute ? Spatial{{x.a[0][z], x.a[1][z], x.a[z][z]}, x.b[z]}
                                  : Spatial{{x.b[0][z], x.b[1][z], x.b[z][z]}, {x.m[0][z], x.m[1][z], x.m[z][z]}};
    const Expression along = joint.revolute ? state.column.angular[z] : state.column.linear[z];
    state.inverse = graph().one() / along;
    state.surplus = tau_[j] - (joint.revolute ? p.angular[z] : p.linear[z]);
    graph().name(state.inverse, name + "_Dinv");
    graph().name(state.surplus, name + "_u");
    if (!setup_.parent_matters(joint.child)) return;
    const Spatial gain{state.inverse * state.column.angular, state.inverse * state.column.linear};
    release(joint.revolute, state.column, gain, x);
    // The joint passes the wrench on, the surplus taken off; what is left about its axis is exactly tau.
    p.angular += state.surplus * gain.angular;
    p.linear += state.surplus * gain.linear;
    (joint.revolute ? p.angular[z] : p.linear[z]) = tau_[j];
    inertia = inertia + to_parent(setup_.pose(joint.index), x);
    bias += algorithm::to_parent(setup_.pose(joint.index), p);
  }

  // Takes out of the inertia what the joint lets go: x - column column' / D. Row and column of the axis become zero.
  static void release(bool revolute, const Spatial& column, const Spatial& gain, ArticulatedInertia& x) {
    const std::size_t z = 2;
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = r; c < 3; ++c) {
        x.a[r][c] = x.a[c][r] = revolute && c == z ? Expression() : x.a[r][c] - column.angular[r] * gain.angular[c];
        x.m[r][c] = x.m[c][r] = !revolute && c == z ? Expression() : x.m[r][c] - column.linear[r] * gain.linear[c];
      }
    }
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) {
        const bool axis = revolute ? r == z : c == z;
        const Expression share = revolute ? gain.angular[r] * column.linear[c] : column.angular[r] * gain.linear[c];
        x.b[r][c] = axis ? Expression() : x.b[r][c] - share;
      }
    }
  }

  void name_inertia(const std::string& link, const ArticulatedInertia& x) {
    const char* axes = "xyz";
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) {
        const std::string suffix = {axes[r], axes[c]};
        if (c >= r) graph().name(x.a[r][c], link + "_A" + suffix);
        graph().name(x.b[r][c], link + "_B" + suffix);
        if (c >= r) graph().name(x.m[r][c], link + "_M" + suffix);
      }
    }
  }

 public:
  std::vector<Expression> qdd = std::vector<Expression>(tau_.size());
};

// -[A B; B' M]^-1 bias.
Spatial free_acceleration(Trace& trace, const ArticulatedInertia& x, const Spatial& bias) {
  trace.section(trace.tree.links[0].name, "base: acceleration");
  std::vector<std::vector<Expression>> matrix(6, std::vector<Expression>(6));
  std::vector<Expression> right(6);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      matrix[i][j] = x.a[i][j];
      matrix[i][3 + j] = x.b[i][j];
      matrix[3 + j][i] = x.b[i][j];
      matrix[3 + i][3 + j] = x.m[i][j];
    }
    right[i] = -bias.angular[i];
    right[3 + i] = -bias.linear[i];
  }
  const std::vector<Expression> s = solve(matrix, right);
  return {{s[0], s[1], s[2]}, {s[3], s[4], s[5]}};
}

}  // namespace

ForwardMotion by_articulated_bodies(const Setup& setup, const ForwardInputs& in, const LoadInputs& load) {
  ArticulatedBodies bodies(setup, in.qd, in.tau, load);
  ArticulatedInertia inertia;
  Spatial bias, acceleration;
  bodies.collect(0, base_motion(in.base_velocity, {}, load.gravity), inertia, bias);
  if (setup.floating()) acceleration = free_acceleration(setup.trace, inertia, bias);
  bodies.accelerate(0, acceleration);
  return {bodies.qdd, acceleration};
}

}  // namespace robcogen::algorithm
