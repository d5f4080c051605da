// P6: different descriptions of one machine give the same forces, inertias and accelerations. Link frames are moved,
// declarations reordered, names changed, the robot is mirrored, or a joint is welded.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "interpreted_robot.h"
#include "random_robot.h"
#include "rewritten_robot.h"
#include "volume.h"

namespace robcogen::numeric::invariance_test {
namespace {

using model::KinematicTree;
using reference::Arguments;
using reference::Case;
using reference::Matrix;
using reference::Real;
using reference::Sample;
using reference::Vector;

// Rewriting rounds placements and inertias to doubles once, which costs a few times the rounding of a program. Errors
// are relative to the terms that the results sum; for accelerations, to those terms multiplied by the inverse of H.
constexpr Real kSame = 1e-11L;

InterpretedRobot programs_of(const KinematicTree& robot) {
  return InterpretedRobot(robot, {}, {});
}

// Translates a state to another description. Joint k of the other robot is joint joints[k] of this one, and its
// position is multiplied by signs[k]. Link k of the other robot is links[k] of this one. Base vectors and link wrenches
// are mapped by 6 x 6 transforms.
struct Translation {
  std::vector<int> joints;
  std::vector<double> signs;
  std::vector<int> links;
  Matrix<double> base_motion = Matrix<double>::identity(6);
  Matrix<double> base_force = Matrix<double>::identity(6);
  std::vector<Matrix<double>> link_force;
  Matrix<double> gravity = Matrix<double>::identity(3);
};

Translation same_words(const KinematicTree& robot) {
  Translation t;
  t.joints.resize(robot.joints.size());
  std::iota(t.joints.begin(), t.joints.end(), 0);
  t.signs.assign(robot.joints.size(), 1.0);
  t.links.resize(robot.links.size());
  std::iota(t.links.begin(), t.links.end(), 0);
  t.link_force.assign(robot.links.size(), Matrix<double>::identity(6));
  return t;
}

Vector<double> joints_in(const Translation& t, const Vector<double>& v) {
  Vector<double> result(static_cast<int>(t.joints.size()));
  for (int k = 0; k < result.rows(); ++k)
    result(k) = t.signs[static_cast<std::size_t>(k)] * v(t.joints[static_cast<std::size_t>(k)]);
  return result;
}

Sample in(const Translation& t, const Sample& s) {
  Sample result;
  result.motion.q = joints_in(t, s.motion.q);
  result.motion.qd = joints_in(t, s.motion.qd);
  result.motion.qdd = joints_in(t, s.motion.qdd);
  result.motion.base_velocity = t.base_motion * s.motion.base_velocity;
  result.motion.base_acceleration = t.base_motion * s.motion.base_acceleration;
  result.gravity = t.gravity * s.gravity;
  for (std::size_t i = 0; i < t.links.size(); ++i)
    result.external.push_back(t.link_force[i] * s.external[static_cast<std::size_t>(t.links[i])]);
  return result;
}

// Translates a vector of the joints, or of the base and the joints.
Vector<double> in(const Translation& t, bool floating, const Matrix<double>& base, const Vector<double>& v) {
  if (!floating) return joints_in(t, v);
  return stacked(base * v.head(6), joints_in(t, v.tail(v.rows() - 6)));
}

// Returns an empty string if the two robots agree in a random state, otherwise the differences.
std::string difference(
    const KinematicTree& robot,
    const KinematicTree& other,
    const Translation& t,
    std::uint64_t seed) {
  const InterpretedRobot a = programs_of(robot), b = programs_of(other);
  const reflection::Robot tables = a.tables();
  std::mt19937_64 engine(seed);
  const Sample here = reference::random_sample(engine, tables);
  const Sample there = in(t, here);
  const Case c(tables, here, 0);
  const bool floating = robot.floating_base;
  const reference::Loads<Real> loads = reference::loads<Real>(here.gravity, here.external);
  const Arguments given{&here.gravity, &here.external}, translated{&there.gravity, &there.external};

  std::string text;
  const auto compare = [&](const char* name, const Vector<double>& mine, const Vector<double>& theirs,
                           const Matrix<double>& base, const Vector<Real>& terms) {
    // The sizes of terms have no sign, and are the same for all axes of the base.
    Translation sizes = t;
    sizes.signs.assign(t.signs.size(), 1.0);
    const Vector<double> sized = in(sizes, floating, Matrix<double>::identity(6), terms.cast<double>());
    const Vector<Real> wanted = in(t, floating, base, mine).cast<Real>();
    const Real error = reference::blockwise_error(floating, theirs, wanted, sized.cast<Real>());
    if (!(error <= kSame)) text += std::string(name) + ": " + std::to_string(static_cast<double>(error)) + "\n";
  };
  const Vector<Real> terms = reference::expected_forces(c, here.motion, loads).terms;
  compare(
      "inverse dynamics", a.inverse_dynamics_fully_actuated(here.motion, given),
      b.inverse_dynamics_fully_actuated(there.motion, translated), t.base_force, terms);
  compare(
      "bias forces", a.bias_forces(here.motion, given), b.bias_forces(there.motion, translated), t.base_force, terms);
  compare(
      "gravity forces", a.gravity_forces(here.motion.q, given), b.gravity_forces(there.motion.q, translated),
      t.base_force, terms);
  const Vector<double> tau = inverse_dynamics(tables, c.motion, loads).tau.cast<double>();
  compare(
      "forward dynamics", a.forward_dynamics(here.motion, tau, given),
      b.forward_dynamics(there.motion, joints_in(t, tau), translated), t.base_motion,
      reference::expected_accelerations(c, tau, loads).terms);
  const Matrix<double> H = a.joint_space_inertia(here.motion.q), their_H = b.joint_space_inertia(there.motion.q);
  for (int k = 0; k < robot.dof(); ++k) {
    // A column is the force of a unit acceleration.
    reference::Motion<double> unit = reference::at_rest(here.motion.q);
    unit.qdd(k) = 1;
    const int first = floating ? 6 : 0;
    const auto place = std::find(t.joints.begin(), t.joints.end(), k) - t.joints.begin();
    const double sign = t.signs[static_cast<std::size_t>(place)];
    const Vector<Real> column_terms =
        reference::expected_forces(c, unit, reference::loads<Real>(Vector<double>(3))).terms;
    compare(
        "inertia matrix", H.col(first + k), sign * their_H.col(first + static_cast<int>(place)), t.base_force,
        column_terms);
  }
  return text;
}

using Rewrite = std::string (*)(const KinematicTree&, std::uint64_t);

std::string after_reframing(const KinematicTree& robot, std::uint64_t seed) {
  const Reframed other = reframed(robot);
  Translation t = same_words(robot);
  for (std::size_t i = 0; i < t.links.size(); ++i)
    t.link_force[i] = reference::force_form(other.new_X_old[i]).cast<double>();
  return difference(robot, other.robot, t, seed);
}

std::string after_reordering(const KinematicTree& robot, std::uint64_t seed) {
  Translation t = same_words(robot);
  std::reverse(t.links.begin() + 1, t.links.end());
  std::reverse(t.joints.begin(), t.joints.end());
  KinematicTree other = reordered(robot, t.links, t.joints);
  for (model::Link& link : other.links) std::reverse(link.child_joints.begin(), link.child_joints.end());
  return difference(robot, other, t, seed);
}

std::string after_renaming(const KinematicTree& robot, std::uint64_t seed) {
  return difference(robot, renamed(robot), same_words(robot), seed);
}

std::string in_a_mirror(const KinematicTree& robot, std::uint64_t seed) {
  Translation t = same_words(robot);
  for (std::size_t k = 0; k < t.signs.size(); ++k) t.signs[k] = model::turns(robot.joints[k].type) ? -1 : 1;
  // Rotations about x and z, and translations along y, are reversed.
  Matrix<double> M(6, 6);
  for (int k = 0; k < 6; ++k) M(k, k) = k == 0 || k == 2 || k == 4 ? -1 : 1;
  t.base_motion = t.base_force = M;
  t.link_force.assign(robot.links.size(), M);
  t.gravity(1, 1) = -1;
  return difference(robot, mirrored(robot), t, seed);
}

// A joint at rest exerts its constraint force; the others behave as in the welded robot.
std::string with_a_weld(const KinematicTree& robot, std::uint64_t seed) {
  if (robot.dof() < 2) return "";
  const int joint = static_cast<int>(seed % static_cast<std::uint64_t>(robot.dof()));
  const InterpretedRobot a = programs_of(robot);
  const reflection::Robot tables = a.tables();
  std::mt19937_64 engine(seed);
  Sample s = reference::random_sample(engine, tables);
  s.motion.qd(joint) = s.motion.qdd(joint) = 0;
  const InterpretedRobot b = programs_of(with_locked_joint(robot, joint, s.motion.q(joint)));

  const auto without = [&](const Vector<double>& v, int at) { return stacked(v.head(at), v.tail(v.rows() - at - 1)); };
  reference::Motion<double> motion = s.motion;
  motion.q = without(s.motion.q, joint);
  motion.qd = without(s.motion.qd, joint);
  motion.qdd = without(s.motion.qdd, joint);
  const int row = joint + (robot.floating_base ? 6 : 0);
  const Case c(tables, s, 0);
  const Vector<Real> terms = reference::expected_forces(c, s.motion, reference::loads<Real>(s.gravity)).terms;
  const Real error = reference::blockwise_error(
      robot.floating_base, b.inverse_dynamics_fully_actuated(motion, {&s.gravity, nullptr}),
      without(a.inverse_dynamics_fully_actuated(s.motion, {&s.gravity, nullptr}), row).cast<Real>(),
      without(terms.cast<double>(), row).cast<Real>());
  return error <= kSame ? "" : "welded at " + robot.joints[static_cast<std::size_t>(joint)].name;
}

void expect_the_same_machine(Rewrite rewrite) {
  const int robots = volume("ROBCOGEN_TEST_ROBOTS", 50);
  for (int i = 0; i < robots; ++i) {
    const auto seed = static_cast<std::uint64_t>(i) + 10000;
    const KinematicTree robot = random_robot(seed, {.max_joints = 15});
    const std::string found = rewrite(robot, seed);
    if (found.empty()) continue;
    const KinematicTree small = shrink(robot, [&](const KinematicTree& r) { return !rewrite(r, seed).empty(); });
    FAIL() << "seed " << seed << "\n" << found << "shrunk to\n" << describe(small) << rewrite(small, seed);
  }
}

TEST(Invariance, OfLinkFrames) {
  expect_the_same_machine(after_reframing);
}
TEST(Invariance, OfTheOrderOfDeclarations) {
  expect_the_same_machine(after_reordering);
}
TEST(Invariance, OfNames) {
  expect_the_same_machine(after_renaming);
}
TEST(Invariance, OfTheMirrorImage) {
  expect_the_same_machine(in_a_mirror);
}
TEST(Invariance, OfWeldedJoints) {
  expect_the_same_machine(with_a_weld);
}

}  // namespace
}  // namespace robcogen::numeric::invariance_test
