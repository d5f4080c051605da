// The arm carries itself at 1 kHz, while a hand pushes it. The robot is simulated.
#include <picker/picker.h>
#include <robcogen/generic/simulation.h>
#include <robcogen/world.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>

using picker::JointState;
using State = robcogen::State<picker::Robot>;
using Clock = std::chrono::steady_clock;
namespace homogeneous = picker::transforms::homogeneous;

// The controller. It has no state and allocates nothing.
JointState hold(const State& measured, double share_of_friction) {
  return picker::gravity_forces(measured.q) + share_of_friction * picker::passive_forces(measured.q, measured.qd);
}

Eigen::Vector3d tool(const JointState& q) {
  return homogeneous::fr_table_X_tool(q).topRightCorner<3, 1>();
}

// One millisecond of the robot under these torques, with a force (N, axes of the table) at its tool. Friction stops the
// light wrist within 0.1 ms, so the simulation takes ten steps.
State simulated(State s, const JointState& tau, const Eigen::Vector3d& force) {
  for (int i = 0; i < 10; ++i) {
    picker::LinkWrenches external;
    external[picker::Link::hand] =
        robcogen::wrench_on_link<double>(homogeneous::fr_table_X_fr_hand(s.q), tool(s.q), force);
    s = integrate(s, picker::forward_dynamics(s.q, s.qd, tau, external), 1e-4);
  }
  return s;
}

// A second of control. A hand pushes the tool upwards with 3 N from 0.2 s to 0.4 s.
void run(const char* name, double share_of_gravity, double share_of_friction) {
  State state;
  state.q << 0.2, -0.9, 1.4, 0.0;
  const Eigen::Vector3d start = tool(state.q);
  double at_push = 0, busy = 0;
  Clock::time_point next = Clock::now();
  for (int cycle = 0; cycle < 1000; ++cycle) {
    if (cycle == 200) at_push = tool(state.q).z();
    const Clock::time_point begin = Clock::now();
    const JointState tau = share_of_gravity * hold(state, share_of_friction);
    busy += std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
    const double push = cycle >= 200 && cycle < 400 ? 3 : 0;
    state = simulated(state, tau, Eigen::Vector3d(0, 0, push));
    next += std::chrono::milliseconds(1);
    std::this_thread::sleep_until(next);
  }
  std::printf(
      "%-22s  %6.3f m before the push, %6.3f m after it, %s; ~%.1f us a cycle\n", name, at_push - start.z(),
      tool(state.q).z() - at_push, state.qd.norm() < 1e-3 ? "at rest" : "still moving", busy / 1000);
}

int main() {
  std::printf("the tool rises by\n");
  run("no torque", 0, 0);
  run("gravity", 1, 0);
  run("gravity, half friction", 1, 0.5);
}
