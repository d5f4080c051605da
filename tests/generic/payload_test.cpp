// Loads whose mass properties are parameters, alone and on a robot: a URDF or robot document without parameters gets
// them from the CMake call.
#include <carrying/carrying.h>
#include <gtest/gtest.h>
#include <robcogen/payload.h>

#include <array>
#include <vector>

namespace robcogen {
namespace {

using Vector3 = Matrix<double, 3, 1>;
using Matrix3 = Matrix<double, 3, 3>;

struct Point {
  double mass;
  Vector3 place;
};

// The body of these point masses, from the definitions.
Payload body_of(const std::vector<Point>& points) {
  Payload body;
  for (const Point& p : points) {
    body.mass += p.mass;
    body.center_of_mass += p.mass * p.place;
  }
  body.center_of_mass /= body.mass;
  for (const Point& p : points) {
    const Vector3 r = p.place - body.center_of_mass;
    body.inertia += p.mass * (r.dot(r) * Matrix3::Identity() - r * r.transpose());
  }
  return body;
}

void expect_same(const Payload& a, const Payload& b) {
  EXPECT_NEAR(a.mass, b.mass, 1e-14);
  EXPECT_LT((a.center_of_mass - b.center_of_mass).norm(), 1e-14);
  EXPECT_LT((a.inertia - b.inertia).norm(), 1e-14);
}

const std::vector<Point> kFirst = {{1.5, {0.1, 0.2, -0.3}}, {0.7, {-0.2, 0.1, 0.4}}, {0.4, {0.3, -0.1, 0.1}}};
const std::vector<Point> kSecond = {{0.3, {0.5, 0.0, 0.1}}, {0.9, {0.0, -0.4, 0.2}}};

TEST(Payload, OfTwoBodiesIsTheirSum) {
  std::vector<Point> all = kFirst;
  all.insert(all.end(), kSecond.begin(), kSecond.end());
  expect_same(body_of(kFirst) + body_of(kSecond), body_of(all));
  expect_same(body_of(kFirst) + Payload(), body_of(kFirst));
}

TEST(Payload, MovesToOtherFrames) {
  Matrix<double, 4, 4> X = Matrix<double, 4, 4>::Identity();
  X.topLeftCorner<3, 3>() << 0, 0.6, 0.8, 1, 0, 0, 0, 0.8, -0.6;
  X.topRightCorner<3, 1>() << 0.1, -0.2, 0.3;
  std::vector<Point> moved = kFirst;
  for (Point& p : moved) p.place = X.topLeftCorner<3, 3>() * p.place + X.topRightCorner<3, 1>();
  expect_same(in_frame(body_of(kFirst), X), body_of(moved));
}

TEST(Payload, IsReadAsItWasSet) {
  auto values = carrying::Parameters<>().array();
  EXPECT_TRUE(set_payload(carrying::kParameterNames, "fr_foot", body_of(kFirst), values));
  expect_same(payload_of(carrying::kParameterNames, "fr_foot", values), body_of(kFirst));
  const auto before = values;
  EXPECT_FALSE(set_payload(carrying::kParameterNames, "fr_hand", body_of(kFirst), values));
  EXPECT_EQ(values, before);
}

// At rest, a load adds the torques that hold its weight.
TEST(Payload, HangsOnItsFrame) {
  carrying::Parameters<> parameters;
  const carrying::JointState q(0.3, -0.4), zero(0, 0);
  const carrying::JointState empty = carrying::inverse_dynamics(parameters, q, zero, zero);
  Payload load;
  load.mass = 2.5;
  auto values = parameters.array();
  ASSERT_TRUE(set_payload(carrying::kParameterNames, "fr_foot", load, values));
  parameters.update(values);
  const carrying::JointState loaded = carrying::inverse_dynamics(parameters, q, zero, zero);
  const auto J = carrying::jacobians::fr_base_J_fr_foot(parameters, q);
  const carrying::JointState weight = J.bottomRows<3>().transpose() * Vector3(0, 0, load.mass * 9.81);
  EXPECT_LT((loaded - empty - weight).norm(), 1e-12);
}

}  // namespace
}  // namespace robcogen
