// Transforms and Jacobians of every pair of frames, compared with plain matrix products.
#include "algorithm/kinematics/kinematics.h"

#include <Eigen/Dense>
#include <map>
#include <random>

#include "model/descriptions.h"
#include "symbolic/interpret.h"
#include "symbolic/text.h"
#include "symbolic/verify.h"
#include "values.h"

namespace robcogen::algorithm::kinematics_test {
namespace {

using model::FramePair;
using model::KinematicTree;
using model::Quantity;

using Matrix6 = Eigen::Matrix<double, 6, 6>;

// base -a-> trunk -> (b-> arm -e-> hand, c-> leg): revolute and prismatic joints in skew places, frames on every kind
// of link.
KinematicTree robot(bool skew) {
  using model::test::pi;
  const auto placed = [&](double x, double y, double z, const Quantity& rx, const Quantity& ry, const Quantity& rz) {
    return model::Placement{{Quantity(x), Quantity(y), Quantity(z)}, {rx, ry, rz}};
  };
  model::Description d;
  d.name = "robot";
  d.base = model::test::link("base", {{"trunk", "a", {}, {}}});
  d.links = {
      model::test::link("hand"), model::test::link("leg"), model::test::link("arm", {{"hand", "e", {}, {}}}),
      model::test::link("trunk", {{"arm", "b", {}, {}}, {"leg", "c", {}, {}}})};
  using model::JointType;
  const Quantity zero;
  if (skew)
    d.joints = {
        model::test::joint(
            "e", JointType::revolute, placed(0.1, 0.2, 0.3, Quantity(-0.4), Quantity(0.5), Quantity(0.6))),
        model::test::joint("c", JointType::prismatic, placed(0.3, 0, -0.1, Quantity(0.7), pi(1, 4), Quantity(-1.2))),
        model::test::joint("b", JointType::prismatic, placed(0, 0.4, 0.1, Quantity(1.1), Quantity(-0.8), zero)),
        model::test::joint("a", JointType::revolute, placed(0, 0, 0.9, Quantity(0.2), zero, Quantity(0.3)))};
  else
    d.joints = {
        model::test::joint("e", JointType::revolute, placed(0.1, 0, 0, pi(-1, 2), zero, zero)),
        model::test::joint("c", JointType::revolute, placed(0.3, 0, -0.1, pi(1, 2), pi(1), zero)),
        model::test::joint("b", JointType::prismatic, placed(0, 0.4, 0, zero, pi(1, 2), pi(1, 2))),
        model::test::joint("a", JointType::revolute, placed(0, 0, 0, zero, zero, zero))};
  d.links[0].frames = {{"finger", placed(0.05, 0.06, 0.07, Quantity(0.1), Quantity(0.2), Quantity(0.3)), {}}};
  d.links[1].frames = {{"sole", placed(0, 0, 0.3, pi(1, 2), zero, zero), {}}};
  d.base.frames = {{"camera", placed(1, 2, 3, zero, Quantity(0.4), zero), {}}};
  Diagnostics diagnostics;
  const auto tree = model::build(d, diagnostics);
  EXPECT_TRUE(tree) << diagnostics.render();
  return *tree;
}

Eigen::Isometry3d joint_motion(const model::Joint& joint, double q) {
  return joint.type == model::JointType::revolute ? Eigen::Isometry3d(Eigen::AngleAxisd(q, Eigen::Vector3d::UnitZ()))
                                                  : Eigen::Isometry3d(Eigen::Translation3d(0, 0, q));
}

Eigen::Isometry3d link_in_base(const KinematicTree& tree, int link, const std::vector<double>& q) {
  const int j = tree.links[static_cast<std::size_t>(link)].parent_joint;
  if (j < 0) return Eigen::Isometry3d::Identity();
  const model::Joint& joint = tree.joints[static_cast<std::size_t>(j)];
  return link_in_base(tree, joint.parent, q) * model::test::pose(joint.placement) *
         joint_motion(joint, q[static_cast<std::size_t>(j)]);
}

Eigen::Isometry3d frame_in_base(const KinematicTree& tree, const model::Frame& frame, const std::vector<double>& q) {
  const Eigen::Isometry3d link = link_in_base(tree, tree.link_of(frame), q);
  const auto i = static_cast<std::size_t>(frame.index);
  if (frame.kind == model::Frame::Kind::joint) return link * model::test::pose(tree.joints[i].placement);
  if (frame.kind == model::Frame::Kind::user) return link * model::test::pose(tree.user_frames[i].placement);
  return link;
}

Eigen::Isometry3d relative(const KinematicTree& tree, const FramePair& pair, const std::vector<double>& q) {
  return frame_in_base(tree, pair.left, q).inverse() * frame_in_base(tree, pair.right, q);
}

Eigen::Matrix3d skew(const Eigen::Vector3d& p) {
  Eigen::Matrix3d m;
  m << 0, -p.z(), p.y(), p.z(), 0, -p.x(), -p.y(), p.x(), 0;
  return m;
}

// Every ordered pair of frames, including each frame with itself.
std::vector<FramePair> all_pairs(const KinematicTree& tree) {
  std::vector<FramePair> pairs;
  for (const model::Frame& left : tree.frames())
    for (const model::Frame& right : tree.frames()) pairs.push_back({left, right});
  return pairs;
}

class Kinematics : public testing::TestWithParam<bool> {
 protected:
  KinematicTree tree = robot(GetParam());
  std::vector<double> q{0.7, -0.4, 0.25, 1.3};

  Eigen::MatrixXd run(const symbolic::Program& p) const {
    EXPECT_EQ(verify(p), "");
    const symbolic::OutputArray& shape = p.outputs.at(0);
    const std::vector<double> values = symbolic::interpret<double>(p, {{"q", q}}).at(shape.name);
    return Eigen::Map<const Eigen::MatrixXd>(values.data(), shape.rows, shape.columns);
  }
};

TEST_P(Kinematics, HomogeneousTransforms) {
  for (const FramePair& pair : all_pairs(tree)) {
    const Eigen::MatrixXd x = run(coordinate_transform(tree, pair, TransformForm::homogeneous, "x"));
    EXPECT_TRUE(x.isApprox(relative(tree, pair, q).matrix(), test::kTolerance)) << pair.left.name << pair.right.name;
  }
}

TEST_P(Kinematics, MotionAndForceTransforms) {
  for (const FramePair& pair : all_pairs(tree)) {
    const Eigen::Isometry3d t = relative(tree, pair, q);
    const Eigen::Matrix3d r = t.linear(), pr = skew(t.translation()) * r, none = Eigen::Matrix3d::Zero();
    Matrix6 motion, force;
    motion << r, none, pr, r;
    force << r, pr, none, r;
    EXPECT_TRUE(run(coordinate_transform(tree, pair, TransformForm::spatial_motion, "x")).isApprox(motion, 1e-13));
    EXPECT_TRUE(run(coordinate_transform(tree, pair, TransformForm::spatial_force, "x")).isApprox(force, 1e-13));
    // Power is the same in both frames.
    EXPECT_TRUE((motion.transpose() * force).isIdentity(1e-12));
  }
}

// The joints between two links: those above exactly one of them.
std::map<int, bool> joints_between(const KinematicTree& tree, const FramePair& pair) {
  const auto above = [&](const model::Frame& frame) {
    std::map<int, bool> joints;
    for (int j = tree.links[static_cast<std::size_t>(tree.link_of(frame))].parent_joint; j >= 0;
         j = tree.parent_joint_of(j))
      joints[j] = true;
    return joints;
  };
  std::map<int, bool> between;
  const auto left = above(pair.left), right = above(pair.right);
  for (const auto& [j, unused] : left)
    if (!right.contains(j)) between[j] = true;
  for (const auto& [j, unused] : right)
    if (!left.contains(j)) between[j] = true;
  return between;
}

// Angular velocity and velocity of the right frame's origin, from central differences of its pose in the left frame.
Eigen::Matrix<double, 6, 1> twist(const KinematicTree& tree, const FramePair& pair, std::vector<double> q, int joint) {
  constexpr double kStep = 1e-5;
  const Eigen::Matrix3d r = relative(tree, pair, q).linear();
  double& moved = q[static_cast<std::size_t>(joint)];
  moved += kStep;
  const Eigen::Isometry3d after = relative(tree, pair, q);
  moved -= 2 * kStep;
  const Eigen::Isometry3d before = relative(tree, pair, q);
  const Eigen::Matrix3d w = (after.linear() - before.linear()) / (2 * kStep) * r.transpose();
  Eigen::Matrix<double, 6, 1> result;
  result << w(2, 1), w(0, 2), w(1, 0), (after.translation() - before.translation()) / (2 * kStep);
  return result;
}

TEST_P(Kinematics, Jacobians) {
  constexpr double kDifferences = 1e-9;  // square of the step, and rounding errors divided by the step
  for (const FramePair& pair : all_pairs(tree)) {
    SCOPED_TRACE(pair.left.name + "_J_" + pair.right.name);
    const std::vector<int> columns = chain_coordinates(tree, pair);
    const Eigen::MatrixXd j = run(geometric_jacobian(tree, pair, "j"));
    ASSERT_EQ(j.rows(), 6);
    ASSERT_EQ(j.cols(), static_cast<Eigen::Index>(columns.size()));
    std::map<int, bool> chain;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      chain[columns[k]] = true;
      const auto expected = twist(tree, pair, q, columns[k]);
      EXPECT_LT((j.col(static_cast<Eigen::Index>(k)) - expected).norm(), kDifferences) << columns[k];
    }
    EXPECT_EQ(chain, joints_between(tree, pair));
    EXPECT_EQ(chain.size(), columns.size());
  }
}

INSTANTIATE_TEST_SUITE_P(, Kinematics, testing::Bool(), [](const auto& kind) {
  return kind.param ? "skew" : "square";
});

FramePair pair_of(const KinematicTree& tree, const char* left, const char* right) {
  return {*tree.find_frame(left), *tree.find_frame(right)};
}

TEST(KinematicChain, ColumnsAreTheJointsFromLeftToRight) {
  const KinematicTree tree = robot(true);  // joints: e c b a
  EXPECT_EQ(chain_coordinates(tree, pair_of(tree, "camera", "finger")), (std::vector<int>{3, 2, 0}));
  EXPECT_EQ(chain_coordinates(tree, pair_of(tree, "finger", "camera")), (std::vector<int>{0, 2, 3}));
  EXPECT_EQ(chain_coordinates(tree, pair_of(tree, "finger", "sole")), (std::vector<int>{0, 2, 1}));
  EXPECT_EQ(chain_coordinates(tree, pair_of(tree, "fr_base", "fr_a")), (std::vector<int>{}));
}

TEST(KinematicChain, FramesOfOneLinkHaveAJacobianWithoutColumns) {
  const KinematicTree tree = robot(true);
  const symbolic::Program p = geometric_jacobian(tree, pair_of(tree, "fr_base", "camera"), "j");
  EXPECT_EQ(p.outputs[0].rows, 6);
  EXPECT_EQ(p.outputs[0].columns, 0);
  EXPECT_TRUE(p.outputs[0].values.empty());
  EXPECT_TRUE(p.statements.empty());
}

TEST(KinematicChain, AFrameInItselfIsTheIdentityAndCostsNothing) {
  const KinematicTree tree = robot(true);
  for (const model::Frame& frame : tree.frames()) {
    const symbolic::Program p = coordinate_transform(tree, {frame, frame}, TransformForm::spatial_motion, "x");
    EXPECT_TRUE(p.statements.empty()) << frame.name;
  }
}

// Each joint costs one sine and cosine, whatever is between the joints.
TEST(KinematicChain, EachJointCostsOneSineAndCosine) {
  const KinematicTree tree = robot(true);
  const FramePair pair = pair_of(tree, "camera", "finger");
  EXPECT_EQ(symbolic::cost(coordinate_transform(tree, pair, TransformForm::homogeneous, "x")).sincos, 2);
  EXPECT_EQ(symbolic::cost(geometric_jacobian(tree, pair, "j")).sincos, 2);
}

}  // namespace
}  // namespace robcogen::algorithm::kinematics_test
