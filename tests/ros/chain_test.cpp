// Poses and Jacobians of links of a chain, by the names of a robot description.
#include "robcogen/ros/chain.h"

#include "plugins.h"
#include "robcogen/ros/description.h"

namespace robcogen::test::chain_test {
namespace {

using ros::Chain;
using Arm = Chain<arm::Robot>;

// Rounding of differences over kStep, for velocities of up to 1 m/s per rad/s.
constexpr double kStep = 1e-6, kDifferenceTolerance = 1e-8;

Arm chain(const std::string& base, const std::string& tip, const std::vector<std::string>& joints = {}) {
  Arm result;
  EXPECT_EQ(result.select(arm::reflection::robot, base, tip, joints), "");
  return result;
}

std::string problem(const std::string& base, const std::string& tip, const std::vector<std::string>& joints = {}) {
  return Arm().select(arm::reflection::robot, base, tip, joints);
}

// The textbook's poses of the links, from the description.
Eigen::Isometry3d expected_pose(const std::string& link, const arm::JointState& q) {
  const auto model = urdf::parseURDF(description());
  return ros::Description<arm::Robot>(arm::reflection::robot, *model).sums(q, Eigen::Vector3d::Zero()).poses.at(link);
}

TEST(Chain, NamesOfDescriptions) {
  EXPECT_TRUE(ros::is_name_of("joint_1", "joint_1"));
  EXPECT_TRUE(ros::is_name_of("left_arm_joint_1", "left-arm/joint.1"));
  EXPECT_TRUE(ros::is_name_of("_1st", "1st"));
  EXPECT_FALSE(ros::is_name_of("1st", "1st"));
  EXPECT_FALSE(ros::is_name_of("joint_1", "joint_12"));
  EXPECT_FALSE(ros::is_name_of("joint_12", "joint_1"));
  EXPECT_FALSE(ros::is_name_of("", "a"));
  EXPECT_EQ(ros::is_frame_of("tool", "tool"), 2);
  EXPECT_EQ(ros::is_frame_of("fr_tool", "tool"), 1);
  EXPECT_EQ(ros::is_frame_of("fr_tool", "fr_tool"), 2);
  EXPECT_EQ(ros::is_frame_of("fr_tool_frame", "fr_tool"), 3);
  EXPECT_EQ(ros::is_frame_of("tools", "tool"), 0);
  EXPECT_EQ(ros::is_frame_of("tool", "tool_frame"), 0);
}

TEST(Chain, PosesAreThoseOfTheDescription) {
  const char* const links[] = {"shoulder", "upper_arm", "forearm", "wrist_1",
                               "wrist_2",  "wrist_3",   "tool0",   "base_link"};
  for (const char* const base : {"", "base_link", "upper_arm", "tool0"}) {
    const Arm c = chain(base, std::string(base) == "tool0" ? "base_link" : "tool0");
    for (int i = 0; i < 5; ++i) {
      const arm::JointState q = some_positions(i);
      const Eigen::Isometry3d B = *base ? expected_pose(base, q) : Eigen::Isometry3d::Identity();
      for (const char* const link : links) {
        const int index = c.find(link);
        if (std::string(base) == "upper_arm" && (std::string(link) == "shoulder" || std::string(link) == "base_link")) {
          EXPECT_EQ(index, -1) << link;  // joints before the base move it
          continue;
        }
        ASSERT_GE(index, 0) << link;
        EXPECT_TRUE(c.pose(q, index).isApprox(B.inverse() * expected_pose(link, q), 1e-12)) << base << " to " << link;
      }
    }
  }
}

TEST(Chain, JacobiansAreDifferencesOfPoses) {
  for (const auto& [base, tip, count] :
       {std::tuple("", "tool0", 6),
        {"upper_arm", "tool0", 4},
        {"tool0", "upper_arm", 4},
        {"wrist_3", "base_link", 6},
        {"base_link", "forearm", 3}}) {
    const Arm c = chain(base, tip);
    ASSERT_EQ(c.size(), count);
    for (const char* const link : {"forearm", tip}) {
      const int index = c.find(link);
      ASSERT_GE(index, 0);
      Eigen::VectorXd q(count);
      for (int j = 0; j < count; ++j) q[j] = std::sin(1 + 3.3 * j);
      Eigen::Matrix<double, 6, Eigen::Dynamic> J(6, count);
      c.jacobian(c.positions(q), index, J);
      for (int j = 0; j < count; ++j) {
        Eigen::VectorXd plus = q, minus = q;
        plus[j] += kStep, minus[j] -= kStep;
        const Eigen::Isometry3d X = c.pose(c.positions(plus), index), Y = c.pose(c.positions(minus), index);
        const Eigen::Matrix3d W =
            (X.linear() - Y.linear()) / (2 * kStep) * c.pose(c.positions(q), index).linear().transpose();
        Eigen::Matrix<double, 6, 1> expected;
        expected << (X.translation() - Y.translation()) / (2 * kStep), W(2, 1), W(0, 2), W(1, 0);
        EXPECT_LT((J.col(j) - expected).cwiseAbs().maxCoeff(), kDifferenceTolerance) << base << ' ' << link << ' ' << j;
      }
    }
  }
}

TEST(Chain, OrderOfJoints) {
  EXPECT_EQ(
      chain("tool0", "upper_arm").joint_names(),
      (std::vector<std::string>{"joint_6", "joint_5", "joint_4", "joint_3"}));
  const Arm c = chain("", "forearm", {"joint_3", "joint_6", "joint_1", "joint_2"});
  const arm::JointState q = c.positions(Eigen::Vector4d(0.3, 0.6, 0.1, 0.2));
  EXPECT_EQ(q, (arm::JointState() << 0.1, 0.2, 0.3, 0, 0, 0.6).finished());
  Eigen::Matrix<double, 6, Eigen::Dynamic> J(6, 4);
  c.jacobian(q, c.find("forearm"), J);
  EXPECT_EQ(J.col(1).norm(), 0) << "joint_6 is not on the path";
  EXPECT_EQ(J(5, 2), 1) << "joint_1 turns about z";
}

TEST(Chain, SaysWhatIsWrong) {
  EXPECT_EQ(
      problem("", "tool"),
      "robot 'six_axis' has no link 'tool'; its links are 'base_link', 'shoulder', 'upper_arm', 'forearm', "
      "'wrist_1', 'wrist_2', 'wrist_3', 'tool0'");
  EXPECT_EQ(problem("tool0", "tool0"), "link 'tool0' does not move with respect to 'tool0'");
  EXPECT_EQ(problem("", "base_link"), "link 'base_link' does not move with respect to the root");
  EXPECT_EQ(problem("", "upper_arm", {"joint_1"}), "joint 'joint_2' is missing among the joints");
  EXPECT_EQ(problem("", "upper_arm", {"joint_1", "joint_1"}), "joint 'joint_1' is listed twice");
  EXPECT_EQ(
      problem("", "upper_arm", {"elbow"}),
      "robot 'six_axis' has no joint 'elbow'; its joints are 'joint_1', 'joint_2', 'joint_3', 'joint_4', 'joint_5', "
      "'joint_6'");
}

}  // namespace
}  // namespace robcogen::test::chain_test
