// Functions of a base that has a pose in the world, on random robots, trees and loops, compared with the dense
// kinematics of the reference in long double, rotated by the pose.
#include <gtest/gtest.h>

#include "coupled_robot.h"
#include "import/kinematics.h"
#include "interpreted_robot.h"
#include "language/kinematics/document.h"
#include "looped_robot.h"
#include "random_drives.h"
#include "random_robot.h"
#include "robcogen/reference/contacts.h"
#include "robcogen/reference/energy.h"
#include "robcogen/reference/samples.h"
#include "spherical_robot.h"

namespace robcogen::numeric::world_test {
namespace {

using model::KinematicTree;
using reference::origin_of;
using reference::Real;
using reference::rotation_of;
using reference::stacked;
using reference::transpose;
using Matrix = reference::Matrix<Real>;
using Vector = reference::Vector<Real>;

constexpr double kKinematics = 1e-11;
constexpr double kDynamics = 1e-10;
constexpr int kRobots = ROBCOGEN_TEST_EVERYTHING ? 48 : 24;

double relative(const Matrix& found, const Matrix& wanted) {
  return static_cast<double>(reference::largest(found - wanted) / (1 + reference::largest(wanted)));
}

Matrix twice(const Matrix& R) {
  Matrix both(6, 6);
  both.set_block(0, 0, R);
  both.set_block(3, 3, R);
  return both;
}

// The rotation from base axes to world axes, from the vector part of the quaternion (Rodrigues).
Matrix rotation_by(const reference::Vector<double>& q) {
  const Vector v{q(1), q(2), q(3)};
  const Matrix S = reference::skew(v);
  Matrix R = Real(2 * q(0)) * S + Real(2) * (S * S);
  for (int i = 0; i < 3; ++i) R(i, i) += 1;
  return R;
}

// Of every four robots one has couplings, one has spherical joints, and one has loops.
std::optional<KinematicTree> random_tree(std::uint64_t seed, std::vector<double>& parameters) {
  if (seed % 4 == 3) {
    Diagnostics diagnostics;
    const auto source = std::make_shared<const Source>("looped.kindsl", looped_document(seed));
    auto tree = import::kinematic_tree(language::kinematics::parse(source, diagnostics), diagnostics);
    if (tree) parameters = algorithm::parameter_values(*tree);
    return tree;
  }
  KinematicTree tree = random_robot(seed, {.min_joints = 2, .max_joints = 12});
  if (seed % 3 == 0) tree = with_random_drives(std::move(tree), seed);
  if (seed % 4 == 2) return with_spherical_joints(tree, seed);
  if (seed % 4 == 0) return tree;
  CoupledRobot made = coupled(tree, seed, seed % 8 == 1);
  parameters = made.parameters;
  return made.robot;
}

struct Case {
  Case(std::uint64_t number, const KinematicTree& robot_tree, std::vector<double> parameters, const std::string& group)
      : tree(robot_tree),
        desired(random_desired(number, tree)),
        robot(
            tree,
            desired,
            number % 2 == 0 ? std::vector<std::string>() : all_steps(),
            std::move(parameters),
            {},
            {group}) {
    std::mt19937_64 engine(number);
    tables = std::make_unique<reference::AtLoops>(reference::draw(engine, robot.tables(), sample));
    pose = stacked(reference::unit_vector(engine, 4), reference::uniform_vector(engine, 3, 3));
    R = rotation_by(pose);
    motion = reference::cast<Real>(sample.motion);
  }

  const reflection::Robot& reference() const { return tables->robot(); }
  int frame(const model::Frame& f) const { return frame_index(tree, f); }
  Vector position() const { return pose.tail(3).cast<Real>(); }
  Vector velocity() const { return tree.floating_base ? stacked(motion.base_velocity, motion.qd) : motion.qd; }
  Vector acceleration() const {
    return tree.floating_base ? stacked(motion.base_acceleration, motion.qdd) : motion.qdd;
  }
  Matrix base_X(const model::Frame& f) const { return reference::transform(reference(), motion.q, 0, frame(f)); }

  bool has(const std::string& name) const { return robot.programs().contains(name); }
  Matrix run(const std::string& name, int rows) const {
    const reference::Motion<double>& m = sample.motion;
    const symbolic::Arrays<double> inputs = {
        {"q", m.q.values()},
        {"qd", m.qd.values()},
        {"qdd", m.qdd.values()},
        {"base_pose", pose.values()},
        {"base_velocity", m.base_velocity.values()},
        {"base_acceleration", m.base_acceleration.values()}};
    const std::vector<double> values = robot.run(name, {}, inputs).begin()->second;
    Matrix result(rows, static_cast<int>(values.size()) / rows);
    for (std::size_t k = 0; k < values.size(); ++k) result.data()[k] = values[k];
    return result;
  }

  KinematicTree tree;
  model::DesiredTransforms desired;
  InterpretedRobot robot;
  std::unique_ptr<reference::AtLoops> tables;
  reference::Sample sample;
  reference::Motion<Real> motion;
  reference::Vector<double> pose;
  Matrix R;
};

template <class Check>
int for_each_case(const std::string& group, const Check& check) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    std::vector<double> parameters;
    const std::optional<KinematicTree> tree = random_tree(seed, parameters);
    if (!tree) continue;
    const Case c(seed, *tree, parameters, group);
    SCOPED_TRACE(seed);
    compared += check(c);
  }
  return compared;
}

TEST(World, FramesAreWhereTheBaseCarriesThem) {
  const int compared = for_each_case("world", [](const Case& c) {
    int count = 0;
    for (const model::FramePair& pair : c.desired.transforms)
      for (const model::Frame& frame : {pair.left, pair.right}) {
        if (frame.name == c.tree.frames().front().name) continue;
        const Matrix X = c.base_X(frame);
        const Vector p = c.R * origin_of(X) + c.position();
        Matrix expected(4, 4);
        expected.set_block(0, 0, c.R * rotation_of(X));
        expected.set_block(0, 3, p);
        expected(3, 3) = 1;
        EXPECT_LT(relative(c.run("in_world_X_" + frame.name, 4), expected), kKinematics);
        EXPECT_LT(relative(c.run("in_world_position_" + frame.name, 3), p), kKinematics);
        ++count;
      }
    return count;
  });
  EXPECT_GT(compared, 50);
}

TEST(World, FramesMoveAsTheirJacobiansSay) {
  const int compared = for_each_case("world", [](const Case& c) {
    int count = 0;
    for (const model::FramePair& pair : c.desired.jacobians)
      for (const model::Frame& frame : {pair.left, pair.right}) {
        const bool stands = !c.tree.floating_base && c.tree.link_of(frame) == 0;
        const bool is_base = frame.name == c.tree.frames().front().name;
        EXPECT_EQ(c.has("in_world_J_" + frame.name), !stands && !is_base);
        if (stands || is_base) continue;
        const Matrix J = reference::jacobian_with_base(c.reference(), c.motion.q, c.frame(frame));
        const Vector bias = reference::bias_with_base(c.reference(), c.motion, c.frame(frame));
        const Matrix to_frame = twice(transpose(rotation_of(c.base_X(frame))));
        for (const bool in_target : {false, true}) {
          const std::string prefix = in_target ? "world_in_target_" : "in_world_";
          const Matrix turn = in_target ? to_frame : twice(c.R);
          EXPECT_LT(relative(c.run(prefix + "J_" + frame.name, 6), turn * J), kKinematics);
          EXPECT_LT(relative(c.run(prefix + "bias_" + frame.name, 6), turn * bias), kKinematics);
          EXPECT_LT(relative(c.run(prefix + "velocity_" + frame.name, 6), turn * (J * c.velocity())), kKinematics);
          const Matrix acceleration = turn * (J * c.acceleration() + bias);
          EXPECT_LT(relative(c.run(prefix + "acceleration_" + frame.name, 6), acceleration), kKinematics);
        }
        ++count;
      }
    return count;
  });
  EXPECT_GT(compared, 50);
}

// Momentum about the centre of mass, in axes of the base, from the sum over the links.
Vector central_momentum(const Case& c, const reference::Motion<Real>& motion, const Vector& com) {
  const Vector h = reference::momentum(c.reference(), motion);
  return stacked(h.head(3) - reference::cross(com, h.tail(3)), h.tail(3));
}

TEST(World, TheCentreOfMassAndTheMomentumAreThoseOfTheLinks) {
  const int compared = for_each_case("world_centroidal", [](const Case& c) {
    if (!c.has("in_world_center_of_mass")) return 0;
    const Real mass = reference::moving_mass(c.reference());
    const Vector com = Real(1) / mass * reference::first_moment(c.reference(), c.motion.q);
    EXPECT_LT(relative(c.run("in_world_center_of_mass", 3), c.R * com + c.position()), kKinematics);

    const Vector h = twice(c.R) * central_momentum(c, c.motion, com);
    EXPECT_LT(relative(c.run("in_world_centroidal_momentum", 6), h), kDynamics);
    EXPECT_LT(relative(c.run("in_world_center_of_mass_velocity", 3), Real(1) / mass * h.tail(3)), kDynamics);
    const Matrix A = c.run("in_world_centroidal_momentum_matrix", 6), J = c.run("in_world_center_of_mass_jacobian", 3);
    EXPECT_LT(relative(A * c.velocity(), h), kDynamics);
    EXPECT_LT(relative(mass * J, A.block(3, 0, 3, A.cols())), kDynamics);
    // Each column alone, from a unit velocity.
    const int base = c.tree.floating_base ? 6 : 0;
    for (int k = 0; k < A.cols(); ++k) {
      reference::Motion<Real> unit = c.motion;
      unit.qd = Vector(c.tree.dof());
      unit.base_velocity = Vector(6);
      (k < base ? unit.base_velocity : unit.qd)(k < base ? k : k - base) = 1;
      EXPECT_LT(relative(A.col(k), twice(c.R) * central_momentum(c, unit, com)), kDynamics) << k;
    }
    return 1;
  });
  EXPECT_GT(compared, kRobots * 5 / 8);
}

// With zero joint and base accelerations, the rate of the centroidal momentum is the force and the moment about the
// centre of mass that act from outside (Newton, Euler).
TEST(World, TheBiasOfTheMomentumIsWhatActsFromOutside) {
  const int compared = for_each_case("world_centroidal", [](const Case& c) {
    if (!c.has("in_world_centroidal_momentum_bias") || !c.tree.floating_base) return 0;
    const Real mass = reference::moving_mass(c.reference());
    const Vector com = Real(1) / mass * reference::first_moment(c.reference(), c.motion.q);
    const reference::Loads<Real> none{Vector(3), {}, false};
    const Vector wrench = reference::bias_forces(c.reference(), c.motion, none).base_wrench;
    const Vector bias = stacked(wrench.head(3) - reference::cross(com, wrench.tail(3)), wrench.tail(3));
    EXPECT_LT(relative(c.run("in_world_centroidal_momentum_bias", 6), twice(c.R) * bias), kDynamics);
    return 1;
  });
  EXPECT_GT(compared, kRobots / 5);
}

}  // namespace
}  // namespace robcogen::numeric::world_test
