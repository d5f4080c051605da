// Joints of both types against their motion subspace in 6 x 6 matrices of Eigen.
#include "algorithm/spatial/joint.h"

#include "bodies.h"
#include "hand_robots.h"

namespace robcogen::algorithm {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::Cloud;
using test::kTolerance;
using test::Matrix6d;
using test::Numbers;
using test::RandomPose;
using test::Vector6d;

// A joint of each type, with the numbers of random states.
class JointTypes : public testing::TestWithParam<std::tuple<model::JointType, int>> {
 protected:
  bool revolute = std::get<0>(GetParam()) == model::JointType::revolute;
  Joint joint{0, 1, std::get<0>(GetParam())};
  Numbers n{static_cast<unsigned>(std::get<1>(GetParam()))};
  // Featherstone 2008, table 4.1.
  Vector6d S = Vector6d::Unit(revolute ? 2 : 5);

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
  EXPECT_EQ(n.value(project(joint, f)), S.dot(before));
  const double wanted = n.real();
  set_projection(joint, n.expression(wanted), f);
  EXPECT_EQ(value(n, f), before - S * S.dot(before) + S * wanted);
  EXPECT_EQ(feels_only_moment(joint), S.tail<3>().isZero(0));
}

TEST_P(JointTypes, GivesUpItsRate) {
  Motion v = motion();
  const Vector6d before = value(n, v);
  EXPECT_EQ(n.value(take_rate(joint, v)), S.dot(before));
  EXPECT_EQ(value(n, v), before - S * S.dot(before));
}

// S x V = [w]x 0; [v]x [w]x of S, times V (Featherstone 2008, eq. 2.31).
TEST_P(JointTypes, CrossProductOfTheSubspace) {
  const Motion v = motion();
  Matrix6d cross = Matrix6d::Zero();
  cross.topLeftCorner<3, 3>() = cross.bottomRightCorner<3, 3>() = test::cross_matrix(S.head<3>());
  cross.bottomLeftCorner<3, 3>() = test::cross_matrix(S.tail<3>());
  EXPECT_EQ(value(n, cross_subspace(joint, v)), cross * value(n, v));
}

TEST_P(JointTypes, VelocityOfAChild) {
  const RandomPose random(n);
  const Motion parent = motion();
  const double rate = n.real();
  const Vector6d expected = test::motion_transform(random.transform.inverse()) * value(n, parent) + S * rate;
  EXPECT_TRUE(value(n, across_joint(joint, random.pose, parent, n.expression(rate))).isApprox(expected, 1e-12));
}

// Accelerations of a point of the parent in moving axes.
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

  const LinkMotion child = across_joint(joint, random.pose, parent, qd, qdd);
  const Vector3d turning = revolute ? Vector3d(rate * z) : Vector3d::Zero();
  EXPECT_TRUE(n.value(child.angular.w).isApprox(r * w + turning, kTolerance));
  const Vector3d turned = revolute ? Vector3d(w.cross(rate * along) + acceleration * along) : Vector3d::Zero();
  EXPECT_TRUE(n.value(child.angular.wd).isApprox(r * (wd + turned), kTolerance));
  const Vector3d slid = revolute ? Vector3d::Zero() : Vector3d(2 * w.cross(rate * along) + acceleration * along);
  EXPECT_TRUE(n.value(child.a).isApprox(r * (carried + slid), kTolerance));
}

TEST_P(JointTypes, InertiaTimesTheSubspace) {
  const Cloud body = Cloud::random(n);
  const Vector6d expected = body.spatial_inertia() * S;
  const MassProperties symbols = body.symbols(n);
  EXPECT_TRUE(value(n, times_subspace(symbols, joint)).isApprox(expected, kTolerance));
  const SpatialInertia any = {n.symmetric(), n.matrix(), n.symmetric()};
  EXPECT_EQ(value(n, times_subspace(any, joint)), value(n, any) * S);
}

// What is left of the inertia with respect to the other five directions is the Schur complement; a free joint takes no
// force.
TEST_P(JointTypes, ReleasedInertiaIsTheSchurComplement) {
  const SpatialInertia body = {n.symmetric(), n.matrix(), n.symmetric()};
  const Matrix6d whole = value(n, body);
  const int axis = revolute ? 2 : 5;
  if (std::abs(whole(axis, axis)) < 0.1) return;  // nothing to divide by
  const Force U = times_subspace(body, joint);
  const Force gain = (n.graph.one() / project(joint, U)) * U;
  const SpatialInertia left = released(body, joint, U, gain);
  const SquareMatrix elements = matrix(left);
  for (int k = 0; k < 6; ++k) EXPECT_TRUE(elements(k, axis).is_zero() && elements(axis, k).is_zero()) << k;

  Eigen::Matrix<double, 6, 5> others;  // the other directions
  for (int k = 0, column = 0; k < 6; ++k)
    if (k != axis) others.col(column++) = Vector6d::Unit(k);
  const Eigen::Matrix<double, 5, 5> kept = others.transpose() * whole * others;
  const Eigen::Matrix<double, 5, 1> coupling = others.transpose() * whole * S;
  const Eigen::Matrix<double, 5, 5> schur = kept - coupling * coupling.transpose() / S.dot(whole * S);
  EXPECT_TRUE((others.transpose() * value(n, left) * others).isApprox(schur, 1e-12));
}

INSTANTIATE_TEST_SUITE_P(
    ,
    JointTypes,
    testing::Combine(testing::Values(model::JointType::revolute, model::JointType::prismatic), testing::Range(0, 20)));

TEST(JointOfATree, IsThatOfTheModel) {
  const model::KinematicTree tree = test::ball_and_bead();
  const Joint joint = joint_of(tree, 0);
  EXPECT_EQ(joint.index, 0);
  EXPECT_EQ(tree.links[static_cast<std::size_t>(joint.child)].name, "bead");
  EXPECT_EQ(joint.type, model::JointType::prismatic);
}

}  // namespace
}  // namespace robcogen::algorithm
