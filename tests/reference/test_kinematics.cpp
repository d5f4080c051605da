// The reference's poses, rates and Jacobians against closed forms and against derivatives of the poses themselves.
#include <gtest/gtest.h>

#include "sample_robots.h"

namespace robcogen::reference {
namespace {

// Rounding of a dozen 4 x 4 products of order one.
constexpr double kRounding = 1e-13;
// Central differences of second order with step 1e-5 in long double: truncation 1e-10 times third derivatives.
constexpr double kDifference = 1e-7;
constexpr long double kStep = 1e-5L;

using Complex = std::complex<double>;
constexpr double kImaginaryStep = 1e-30;

TEST(ReferencePlacement, IsTranslationThenIntrinsicXYZ) {
  const double t[3] = {1, 2, 3};
  const double r[3] = {kPi / 2, 0, kPi / 2};
  const Matrix4<double> pose = placement<double>(t, r);
  Matrix4<double> expected;
  // First x: y -> z, z -> -y. Then about the new z (which is old -y): x -> new y (old z), new y -> -x.
  expected << 0, -1, 0, 1,  //
      0, 0, -1, 2,          //
      1, 0, 0, 3,           //
      0, 0, 0, 1;
  EXPECT_LT((pose - expected).norm(), kRounding);
}

TEST(ReferencePlacement, MatchesEigenAngleAxes) {
  const double t[3] = {0.1, -0.4, 0.7};
  const double r[3] = {0.3, -1.2, 2.5};
  const Eigen::Matrix3d R =
      (Eigen::AngleAxisd(r[0], Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(r[1], Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(r[2], Eigen::Vector3d::UnitZ()))
          .toRotationMatrix();
  EXPECT_LT((rotation_of(placement<double>(t, r)) - R).norm(), kRounding);
}

TEST(ReferenceForms, MapPlueckerVectorsOfALine) {
  // A force along y through the point (1, 0, 0) of frame B, with B at (0, 0, 2) in A and turned by 90 degrees about z.
  const Matrix4<double> A_X_B = translation(0.0, 0.0, 2.0) * rotation(2, kPi / 2);
  Vector6<double> wrench_B;
  wrench_B << 0, 0, 1, 0, 1, 0;  // moment = (1,0,0) x (0,1,0)
  Vector6<double> wrench_A;
  wrench_A << 0, -2, 1, -1, 0, 0;  // force along -x through (0, 1, 2): moment = (0,1,2) x (-1,0,0) = (0,-2,1)
  EXPECT_LT((force_form(A_X_B) * wrench_B - wrench_A).norm(), kRounding);
  // A spin about B's y axis has A's point at its own origin moving: v = -w x p = -(-1,0,0) x (0,0,2) = (0,-2,0).
  Vector6<double> twist_B = Vector6<double>::Unit(1);
  Vector6<double> twist_A;
  twist_A << -1, 0, 0, 0, -2, 0;
  EXPECT_LT((motion_form(A_X_B) * twist_B - twist_A).norm(), kRounding);
}

TEST(ReferenceForms, ForceIsInverseTransposeOfMotion) {
  const Tables tables = crooked_tree(false);
  std::mt19937_64 engine(1);
  const VectorX<double> q = 3 * random_vector(engine, 5);
  const Matrix4<double> X = transform(tables.robot(), q, 1, 2);
  EXPECT_LT((force_form(X).transpose() * motion_form(X) - Matrix6<double>::Identity()).norm(), kRounding);
  EXPECT_LT((motion_form(X) * motion_form(inverse_of(X)) - Matrix6<double>::Identity()).norm(), kRounding);
}

TEST(ReferenceKinematics, DoublePendulumTip) {
  const Tables tables = double_pendulum(1, 0.7, 1, 0.4);
  const VectorX<double> q = Eigen::Vector2d(0.3, -1.1);
  const LinkMotion<double> lower = link_motions(tables.robot(), at_rest<double>(q))[2];
  const Vector3<double> tip = lower.position({0, -0.4, 0});
  const Vector3<double> expected(
      0.7 * std::sin(0.3) + 0.4 * std::sin(-0.8), 0, -0.7 * std::cos(0.3) - 0.4 * std::cos(-0.8));
  EXPECT_LT((tip - expected).norm(), kRounding);
}

TEST(ReferenceKinematics, BaseOriginHasTheClassicalAcceleration) {
  const Tables tables = free_body(1, {}, {1, 1, 1});
  Motion<double> motion = at_rest<double>(VectorX<double>(0));
  motion.base_velocity << 0, 0, 2, 3, 0, 0;  // circles: spatial acceleration zero, centripetal acceleration w x v
  const LinkMotion<double> base = link_motions(tables.robot(), motion)[0];
  EXPECT_LT((base.acceleration({0, 0, 0}) - Vector3<double>(0, 6, 0)).norm(), kRounding);
  EXPECT_LT((base.velocity({0, 1, 0}) - Vector3<double>(1, 0, 0)).norm(), kRounding);
  EXPECT_LT((base.angular_velocity() - Vector3<double>(0, 0, 2)).norm(), kRounding);
}

// Poses along q + qd t + qdd t^2 / 2, fixed base, differentiated numerically.
TEST(ReferenceKinematics, RatesAreTimeDerivativesOfPoses) {
  const Tables tables = crooked_tree(false);
  std::mt19937_64 engine(2);
  const Motion<double> motion = random_motion(engine, tables.robot());
  const auto poses_at = [&](long double t) {
    const VectorX<long double> q =
        motion.q.cast<long double>() + t * motion.qd.cast<long double>() + t * t / 2 * motion.qdd.cast<long double>();
    return link_poses(tables.robot(), q);
  };
  const auto before = poses_at(-kStep);
  const auto now = poses_at(0);
  const auto after = poses_at(kStep);
  const std::vector<LinkMotion<double>> links = link_motions(tables.robot(), motion);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Matrix4<long double> rate = (after[i] - before[i]) / (2 * kStep);
    const Matrix4<long double> second_rate = (after[i] - 2 * now[i] + before[i]) / (kStep * kStep);
    EXPECT_LT((links[i].rate - rate.cast<double>()).norm(), kDifference * (1 + links[i].rate.norm()));
    EXPECT_LT(
        (links[i].second_rate - second_rate.cast<double>()).norm(), kDifference * (1 + links[i].second_rate.norm()));
  }
}

TEST(ReferenceKinematics, BodyJacobianTimesVelocityIsTheBodysVelocity) {
  const Tables tables = crooked_tree(true);
  std::mt19937_64 engine(3);
  const Motion<double> motion = random_motion(engine, tables.robot());
  VectorX<double> velocity(6 + motion.qd.size());
  velocity << motion.base_velocity, motion.qd;
  const auto links = link_motions(tables.robot(), motion);
  const auto poses = link_poses(tables.robot(), motion.q);
  const Vector3<double> point(0.1, 0.2, 0.3);
  for (int i = 0; i < tables.robot().links.size; ++i) {
    const LinkMotion<double>& link = links[static_cast<std::size_t>(i)];
    const Vector6<double> product = body_jacobian<double>(tables.robot(), poses, i, point) * velocity;
    Vector6<double> expected;
    expected << link.angular_velocity(), link.velocity(point);
    EXPECT_LT((product - expected).norm(), kRounding * (1 + expected.norm())) << tables.robot().links[i].name;
  }
}

// Every pair of frames: up-going, down-going and mixed chains.
TEST(ReferenceKinematics, FrameJacobianIsTheComplexStepDerivativeOfTheTransform) {
  const Tables tables = crooked_tree(false);
  const Robot robot = tables.robot();
  std::mt19937_64 engine(4);
  const VectorX<double> q = 3 * random_vector(engine, 5);
  for (int left = 0; left < robot.frames.size; ++left) {
    for (int right = 0; right < robot.frames.size; ++right) {
      const Matrix6X<double> J = frame_jacobian(robot, q, left, right);
      const Matrix3<double> R = rotation_of(transform(robot, q, left, right));
      for (int j = 0; j < robot.joints.size; ++j) {
        VectorX<Complex> stepped = q.cast<Complex>();
        stepped(j) += Complex(0, kImaginaryStep);
        const Matrix4<double> derivative = transform(robot, stepped, left, right).imag() / kImaginaryStep;
        Vector6<double> column;
        column << axis_of<double>(rotation_of(derivative) * R.transpose()), origin_of(derivative);
        EXPECT_LT((J.col(j) - column).norm(), kRounding)
            << robot.frames[left].name << "_J_" << robot.frames[right].name << " joint " << robot.joints[j].name;
      }
    }
  }
}

TEST(ReferenceKinematics, JacobianPicksColumns) {
  const Tables tables = crooked_tree(false);
  const VectorX<double> q = VectorX<double>::Constant(5, 0.4);
  const int columns[] = {3, 0};
  const reflection::Jacobian what{"trunk_J_hand", 0, 1, columns, 2, nullptr};
  const Matrix6X<double> J = jacobian(tables.robot(), q, what);
  const Matrix6X<double> all = frame_jacobian(tables.robot(), q, 0, 1);
  EXPECT_EQ(J.cols(), 2);
  EXPECT_EQ(J.col(0), all.col(3));
  EXPECT_EQ(J.col(1), all.col(0));
}

}  // namespace
}  // namespace robcogen::reference
