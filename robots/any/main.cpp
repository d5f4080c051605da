// One program for all robots: the command line names the robot to simulate.
//
//   any_robot ROBOT [SECONDS]
//
// The joints go to half a radian (or metre) by computed torque. A fixed base does not move; a floating base falls, and
// the motion of the joints turns it.
#include <centaur/centaur.h>
#include <centaur/reflection.h>
#include <hyl/hyl.h>
#include <hyl/reflection.h>
#include <puma560/puma560.h>
#include <puma560/reflection.h>
#include <quadruped/quadruped.h>
#include <quadruped/reflection.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>

#include "robcogen/any_robot.h"
#include "robcogen/pose.h"

namespace {

using robcogen::AnyRobot, robcogen::make_any;

// The program keeps its own registry of robots.
const AnyRobot* find_robot(const char* name) {
  static const AnyRobot robots[] = {
      make_any<hyl::Robot>(hyl::reflection::robot), make_any<puma560::Robot>(puma560::reflection::robot),
      make_any<quadruped::Robot>(quadruped::reflection::robot), make_any<centaur::Robot>(centaur::reflection::robot)};
  static const char* const names[] = {"hyl", "puma560", "quadruped", "centaur"};
  for (std::size_t i = 0; i < std::size(robots); ++i)
    if (std::strcmp(name, names[i]) == 0) return &robots[i];
  return nullptr;
}

void simulate(const AnyRobot& robot, double duration) {
  constexpr double kStep = 1e-3, kPole = 5;  // s, 1/s
  const Eigen::VectorXd goal = Eigen::VectorXd::Constant(robot.dof(), 0.5);
  // All memory that the loop needs.
  Eigen::VectorXd q = Eigen::VectorXd::Zero(robot.dof()), v = Eigen::VectorXd::Zero(robot.size());
  Eigen::VectorXd qdd(robot.dof()), tau(robot.dof()), a(robot.size());
  robcogen::BasePose pose;

  const int steps = static_cast<int>(duration / kStep + 0.5);
  for (int i = 0; i <= steps; ++i) {
    if (i % 200 == 0) std::printf("%6.1f s  largest error %.2e\n", i * kStep, (goal - q).cwiseAbs().maxCoeff());
    const robcogen::Gravity gravity = robcogen::gravity_in_base(pose);
    const auto qd = v.tail(robot.dof());
    qdd = kPole * kPole * (goal - q) - 2 * kPole * qd;
    robot.inverse_dynamics(q, v, qdd, tau, gravity);
    robot.forward_dynamics(q, v, tau, a, gravity);
    v += kStep * a;
    q += kStep * qd;
    if (robot.floating_base()) pose = robcogen::integrate(pose, robcogen::Twist(v.head<6>()), kStep);
  }
  if (!robot.floating_base()) return;
  const robcogen::Twist turned = robcogen::difference(robcogen::BasePose(), pose);
  std::printf(
      "the base has turned by %.3f rad and falls at %.3f m/s\n", turned.angular().norm(), v.segment<3>(3).norm());
}

}  // namespace

int main(int argc, char** argv) {
  const AnyRobot* robot = argc >= 2 ? find_robot(argv[1]) : nullptr;
  char* end = nullptr;
  const double duration = argc == 3 ? std::strtod(argv[2], &end) : 2;
  if (robot == nullptr || argc > 3 || (argc == 3 && (*end != '\0' || !(duration > 0 && duration <= 1000)))) {
    std::fprintf(stderr, "usage: %s hyl|puma560|quadruped|centaur [SECONDS]\n", argv[0]);
    return 2;
  }
  std::printf("%s: %d joints, %s base\n", robot->name(), robot->dof(), robot->floating_base() ? "floating" : "fixed");
  simulate(*robot, duration);
}
