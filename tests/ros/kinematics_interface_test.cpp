// The plugin for kinematics_interface, as a controller uses it.
#include <kinematics_interface/kinematics_interface.hpp>

#include "../real_time/allocation_hook.h"
#include "plugins.h"

namespace robcogen::test::kinematics_interface_test {
namespace {

using kinematics_interface::KinematicsInterface;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Vector7 = Eigen::Matrix<double, 7, 1>;
using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;
using Inverse = Eigen::Matrix<double, Eigen::Dynamic, 6>;

using Values = std::map<std::string, rclcpp::Parameter::Value>;

bool initialize(KinematicsInterface& plugin, const Values& values, const std::string& text = description()) {
  return plugin.initialize(text, node_with(values), "kinematics");
}

std::unique_ptr<KinematicsInterface> initialized(Values values = {}) {
  values.insert({"kinematics.tip", std::string("tool0")});
  auto plugin = load<KinematicsInterface>(KINEMATICS_INTERFACE);
  EXPECT_TRUE(initialize(*plugin, values)) << last_message();
  return plugin;
}

TEST(KinematicsInterface, ReturnsWhatTheLibraryComputes) {
  const auto plugin = initialized({{"kinematics.alpha", 0.0}});
  for (int i = 0; i < 20; ++i) {
    const arm::JointState q = some_positions(i);
    const Eigen::VectorXd positions = q;
    Eigen::Isometry3d X;
    ASSERT_TRUE(plugin->calculate_link_transform(positions, "tool0", X));
    EXPECT_LT((X.matrix() - arm::transforms::homogeneous::fr_base_link_X_tool0(q)).cwiseAbs().maxCoeff(), 1e-14);
    Jacobian J(6, 6);
    ASSERT_TRUE(plugin->calculate_jacobian(positions, "tool0", J));
    const auto angular_first = arm::jacobians::fr_base_link_J_tool0(q);
    EXPECT_LT((J.topRows<3>() - angular_first.bottomRows<3>()).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((J.bottomRows<3>() - angular_first.topRows<3>()).cwiseAbs().maxCoeff(), 1e-14);

    const Eigen::VectorXd dq = some_positions(i + 100);
    Vector6 dx;
    ASSERT_TRUE(plugin->convert_joint_deltas_to_cartesian_deltas(positions, dq, "tool0", dx));
    EXPECT_LT((dx - J * dq).cwiseAbs().maxCoeff(), 1e-13);
    // The inverse is that of J J^T, whose condition is the square of that of J.
    constexpr double kInverse = 1e-10;
    Eigen::VectorXd back(6);
    ASSERT_TRUE(plugin->convert_cartesian_deltas_to_joint_deltas(positions, dx, "tool0", back));
    EXPECT_LT((J * back - dx).cwiseAbs().maxCoeff(), kInverse);
    Inverse inverse(6, 6);
    ASSERT_TRUE(plugin->calculate_jacobian_inverse(positions, "tool0", inverse));
    EXPECT_LT((J * inverse - Eigen::Matrix<double, 6, 6>::Identity()).cwiseAbs().maxCoeff(), kInverse);
  }
}

TEST(KinematicsInterface, DampsTheInverse) {
  const auto plugin = initialized({{"kinematics.base", std::string("upper_arm")}, {"kinematics.alpha", 0.01}});
  const Eigen::VectorXd q = Eigen::Vector4d(0.5, -0.7, 1.1, 0.3);
  Jacobian J(6, 4);
  Inverse inverse(4, 6);
  ASSERT_TRUE(plugin->calculate_jacobian(q, "tool0", J));
  ASSERT_TRUE(plugin->calculate_jacobian_inverse(q, "tool0", inverse));
  const Eigen::Matrix4d damped = J.transpose() * J + 0.01 * Eigen::Matrix4d::Identity();
  EXPECT_LT((damped * inverse - J.transpose()).cwiseAbs().maxCoeff(), 1e-13);

  const auto undamped = initialized({{"kinematics.alpha", std::int64_t(0)}});
  Inverse none(6, 6);
  EXPECT_FALSE(undamped->calculate_jacobian_inverse(Eigen::VectorXd::Zero(6), "tool0", none));
  EXPECT_EQ(
      last_message(),
      "robcogen.six_axis: the Jacobian has no inverse here: set parameter 'alpha' to a positive number");
}

TEST(KinematicsInterface, DifferenceOfFrames) {
  const auto plugin = load<KinematicsInterface>(KINEMATICS_INTERFACE);  // works before initialisation
  Vector7 a, b;
  const Eigen::Quaterniond A = Eigen::Quaterniond(0.5, -0.2, 0.7, 0.1).normalized();
  const Eigen::Vector3d turn(0.3, -0.4, 1.2);  // in the axes of both
  const Eigen::Quaterniond B = Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * A;
  a << 1, 2, 3, A.coeffs();
  b << 1.5, 2, 1, -2 * B.coeffs();  // the other sign is the same orientation
  Vector6 difference, expected;
  ASSERT_TRUE(plugin->calculate_frame_difference(a, b, 0.5, difference));
  expected << 1, 0, -4, 2 * turn;
  EXPECT_LT((difference - expected).cwiseAbs().maxCoeff(), 1e-14);
  ASSERT_TRUE(plugin->calculate_frame_difference(a, a, 0.5, difference));
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-7);  // the angle is a root of a rounding error
  for (const double dt : {0.0, -0.1, std::nan("")})
    EXPECT_FALSE(plugin->calculate_frame_difference(a, b, dt, difference));
  b.tail<4>().setZero();
  EXPECT_FALSE(plugin->calculate_frame_difference(a, b, 1, difference));
}

TEST(KinematicsInterface, RefusesWrongArguments) {
  const auto plugin = initialized();
  const Eigen::VectorXd q = Eigen::VectorXd::Zero(6), five = Eigen::VectorXd::Zero(5);
  Eigen::VectorXd dq = q, short_dq = five;
  Eigen::Isometry3d X;
  Vector6 dx = Vector6::Zero();
  Jacobian J(6, 6), narrow(6, 5);
  Inverse inverse(6, 6), low(5, 6);
  EXPECT_FALSE(plugin->calculate_link_transform(five, "tool0", X));
  EXPECT_EQ(last_message(), "robcogen.six_axis: joint_pos has 5 elements instead of 6");
  EXPECT_FALSE(plugin->calculate_link_transform(q, "hand", X));
  EXPECT_EQ(
      last_message(),
      "robcogen.six_axis: link 'hand' is not among those that the chain moves: 'base_link', 'shoulder', "
      "'upper_arm', 'forearm', 'wrist_1', 'wrist_2', 'wrist_3', 'tool0'");
  EXPECT_FALSE(plugin->calculate_jacobian(q, "tool0", narrow));
  EXPECT_EQ(last_message(), "robcogen.six_axis: jacobian is for 5 joints instead of 6");
  EXPECT_FALSE(plugin->calculate_jacobian(five, "tool0", J));
  EXPECT_FALSE(plugin->calculate_jacobian_inverse(q, "tool0", low));
  EXPECT_FALSE(plugin->calculate_jacobian_inverse(five, "tool0", inverse));
  EXPECT_FALSE(plugin->convert_joint_deltas_to_cartesian_deltas(q, five, "tool0", dx));
  EXPECT_FALSE(plugin->convert_joint_deltas_to_cartesian_deltas(five, q, "tool0", dx));
  EXPECT_FALSE(plugin->convert_cartesian_deltas_to_joint_deltas(q, dx, "tool0", short_dq));
  EXPECT_FALSE(plugin->convert_cartesian_deltas_to_joint_deltas(q, dx, "hand", dq));
  std::vector<double> vector(6), deltas(6);
  EXPECT_TRUE(plugin->convert_cartesian_deltas_to_joint_deltas(vector, {0, 0, 1, 0, 0, 0}, "tool0", deltas));
}

TEST(KinematicsInterface, RefusesWrongParameters) {
  const auto refused = [](const Values& values, const std::string& text = description()) {
    const auto plugin = load<KinematicsInterface>(KINEMATICS_INTERFACE);
    EXPECT_FALSE(initialize(*plugin, values, text));
    const std::string message = last_message();
    Eigen::Isometry3d X;
    EXPECT_FALSE(plugin->calculate_link_transform(Eigen::VectorXd(Eigen::VectorXd::Zero(6)), "tool0", X));
    EXPECT_EQ(last_message(), "robcogen.six_axis: initialize has not been called, or has failed");
    return message.substr(std::string("robcogen.six_axis: ").size());
  };
  const Values tip = {{"kinematics.tip", std::string("tool0")}};
  const auto with_tip = [&](Values values) {
    values.insert(tip.begin(), tip.end());
    return values;
  };
  EXPECT_EQ(refused({}), "the end effector is not set: parameter 'tip'");
  EXPECT_EQ(refused({{"kinematics.tip", 3.0}}), "the end effector is not set: parameter 'tip'");
  EXPECT_TRUE(refused({{"kinematics.tip", std::string("hand")}}).starts_with("robot 'six_axis' has no link 'hand'"));
  EXPECT_TRUE(refused(with_tip({{"kinematics.base", std::string("floor")}}))
                  .starts_with("robot 'six_axis' has no link 'floor'"));
  EXPECT_EQ(
      refused(with_tip({{"kinematics.alpha", std::string("much")}})), "parameter 'kinematics.alpha' is not a number");
  EXPECT_EQ(refused(with_tip({{"kinematics.alpha", -1.0}})), "parameter 'alpha' must not be negative");
  EXPECT_EQ(refused(with_tip({{"kinematics.joints", 1.0}})), "parameter 'kinematics.joints' is not a list of texts");

  // Robot descriptions.
  EXPECT_EQ(refused(tip, ""), "there is no robot description: parameter 'robot_description'");
  EXPECT_EQ(refused(tip, "<robot"), "the robot description is not a URDF");
  const std::string another = "the robot description is not that of the generated robot 'six_axis': ";
  EXPECT_EQ(
      refused(tip, description_with("joint name=\"joint_4\"", "joint name=\"roll\"")),
      another + "it does not have the joint 'joint_4'");
  EXPECT_EQ(
      refused(tip, description_with("xyz=\"0.45 0 0\"", "xyz=\"0.46 0 0\"")),
      another + "link 'forearm' is 0.01 m and 0 rad from where it should be, with all joints at zero");
  EXPECT_EQ(
      refused(tip, description_with("<axis xyz=\"1 0 0\"/>", "<axis xyz=\"-1 0 0\"/>")).substr(0, another.size()),
      another);

  const auto plugin = load<KinematicsInterface>(KINEMATICS_INTERFACE);
  Values from_node = with_tip({});
  from_node["robot_description"] = description();
  EXPECT_TRUE(initialize(*plugin, from_node, ""));
  EXPECT_TRUE(initialize(*plugin, with_tip({{"kinematics.check_description", false}}), "")) << last_message();
  // Names of links that the library does not have, and numbers that differ by rounding, are no other robot.
  EXPECT_TRUE(initialize(*plugin, tip, description_with("xyz=\"0.45 0 0\"", "xyz=\"0.450001 0 0\""))) << last_message();
}

TEST(KinematicsInterface, AllocatesNothing) {
  const auto plugin = initialized();
  const Eigen::VectorXd q = some_positions(3);
  Eigen::VectorXd dq = q;
  const std::string link = "tool0";
  Vector6 dx = Vector6::Ones();
  Vector7 a = Vector7::Ones(), b = Vector7::Ones();
  Eigen::Isometry3d X;
  Jacobian J(6, 6);
  Inverse inverse(6, 6);
  bool is_good = true;
  {
    const NoAllocation none("the plugin for kinematics_interface");
    is_good = plugin->calculate_link_transform(q, link, X) && plugin->calculate_jacobian(q, link, J) &&
              plugin->calculate_jacobian_inverse(q, link, inverse) &&
              plugin->convert_joint_deltas_to_cartesian_deltas(q, dq, link, dx) &&
              plugin->convert_cartesian_deltas_to_joint_deltas(q, dx, link, dq) &&
              plugin->calculate_frame_difference(a, b, 1e-3, dx);
  }
  EXPECT_TRUE(is_good);
}

}  // namespace
}  // namespace robcogen::test::kinematics_interface_test
