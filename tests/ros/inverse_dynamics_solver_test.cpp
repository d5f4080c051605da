// The plugin for inverse_dynamics_solver.
#include <inverse_dynamics_solver/exceptions.h>
#include <inverse_dynamics_solver/inverse_dynamics_solver.h>

#include "plugins.h"

namespace robcogen::test::inverse_dynamics_solver_test {
namespace {

namespace ids = inverse_dynamics_solver;
using Eigen::VectorXd;
using ids::InverseDynamicsSolver;
using Values = std::map<std::string, rclcpp::Parameter::Value>;

std::unique_ptr<InverseDynamicsSolver> initialized(const Values& values = {}) {
  auto plugin = load<InverseDynamicsSolver>(INVERSE_DYNAMICS_SOLVER);
  plugin->initialize(node_with(values), "dynamics", description());
  return plugin;
}

TEST(InverseDynamicsSolver, ReturnsWhatTheLibraryComputes) {
  const auto plugin = initialized();
  for (int i = 0; i < 5; ++i) {
    const arm::JointState q = some_positions(i), qd = some_positions(i + 10), qdd = some_positions(i + 20);
    EXPECT_EQ(plugin->getInertiaMatrix(q), arm::joint_space_inertia(q));
    EXPECT_EQ(plugin->getCoriolisVector(q, qd), arm::coriolis_forces(q, qd));
    EXPECT_LT((plugin->getGravityVector(q) - arm::gravity_forces(q)).cwiseAbs().maxCoeff(), 1e-12);
    const VectorXd tau = plugin->getTorques(q, qd, qdd);
    EXPECT_LT((tau - arm::inverse_dynamics(q, qd, qdd)).cwiseAbs().maxCoeff(), 1e-11);
    const auto [H, C, g] = plugin->getDynamicParameters(q, qd);
    EXPECT_LT((tau - (H * VectorXd(qdd) + C + g)).cwiseAbs().maxCoeff(), 1e-11);
  }
}

TEST(InverseDynamicsSolver, GravityAndCoriolisForces) {
  const auto plugin = initialized({{"dynamics.gravity", std::vector<double>{1, -2, 3}}});
  const arm::JointState q = some_positions(7);
  const arm::JointState gravity_forces = arm::gravity_forces(q, Gravity(Eigen::Vector3d(1, -2, 3)));
  EXPECT_LT((plugin->getGravityVector(q) - gravity_forces).cwiseAbs().maxCoeff(), 1e-13);
  // Coriolis forces: H' qd - 1/2 d(qd' H qd)/dq, by differences of the inertia.
  const arm::JointState qd = some_positions(8);
  constexpr double kStep = 1e-5;
  arm::JointState expected =
      (arm::joint_space_inertia(q + kStep * qd) - arm::joint_space_inertia(q - kStep * qd)) * qd / (2 * kStep);
  for (int j = 0; j < 6; ++j) {
    arm::JointState plus = q, minus = q;
    plus[j] += kStep, minus[j] -= kStep;
    expected[j] -= qd.dot((arm::joint_space_inertia(plus) - arm::joint_space_inertia(minus)) * qd) / (4 * kStep);
  }
  EXPECT_LT((plugin->getCoriolisVector(q, qd) - expected).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(InverseDynamicsSolver, FrictionOfTheJoints) {
  const auto plugin = initialized();
  const VectorXd qd = (VectorXd(6) << 1, 1, -2, 1, 1, 1).finished();
  EXPECT_EQ(plugin->getFrictionVector(qd), (VectorXd(6) << 0, 0, -2 * 0.8 - 1.5, 0, 0, 0).finished());
  EXPECT_EQ(plugin->getFrictionVector(VectorXd::Zero(6)), VectorXd::Zero(6));
}

TEST(InverseDynamicsSolver, SomeJoints) {
  const auto plugin = initialized(
      {{"dynamics.root", std::string("base_link")},
       {"dynamics.tip", std::string("forearm")},
       {"dynamics.joints", std::vector<std::string>{"joint_3", "joint_1", "joint_2"}}});
  const VectorXd q = Eigen::Vector3d(0.3, 0.1, 0.2), qd = Eigen::Vector3d(3, 1, 2),
                 qdd = Eigen::Vector3d(0.7, 0.5, 0.6);
  const auto all = [](const VectorXd& v) {
    arm::JointState result = arm::JointState::Zero();
    result << v[1], v[2], v[0], 0, 0, 0;
    return result;
  };
  const arm::JointState expected = arm::inverse_dynamics(all(q), all(qd), all(qdd));
  const VectorXd tau = plugin->getTorques(q, qd, qdd);
  ASSERT_EQ(tau.size(), 3);
  EXPECT_LT((tau - Eigen::Vector3d(expected[2], expected[0], expected[1])).cwiseAbs().maxCoeff(), 1e-12);
  const Eigen::MatrixXd H = plugin->getInertiaMatrix(q);
  ASSERT_EQ(H.rows(), 3);
  EXPECT_EQ(H(0, 1), arm::joint_space_inertia(all(q))(2, 0));
}

TEST(InverseDynamicsSolver, RefusesWrongArguments) {
  const auto plugin = load<InverseDynamicsSolver>(INVERSE_DYNAMICS_SOLVER);
  const VectorXd six = VectorXd::Zero(6), five = VectorXd::Zero(5);
  EXPECT_THROW(plugin->getInertiaMatrix(six), ids::UninitializedException);
  plugin->initialize(nullptr, "", description());
  EXPECT_NO_THROW(plugin->getInertiaMatrix(six));
  EXPECT_THROW(plugin->getInertiaMatrix(five), std::invalid_argument);
  EXPECT_THROW(plugin->getTorques(six, six, five), std::invalid_argument);
  EXPECT_THROW(plugin->getFrictionVector(five), std::invalid_argument);
  try {
    plugin->getCoriolisVector(six, five);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "robcogen.six_axis: joint_velocities has 5 elements instead of 6");
  }
}

TEST(InverseDynamicsSolver, RefusesWrongParameters) {
  const auto refused = [](const Values& values, const std::string& text = description()) -> std::string {
    const auto plugin = load<InverseDynamicsSolver>(INVERSE_DYNAMICS_SOLVER);
    try {
      plugin->initialize(node_with(values), "", text);
    } catch (const ids::InvalidParameterValueException& error) {
      EXPECT_THROW(plugin->getFrictionVector(VectorXd::Zero(6)), ids::UninitializedException);
      return std::string(error.what()).substr(std::string("robcogen.six_axis: ").size());
    }
    return "";
  };
  EXPECT_EQ(refused({}), "");
  EXPECT_EQ(refused({{"gravity", std::vector<double>{0, -9.81}}}), "parameter 'gravity' has 2 elements instead of 3");
  EXPECT_EQ(refused({{"gravity", std::vector<std::int64_t>{0, 0, -9}}}), "");
  EXPECT_EQ(refused({{"root", std::string("base_link")}}), "parameter 'root' needs 'tip'");
  EXPECT_EQ(
      refused({{"root", std::string("shoulder")}, {"tip", std::string("tool0")}}),
      "link 'shoulder' moves: the root must be fixed to that of the robot");
  EXPECT_TRUE(refused({{"tip", std::string("hand")}}).starts_with("robot 'six_axis' has no link 'hand'"));

  EXPECT_EQ(refused({}, "<robot"), "the robot description is not a URDF");
  EXPECT_TRUE(
      refused({}, description_with("0.45 0 0", "0.46 0 0")).starts_with("the robot description is not that of"));
  const std::string masses = "the robot description does not have the masses of the generated robot 'six_axis': ";
  EXPECT_EQ(refused({}, description_with("mass value=\"1.4\"", "mass value=\"1.5\"")).substr(0, masses.size()), masses);
  EXPECT_EQ(refused({}, description_with("iyz=\"-0.004\"", "iyz=\"0.004\"")), "")
      << "it has no effect: shoulder turns about z only";
  EXPECT_EQ(refused({}, description_with("ixy=\"0.002\"", "ixy=\"-0.002\"")).substr(0, masses.size()), masses);
  EXPECT_EQ(refused({}, description_with("izz=\"0.0002\"", "izz=\"0.0012\"")).substr(0, masses.size()), masses);
  EXPECT_THROW(
      load<InverseDynamicsSolver>(INVERSE_DYNAMICS_SOLVER)->initialize(nullptr, "", ""),
      ids::ParameterUninitializedException);
}

}  // namespace
}  // namespace robcogen::test::inverse_dynamics_solver_test
