// Conversion of states from and to the arrays of MuJoCo, Pinocchio, RBDL, Drake and ROS.
//
//     const auto match = robcogen::match_joints(quadruped::kJointNames, names_of_the_other_library);
//     if (!match.order) …                                   // match.problem and match.name say why
//     robcogen::to_mujoco(state, *match.order, qpos, qvel);
//     state = robcogen::from_mujoco<State>(qpos, qvel, *match.order);
//
// A state is a robcogen::State<R>, or any default-constructible struct with Eigen vectors q and qd and, if the base
// floats, a pose and a base_velocity. The base body of the other library must have the frame of the base here, and its
// coordinates must come first in the arrays, as those of a URDF's root do; the world is the same. Joints, in any order,
// have one variable or, except for Drake and ROS, are spherical. A fixed base has no coordinates in any of these
// libraries.
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
// Linear velocities are those of the base origin. The quaternion of a spherical joint is w x y z in MuJoCo and x y z w
// in Pinocchio; in RBDL it is x y z at the joint, with w at the end, after that of the base. Its velocities are the
// same in all three, in axes of the child. Nothing allocates or throws.
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

template <std::size_t kDof, std::size_t kBalls = 0>
struct JointMatch;

template <std::size_t kDof, std::size_t kBalls, class Names>
JointMatch<kDof, kBalls> match_joints(
    const std::array<const char*, kDof>& ours,
    const std::array<int, kBalls>& quaternions,
    const Names& theirs) noexcept;

// Where another library has the scalar part of a quaternion: before the vector part, after it, or after the last joint,
// where all scalar parts are in the order of the joints.
enum class ScalarPart { first, last, behind_all };

// Maps the joints of a robot, kBalls of them spherical, to their indices in the vectors of another library.
template <std::size_t kDof, std::size_t kBalls = 0>
class JointOrder {
 public:
  // Index of our joint in their velocities, and in their positions if no joint is spherical.
  constexpr int operator[](std::size_t joint) const noexcept { return places_[joint]; }

  // Convert vectors with one element per velocity.
  template <class Ours, class Number>
  void to(const Ours& ours, Number* theirs) const noexcept {
    for (std::size_t j = 0; j < kDof; ++j) theirs[places_[j]] = static_cast<Number>(ours[static_cast<Eigen::Index>(j)]);
  }
  template <class Ours, class Number>
  void from(const Number* theirs, Ours& ours) const noexcept {
    using Scalar = std::decay_t<decltype(ours[0])>;
    for (std::size_t j = 0; j < kDof; ++j) ours[static_cast<Eigen::Index>(j)] = static_cast<Scalar>(theirs[places_[j]]);
  }

  // Converts positions. `others` counts the scalar parts of the base that precede those of the joints at the end.
  template <class Ours, class Number>
  void positions_to(const Ours& q, ScalarPart scalar, int others, Number* theirs) const noexcept {
    visit(scalar, others, [&](int own, int place) { theirs[place] = static_cast<Number>(q[own]); });
  }
  // Normalises the quaternions.
  template <class Ours, class Number>
  void positions_from(const Number* theirs, ScalarPart scalar, int others, Ours& q) const noexcept {
    using Scalar = std::decay_t<decltype(q[0])>;
    visit(scalar, others, [&](int own, int place) { q[own] = static_cast<Scalar>(theirs[place]); });
    for (const int first : quaternions_) q.template segment<4>(first).normalize();
  }

 private:
  template <std::size_t n, std::size_t m, class Names>
  friend JointMatch<n, m> match_joints(
      const std::array<const char*, n>& ours,
      const std::array<int, m>& quaternions,
      const Names& theirs) noexcept;

  constexpr JointOrder(
      const std::array<int, kDof>& places,
      const std::array<int, kBalls>& quaternions,
      const std::array<int, kBalls>& ordinals) noexcept
      : places_(places), quaternions_(quaternions), ordinals_(ordinals) {}

  // Calls visit(index in q, index in theirs) for each element of q.
  template <class Visit>
  void visit(ScalarPart scalar, int others, const Visit& visit) const noexcept {
    std::size_t ball = 0;
    int own = 0;
    for (std::size_t j = 0; j < kDof; ++own) {
      int place = places_[j];
      // Each spherical joint before this one has one position more than it has velocities.
      for (std::size_t b = 0; scalar != ScalarPart::behind_all && b < kBalls; ++b)
        if (places_[static_cast<std::size_t>(quaternions_[b]) - b] < places_[j]) ++place;
      if (ball == kBalls || quaternions_[ball] != own) {
        visit(own, place);
        ++j;
        continue;
      }
      const int behind_all = static_cast<int>(kDof) + others + ordinals_[ball++];
      visit(own, scalar == ScalarPart::first ? place : scalar == ScalarPart::last ? place + 3 : behind_all);
      for (int k = 0; k < 3; ++k) visit(++own, place + k + (scalar == ScalarPart::first ? 1 : 0));
      j += 3;
    }
  }

  std::array<int, kDof> places_;
  std::array<int, kBalls> quaternions_;  // elements of q where they begin
  std::array<int, kBalls> ordinals_;     // index of each among their spherical joints
};

enum class JointProblem {
  none,
  missing,   // the other list does not have this joint
  unknown,   // the robot does not have this joint
  repeated,  // the other list has this joint more than once
};

// There is no order if there is a problem; `name` is then the name of the joint, a view of the caller's text.
template <std::size_t kDof, std::size_t kBalls>
struct JointMatch {
  std::optional<JointOrder<kDof, kBalls>> order;
  JointProblem problem = JointProblem::none;
  std::string_view name;
};

// `ours` are the generated kJointNames, `theirs` the names of the other library's joints in the order of its vectors,
// without the base: any range of strings. A null pointer is a joint without a name, which the robot does not have.
template <std::size_t kDof, class Names>
JointMatch<kDof> match_joints(const std::array<const char*, kDof>& ours, const Names& theirs) noexcept {
  return match_joints(ours, std::array<int, 0>{}, theirs);
}

// The same for any robot: `quaternions` is its Robot::kQuaternions, or kQuaternions<R> (positions.h). `theirs` has one
// name for a spherical joint, that of the document: `hip` for our `hip_x`, `hip_y` and `hip_z`.
template <std::size_t kDof, std::size_t kBalls, class Names>
JointMatch<kDof, kBalls> match_joints(
    const std::array<const char*, kDof>& ours,
    const std::array<int, kBalls>& quaternions,
    const Names& theirs) noexcept {
  std::array<int, kDof> places{};
  std::array<bool, kDof> found{};
  std::array<int, kBalls> ordinals{};
  // For each joint: -1 if it is not spherical, the index of the spherical joint for its first component, and kBalls for
  // its other components.
  std::array<int, kDof> balls{};
  balls.fill(-1);
  for (std::size_t b = 0; b < kBalls; ++b)
    for (std::size_t k = 0; k < 3; ++k)
      balls[static_cast<std::size_t>(quaternions[b]) - b + k] = static_cast<int>(k == 0 ? b : kBalls);
  const auto name_of = [&](std::size_t joint) {
    std::string_view name = ours[joint];
    if (balls[joint] >= 0) name.remove_suffix(2);
    return name;
  };
  const auto is_joint = [&](std::size_t joint) { return balls[joint] != static_cast<int>(kBalls); };
  int place = 0, ball = 0;
  for (const auto& item : theirs) {
    std::string_view name;
    if constexpr (std::is_pointer_v<std::decay_t<decltype(item)>>) {
      if (item != nullptr) name = item;
    } else {
      name = item;
    }
    std::size_t joint = 0;
    while (joint < kDof && !(is_joint(joint) && name == name_of(joint))) ++joint;
    if (joint == kDof) return {std::nullopt, JointProblem::unknown, name};
    if (found[joint]) return {std::nullopt, JointProblem::repeated, name};
    found[joint] = true;
    places[joint] = place++;
    if (balls[joint] < 0) continue;
    ordinals[static_cast<std::size_t>(balls[joint])] = ball++;
    for (std::size_t k = 1; k < 3; ++k) places[joint + k] = place++;
  }
  for (std::size_t j = 0; j < kDof; ++j)
    if (is_joint(j) && !found[j]) return {std::nullopt, JointProblem::missing, name_of(j)};
  return {JointOrder<kDof, kBalls>(places, quaternions, ordinals), JointProblem::none, {}};
}

// ---- Layouts.

namespace conversions {

enum class Axes { base, world };

// Where the base is in the arrays of positions and velocities, and where the joints begin.
struct Layout {
  int position, quaternion_xyz, quaternion_w, joint_positions;
  int linear, angular, joint_velocities;
  Axes linear_axes, angular_axes;
  ScalarPart scalar;  // of spherical joints
};

constexpr int kAfterJoints = -1;

inline constexpr Layout kMujoco{0, 4, 3, 7, 0, 3, 6, Axes::world, Axes::base, ScalarPart::first};
inline constexpr Layout kPinocchio{0, 3, 6, 7, 0, 3, 6, Axes::base, Axes::base, ScalarPart::last};
inline constexpr Layout kRbdl{0, 3, kAfterJoints, 6, 0, 3, 6, Axes::world, Axes::base, ScalarPart::behind_all};
inline constexpr Layout kDrake{4, 1, 0, 7, 3, 0, 6, Axes::world, Axes::world, ScalarPart::first};

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

// Whether the order is that of a robot with as many positions and velocities as the state.
template <class State, std::size_t kDof, std::size_t kBalls = 0>
constexpr bool kFits = std::decay_t<decltype(std::declval<State&>().q)>::SizeAtCompileTime ==
                           static_cast<int>(kDof + kBalls) &&
                       std::decay_t<decltype(std::declval<State&>().qd)>::SizeAtCompileTime == static_cast<int>(kDof);

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

template <class State, std::size_t kDof, std::size_t kBalls, class Number>
void to_arrays(
    const Layout& layout,
    const State& state,
    const JointOrder<kDof, kBalls>& order,
    Number* positions,
    Number* velocities) noexcept {
  static_assert(kFits<State, kDof, kBalls>, "the order is that of another robot, or lacks its quaternions");
  if constexpr (HasPose<State>::value) {
    base_to_arrays(layout, state, place_of_w(layout, kDof), positions, velocities);
    positions += layout.joint_positions;
    velocities += layout.joint_velocities;
  }
  order.positions_to(state.q, layout.scalar, HasPose<State>::value ? 1 : 0, positions);
  order.to(state.qd, velocities);
}

template <class State, std::size_t kDof, std::size_t kBalls, class Number>
State from_arrays(
    const Layout& layout,
    const Number* positions,
    const Number* velocities,
    const JointOrder<kDof, kBalls>& order) noexcept {
  static_assert(kFits<State, kDof, kBalls>, "the order is that of another robot, or lacks its quaternions");
  State state;
  if constexpr (HasPose<State>::value) {
    base_from_arrays(layout, positions, velocities, place_of_w(layout, kDof), state);
    positions += layout.joint_positions;
    velocities += layout.joint_velocities;
  }
  order.positions_from(positions, layout.scalar, HasPose<State>::value ? 1 : 0, state.q);
  order.from(velocities, state.qd);
  return state;
}

}  // namespace conversions

// ---- Conversions for each library. Arrays have one position and one velocity for each joint of one variable, four
// positions and three velocities for each spherical joint, and seven positions and six velocities for a floating base.

template <class State, std::size_t kDof, std::size_t kBalls, class Number>
void to_mujoco(const State& state, const JointOrder<kDof, kBalls>& order, Number* qpos, Number* qvel) noexcept {
  conversions::to_arrays(conversions::kMujoco, state, order, qpos, qvel);
}
template <class State, std::size_t kDof, std::size_t kBalls, class Number>
State from_mujoco(const Number* qpos, const Number* qvel, const JointOrder<kDof, kBalls>& order) noexcept {
  return conversions::from_arrays<State>(conversions::kMujoco, qpos, qvel, order);
}

template <class State, std::size_t kDof, std::size_t kBalls, class Number>
void to_pinocchio(const State& state, const JointOrder<kDof, kBalls>& order, Number* q, Number* v) noexcept {
  conversions::to_arrays(conversions::kPinocchio, state, order, q, v);
}
template <class State, std::size_t kDof, std::size_t kBalls, class Number>
State from_pinocchio(const Number* q, const Number* v, const JointOrder<kDof, kBalls>& order) noexcept {
  return conversions::from_arrays<State>(conversions::kPinocchio, q, v, order);
}

template <class State, std::size_t kDof, std::size_t kBalls, class Number>
void to_rbdl(const State& state, const JointOrder<kDof, kBalls>& order, Number* Q, Number* QDot) noexcept {
  conversions::to_arrays(conversions::kRbdl, state, order, Q, QDot);
}
template <class State, std::size_t kDof, std::size_t kBalls, class Number>
State from_rbdl(const Number* Q, const Number* QDot, const JointOrder<kDof, kBalls>& order) noexcept {
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

// The numbers of nav_msgs/Odometry, in the order of Pinocchio: the pose in the frame of the message, and the twist in
// the axes of its child frame, which is that of the base.
struct Odometry {
  std::array<double, 7> pose{0, 0, 0, 0, 0, 0, 1};  // position x y z, orientation x y z w
  std::array<double, 6> twist{};                    // linear, angular
};

// `position` and `velocity` are those of sensor_msgs/JointState, and `order` is the order of its names. A message may
// leave out its velocities: check its sizes first. A fixed base has no odometry: use order.to(state.q, position).
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
