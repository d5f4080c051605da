// At rest, the motor of the vertical slider carries the weight of all moving links.
#include <left/leg/leg.h>
#include <right/leg/leg.h>
#include <slow/leg/leg.h>

#include <cmath>

template <class State, class Force>
bool carries(const Force& force, double mass) {
  const State zero = State::Zero();
  return std::abs(std::abs(force(zero, zero, zero)[0]) - mass * 9.81) < 1e-9;
}

int main() {
  const auto left_force = [](auto&... state) { return left::leg::inverse_dynamics(state...); };
  const auto right_force = [](auto&... state) { return right::leg::inverse_dynamics(state...); };
  const auto slow_force = [](auto&... state) { return slow::leg::inverse_dynamics(state...); };
  const bool is_right = carries<left::leg::JointState>(left_force, left::leg::kTotalMass) &&
                        carries<right::leg::JointState>(right_force, right::leg::kTotalMass) &&
                        carries<slow::leg::JointState>(slow_force, slow::leg::kTotalMass);
  return is_right && right::leg::kTotalMass - left::leg::kTotalMass > 1.5 ? 0 : 1;
}
