// The states over which one robot's functions are timed.
#pragma once

#include <algorithm>
#include <cmath>
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

// A state as vectors.
struct Sample {
  reference::Motion<double> motion;
  reference::Vector<double> tau;
};

inline Sample random_sample(std::mt19937_64& engine, const Robot& robot) {
  const reference::Motion<double> motion = reference::random_sample(engine, robot).motion;
  return {motion, reference::uniform_vector(engine, robot.dof(), 50)};
}

template <class R>
State<R> state(const R& instance, const Sample& sample) {
  using Joints = typename R::JointState;
  const reference::Motion<double>& m = sample.motion;
  return {
      &instance,
      converted<Joints>(m.q),
      converted<Joints>(m.qd),
      converted<Joints>(m.qdd),
      converted<Joints>(sample.tau),
      converted<Twist>(m.base_velocity),
      converted<SpatialAcceleration>(m.base_acceleration)};
}

// kStates random states for this instance, the same in every run; a fixed base is at rest.
template <class R>
std::vector<State<R>> random_states(const Robot& robot, const R& instance) {
  std::mt19937_64 engine(kSeed);
  std::vector<State<R>> states;
  for (std::size_t i = 0; i < kStates; ++i) states.push_back(state(instance, random_sample(engine, robot)));
  return states;
}

// As many states of a smooth motion from one random state to another, as a controller sees them. From one to the next,
// an angle changes by 0.01 rad at most, so that predictors of branches are mostly right.
template <class R>
std::vector<State<R>> states_of_trajectory(const Robot& robot, const R& instance) {
  std::mt19937_64 engine(kSeed);
  const Sample from = random_sample(engine, robot), to = random_sample(engine, robot);
  std::vector<State<R>> states;
  for (std::size_t i = 0; i < kStates; ++i) {
    const double share = 0.5 - 0.5 * std::cos(3.14159265358979323846 * static_cast<double>(i) / kStates);
    const auto between = [&](const reference::Vector<double>& a, const reference::Vector<double>& b) {
      return reference::Vector<double>(a + share * (b - a));
    };
    const reference::Motion<double>&a = from.motion, &b = to.motion;
    Sample sample = from;
    sample.motion.q = between(a.q, b.q);
    sample.motion.qd = between(a.qd, b.qd);
    sample.motion.qdd = between(a.qdd, b.qdd);
    sample.motion.base_velocity = between(a.base_velocity, b.base_velocity);
    sample.motion.base_acceleration = between(a.base_acceleration, b.base_acceleration);
    sample.tau = between(from.tau, to.tau);
    states.push_back(state(instance, sample));
  }
  return states;
}

}  // namespace robcogen::bench
