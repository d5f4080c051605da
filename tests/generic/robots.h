// The robots that generic code is tested on, and an initial state of each.
#pragma once

#include <gtest/gtest.h>
#include <hyl/hyl.h>
#include <hyl/reflection.h>
#include <puma560/puma560.h>
#include <puma560/reflection.h>
#include <quadruped/quadruped.h>
#include <quadruped/reflection.h>
#include <torso/reflection.h>
#include <torso/torso.h>

#include "robcogen/generic/state.h"
#include "robcogen/reference/energy.h"
#include "robcogen/reference/samples.h"

namespace robcogen::test {

struct Hyl {
  using Robot = hyl::Robot;
  static const reflection::Robot& tables() { return hyl::reflection::robot; }
};
struct Puma560 {
  using Robot = puma560::Robot;
  static const reflection::Robot& tables() { return puma560::reflection::robot; }
};
struct Quadruped {
  using Robot = quadruped::Robot;
  static const reflection::Robot& tables() { return quadruped::reflection::robot; }
};
struct Torso {
  using Robot = torso::Robot;
  static const reflection::Robot& tables() { return torso::reflection::robot; }
};

#if ROBCOGEN_TEST_EVERYTHING
using AllRobots = ::testing::Types<Hyl, Puma560, Quadruped, Torso>;
using FloatingRobots = ::testing::Types<Quadruped, Torso>;
#else
using AllRobots = ::testing::Types<Hyl, Torso>;
using FloatingRobots = ::testing::Types<Torso>;
#endif

template <class JointState>
JointState uniform_joints(std::mt19937_64& engine, double limit) {
  JointState result;
  for (double& x : result) x = reference::uniform(engine, limit);
  return result;
}

// A random posture that moves at about 1 rad/s.
template <class R>
State<R> moving_state(std::mt19937_64& engine) {
  State<R> state;
  state.q = uniform_joints<typename R::JointState>(engine, 0.5);
  state.qd = uniform_joints<typename R::JointState>(engine, 1.0);
  if constexpr (R::kFloatingBase) {
    state.pose = BasePose::from_quaternion_xyzw(0.2, -0.4, 0.1, 0.8, Eigen::Vector3d(0.3, -0.2, 1.5));
    state.base_velocity = Twist(Eigen::Vector3d(0.8, -0.5, 0.3), Eigen::Vector3d(0.2, -0.4, 1.0));
  }
  return state;
}

// Converts to the vector type of the reference.
template <class Eigens>
reference::Vector<double> vector(const Eigens& v) {
  reference::Vector<double> result(static_cast<int>(v.size()));
  std::copy(v.data(), v.data() + v.size(), result.data());
  return result;
}

inline Eigen::Vector3d eigen3(const reference::Vector<double>& v) {
  return {v(0), v(1), v(2)};
}

template <class R>
reference::Motion<double> motion_of(const State<R>& state) {
  reference::Motion<double> motion = reference::at_rest(vector(state.q));
  motion.qd = vector(state.qd);
  if constexpr (R::kFloatingBase) motion.base_velocity = vector(state.base_velocity.vector());
  return motion;
}

}  // namespace robcogen::test
