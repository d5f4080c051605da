// Paths between frames: their segments, and the poses that they lead to, compared with Eigen.
#include "algorithm/kinematics/path.h"

#include <Eigen/Geometry>

#include "bodies.h"
#include "hand_robots.h"

namespace robcogen::algorithm::path_test {
namespace {

using namespace test;
using model::FramePair;
using model::JointType;
using model::KinematicTree;
using model::Quantity;
using symbolic::Role;

constexpr double kPoses = 1e-13;  // products of a few matrices

model::Placement placed(std::array<double, 3> t, std::array<double, 3> r) {
  model::Placement p;
  for (std::size_t k = 0; k < 3; ++k) {
    p.translation[k] = Quantity(t[k]);
    p.rotation[k] = Quantity(r[k]);
  }
  return p;
}

// base -turn-> arm -slide-> hand with a frame `tip`; base -tilt-> leg. The document declares them in another order.
KinematicTree robot() {
  model::Description d;
  d.name = "robot";
  d.base = model::test::link("base", {{"arm", "turn", {}, {}}, {"leg", "tilt", {}, {}}});
  d.links = {
      model::test::link("hand"), model::test::link("leg"), model::test::link("arm", {{"hand", "slide", {}, {}}})};
  d.joints = {
      model::test::joint("slide", JointType::prismatic, placed({0.1, -0.2, 0.3}, {0.4, 0, -0.5})),
      model::test::joint("tilt", JointType::revolute, placed({0, 0.7, 0}, {-1.2, 0.3, 0})),
      model::test::joint("turn", JointType::revolute, placed({0.5, 0, 0.25}, {0, 0.8, 0.1}))};
  d.links[0].frames = {{"tip", placed({0, 0.05, 0.6}, {0.2, 0.3, 0}), {}}};
  return built(d);
}

const std::vector<double> kQ = {0.35, -0.9, 1.4};  // slide, tilt, turn

Eigen::Isometry3d motion_of(const KinematicTree& tree, int joint) {
  const double q = kQ[static_cast<std::size_t>(joint)];
  if (tree.joints[static_cast<std::size_t>(joint)].type == JointType::prismatic)
    return Eigen::Isometry3d(Eigen::Translation3d(0, 0, q));
  return Eigen::Isometry3d(Eigen::AngleAxisd(q, Eigen::Vector3d::UnitZ()));
}

Eigen::Isometry3d child_in_parent(const KinematicTree& tree, int joint) {
  return model::test::pose(tree.joints[static_cast<std::size_t>(joint)].placement) * motion_of(tree, joint);
}

class Paths : public testing::Test {
 protected:
  KinematicTree tree = robot();
  // leg -> tip: backwards along `tilt`, then along `turn` and `slide`.
  Path path = path_between(tree, pair("fr_leg", "tip"));
  Eigen::Isometry3d to_arm = child_in_parent(tree, 1).inverse() * child_in_parent(tree, 2);
  Eigen::Isometry3d to_hand = to_arm * child_in_parent(tree, 0);
  Eigen::Isometry3d to_tip = to_hand * model::test::pose(tree.user_frames.at(0).placement);

  FramePair pair(const char* left, const char* right) const {
    return {*tree.find_frame(left), *tree.find_frame(right)};
  }
  Eigen::MatrixXd transform(const Path& p, TransformForm form) const {
    const symbolic::Program program = transform_along(tree, p, form, "x");
    const std::vector<double> values = run(program, {{"q", kQ}});
    const int rows = program.outputs[0].rows;
    return Eigen::Map<const Eigen::MatrixXd>(values.data(), rows, rows);
  }
};

TEST_F(Paths, AreCutBehindEachJoint) {
  ASSERT_EQ(path.size(), 4U);
  const char* const joints[] = {"tilt", "turn", "slide"};
  for (std::size_t k = 0; k < 3; ++k) {
    const PathSegment& segment = path[k];
    ASSERT_EQ(segment.joints.size(), 1U);
    EXPECT_EQ(segment.subject, joints[k]);
    EXPECT_EQ(segment.passed, std::string("joint ") + joints[k]);
    EXPECT_EQ(tree.joints[static_cast<std::size_t>(segment.joints.front().joint)].name, joints[k]);
    EXPECT_EQ(segment.joints.front().backward, k == 0);
    for (const model::PrimitiveTransform& p : segment.primitives)
      EXPECT_EQ(p.amount.is_constant(), &p != &segment.primitives.back());
  }
  EXPECT_TRUE(path[3].subject.empty());
  EXPECT_TRUE(path[3].joints.empty());
  for (const model::PrimitiveTransform& p : path[3].primitives) EXPECT_TRUE(p.amount.is_constant());
}

TEST_F(Paths, OfFramesOfOneLinkHaveOneSegment) {
  const Path fixed = path_between(tree, pair("fr_hand", "tip"));
  ASSERT_EQ(fixed.size(), 1U);
  EXPECT_TRUE(fixed[0].joints.empty());
}

TEST_F(Paths, LeadPastEachJoint) {
  // Backwards past `tilt`: to this joint's frame, which is fixed to the base.
  const Eigen::Isometry3d expected[] = {motion_of(tree, 1).inverse(), to_arm, to_hand, to_tip};
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  std::vector<PathPose> reached;
  reached.push_back(walk(trace, path, q, [&](const PathSegment& segment, const PathPose& here) {
    ASSERT_LT(reached.size(), 3U);
    EXPECT_EQ(segment.subject, path[reached.size()].subject);
    reached.push_back(here);
  }));
  ASSERT_EQ(reached.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Matrix3d rotation(evaluate(trace.graph, kQ, flat(reached[k].rotation)).data());
    const Eigen::Vector3d position(evaluate(trace.graph, kQ, flat(reached[k].position)).data());
    EXPECT_TRUE(rotation.isApprox(expected[k].linear(), kPoses)) << k;
    EXPECT_LT((position - expected[k].translation()).norm(), kPoses) << k;
  }
}

TEST_F(Paths, EndInTheOtherFrame) {
  EXPECT_TRUE(transform(path, TransformForm::homogeneous).isApprox(to_tip.matrix(), kPoses));
  EXPECT_TRUE(transform(path, TransformForm::spatial_motion).isApprox(motion_transform(to_tip), kPoses));
  EXPECT_TRUE(transform(path, TransformForm::spatial_force).isApprox(force_transform(to_tip), kPoses));
}

TEST_F(Paths, LeadBackToo) {
  const Path back = path_between(tree, pair("tip", "fr_leg"));
  ASSERT_EQ(back.size(), 4U);
  for (std::size_t k = 0; k < 3; ++k) {
    ASSERT_EQ(back[k].joints.size(), 1U);
    EXPECT_EQ(back[k].joints.front().backward, back[k].subject != "tilt");
  }
  EXPECT_TRUE(transform(back, TransformForm::homogeneous).isApprox(to_tip.inverse().matrix(), kPoses));
}

TEST_F(Paths, NameWhatTheyPass) {
  const symbolic::Program p = transform_along(tree, path, TransformForm::homogeneous, "x");
  ASSERT_FALSE(p.sections.empty());
  EXPECT_NE(symbolic::print(p).find("past joint turn"), std::string::npos) << symbolic::print(p);
  EXPECT_NE(symbolic::print(p).find("turn_Rx"), std::string::npos) << symbolic::print(p);
}

PathSegment segment(std::vector<model::PrimitiveTransform> primitives) {
  return {std::move(primitives), "", "", {}};
}

TEST(PathTail, BeginsBehindTheLastRotation) {
  const model::PrimitiveTransform turn{true, model::Axis::z, Quantity(0.5)},
      slide{false, model::Axis::x, Quantity(2.0)};
  EXPECT_EQ(behind_last_turn({segment({slide}), segment({slide})}), 0);
  EXPECT_EQ(behind_last_turn({segment({slide, turn}), segment({slide}), segment({slide})}), 1);
  EXPECT_EQ(behind_last_turn({segment({turn}), segment({turn, slide}), segment({slide})}), 1);
  // Nothing follows the last turn.
  EXPECT_EQ(behind_last_turn({segment({turn}), segment({slide, turn})}), 1);
  EXPECT_EQ(behind_last_turn({segment({})}), 0);
}

}  // namespace
}  // namespace robcogen::algorithm::path_test
