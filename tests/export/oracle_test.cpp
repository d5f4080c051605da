// Exported robots, evaluated by urdfdom and textbook formulas, compared with the robots themselves, evaluated by the
// interpreter.
#include <gtest/gtest.h>

#include "export/urdf.h"
#include "interpreted_robot.h"
#include "random_robot.h"
#include "robcogen/reference/samples.h"
#include "robots.h"
#include "urdf_reader.h"

namespace robcogen::oracle_test {
namespace {

using model::Frame;
using model::KinematicTree;

constexpr std::uint64_t kSeed = 11;
constexpr int kStates = 3;
// Products of about forty poses and as many roundings of the numbers in the URDF, relative to the largest element.
constexpr double kTolerance = 2e-13;

// Requests base_X_frame for every link frame and user frame.
model::DesiredTransforms all_poses(const KinematicTree& tree) {
  model::DesiredTransforms desired;
  const std::vector<Frame> frames = tree.frames();
  for (const Frame& frame : frames) {
    if (frame.kind != Frame::Kind::joint) desired.transforms.push_back({frames.front(), frame});
  }
  return desired;
}

template <class Found>
double difference(const Found& found, const reference::Matrix<double>& expected) {
  EXPECT_EQ(found.rows(), expected.rows());
  double largest = 0;
  for (int j = 0; j < expected.cols(); ++j) {
    for (int i = 0; i < expected.rows(); ++i) largest = std::max(largest, std::abs(found(i, j) - expected(i, j)));
  }
  return largest / std::max(1e-300, reference::largest(expected));
}

// Names of the joints: first the independent ones, then those that follow them.
std::vector<std::string> joint_names(const KinematicTree& tree) {
  std::vector<std::string> names;
  for (const int j : independent_joints_first(tree)) names.push_back(tree.joints[static_cast<std::size_t>(j)].name);
  return names;
}

// The inertia matrix over the base and the coordinates, from the matrix over the base and all joints.
Eigen::MatrixXd reduced(const Eigen::MatrixXd& H, const reflection::Robot& robot) {
  const reference::Matrix<double> coupling = reference::coupling_matrix<double>(robot);
  Eigen::MatrixXd G = Eigen::MatrixXd::Identity(H.rows(), 6 + robot.dof());
  for (int i = 0; i < coupling.rows(); ++i)
    for (int j = 0; j < coupling.cols(); ++j) G(6 + i, 6 + j) = coupling(i, j);
  return G.transpose() * H * G;
}

// True if a user frame has the link's name: the URDF link then has this frame, otherwise the link frame.
bool has_user_frame_of_its_name(const KinematicTree& tree, int link) {
  return std::any_of(tree.user_frames.begin(), tree.user_frames.end(), [&](const model::UserFrame& frame) {
    return frame.link == link && frame.name == tree.links[static_cast<std::size_t>(link)].name;
  });
}

void expect_agreement(const KinematicTree& tree) {
  const test::UrdfReader urdf(exporting::urdf(tree));
  EXPECT_EQ(urdf.complaints(), "");
  EXPECT_EQ(urdf.model().getName(), tree.name);
  EXPECT_EQ(urdf.base().name, tree.links[0].name);
  const model::DesiredTransforms desired = all_poses(tree);
  const numeric::InterpretedRobot robot(tree, desired, {});
  std::mt19937_64 engine(kSeed);
  for (int state = 0; state < kStates; ++state) {
    const reference::Vector<double> q = reference::random_sample(engine, robot.tables()).motion.q;
    test::UrdfReader::Positions positions;
    const std::vector<std::string> joints = joint_names(tree);
    const reference::Vector<double> all = reference::joint_positions(robot.tables(), q);
    for (std::size_t j = 0; j < joints.size(); ++j) positions[joints[j]] = all(static_cast<int>(j));

    const reference::Matrix<double> H = robot.joint_space_inertia(q);
    const Eigen::MatrixXd found = reduced(urdf.inertia_matrix(joints, positions), robot.tables());
    EXPECT_LT(difference(found.bottomRightCorner(H.rows(), H.cols()).eval(), H), kTolerance) << "inertia matrix";

    const auto poses = urdf.poses(positions);
    for (std::size_t k = 0; k < desired.transforms.size(); ++k) {
      const Frame& frame = desired.transforms[k].right;
      if (frame.kind == Frame::Kind::link && has_user_frame_of_its_name(tree, frame.index)) continue;
      const std::string link =
          frame.kind == Frame::Kind::link ? tree.links[static_cast<std::size_t>(frame.index)].name : frame.name;
      ASSERT_TRUE(poses.contains(link)) << link;
      const reference::Matrix<double> expected = robot.transform(static_cast<int>(k), q).homogeneous;
      EXPECT_LT(difference(poses.at(link).matrix(), expected), kTolerance) << "pose of " << link;
    }
  }
}

TEST(ExportedUrdf, IsTheSameRobotForAnIndependentReader) {
  for (const test::NamedRobot& robot : test::constant_robots()) {
    SCOPED_TRACE(robot.document);
    KinematicTree tree = robot.tree;
    tree.uses_passive_forces = false;  // as in the reader
    expect_agreement(tree);
  }
}

TEST(ExportedUrdf, OfRandomRobotsIsTheSameForAnIndependentReader) {
  constexpr std::uint64_t kRobots = 100;
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    const KinematicTree tree = numeric::random_robot(seed, {.screws = false});
    SCOPED_TRACE(numeric::describe(tree));
    expect_agreement(tree);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace robcogen::oracle_test
