// The checks of inverse kinematics find the mistakes that they are meant to find.
#include "robcogen/reference/check_inverse_kinematics.h"

#include "sample_robots.h"

namespace robcogen::reference::check_inverse_kinematics_test {
namespace {

constexpr double kUpper = 0.4, kLower = 0.3;

enum class Fault { none, one_branch, other_sign, wrong_pose, reachable, ignores_signs, reads_inputs_twice, stretched };

// Two joints that turn about z and one that slides along it, to a point.
struct Solution {
  double sine[3], cosine[3], misfit;
};
Solution solution(const double* p, double sign, Fault fault) {
  const double square = p[0] * p[0] + p[1] * p[1];
  const double cosine = (square - kUpper * kUpper - kLower * kLower) / (2 * kUpper * kLower);
  // `stretched`: solutions that are almost singular are missed.
  const double most = fault == Fault::stretched ? 0.9 : 1;
  const double c2 = std::min(most, std::max(-most, cosine)), s2 = sign * std::sqrt(1 - c2 * c2);
  const double along = kUpper + kLower * c2, across = kLower * s2, radius = std::sqrt(along * along + across * across);
  const double length = radius * std::sqrt(square);
  const double c1 = (along * p[0] + across * p[1]) / length, s1 = (along * p[1] - across * p[0]) / length;
  double misfit = std::abs(radius - std::sqrt(square));
  if (fault == Fault::reachable && misfit > 1e-9) misfit = 0;
  return {{fault == Fault::wrong_pose && sign < 0 ? -s1 : s1, s2, p[2]}, {c1, c2, 0}, misfit};
}

template <Fault fault>
void all(const double* in, double* out) noexcept {
  for (int branch = 0; branch < 2; ++branch) {
    const double sign = branch == 0 || fault == Fault::one_branch ? 1 : -1;
    const Solution found = solution(in, sign, fault);
    std::copy_n(found.sine, 3, out + 3 * branch);
    std::copy_n(found.cosine, 3, out + 6 + 3 * branch);
    out[12 + branch] = found.misfit;
  }
}

template <Fault fault>
void branch(const double* in, double* out) noexcept {
  const Solution found = solution(in, fault == Fault::ignores_signs ? 1 : in[3], fault);
  for (int k = 0; k < 2; ++k) out[k] = std::atan2(found.sine[k], found.cosine[k]);
  out[2] = found.sine[2];
  out[3] = found.misfit;
}

template <Fault fault>
void configuration(const double* in, double* out) noexcept {
  out[0] = (std::sin(in[1]) < 0) == (fault == Fault::other_sign) ? 1 : -1;
}

// Of a chain with this tolerance.
template <Fault fault>
std::string report(double tolerance = 0) {
  Tables tables("arm");
  tables.add_link("base", {});
  for (const char* link : {"upper", "lower", "tool"}) tables.add_link(link, body(1, {0.1, 0.2, 0.1}, {0.1, 0.1, 0.1}));
  tables.add_joint("shoulder", JointType::revolute, 0, 1);
  tables.add_joint("elbow", JointType::revolute, 1, 2, {kUpper, 0, 0});
  tables.add_joint("slide", JointType::prismatic, 2, 3, {kLower, 0, 0});
  tables.add_frame("fr_base", 0);
  tables.add_frame("fr_tool", 3);
  static constexpr reflection::Function kFunctions[] = {
      {"all", {}, fault == Fault::reads_inputs_twice ? 9 : 6, 16, &all<fault>},
      {"branch", {}, 7, 5, &branch<fault>},
      {"configuration", {}, 3, 1, &configuration<fault>}};
  static constexpr int kJoints[] = {0, 1, 2};
  const reflection::InverseKinematics chains[] = {
      {"fr_base_X_fr_tool", reflection::InverseTask::position, 0, 1, kJoints, 3, 2, -1, 0, 1, 2, -1, tolerance}};
  Robot robot = tables.robot();
  robot.functions = {kFunctions, 3};
  robot.inverse_kinematics = {chains, 1};
  std::mt19937_64 engine(30);
  Checks checks;
  for (int i = 0; i < 10; ++i) {
    const Sample sample = random_sample(engine, robot);
    check_inverse_kinematics(Case(robot, sample, i), {}, engine, checks);
  }
  return checks.failure_report();
}

template <Fault fault>
void expect_found(const std::string& name) {
  expect_failures(report<fault>(), {"inverse_kinematics: " + name});
}

TEST(Checks, PassInverseKinematics) {
  EXPECT_EQ(report<Fault::none>(), "");
}

// Positions that are almost singular may be missed, if there is a tolerance.
TEST(Checks, KnowCalibratedChains) {
  expect_found<Fault::stretched>("positions among all branches");
  EXPECT_EQ(report<Fault::stretched>(1e-3), "");
  expect_failures(report<Fault::one_branch>(1e-3), {"inverse_kinematics: positions among all branches"});
  expect_failures(report<Fault::wrong_pose>(1e-3), {"inverse_kinematics: poses of all branches"});
}

TEST(Checks, FindMistakesInInverseKinematics) {
  expect_found<Fault::one_branch>("positions among all branches");
  expect_found<Fault::other_sign>("positions in a branch");
  expect_found<Fault::wrong_pose>("poses of all branches");
  expect_found<Fault::reachable>("poses of all branches");
  expect_found<Fault::ignores_signs>("positions in a branch");
  expect_failures(report<Fault::reads_inputs_twice>(), {"inputs of inverse_kinematics"});
}

}  // namespace
}  // namespace robcogen::reference::check_inverse_kinematics_test
