// Joints of all types, compared with their motion subspaces in 6 x 6 Eigen matrices.
#include "algorithm/spatial/joint.h"

#include "bodies.h"
#include "hand_robots.h"

namespace robcogen::algorithm::joint_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::Cloud;
using test::kTolerance;
using test::Matrix6d;
using test::Numbers;
using test::RandomPose;
using test::Vector6d;

// A joint of one type, with the numbers of random states.
class JointTypes : public testing::TestWithParam<std::tuple<model::JointType, int>> {
 protected:
  static constexpr double kPitch = -0.7;

  model::JointType type = std::get<0>(GetParam());
  Numbers n{static_cast<unsigned>(std::get<1>(GetParam()))};
  Joint joint{0, 1, type, n.expression(kPitch)};
  double turn = type == model::JointType::prismatic ? 0 : 1;
  double slide = type == model::JointType::revolute ? 0 : type == model::JointType::prismatic ? 1 : kPitch;
  int axis = turn == 1 ? 2 : 5;  // element of the coordinate
  // Featherstone 2008, table 4.1.
  Vector6d S = turn * Vector6d::Unit(2) + slide * Vector6d::Unit(5);

  Motion motion() { return {n.vector(), n.vector()}; }
  Force force() { return {n.vector(), n.vector()}; }
};

TEST_P(JointTypes, MovesAlongItsSubspace) {
  EXPECT_EQ(value(n, subspace(joint, n.graph)), S);
  const double rate = n.real();
  Motion moved = motion();
  const Vector6d before = value(n, moved);
  add_rate(joint, n.expression(rate), moved);
  EXPECT_TRUE(value(n, moved).isApprox(before + S * rate, kTolerance));
}

TEST_P(JointTypes, FeelsTheForceAlongIt) {
  Force f = force();
  const Vector6d before = value(n, f);
  EXPECT_NEAR(n.value(project(joint, f)), S.dot(before), kTolerance);
  const double wanted = n.real();
  set_projection(joint, n.expression(wanted), f);
  EXPECT_NEAR(n.value(project(joint, f)), wanted, kTolerance);
  Vector6d change = value(n, f) - before;
  change[axis] = 0;
  EXPECT_TRUE(change.isZero(0));
  EXPECT_EQ(feels_only_moment(joint), S.tail<3>().isZero(0));
}

TEST_P(JointTypes, GivesUpItsRate) {
  Motion v = motion();
  const Vector6d before = value(n, v);
  const double rate = n.value(take_rate(joint, v));
  EXPECT_EQ(rate, before[axis]);
  EXPECT_TRUE(value(n, v).isApprox(before - S * rate, kTolerance));
}

// S x V: the matrix [w]x 0; [v]x [w]x of S, times V (Featherstone 2008, eq. 2.31).
TEST_P(JointTypes, CrossProductOfTheSubspace) {
  const Motion v = motion();
  Matrix6d cross = Matrix6d::Zero();
  cross.topLeftCorner<3, 3>() = cross.bottomRightCorner<3, 3>() = test::cross_matrix(S.head<3>());
  cross.bottomLeftCorner<3, 3>() = test::cross_matrix(S.tail<3>());
  EXPECT_TRUE(value(n, cross_subspace(joint, v)).isApprox(cross * value(n, v), kTolerance));
}

TEST_P(JointTypes, VelocityOfAChild) {
  const RandomPose random(n);
  const Motion parent = motion();
  const double rate = n.real();
  const Vector6d expected = test::motion_transform(random.transform.inverse()) * value(n, parent) + S * rate;
  EXPECT_TRUE(value(n, across_joint(joint, random.pose, parent, {n.expression(rate)})).isApprox(expected, 1e-12));
}

// Accelerations of a point of the parent, in moving axes.
TEST_P(JointTypes, MotionOfAChild) {
  const RandomPose random(n);
  const LinkMotion parent{{n.vector(), n.vector()}, n.vector()};
  const double rate = n.real(), acceleration = n.real();
  const Expression qd = n.expression(rate), qdd = n.expression(acceleration);
  const Matrix3d r = random.transform.linear().transpose();
  const Vector3d p = random.transform.translation();
  const Vector3d w = n.value(parent.angular.w), wd = n.value(parent.angular.wd), a = n.value(parent.a);
  const Vector3d z = Vector3d::UnitZ(), along = random.transform.linear() * z;
  const Vector3d carried = a + wd.cross(p) + w.cross(w.cross(p));

  const LinkMotion child = across_joint(joint, random.pose, parent, {qd}, {qdd});
  const Vector3d turning = turn * rate * z;
  EXPECT_TRUE(n.value(child.angular.w).isApprox(r * w + turning, kTolerance));
  const Vector3d turned = turn * (w.cross(rate * along) + acceleration * along);
  EXPECT_TRUE(n.value(child.angular.wd).isApprox(r * (wd + turned), kTolerance));
  const Vector3d slid = slide * (2 * w.cross(rate * along) + acceleration * along);
  EXPECT_TRUE(n.value(child.a).isApprox(r * (carried + slid), kTolerance));
}

TEST_P(JointTypes, InertiaTimesTheSubspace) {
  const Cloud body = Cloud::random(n);
  const Vector6d expected = body.spatial_inertia() * S;
  const MassProperties symbols = body.symbols(n);
  EXPECT_TRUE(value(n, times_subspace(symbols, joint)).isApprox(expected, kTolerance));
  const SpatialInertia any = {n.symmetric(), n.matrix(), n.symmetric()};
  EXPECT_TRUE(value(n, times_subspace(any, joint)).isApprox(value(n, any) * S, kTolerance));
}

// The remaining inertia is the Schur complement; a free joint takes no force.
TEST_P(JointTypes, ReleasedInertiaIsTheSchurComplement) {
  const SpatialInertia body = {n.symmetric(), n.matrix(), n.symmetric()};
  const Matrix6d whole = value(n, body);
  const double D = S.dot(whole * S);
  if (std::abs(D) < 0.1) return;  // too small to divide by
  const Force U = times_subspace(body, joint);
  const Force gain = (n.graph.one() / project(joint, U)) * U;
  const SpatialInertia left = released(body, joint, U, gain);
  const Matrix6d schur = whole - whole * S * (whole * S).transpose() / D;
  EXPECT_TRUE(value(n, left).isApprox(schur, 1e-12));
  EXPECT_TRUE(value(n, reduced(body, U, gain)).isApprox(schur, 1e-12));
  EXPECT_LE((value(n, left) * S).norm(), kTolerance * schur.norm());
  if (type == model::JointType::helical) return;
  const SquareMatrix elements = matrix(left);
  for (int k = 0; k < 6; ++k) EXPECT_TRUE(elements(k, axis).is_zero() && elements(axis, k).is_zero()) << k;
}

INSTANTIATE_TEST_SUITE_P(
    ,
    JointTypes,
    testing::Combine(
        testing::Values(model::JointType::revolute, model::JointType::prismatic, model::JointType::helical),
        testing::Range(0, 20)));

TEST(JointOfATree, IsThatOfTheModel) {
  const model::KinematicTree tree = test::ball_and_bead();
  Trace trace(tree);
  const Joint joint = joint_of(trace, 0);
  EXPECT_EQ(joint.index, 0);
  EXPECT_EQ(tree.links[static_cast<std::size_t>(joint.child)].name, "bead");
  EXPECT_EQ(joint.type, model::JointType::prismatic);
}

}  // namespace
}  // namespace robcogen::algorithm::joint_test
