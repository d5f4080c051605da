// Regressors of random robots, compared with the reference; base parameters, compared with the numerical rank over many
// states.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "algorithm/identification/base_regressor.h"
#include "algorithm/identification/drive_regressor.h"
#include "coupled_robot.h"
#include "import/kinematics.h"
#include "interpreted_robot.h"
#include "linear_algebra.h"
#include "random_drives.h"
#include "random_robot.h"
#include "spherical_robot.h"

namespace robcogen::numeric::identification_test {
namespace {

using algorithm::Loads;
using model::KinematicTree;
using symbolic::Arrays;
using symbolic::Program;

KinematicTree robot_of(const std::string& text, const std::string& name) {
  Diagnostics diagnostics;
  const auto source = std::make_shared<Source>(name, text);
  auto tree = import::kinematic_tree(language::kinematics::parse(source, diagnostics), diagnostics);
  EXPECT_FALSE(diagnostics.has_errors()) << name;
  return *tree;
}

KinematicTree document(const std::string& robot) {
  std::ifstream file(std::filesystem::path(ROBCOGEN_ROBOTS_DIR) / robot / (robot + ".kindsl"), std::ios::binary);
  return robot_of(std::string(std::istreambuf_iterator<char>(file), {}), robot);
}

Eigen::MatrixXd matrix(const Program& program, const Arrays<double>& inputs) {
  const std::vector<double> values = symbolic::interpret(program, inputs).at(program.outputs.front().name);
  return Eigen::Map<const Eigen::MatrixXd>(
      values.data(), program.outputs.front().rows, program.outputs.front().columns);
}

// Returns the matrices of many random states, stacked. Gravity, where it is an input, is random, too.
Eigen::MatrixXd stacked(const Program& program, std::uint64_t seed) {
  const int rows = program.outputs.front().rows, columns = program.outputs.front().columns;
  const int states = 3 * columns / std::max(rows, 1) + 10;
  std::mt19937_64 engine(seed);
  Eigen::MatrixXd all(rows * states, columns);
  for (int s = 0; s < states; ++s) {
    Arrays<double> inputs;
    for (const symbolic::InputArray& array : program.inputs)
      for (std::size_t k = 0; k < array.elements.size(); ++k)
        inputs[array.name].push_back(static_cast<double>(engine() >> 11) * 0x1p-50 - 4.0);
    for (const symbolic::InputArray& array : program.inputs)
      for (const int first : array.quaternions)
        Eigen::Map<Eigen::Vector4d>(inputs[array.name].data() + first).normalize();
    all.middleRows(rows * s, rows) = matrix(program, inputs);
  }
  return all;
}

// Columns are normalised, so that lengths in small units count as much as others; columns that are rounding noise
// become zero.
int rank(Eigen::MatrixXd m) {
  const double largest = m.colwise().norm().maxCoeff();
  for (Eigen::Index k = 0; k < m.cols(); ++k) {
    const double size = m.col(k).norm();
    m.col(k) *= size > 1e-12 * largest ? 1 / size : 0.0;
  }
  return test::rank(m, 1e-9);
}

// Checks standard gravity with a fixed base, and arbitrary gravity.
void expect_minimal(const KinematicTree& robot, std::uint64_t seed) {
  for (const Loads loads : {algorithm::default_loads(robot), Loads::gravity}) {
    const Eigen::MatrixXd Y = stacked(algorithm::base_regressor(robot, "f", loads), seed);
    const Eigen::MatrixXd all = stacked(algorithm::regressor(robot, "f", loads), seed);
    EXPECT_EQ(Y.cols(), rank(all)) << "seed " << seed << "\n" << describe(robot);
    EXPECT_EQ(Y.cols(), rank(Y)) << "seed " << seed << "\n" << describe(robot);
    if (robot.floating_base) return;
  }
}

TEST(BaseParameters, AreAsManyAsTheRankOfTheRegressor) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const KinematicTree robot = random_robot(seed, {.max_joints = 7});
    expect_minimal(robot, seed);
    if (HasFailure()) return;
  }
}

KinematicTree with_balls(std::uint64_t seed, bool has_drives) {
  for (std::uint64_t next = seed;; next += 1000) {
    KinematicTree robot = random_robot(next, {.min_joints = 2, .max_joints = 4});
    if (has_drives) robot = with_random_drives(std::move(robot), next);
    robot = with_spherical_joints(robot, next, has_drives);
    if (!robot.spherical_joints().empty()) return robot;
  }
}

// Of the ten parameters of a spherical joint's child, all but the mass have an effect of their own.
TEST(BaseParameters, OfRobotsWithSphericalJoints) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    expect_minimal(with_balls(seed, false), seed);
    if (HasFailure()) return;
  }
  const KinematicTree leg = document("ball_leg");
  expect_minimal(leg, 1);
  EXPECT_EQ(algorithm::base_parameter_names(leg, algorithm::default_loads(leg)).size(), 9U + 7U + 9U);
}

// Makes every second joint helical unless it is prismatic.
KinematicTree with_screws(KinematicTree robot, std::uint64_t seed) {
  for (std::size_t j = seed % 2; j < robot.joints.size(); j += 2) {
    if (robot.joints[j].type == model::JointType::prismatic) continue;
    robot.joints[j].type = model::JointType::helical;
    robot.joints[j].pitch = model::Quantity(j % 4 < 2 ? 0.07 : -0.2);
  }
  return robot;
}

// Of the ten parameters of a helical joint's child, all but the moment of inertia about its axis have an effect of
// their own.
TEST(BaseParameters, OfRobotsWithScrews) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    expect_minimal(with_screws(random_robot(seed, {.max_joints = 6}), seed), seed);
    if (HasFailure()) return;
  }
}

// Bodies that only translate, axes parallel to gravity or to each other, and combinations.
TEST(BaseParameters, OfSpecialRobots) {
  const auto special = [](std::uint64_t seed) {
    KinematicTree robot = random_robot(seed, {.min_joints = 2, .max_joints = 6, .shape = Shape::chain});
    robot.floating_base = false;
    std::mt19937_64 engine(seed);
    for (model::Joint& joint : robot.joints) {
      joint.type = engine() % 2 == 0 ? model::JointType::prismatic : model::JointType::revolute;
      for (std::size_t k = 0; k < 3; ++k) joint.placement.rotation[k] = model::Quantity();
      if (engine() % 3 == 0) joint.placement.rotation[engine() % 2] = model::Quantity(Number::pi_multiple(1, 2));
    }
    return robot;
  };
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const KinematicTree robot = special(seed);
    expect_minimal(robot, seed);
    if (HasFailure()) return;
  }
}

// The Staeubli RX-90 in the modified Denavit-Hartenberg convention: D3 = 0.45 m, RL4 = 0.45 m (Khalil and Dombre 2002).
KinematicTree rx90() {
  constexpr const char* kTurns[] = {"0", "PI/2.0", "0", "-PI/2.0", "PI/2.0", "-PI/2.0"};
  constexpr const char* kShifts[] = {"0, 0, 0", "0, 0, 0", "0.45, 0, 0", "0, 0.45, 0", "0, 0, 0", "0, 0, 0"};
  std::string links, joints;
  for (int i = 0; i < 6; ++i) {
    const std::string own = std::to_string(i + 1), next = std::to_string(i + 2);
    links += "link L" + own + " { id = " + own +
             " inertia_params { mass = 1 CoM = (0, 0, 0) Ix = 1 Iy = 1 Iz = 1 Ixy = 0 Ixz = 0 Iyz = 0 } children { " +
             (i < 5 ? "L" + next + " via J" + next : "") + " } }\n";
    joints += "r_joint J" + own + " { ref_frame { translation = (" + kShifts[i] + ") rotation = (" + kTurns[i] +
              ", 0, 0) } }\n";
  }
  return robot_of("Robot rx90 {\nRobotBase base { children { L1 via J1 } }\n" + links + joints + "}\n", "rx90");
}

// An arm of n revolute joints, the first one vertical, the second one not, has one base parameter and then seven for
// each further link. Where gravity may have any direction, the first link has three: a centre of mass off the axis has
// an effect, too.
TEST(BaseParameters, OfKnownRobots) {
  for (const auto& [robot, count] :
       {std::pair{document("puma560"), 36}, std::pair{document("iiwa14"), 43}, std::pair{rx90(), 36}}) {
    EXPECT_EQ(algorithm::base_parameter_names(robot, Loads::standard_gravity).size(), static_cast<std::size_t>(count))
        << robot.name;
    EXPECT_EQ(algorithm::base_parameter_names(robot, Loads::gravity).size(), static_cast<std::size_t>(count + 2))
        << robot.name;
    expect_minimal(robot, 1);
  }
}

// With the inertia of the drives the RX-90 has 40 base parameters; the inertias of the first two drives are
// identifiable only together with the links (Khalil and Dombre 2002).
TEST(BaseParameters, WithThoseOfDrives) {
  const KinematicTree robot = rx90();
  const Eigen::MatrixXd Y = stacked(algorithm::base_regressor(robot, "f", Loads::standard_gravity), 1);
  const Eigen::MatrixXd drives = stacked(algorithm::drive_regressor(robot, "f"), 1);
  Eigen::MatrixXd all(std::min(Y.rows(), drives.rows()), Y.cols() + 6);
  all.leftCols(Y.cols()) = Y.topRows(all.rows());
  for (int j = 0; j < 6; ++j) all.col(Y.cols() + j) = drives.col(5 * j).head(all.rows());
  EXPECT_EQ(rank(all), 40);
}

// The first link of an arm on a vertical axis has an effect only through its moment of inertia about that axis.
TEST(BaseParameters, SpeakOfLinks) {
  const std::vector<std::string> names = algorithm::base_parameter_names(document("puma560"), Loads::standard_gravity);
  EXPECT_EQ(names[0].rfind("link1_Izz", 0), 0U) << names[0];
}

// Least squares on simulated measurements recovers the base parameters.
TEST(BaseParameters, AreIdentified) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const KinematicTree robot = random_robot(seed, {.max_joints = 6});
    const Loads loads = algorithm::default_loads(robot);
    const Eigen::MatrixXd Y = stacked(algorithm::base_regressor(robot, "f", loads), seed);
    const Eigen::MatrixXd all = stacked(algorithm::regressor(robot, "f", loads), seed);
    const std::vector<double> pi = symbolic::interpret<double>(algorithm::inertial_parameters(robot, "f"), {}).at("pi");
    const Eigen::VectorXd tau = all.topRows(Y.rows()) * Eigen::Map<const Eigen::VectorXd>(pi.data(), all.cols());
    const Eigen::VectorXd known = matrix(algorithm::base_parameters(robot, "f", loads), {{"inertial_parameters", pi}});
    const Eigen::VectorXd found = test::least_squares(Y, tau);
    EXPECT_LT((found - known).norm(), 1e-9 * (1 + known.norm())) << "seed " << seed << "\n" << describe(robot);
  }
}

// ---- All regressors against the reference.

reference::Checks checks_of(
    const KinematicTree& robot,
    std::uint64_t seed,
    const std::vector<double>& parameters = {}) {
  const std::vector<std::string> steps = seed % 3 == 0 ? all_steps() : std::vector<std::string>{};
  const InterpretedRobot subject(
      robot, {}, steps, parameters, {}, {"regressor", "base_regressor", "energy_regressor", "slotine_li_regressor"});
  const reflection::Robot tables = subject.tables();
  reference::Checks checks;
  std::mt19937_64 engine(seed);
  const reference::Sample sample = reference::random_sample(engine, tables);
  const reference::Case c(tables, sample, 0);
  check_parameters_of_regressors(subject, c, checks);
  check_regressor(subject, c, checks);
  check_base_regressor(subject, c, checks);
  check_energy_regressor(subject, c, checks);
  check_slotine_li_regressor(subject, c, checks);
  return checks;
}

TEST(Regressors, OfRandomRobots) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const KinematicTree robot = random_robot(seed, {.max_joints = 6});
    const reference::Checks checks = checks_of(robot, seed);
    ASSERT_EQ(checks.failures(), 0) << "seed " << seed << "\n" << checks.failure_report() << describe(robot);
  }
}

TEST(Regressors, OfRobotsWithDrives) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const KinematicTree robot = with_random_drives(random_robot(seed, {.max_joints = 6}), seed);
    const reference::Checks checks = checks_of(robot, seed);
    ASSERT_EQ(checks.failures(), 0) << "seed " << seed << "\n" << checks.failure_report() << describe(robot);
  }
}

TEST(Regressors, OfRobotsWithScrews) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    KinematicTree robot = random_robot(seed, {.max_joints = 6});
    if (seed % 3 == 0) robot = with_random_drives(std::move(robot), seed);
    robot = with_screws(std::move(robot), seed);
    const reference::Checks checks = checks_of(robot, seed);
    ASSERT_EQ(checks.failures(), 0) << "seed " << seed << "\n" << checks.failure_report() << describe(robot);
  }
}

KinematicTree chain(int joints) {
  std::string links, placements;
  for (int i = 1; i <= joints; ++i) {
    const std::string own = std::to_string(i), next = std::to_string(i + 1);
    links += "link L" + own + " { id = " + own +
             " inertia_params { mass = 1 CoM = (0.1, 0, 0) Ix = 1 Iy = 1 Iz = 1 Ixy = 0 Ixz = 0 Iyz = 0 } children { " +
             (i < joints ? "L" + next + " via J" + next : "") + " } }\n";
    placements += "r_joint J" + own + " { ref_frame { translation = (0.1, 0, 0) rotation = (PI/2.0, 0, 0) } }\n";
  }
  return robot_of("Robot chain {\nRobotBase base { children { L1 via J1 } }\n" + links + placements + "}\n", "chain");
}

// 40 joints give 16,000 elements.
TEST(Regressors, HaveALargestSize) {
  const std::vector<std::string> limited = {"regressor", "base_regressor", "slotine_li_regressor"};
  for (const std::string& group : limited) {
    EXPECT_EQ(algorithm::reason_of_absence(chain(40), group, algorithm::Reasons::all), "");
    EXPECT_EQ(
        algorithm::reason_of_absence(chain(41), group, algorithm::Reasons::all),
        "with ten columns for each of so many links its matrix would have more than 16,000 elements, too many for the "
        "stacks of threads");
  }
  EXPECT_EQ(algorithm::reason_of_absence(chain(41), "energy_regressor", algorithm::Reasons::all), "");
}

TEST(Regressors, OfLargeRobots) {
  for (const std::string name : {"hexapod", "centaur", "humanoid"}) {
    const reference::Checks checks = checks_of(document(name), 3);
    EXPECT_GT(checks.size(), 8) << name;
    EXPECT_EQ(checks.failures(), 0) << name << "\n" << checks.failure_report();
  }
}

TEST(Regressors, OfRobotsWithSphericalJoints) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const KinematicTree robot = with_balls(seed, seed % 2 == 0);
    const reference::Checks checks = checks_of(robot, seed);
    ASSERT_EQ(checks.failures(), 0) << "seed " << seed << "\n" << checks.failure_report() << describe(robot);
  }
}

TEST(Regressors, OfRobotsWithCouplings) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    KinematicTree free = random_robot(seed, {.min_joints = 2, .max_joints = 6});
    if (seed % 3 == 0) free = with_random_drives(std::move(free), seed);
    const CoupledRobot made = coupled(free, seed, seed % 5 == 0);
    const reference::Checks checks = checks_of(made.robot, seed, made.parameters);
    ASSERT_EQ(checks.failures(), 0) << "seed " << seed << "\n" << checks.failure_report() << describe(made.robot);
  }
}

}  // namespace
}  // namespace robcogen::numeric::identification_test
