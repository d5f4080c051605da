// Whole states from and to the arrays of MuJoCo, Pinocchio, RBDL, Drake and ROS.
//
//     const auto match = robcogen::match_joints(quadruped::kJointNames, names_of_the_other_library);
//     if (!match.order) …                                   // match.problem and match.name say why
//     robcogen::to_mujoco(state, *match.order, qpos, qvel);
//     state = robcogen::from_mujoco<State>(qpos, qvel, *match.order);
//
// A state is a robcogen::State<R>, or any default-constructible struct with Eigen vectors q and qd and, if the base
// floats, a pose and a base_velocity. The base body of the other library must have the frame of the base here, and its
// coordinates the first places of the arrays, as a URDF's root has them; the world is the same. Joints are those of one
// variable, in any order. A fixed base has no coordinates in any of these libraries.
//
//                        position, then velocity of a floating base                    joints
//     MuJoCo, qpos       x y z, quaternion w x y z                                     after the base
//             qvel       linear in world axes, angular in base axes                    after the base
//     Pinocchio, q       x y z, quaternion x y z w                                     after the base
//             v          linear in base axes, angular in base axes                     after the base
//     RBDL, Q            x y z, quaternion x y z (and w at the end, after the joints)  after x y z, x y z
//             QDot       linear in world axes, angular in base axes                    after the base
//     Drake, q           quaternion w x y z, position x y z                            after the base
//             v          angular in world axes, linear in world axes                   after the base
//     ROS, Odometry      x y z, quaternion x y z w                                     JointState
//             twist      linear in base axes, angular in base axes                     JointState
//
// All velocities are those of the base origin. Nothing allocates or throws.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

#include "robcogen/pose.h"

namespace robcogen {

// ---- Joints by name.

template <std::size_t kDof>
struct JointMatch;

// Where the joints of a robot are in the vectors of another library.
template <std::size_t kDof>
class JointOrder {
 public:
  // The place of our joint.
  constexpr int operator[](std::size_t joint) const noexcept { return places_[joint]; }

  template <class Ours, class Number>
  void to(const Ours& ours, Number* theirs) const noexcept {
    for (std::size_t j = 0; j < kDof; ++j) theirs[places_[j]] = static_cast<Number>(ours[static_cast<Eigen::Index>(j)]);
  }
  template <class Ours, class Number>
  void from(const Number* theirs, Ours& ours) const noexcept {
    using Scalar = std::decay_t<decltype(ours[0])>;
    for (std::size_t j = 0; j < kDof; ++j) ours[static_cast<Eigen::Index>(j)] = static_cast<Scalar>(theirs[places_[j]]);
  }

 private:
  template <std::size_t n, class Names>
  friend JointMatch<n> match_joints(const std::array<const char*, n>& ours, const Names& theirs) noexcept;

  constexpr explicit JointOrder(const std::array<int, kDof>& places) noexcept : places_(places) {}

  std::array<int, kDof> places_;
};

enum class JointProblem {
  none,
  missing,   // the other list does not have this joint
  unknown,   // the robot does not have this joint
  repeated,  // the other list has this joint more than once
};

// Without an order if there is a problem; `name` is that of the joint, a view of the caller's text.
template <std::size_t kDof>
struct JointMatch {
  std::optional<JointOrder<kDof>> order;
  JointProblem problem = JointProblem::none;
  std::string_view name;
};

// `ours` are the generated kJointNames, `theirs` the names of the other library's joints in the order of its vectors,
// without the base: any range of strings. A null pointer is a joint without a name, which the robot does not have.
template <std::size_t kDof, class Names>
JointMatch<kDof> match_joints(const std::array<const char*, kDof>& ours, const Names& theirs) noexcept {
  std::array<int, kDof> places{};
  std::array<bool, kDof> found{};
  int place = 0;
  for (const auto& item : theirs) {
    std::string_view name;
    if constexpr (std::is_pointer_v<std::decay_t<decltype(item)>>) {
      if (item != nullptr) name = item;
    } else {
      name = item;
    }
    std::size_t joint = 0;
    while (joint < kDof && name != ours[joint]) ++joint;
    if (joint == kDof) return {std::nullopt, JointProblem::unknown, name};
    if (found[joint]) return {std::nullopt, JointProblem::repeated, name};
    found[joint] = true;
    places[joint] = place++;
  }
  for (std::size_t j = 0; j < kDof; ++j)
    if (!found[j]) return {std::nullopt, JointProblem::missing, ours[j]};
  return {JointOrder<kDof>(places), JointProblem::none, {}};
}

// ---- Layouts.

namespace conversions {

enum class Axes { base, world };

// Where the base is in the arrays of positions and velocities, and where the joints begin.
struct Layout {
  int position, quaternion_xyz, quaternion_w, joint_positions;
  int linear, angular, joint_velocities;
  Axes linear_axes, angular_axes;
};

constexpr int kAfterJoints = -1;

inline constexpr Layout kMujoco{0, 4, 3, 7, 0, 3, 6, Axes::world, Axes::base};
inline constexpr Layout kPinocchio{0, 3, 6, 7, 0, 3, 6, Axes::base, Axes::base};
inline constexpr Layout kRbdl{0, 3, kAfterJoints, 6, 0, 3, 6, Axes::world, Axes::base};
inline constexpr Layout kDrake{4, 1, 0, 7, 3, 0, 6, Axes::world, Axes::world};

template <class State, class = void>
struct HasPose : std::false_type {};
template <class State>
struct HasPose<State, std::void_t<decltype(std::declval<State&>().pose)>> : std::true_type {};

template <class Number, class Vector>
void write(const Vector& from, Number* to) noexcept {
  for (Eigen::Index i = 0; i < from.size(); ++i) to[i] = static_cast<Number>(from[i]);
}

template <class Scalar, class Number>
Eigen::Matrix<Scalar, 3, 1> read(const Number* from) noexcept {
  return {static_cast<Scalar>(from[0]), static_cast<Scalar>(from[1]), static_cast<Scalar>(from[2])};
}

inline int place_of_w(const Layout& layout, std::size_t dof) noexcept {
  return layout.quaternion_w == kAfterJoints ? layout.joint_positions + static_cast<int>(dof) : layout.quaternion_w;
}

// The order is that of a robot with as many joints.
template <class State, std::size_t kDof>
constexpr bool kFits = std::decay_t<decltype(std::declval<State&>().q)>::SizeAtCompileTime == static_cast<int>(kDof);

template <class State, class Number>
void base_to_arrays(const Layout& layout, const State& state, int w, Number* positions, Number* velocities) noexcept {
  const auto& pose = state.pose;
  const auto quaternion = pose.quaternion_xyzw();
  const auto linear = state.base_velocity.linear(), angular = state.base_velocity.angular();
  write(pose.position(), positions + layout.position);
  write(quaternion.template head<3>(), positions + layout.quaternion_xyz);
  positions[w] = static_cast<Number>(quaternion[3]);
  write(layout.linear_axes == Axes::world ? pose.to_world_axes(linear) : linear, velocities + layout.linear);
  write(layout.angular_axes == Axes::world ? pose.to_world_axes(angular) : angular, velocities + layout.angular);
}

template <class State, class Number>
void base_from_arrays(
    const Layout& layout,
    const Number* positions,
    const Number* velocities,
    int w,
    State& state) noexcept {
  using Pose = std::decay_t<decltype(state.pose)>;
  using Scalar = typename Pose::Scalar;
  const auto xyz = read<Scalar>(positions + layout.quaternion_xyz),
             position = read<Scalar>(positions + layout.position);
  const auto linear = read<Scalar>(velocities + layout.linear), angular = read<Scalar>(velocities + layout.angular);
  state.pose = Pose::from_quaternion_xyzw(xyz[0], xyz[1], xyz[2], static_cast<Scalar>(positions[w]), position);
  state.base_velocity = BasicTwist<Scalar>(
      layout.angular_axes == Axes::world ? state.pose.to_base_axes(angular) : angular,
      layout.linear_axes == Axes::world ? state.pose.to_base_axes(linear) : linear);
}

template <class State, std::size_t kDof, class Number>
void to_arrays(
    const Layout& layout,
    const State& state,
    const JointOrder<kDof>& order,
    Number* positions,
    Number* velocities) noexcept {
  static_assert(kFits<State, kDof>, "the order is that of another robot");
  if constexpr (HasPose<State>::value) {
    base_to_arrays(layout, state, place_of_w(layout, kDof), positions, velocities);
    positions += layout.joint_positions;
    velocities += layout.joint_velocities;
  }
  order.to(state.q, positions);
  order.to(state.qd, velocities);
}

template <class State, std::size_t kDof, class Number>
State from_arrays(
    const Layout& layout,
    const Number* positions,
    const Number* velocities,
    const JointOrder<kDof>& order) noexcept {
  static_assert(kFits<State, kDof>, "the order is that of another robot");
  State state;
  if constexpr (HasPose<State>::value) {
    base_from_arrays(layout, positions, velocities, place_of_w(layout, kDof), state);
    positions += layout.joint_positions;
    velocities += layout.joint_velocities;
  }
  order.from(positions, state.q);
  order.from(velocities, state.qd);
  return state;
}

}  // namespace conversions

// ---- One library after another. With a floating base of n joints, arrays of positions have 7 + n elements and those
// of velocities 6 + n; otherwise n each.

template <class State, std::size_t kDof, class Number>
void to_mujoco(const State& state, const JointOrder<kDof>& order, Number* qpos, Number* qvel) noexcept {
  conversions::to_arrays(conversions::kMujoco, state, order, qpos, qvel);
}
template <class State, std::size_t kDof, class Number>
State from_mujoco(const Number* qpos, const Number* qvel, const JointOrder<kDof>& order) noexcept {
  return conversions::from_arrays<State>(conversions::kMujoco, qpos, qvel, order);
}

template <class State, std::size_t kDof, class Number>
void to_pinocchio(const State& state, const JointOrder<kDof>& order, Number* q, Number* v) noexcept {
  conversions::to_arrays(conversions::kPinocchio, state, order, q, v);
}
template <class State, std::size_t kDof, class Number>
State from_pinocchio(const Number* q, const Number* v, const JointOrder<kDof>& order) noexcept {
  return conversions::from_arrays<State>(conversions::kPinocchio, q, v, order);
}

template <class State, std::size_t kDof, class Number>
void to_rbdl(const State& state, const JointOrder<kDof>& order, Number* Q, Number* QDot) noexcept {
  conversions::to_arrays(conversions::kRbdl, state, order, Q, QDot);
}
template <class State, std::size_t kDof, class Number>
State from_rbdl(const Number* Q, const Number* QDot, const JointOrder<kDof>& order) noexcept {
  return conversions::from_arrays<State>(conversions::kRbdl, Q, QDot, order);
}

template <class State, std::size_t kDof, class Number>
void to_drake(const State& state, const JointOrder<kDof>& order, Number* q, Number* v) noexcept {
  conversions::to_arrays(conversions::kDrake, state, order, q, v);
}
template <class State, std::size_t kDof, class Number>
State from_drake(const Number* q, const Number* v, const JointOrder<kDof>& order) noexcept {
  return conversions::from_arrays<State>(conversions::kDrake, q, v, order);
}

// The numbers of nav_msgs/Odometry: the pose in its frame, the twist in the axes of its child frame, that of the base.
// They have the order of Pinocchio.
struct Odometry {
  std::array<double, 7> pose{0, 0, 0, 0, 0, 0, 1};  // position x y z, orientation x y z w
  std::array<double, 6> twist{};                    // linear, angular
};

// `position` and `velocity` are those of sensor_msgs/JointState, `order` that of its names. A message may leave its
// velocities out: check its sizes first. A fixed base has no odometry: order.to(state.q, position).
template <class State, std::size_t kDof>
void to_ros(
    const State& state,
    const JointOrder<kDof>& order,
    Odometry& odometry,
    double* position,
    double* velocity) noexcept {
  static_assert(conversions::kFits<State, kDof>, "the order is that of another robot");
  constexpr conversions::Layout layout = conversions::kPinocchio;
  conversions::base_to_arrays(layout, state, layout.quaternion_w, odometry.pose.data(), odometry.twist.data());
  order.to(state.q, position);
  order.to(state.qd, velocity);
}
template <class State, std::size_t kDof>
State from_ros(
    const Odometry& odometry,
    const double* position,
    const double* velocity,
    const JointOrder<kDof>& order) noexcept {
  static_assert(conversions::kFits<State, kDof>, "the order is that of another robot");
  constexpr conversions::Layout layout = conversions::kPinocchio;
  State state;
  conversions::base_from_arrays(layout, odometry.pose.data(), odometry.twist.data(), layout.quaternion_w, state);
  order.from(position, state.q);
  order.from(velocity, state.qd);
  return state;
}

}  // namespace robcogen
