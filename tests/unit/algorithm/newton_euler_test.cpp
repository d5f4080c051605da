// Mass properties, motions and wrenches of links, compared with sums over point masses.
#include "algorithm/dynamics/newton_euler.h"

#include "bodies.h"

namespace robcogen::algorithm::newton_euler_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::Cloud;
using test::kTolerance;
using test::Numbers;
using test::RandomPose;

class NewtonEuler : public testing::TestWithParam<int> {
 protected:
  Numbers n{static_cast<unsigned>(GetParam())};
};

TEST_P(NewtonEuler, TheInertiaTensor) {
  const Cloud body = Cloud::random(n);
  EXPECT_TRUE(n.value(inertia_tensor(body.symbols(n))).isApprox(body.inertia_tensor(), kTolerance));
}

TEST_P(NewtonEuler, MassPropertiesOfADocument) {
  const Cloud body = Cloud::random(n);
  const Vector3d h = body.first_moment();
  const Matrix3d s = body.pseudo_inertia();
  model::Link link;
  link.inertia = body.document();
  const MassProperties m = mass_properties(n.trace, link);
  EXPECT_EQ(n.value(m.mass), body.total());
  EXPECT_TRUE(n.value(m.first_moment).isApprox(h, kTolerance));
  EXPECT_TRUE(n.value(m.pseudo_inertia).isApprox(s, kTolerance));
  const MassProperties none = mass_properties(n.trace, model::Link());
  EXPECT_TRUE(none.mass.is_zero() && is_zero(none.first_moment));
  for (const Vector3& row : none.pseudo_inertia.row) EXPECT_TRUE(is_zero(row));
}

TEST_P(NewtonEuler, MassPropertiesMoveToTheParent) {
  const Cloud body = Cloud::random(n);
  const RandomPose random(n);
  Cloud moved = body;
  for (Vector3d& point : moved.at) point = random.transform * point;
  const MassProperties m = to_parent(random.pose, body.symbols(n));
  EXPECT_NEAR(n.value(m.mass), moved.total(), kTolerance);
  EXPECT_TRUE(n.value(m.first_moment).isApprox(moved.first_moment(), kTolerance));
  EXPECT_TRUE(n.value(m.pseudo_inertia).isApprox(moved.pseudo_inertia(), kTolerance));
}

TEST_P(NewtonEuler, WrenchesMoveToTheParent) {
  const RandomPose random(n);
  const Force wrench{n.vector(), n.vector()};
  const Vector3d force = random.transform.linear() * n.value(wrench.linear);
  const Vector3d moment =
      random.transform.linear() * n.value(wrench.moment) + random.transform.translation().cross(force);
  const Force moved = to_parent(random.pose, wrench);
  EXPECT_TRUE(n.value(moved.linear).isApprox(force, kTolerance));
  EXPECT_TRUE(n.value(moved.moment).isApprox(moment, kTolerance));
}

// The power of a force is the same in both frames, and the inverse transform restores the motion.
TEST_P(NewtonEuler, MotionsMoveAgainstWrenches) {
  const RandomPose random(n);
  const Motion motion{n.vector(), n.vector()};
  const Force wrench{n.vector(), n.vector()};
  const double power = n.value(dot(wrench, motion));
  const Motion moved = to_parent(random.pose, motion);
  EXPECT_NEAR(n.value(dot(to_parent(random.pose, wrench), moved)), power, 10 * kTolerance * (1 + std::abs(power)));
  const Motion back = to_child(random.pose, moved);
  EXPECT_TRUE(n.value(back.angular).isApprox(n.value(motion.angular), kTolerance));
  EXPECT_TRUE(n.value(back.linear).isApprox(n.value(motion.linear), 10 * kTolerance));
}

// Zeros in the angular velocity and acceleration decide which of the equivalent forms of the moment is cheapest.
TEST_P(NewtonEuler, TheWrenchThatMovesALink) {
  const Cloud body = Cloud::random(n);
  LinkMotion motion{{n.vector(), n.vector()}, n.vector()};
  for (std::size_t i = 0; i < 3; ++i) {
    if (n.pick(3) == 0) motion.angular.w[i] = Expression();
    if (n.pick(3) == 0) motion.angular.wd[i] = Expression();
  }
  const Vector3d w = n.value(motion.angular.w), wd = n.value(motion.angular.wd), a = n.value(motion.a);
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
  for (std::size_t k = 0; k < body.mass.size(); ++k) {
    const Vector3d& r = body.at[k];
    const Vector3d inertial = body.mass[k] * (a + wd.cross(r) + w.cross(w.cross(r)));
    force += inertial;
    moment += r.cross(inertial);
  }
  const MassProperties m = body.symbols(n);
  const Force wrench = link_wrench(n.trace, m, motion);
  // Sums over five points, of a few newtons.
  EXPECT_LT((n.value(wrench.linear) - force).norm(), 10 * kTolerance * (1 + force.norm()));
  EXPECT_LT((n.value(wrench.moment) - moment).norm(), 10 * kTolerance * (1 + moment.norm()));
  const Force only_z = link_wrench(n.trace, m, motion, {}, true);
  EXPECT_NEAR(n.value(only_z.moment[2]), moment.z(), 10 * kTolerance * (1 + moment.norm()));
}

TEST_P(NewtonEuler, VelocityProductsOfAngularState) {
  const AngularState state{n.vector(), n.vector()};
  const Vector3 v = n.vector();
  const Vector3d w = n.value(state.w), wd = n.value(state.wd), r = n.value(v);
  EXPECT_TRUE(n.value(multiply_u(state, v)).isApprox(wd.cross(r) + w.cross(w.cross(r)), kTolerance));
}

INSTANTIATE_TEST_SUITE_P(, NewtonEuler, testing::Range(0, 40));

}  // namespace
}  // namespace robcogen::algorithm::newton_euler_test
