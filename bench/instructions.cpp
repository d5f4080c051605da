// Calls one function of a generated library repeatedly, for a program that counts instructions (instructions.sh):
//     instructions inverse_dynamics|inverse_dynamics_base_free|forward_dynamics|joint_space_inertia <calls>
#include <subject/subject.h>

#include <Eigen/Core>
#include <array>
#include <cstdlib>
#include <random>
#include <string>

namespace {

using subject::JointState;
using subject::Robot;

struct State {
  JointState q, qd, qdd, tau;
  robcogen::Twist base_velocity;
  robcogen::SpatialAcceleration base_acceleration;
};

template <class Vector>
Vector random_vector(std::mt19937& engine) {
  Vector v;
  for (int i = 0; i < static_cast<int>(sizeof(Vector) / sizeof(double)); ++i)
    v.data()[i] = std::uniform_real_distribution<double>(-2, 2)(engine);
  return v;
}

std::array<State, 64> random_states() {
  std::mt19937 engine(1);
  std::array<State, 64> states;
  for (State& s : states) {
    for (JointState* v : {&s.q, &s.qd, &s.qdd, &s.tau}) *v = random_vector<JointState>(engine);
    s.base_velocity = random_vector<robcogen::Twist>(engine);
    s.base_acceleration = random_vector<robcogen::SpatialAcceleration>(engine);
  }
  return states;
}

template <class Call>
void repeat(int calls, const Call& call) {
  const std::array<State, 64> states = random_states();
  for (int i = 0; i < calls; ++i) {
    auto result = call(states[static_cast<unsigned>(i) % states.size()]);
    asm volatile("" : : "g"(&result) : "memory");  // the compiler must assume a reader
  }
}

// As in the comparison with other libraries, the acceleration of a floating base is given.
template <class R>
bool run(const std::string& function, int calls) {
  if (function == "inverse_dynamics") {
    repeat(calls, [](const State& s) {
      if constexpr (R::kFloatingBase) {
        return R::inverse_dynamics_fully_actuated(
            s.q, s.qd, s.qdd, s.base_velocity, s.base_acceleration, robcogen::kStandardGravity);
      } else {
        return R::inverse_dynamics(s.q, s.qd, s.qdd);
      }
    });
  } else if (function == "inverse_dynamics_base_free") {
    if constexpr (R::kFloatingBase)
      repeat(calls, [](const State& s) {
        return R::inverse_dynamics(s.q, s.qd, s.qdd, s.base_velocity, robcogen::kStandardGravity);
      });
    return R::kFloatingBase;
  } else if (function == "forward_dynamics") {
    repeat(calls, [](const State& s) {
      if constexpr (R::kFloatingBase) {
        return R::forward_dynamics(s.q, s.qd, s.tau, s.base_velocity, robcogen::kStandardGravity);
      } else {
        return R::forward_dynamics(s.q, s.qd, s.tau);
      }
    });
  } else if (function == "joint_space_inertia") {
    repeat(calls, [](const State& s) { return R::joint_space_inertia(s.q); });
  } else {
    return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  return argc == 3 && run<Robot>(argv[1], std::atoi(argv[2])) ? 0 : 2;
}
