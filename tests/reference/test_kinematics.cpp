// The reference's poses, rates and Jacobians, compared with closed forms and with derivatives of the poses themselves.
#include <gtest/gtest.h>

#include "robcogen/reference/check_frame_motion.h"
#include "sample_robots.h"

namespace robcogen::reference::kinematics_test {
namespace {

// Rounding of a dozen 4 x 4 products of order one.
constexpr double kRounding = 1e-13;
// Central differences of second order with step 1e-5 in long double: truncation 1e-10 times third derivatives.
constexpr double kDifference = 1e-6;
constexpr long double kStep = 1e-5L;

using Complex = std::complex<double>;
constexpr double kImaginaryStep = 1e-30;

double distance(const Matrix<double>& a, const Matrix<double>& b) {
  return largest(a - b);
}

TEST(ReferencePlacement, IsTranslationThenIntrinsicXYZ) {
  const double t[3] = {1, 2, 3};
  const double r[3] = {kPi / 2, 0, kPi / 2};
  const Matrix<double> pose = placement<double>(t, r);
  // First about x: y -> z. Then about the new z, which is the old -y: x -> z (old axes), z -> -x.
  EXPECT_LT(distance(origin_of(pose), {1, 2, 3}), kRounding);
  EXPECT_LT(distance(rotation_of(pose) * Vector<double>{1, 0, 0}, {0, 0, 1}), kRounding);
  EXPECT_LT(distance(rotation_of(pose) * Vector<double>{0, 1, 0}, {-1, 0, 0}), kRounding);
  EXPECT_LT(distance(rotation_of(pose) * Vector<double>{0, 0, 1}, {0, -1, 0}), kRounding);
}

TEST(ReferencePlacement, RotatesAboutEachAxisByTheRightHand) {
  const double none[3] = {0, 0, 0};
  const double x[3] = {0.3, 0, 0}, y[3] = {0, 0.3, 0}, z[3] = {0, 0, 0.3};
  const double c = std::cos(0.3), s = std::sin(0.3);
  EXPECT_LT(distance(rotation_of(placement<double>(none, x)) * Vector<double>{0, 1, 0}, {0, c, s}), kRounding);
  EXPECT_LT(distance(rotation_of(placement<double>(none, y)) * Vector<double>{0, 0, 1}, {s, 0, c}), kRounding);
  EXPECT_LT(distance(rotation_of(placement<double>(none, z)) * Vector<double>{1, 0, 0}, {c, s, 0}), kRounding);
}

TEST(ReferenceForms, MapPlueckerVectorsOfALine) {
  // A force along y through the point (1, 0, 0) of frame B, with B at (0, 0, 2) in A and turned by 90 degrees about z.
  const Matrix<double> A_X_B = translation(0.0, 0.0, 2.0) * rotation(2, kPi / 2);
  const Vector<double> wrench_B{0, 0, 1, 0, 1, 0};  // moment = (1, 0, 0) x (0, 1, 0)
  // The force acts along -x through (0, 1, 2): moment = (0, 1, 2) x (-1, 0, 0).
  EXPECT_LT(distance(force_form(A_X_B) * wrench_B, {0, -2, 1, -1, 0, 0}), kRounding);
  // A spin about B's y axis, which is A's -x, moves the point at A's origin by -w x p = (1, 0, 0) x (0, 0, 2).
  const Vector<double> twist_B{0, 1, 0, 0, 0, 0};
  EXPECT_LT(distance(motion_form(A_X_B) * twist_B, {-1, 0, 0, 0, -2, 0}), kRounding);
}

TEST(ReferenceForms, ForceIsInverseTransposeOfMotion) {
  const Tables tables = crooked_tree(false);
  std::mt19937_64 engine(1);
  const Matrix<double> X = transform(tables.robot(), uniform_vector(engine, 5, 3), 1, 2);
  EXPECT_LT(distance(transpose(force_form(X)) * motion_form(X), Matrix<double>::identity(6)), kRounding);
  EXPECT_LT(distance(motion_form(X) * motion_form(inverse_of(X)), Matrix<double>::identity(6)), kRounding);
}

TEST(ReferenceKinematics, DoublePendulumTip) {
  const Tables tables = double_pendulum(1, 0.7, 1, 0.4);
  const LinkMotion<double> lower = link_motions(tables.robot(), at_rest<double>({0.3, -1.1}))[2];
  const double x = 0.7 * std::sin(0.3) + 0.4 * std::sin(-0.8);
  const double z = -0.7 * std::cos(0.3) - 0.4 * std::cos(-0.8);
  EXPECT_LT(distance(lower.position({0, -0.4, 0}), {x, 0, z}), kRounding);
}

TEST(ReferenceKinematics, BaseOriginHasTheClassicalAcceleration) {
  const Tables tables = free_body(1, {}, {1, 1, 1});
  Motion<double> motion = at_rest(Vector<double>());
  motion.base_velocity = {0, 0, 2, 3, 0, 0};  // circles: spatial acceleration zero, centripetal acceleration w x v
  const LinkMotion<double> base = link_motions(tables.robot(), motion)[0];
  EXPECT_LT(distance(base.acceleration({0, 0, 0}), {0, 6, 0}), kRounding);
  EXPECT_LT(distance(base.velocity({0, 1, 0}), {1, 0, 0}), kRounding);
  EXPECT_LT(distance(base.angular_velocity(), {0, 0, 2}), kRounding);
}

// Poses along q + qd t + qdd t^2 / 2, fixed base, differentiated numerically.
TEST(ReferenceKinematics, RatesAreTimeDerivativesOfPoses) {
  const Tables tables = crooked_tree(false);
  std::mt19937_64 engine(2);
  const Motion<double> motion = random_motion(engine, tables.robot());
  const Motion<long double> exact = cast<long double>(motion);
  const auto poses_at = [&](long double t) {
    return link_poses(tables.robot(), exact.q + t * exact.qd + t * t / 2 * exact.qdd);
  };
  const auto before = poses_at(-kStep), now = poses_at(0), after = poses_at(kStep);
  const std::vector<LinkMotion<double>> links = link_motions(tables.robot(), motion);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Matrix<long double> rate = 1 / (2 * kStep) * (after[i] - before[i]);
    const Matrix<long double> second_rate = 1 / (kStep * kStep) * (after[i] - 2.0L * now[i] + before[i]);
    EXPECT_LT(distance(links[i].rate, rate.cast<double>()), kDifference);
    EXPECT_LT(distance(links[i].second_rate, second_rate.cast<double>()), kDifference * (1 + largest(links[i].rate)));
  }
}

TEST(ReferenceKinematics, BodyJacobianTimesVelocityIsTheBodysVelocity) {
  const Tables tables = crooked_tree(true);
  std::mt19937_64 engine(3);
  const Motion<double> motion = random_motion(engine, tables.robot());
  const auto links = link_motions(tables.robot(), motion);
  const auto poses = link_poses(tables.robot(), motion.q);
  const Vector<double> point{0.1, 0.2, 0.3};
  for (int i = 0; i < tables.robot().links.size; ++i) {
    const LinkMotion<double>& link = links[static_cast<std::size_t>(i)];
    const Vector<double> velocity =
        body_jacobian(tables.robot(), poses, i, point) * stacked(motion.base_velocity, motion.qd);
    EXPECT_LT(distance(velocity, stacked(link.angular_velocity(), link.velocity(point))), 10 * kRounding)
        << tables.robot().links[i].name;
  }
}

// Every pair of frames: chains towards the base, away from it, and mixed ones.
TEST(ReferenceKinematics, FrameJacobianIsTheComplexStepDerivativeOfTheTransform) {
  const Tables tables = crooked_tree(false);
  const Robot robot = tables.robot();
  std::mt19937_64 engine(4);
  const Vector<double> q = uniform_vector(engine, 5, 3);
  for (int left = 0; left < robot.frames.size; ++left) {
    for (int right = 0; right < robot.frames.size; ++right) {
      const Matrix<double> J = frame_jacobian(robot, q, left, right);
      const Matrix<double> R = rotation_of(transform(robot, q, left, right));
      for (int j = 0; j < robot.joints.size; ++j) {
        Vector<Complex> moved = q.cast<Complex>();
        moved(j) += Complex(0, kImaginaryStep);
        const Matrix<double> derivative =
            transform(robot, moved, left, right).mapped([](const Complex& x) { return x.imag() / kImaginaryStep; });
        const Vector<double> column = stacked(axis_of(rotation_of(derivative) * transpose(R)), origin_of(derivative));
        EXPECT_LT(distance(J.col(j), column), kRounding)
            << robot.frames[left].name << "_J_" << robot.frames[right].name << " joint " << robot.joints[j].name;
      }
    }
  }
}

TEST(ReferenceKinematics, JacobianPicksColumns) {
  const Tables tables = crooked_tree(false);
  const Vector<double> q{0.4, 0.3, 0.2, 0.1, 0.5};
  const int columns[] = {3, 0};
  const reflection::Jacobian what{"trunk_J_hand", 0, 1, columns, 2, nullptr};
  const Matrix<double> J = jacobian(tables.robot(), q, what);
  const Matrix<double> all = frame_jacobian(tables.robot(), q, 0, 1);
  EXPECT_EQ(J.cols(), 2);
  EXPECT_EQ(distance(J.col(0), all.col(3)), 0);
  EXPECT_EQ(distance(J.col(1), all.col(0)), 0);
}

// Twists with respect to the base, and their derivatives, as parts of those with respect to the ground.
TEST(ReferenceKinematics, MotionOfTheBaseAddsToMotionWithRespectToIt) {
  Tables tables = crooked_tree(true);
  const int base = tables.add_frame("base", 0);
  const Robot robot = tables.robot();
  std::mt19937_64 engine(3);
  const Motion<Real> m = cast<Real>(random_sample(engine, robot).motion);
  const Vector<Real> w0 = m.base_velocity.head(3), v0 = m.base_velocity.tail(3);
  const std::vector<LinkMotion<Real>> links = link_motions(robot, m);
  for (int frame = 0; frame < robot.frames.size; ++frame) {
    const LinkMotion<Real>& link = links[static_cast<std::size_t>(robot.frames[frame].link)];
    const Vector<Real> origin(3);
    const Vector<Real> p = link.position(origin), pd = link.velocity(origin), pdd = link.acceleration(origin);
    const Vector<Real> w = link.angular_velocity();
    // wd from R'' = ([wd]x + [w]x [w]x) R, where the second part is symmetric.
    const Vector<Real> wd = link.angular_acceleration();

    const Vector<Real> V = frame_quantity(robot, m, FrameQuantity::frame_velocity, base, frame);
    EXPECT_LT(largest(m.base_velocity + V - stacked(w, pd + cross(p, w))), kRounding) << robot.frames[frame].name;

    const Vector<Real> A = frame_quantity(robot, m, FrameQuantity::frame_acceleration, base, frame);
    const Vector<Real> turning = stacked(cross(w0, V.head(3)), cross(w0, V.tail(3)) + cross(v0, V.head(3)));
    EXPECT_LT(largest(m.base_acceleration + A + turning - stacked(wd, pdd + cross(pd, w) + cross(p, wd))), kRounding)
        << robot.frames[frame].name;
  }
}

}  // namespace
}  // namespace robcogen::reference::kinematics_test
