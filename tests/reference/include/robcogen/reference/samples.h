// Random states of a robot for checks: the same seed gives the same states everywhere.
#pragma once

#include <random>

#include "robcogen/reference/dynamics.h"

namespace robcogen::reference {

// Moderate values: any angle for joints that turn, a metre for prismatic ones, a few rad/s, tens of newtons.
struct Sample {
  Motion<double> motion;  // base velocity and acceleration are zero for a fixed base
  Vector<double> gravity;
  std::vector<Vector<double>> external;
};

// The same sample, rounded to single precision.
inline Sample in_single(Sample sample) {
  const auto round = [](Vector<double>& v) {
    for (int i = 0; i < v.rows(); ++i) v(i) = static_cast<double>(static_cast<float>(v(i)));
  };
  Motion<double>& m = sample.motion;
  for (Vector<double>* v : {&m.q, &m.qd, &m.qdd, &m.base_velocity, &m.base_acceleration, &sample.gravity}) round(*v);
  for (Vector<double>& wrench : sample.external) round(wrench);
  return sample;
}

// Uses the bits of a 64-bit engine instead of std::uniform_real_distribution, which differs between standard libraries.
inline double uniform(std::mt19937_64& engine, double limit) {
  const double unit = static_cast<double>(engine() >> 11) * 0x1p-53;
  return limit * (2 * unit - 1);
}

inline Vector<double> uniform_vector(std::mt19937_64& engine, int size, double limit) {
  Vector<double> v(size);
  for (int i = 0; i < size; ++i) v(i) = uniform(engine, limit);
  return v;
}

inline Vector<double> unit_vector(std::mt19937_64& engine, int size) {
  constexpr double kShort = 0.1;
  while (true) {
    const Vector<double> v = uniform_vector(engine, size, 1);
    const double length = std::sqrt(dot(v, v));
    if (length > kShort) return 1 / length * v;
  }
}

inline Sample random_sample(std::mt19937_64& engine, const Robot& robot) {
  constexpr double kAngle = 3.14159265358979323846, kStroke = 1, kRate = 3, kAcceleration = 10, kLoad = 20;
  constexpr double kNearAngle = 0.3, kNearStroke = 0.03;
  const int n = robot.dof();
  Sample s;
  s.motion.q = Vector<double>(robot.position_count());
  for (int j = 0; j < n; ++j) {
    const int k = robot.position_of(j);
    if (robot.is_follower(j)) continue;
    if (robot.joints[j].type == JointType::spherical)
      s.motion.q.set_block(k - 1, 0, unit_vector(engine, 4));
    else if (follows_through_loops(robot))  // near the position in which loops are assembled: others may not close
      s.motion.q(k) =
          robot.joints[j].assembled + uniform(engine, turns(robot.joints[j].type) ? kNearAngle : kNearStroke);
    else
      s.motion.q(k) = uniform(engine, turns(robot.joints[j].type) ? kAngle : kStroke);
  }
  s.motion.qd = uniform_vector(engine, n, kRate);
  s.motion.qdd = uniform_vector(engine, n, kAcceleration);
  if (robot.floating_base) {
    s.motion.base_velocity = uniform_vector(engine, 6, kRate);
    s.motion.base_acceleration = uniform_vector(engine, 6, kAcceleration);
  }
  s.gravity = uniform_vector(engine, 3, kAcceleration);
  for (int i = 0; i < robot.links.size; ++i) s.external.push_back(uniform_vector(engine, 6, kLoad));
  return s;
}

template <class Scalar>
Motion<Scalar> cast(const Motion<double>& m) {
  return {
      m.q.cast<Scalar>(),
      m.qd.cast<Scalar>(),
      m.qdd.cast<Scalar>(),
      m.base_velocity.cast<Scalar>(),
      m.base_acceleration.cast<Scalar>(),
      m.of_loops.cast<Scalar>()};
}

template <class Scalar>
Loads<Scalar> loads(const Vector<double>& gravity, const std::vector<Vector<double>>& external = {}) {
  return Loads<double>{gravity, external, true}.cast<Scalar>();
}

// Gravity only: drives do not resist motion.
template <class Scalar>
Loads<Scalar> without_passive(const Vector<double>& gravity) {
  return Loads<double>{gravity, {}, false}.cast<Scalar>();
}

}  // namespace robcogen::reference
