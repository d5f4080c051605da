// Velocities, accelerations and forces of all links for the getters of InverseDynamics, computed when one of them is
// used. The motion that they belong to is that of the last call.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "robcogen/compatibility/iit.h"
#include "robcogen/compatibility/transforms.h"

namespace robcogen::compatibility {

// The links without the base, parents before children.
template <class Robot>
constexpr std::array<int, Robot::kLinks - 1> topological_order() {
  std::array<int, Robot::kLinks - 1> order{};
  std::array<bool, Robot::kLinks> is_placed{};
  is_placed[0] = true;
  for (std::size_t n = 0; n < order.size();)
    for (int link = 1; link < Robot::kLinks; ++link)
      if (!is_placed[std::size_t(link)] && is_placed[std::size_t(Robot::parent(link))]) {
        is_placed[std::size_t(link)] = true;
        order[n++] = link;
      }
  return order;
}

template <class Trait, class Robot>
class LinkMotions {
 public:
  using Scalar = typename Trait::Scalar;
  using Vector = typename iit::rbd::Core<Scalar>::Vector6;
  using Vector3 = typename iit::rbd::Core<Scalar>::Vector3;
  using State = JointState<Robot, Scalar>;

  // The motion of the joints and of the base, whose acceleration is relative to free fall.
  struct Motion {
    State q = zero<State>(), qd = zero<State>(), qdd = zero<State>();
    Vector base_velocity = zero<Vector>(), base_acceleration = zero<Vector>();
    bool has_wrenches = false;
    std::array<Vector, Robot::kLinks> wrenches;
  };

  // Of a link, in its coordinates. Accelerations do not include gravity: they are relative to free fall.
  Vector velocity[Robot::kLinks], acceleration[Robot::kLinks], force[Robot::kLinks];

  template <class Transforms, class Inertias>
  void compute(const Motion& motion, const Transforms& transforms, const Inertias& inertias) {
    typename iit::rbd::Core<Scalar>::Matrix66 link_X_parent[Robot::kLinks];
    Transforms::visit(transforms, [&](const auto& transform) {
      using Pair = typename std::decay_t<decltype(transform)>::Frames;
      if constexpr (has_state<MotionKind, Pair>())
        transform.compute(transforms.parameters(), motion.q, link_X_parent[Robot::child(Pair::kJoint)].data());
    });
    velocity[0] = motion.base_velocity;
    acceleration[0] = motion.base_acceleration;
    constexpr std::array<int, Robot::kLinks - 1> order = topological_order<Robot>();
    for (const int link : order) {
      const int joint = Robot::joint(link);
      const int axis = Robot::is_prismatic(joint) ? 5 : 2;
      Vector joint_velocity = zero<Vector>();
      joint_velocity(axis) = motion.qd(joint);
      velocity[link] = link_X_parent[link] * velocity[Robot::parent(link)];
      acceleration[link] = link_X_parent[link] * acceleration[Robot::parent(link)];
      acceleration[link] += crossed(velocity[link], joint_velocity);
      velocity[link](axis) += motion.qd(joint);
      acceleration[link](axis) += motion.qdd(joint);
    }
    for (int link = 0; link < Robot::kLinks; ++link) {
      const Vector momentum = inertias.tensor(link) * velocity[link];
      force[link] = inertias.tensor(link) * acceleration[link];
      force[link] += crossed_wrench(velocity[link], momentum);
      if (motion.has_wrenches) force[link] -= motion.wrenches[std::size_t(link)];
    }
    for (auto link = order.rbegin(); link != order.rend(); ++link)
      force[Robot::parent(*link)] += link_X_parent[*link].transpose() * force[*link];
  }

 private:
  template <class Value>
  static Value zero() {
    return Value::Constant(Scalar(0));
  }
  static Vector3 part(const Vector& v, int first) { return Vector3(v(first), v(first + 1), v(first + 2)); }
  static Vector joined(const Vector3& angular, const Vector3& linear) {
    Vector v;
    v << angular, linear;
    return v;
  }
  static Vector crossed(const Vector& v, const Vector& m) {
    return joined(part(v, 0).cross(part(m, 0)), part(v, 0).cross(part(m, 3)) + part(v, 3).cross(part(m, 0)));
  }
  static Vector crossed_wrench(const Vector& v, const Vector& f) {
    return joined(part(v, 0).cross(part(f, 0)) + part(v, 3).cross(part(f, 3)), part(v, 0).cross(part(f, 3)));
  }
};

}  // namespace robcogen::compatibility
