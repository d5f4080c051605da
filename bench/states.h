// The states over which one robot's functions are timed.
#pragma once

#include <algorithm>
#include <vector>

#include "robcogen/reference/compiled_robot.h"
#include "robcogen/reference/samples.h"
#include "robcogen/spatial.h"

namespace robcogen::bench {

using reflection::Robot;

// Too many for branch and value predictors to learn, few enough to stay in the near caches.
constexpr std::size_t kStates = 1024;
constexpr std::uint64_t kSeed = 20;

// The arguments of one call, in the types that the functions of `R`, the robot's traits, take.
template <class R>
struct State {
  const R* robot;
  typename R::JointState q, qd, qdd, tau;
  Twist base_velocity;
  SpatialAcceleration base_acceleration;
};

// Converts to a type of the library, which stores its elements contiguously.
template <class To>
To converted(const reference::Vector<double>& from) {
  To to;
  std::copy(from.data(), from.data() + from.rows(), to.data());
  return to;
}

// kStates random states for this instance, the same in every run; a fixed base is at rest.
template <class R>
std::vector<State<R>> random_states(const Robot& robot, const R& instance) {
  using Joints = typename R::JointState;
  std::mt19937_64 engine(kSeed);
  std::vector<State<R>> states;
  for (std::size_t i = 0; i < kStates; ++i) {
    const reference::Motion<double> m = reference::random_sample(engine, robot).motion;
    const auto tau = reference::uniform_vector(engine, R::kDof, 50);
    states.push_back(
        {&instance, converted<Joints>(m.q), converted<Joints>(m.qd), converted<Joints>(m.qdd), converted<Joints>(tau),
         converted<Twist>(m.base_velocity), converted<SpatialAcceleration>(m.base_acceleration)});
  }
  return states;
}

}  // namespace robcogen::bench
