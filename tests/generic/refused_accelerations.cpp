// Calls that must not compile, each with one message (check_refused.cmake).
#include "robcogen/generic/all_joints.h"
#include "tiny_robots.h"

using namespace robcogen;
using namespace robcogen::test;

struct Nothing {};
struct OfThreeJoints {
  Eigen::Vector3d qdd;
};

// expected: an impact changes velocities at once: use after_impact(state, result)
State<Floating> a(const State<Floating>& s) {
  return integrate(s, ImpactFloating(), 0.1);
}
// expected: loop_constrained_forward_dynamics has the accelerations of all joints
State<Fixed> b(const State<Fixed>& s) {
  return integrate(s, LoopConstrained(), 0.1);
}
// expected: the result of inverse_dynamics has the acceleration of the base only
State<Floating> c(const State<Floating>& s) {
  return integrate(s, Floating::InverseDynamics(), 0.1);
}
// expected: with a floating base, the acceleration of the base is missing
State<Floating> d(const State<Floating>& s) {
  return integrate(s, Eigen::Vector2d(1, 2), 0.1);
}
// expected: `qdd` is not a vector with one element for each joint of this robot
State<Fixed> e(const State<Fixed>& s) {
  return integrate(s, OfThreeJoints(), 0.1);
}
// expected: the accelerations must be a result with a member `qdd`
State<Fixed> f(const State<Fixed>& s) {
  return runge_kutta_step(s, 0.1, [](const State<Fixed>&) { return Nothing(); });
}
// expected: the accelerations must be a result of loop_constrained_forward_dynamics
AllJointsState<Fixed> g(const AllJointsState<Fixed>& s) {
  return integrate(s, Eigen::Vector3d(1, 2, 3), 0.1);
}
