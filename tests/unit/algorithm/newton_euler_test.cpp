// Mass properties, motions and wrenches of links against sums over point masses.
#include "algorithm/dynamics/newton_euler.h"

#include <Eigen/Geometry>

#include "model/descriptions.h"
#include "values.h"

namespace robcogen::algorithm {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::kTolerance;
using test::Numbers;

// A body made of a few point masses: mass, first moment and pseudo-inertia are sums, and so is everything else.
struct Cloud {
  std::vector<double> mass;
  std::vector<Vector3d> at;

  static Cloud random(Numbers& n) {
    Cloud cloud;
    for (int k = 0; k < 5; ++k) {
      cloud.mass.push_back(std::abs(n.real()));
      cloud.at.emplace_back(n.real(), n.real(), n.real());
    }
    return cloud;
  }
  double total() const {
    double m = 0;
    for (double each : mass) m += each;
    return m;
  }
  Vector3d first_moment() const {
    Vector3d h = Vector3d::Zero();
    for (std::size_t k = 0; k < mass.size(); ++k) h += mass[k] * at[k];
    return h;
  }
  Matrix3d pseudo_inertia() const {
    Matrix3d s = Matrix3d::Zero();
    for (std::size_t k = 0; k < mass.size(); ++k) s += mass[k] * at[k] * at[k].transpose();
    return s;
  }
  Matrix3d inertia_tensor() const {
    Matrix3d i = Matrix3d::Zero();
    for (std::size_t k = 0; k < mass.size(); ++k)
      i += mass[k] * (at[k].squaredNorm() * Matrix3d::Identity() - at[k] * at[k].transpose());
    return i;
  }
  MassProperties symbols(Numbers& n) const {
    const Vector3d h = first_moment();
    const Matrix3d s = pseudo_inertia();
    MassProperties m;
    m.mass = n.expression(total());
    for (std::size_t i = 0; i < 3; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      m.first_moment[i] = n.expression(h[row]);
      for (std::size_t j = i; j < 3; ++j)
        m.pseudo_inertia[i][j] = m.pseudo_inertia[j][i] = n.expression(s(row, static_cast<Eigen::Index>(j)));
    }
    return m;
  }
};

// A pose of every part: quarter turns, planes, offset and slide.
struct RandomPose {
  explicit RandomPose(Numbers& n) {
    pose.rotation.quarter = quarter_turn(n.pick(3), n.pick(4));
    transform.rotate(matrix_of(pose.rotation.quarter));
    for (int k = n.pick(4); k > 0; --k) {
      const int axis = n.pick(3);
      const double angle = n.real();
      const Expression symbol = n.expression(angle);
      pose.rotation.planes.push_back({axis, cos(symbol), sin(symbol)});
      transform.rotate(Eigen::AngleAxisd(angle, Vector3d::Unit(axis)));
    }
    Vector3d offset(n.real(), n.real(), n.real());
    if (n.pick(3) == 0) offset[n.pick(3)] = 0;
    const double slide = n.pick(2) == 0 ? 0.0 : n.real();
    for (std::size_t i = 0; i < 3; ++i)
      if (offset[static_cast<int>(i)] != 0) pose.offset[i] = n.expression(offset[static_cast<int>(i)]);
    if (slide != 0) pose.slide = n.expression(slide);
    transform = Eigen::Translation3d(offset) * transform * Eigen::Translation3d(0, 0, slide);
  }

  static Matrix3d matrix_of(const QuarterTurns& q) {
    Matrix3d m = Matrix3d::Zero();
    for (std::size_t i = 0; i < 3; ++i) m(static_cast<int>(i), q.image[i]) = q.sign[i];
    return m;
  }

  Pose pose;
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
};

class NewtonEuler : public testing::TestWithParam<int> {
 protected:
  Numbers n{static_cast<unsigned>(GetParam())};
};

TEST_P(NewtonEuler, TheInertiaTensor) {
  const Cloud body = Cloud::random(n);
  EXPECT_TRUE(n.value(inertia_tensor(body.symbols(n))).isApprox(body.inertia_tensor(), kTolerance));
}

// Moments and products of a document are about the link's origin; products have positive sign.
TEST_P(NewtonEuler, MassPropertiesOfADocument) {
  const Cloud body = Cloud::random(n);
  const Vector3d h = body.first_moment();
  const Matrix3d s = body.pseudo_inertia(), tensor = body.inertia_tensor();
  model::Inertia inertia;
  inertia.mass = model::Quantity(body.total());
  for (std::size_t i = 0; i < 3; ++i) inertia.com[i] = model::Quantity(h[static_cast<int>(i)] / body.total());
  inertia.ixx = model::Quantity(tensor(0, 0));
  inertia.iyy = model::Quantity(tensor(1, 1));
  inertia.izz = model::Quantity(tensor(2, 2));
  inertia.ixy = model::Quantity(s(0, 1));
  inertia.ixz = model::Quantity(s(0, 2));
  inertia.iyz = model::Quantity(s(1, 2));
  model::Link link;
  link.inertia = inertia;
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

// The power of a force is the same in both frames, and the way back undoes the way.
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

// Of the equivalent forms of the moment, whichever is cheapest where angular velocity or acceleration have zeros.
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
  // Sums of five points of some newtons.
  EXPECT_LT((n.value(wrench.linear) - force).norm(), 10 * kTolerance * (1 + force.norm()));
  EXPECT_LT((n.value(wrench.moment) - moment).norm(), 10 * kTolerance * (1 + moment.norm()));
  const Force only_z = link_wrench(n.trace, m, motion, true);
  EXPECT_NEAR(n.value(only_z.moment[2]), moment.z(), 10 * kTolerance * (1 + moment.norm()));
}

TEST_P(NewtonEuler, VelocityProductsOfAngularState) {
  const AngularState state{n.vector(), n.vector()};
  const Vector3 v = n.vector();
  const Vector3d w = n.value(state.w), wd = n.value(state.wd), r = n.value(v);
  EXPECT_TRUE(n.value(multiply_u(state, v)).isApprox(wd.cross(r) + w.cross(w.cross(r)), kTolerance));
}

TEST_P(NewtonEuler, MotionOfAChild) {
  const RandomPose random(n);
  const LinkMotion parent{{n.vector(), n.vector()}, n.vector()};
  const double rate = n.real(), acceleration = n.real();
  const Expression qd = n.expression(rate), qdd = n.expression(acceleration);
  const Matrix3d r = random.transform.linear().transpose();
  const Vector3d p = random.transform.translation();
  const Vector3d w = n.value(parent.angular.w), wd = n.value(parent.angular.wd), a = n.value(parent.a);
  const Vector3d z = Vector3d::UnitZ(), along = random.transform.linear() * z;
  const Vector3d carried = a + wd.cross(p) + w.cross(w.cross(p));

  const LinkMotion turned = across_joint(Joint{0, 1, model::JointType::revolute}, random.pose, parent, qd, qdd);
  EXPECT_TRUE(n.value(turned.angular.w).isApprox(r * w + rate * z, kTolerance));
  EXPECT_TRUE(n.value(turned.angular.wd).isApprox(r * (wd + w.cross(rate * along)) + acceleration * z, kTolerance));
  EXPECT_TRUE(n.value(turned.a).isApprox(r * carried, kTolerance));

  const LinkMotion slid = across_joint(Joint{0, 1, model::JointType::prismatic}, random.pose, parent, qd, qdd);
  EXPECT_TRUE(n.value(slid.angular.w).isApprox(r * w, kTolerance));
  EXPECT_TRUE(n.value(slid.angular.wd).isApprox(r * wd, kTolerance));
  const Vector3d coriolis = 2 * w.cross(rate * along);
  EXPECT_TRUE(n.value(slid.a).isApprox(r * (carried + coriolis + acceleration * along), kTolerance));
}

INSTANTIATE_TEST_SUITE_P(, NewtonEuler, testing::Range(0, 40));

}  // namespace
}  // namespace robcogen::algorithm
