#include <gtest/gtest.h>

#include "descriptions.h"

namespace robcogen::model::mass_properties_test {
namespace {

using Codes = std::vector<std::string>;
using test::number;

Codes codes_of(const Inertia& inertia) {
  Description d = test::two_links();
  d.links[1].inertia = inertia;
  Diagnostics diagnostics;
  build(d, diagnostics);
  return test::codes(diagnostics);
}

Inertia moments(double ixx, double iyy, double izz) {
  Inertia i = test::ball();
  i.ixx = number(ixx), i.iyy = number(iyy), i.izz = number(izz);
  return i;
}

TEST(MassProperties, AcceptsThinRodsAndPlates) {
  EXPECT_EQ(codes_of(moments(0.0, 0.3, 0.3)), Codes{});
  EXPECT_EQ(codes_of(moments(0.1, 0.2, 0.3)), Codes{});
}

TEST(MassProperties, JudgesTheTriangleInequalityRelativeToTheLargestMoment) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    EXPECT_EQ(codes_of(moments(0.1 * scale, 0.2 * scale, 0.3 * scale * (1.0 + 1e-9))), Codes{}) << scale;
    EXPECT_EQ(codes_of(moments(0.1 * scale, 0.2 * scale, 0.45 * scale)), Codes{"triangle-inequality"}) << scale;
  }
}

TEST(MassProperties, JudgesMomentsAboutTheCentreOfMass) {
  // A plate with moments 0.1, 0.2, 0.3 about its centre, given about a point 2 m away along x. The moments about the
  // centre are valid.
  Inertia i = moments(0.1, 0.2 + 4.0, 0.3 + 4.0);
  i.com[0] = number(2.0);
  EXPECT_EQ(codes_of(i), Codes{});
  // With the centre 2.1 m away, the same numbers give negative moments about it.
  i.com[0] = number(2.1);
  EXPECT_EQ(codes_of(i), Codes{"inertia-not-positive"});
}

// Products of inertia can hide that plausible moments are invalid; the principal moments decide.
TEST(MassProperties, JudgesPrincipalMoments) {
  const Eigen::Matrix3d R = test::pose({{}, {number(0.3), number(-0.8), number(1.1)}}).rotation();
  const auto rotated = [&](double low, double middle, double high) {
    const Eigen::Matrix3d I = R * Eigen::Vector3d(low, middle, high).asDiagonal() * R.transpose();
    Inertia i = moments(I(0, 0), I(1, 1), I(2, 2));
    i.ixy = number(-I(0, 1)), i.ixz = number(-I(0, 2)), i.iyz = number(-I(1, 2));
    return i;
  };
  EXPECT_EQ(codes_of(rotated(0.1, 0.2, 0.3)), Codes{});
  EXPECT_EQ(codes_of(rotated(0.1, 0.2, 0.301)), Codes{"triangle-inequality"});
  EXPECT_EQ(codes_of(rotated(0.0, 0.3, 0.3)), Codes{});
  EXPECT_EQ(codes_of(rotated(-0.001, 0.3, 0.3)), Codes{"inertia-not-positive"});
}

TEST(MassProperties, DoesNotJudgeParameters) {
  Inertia i = moments(0.1, 0.2, 5.0);
  i.mass = Quantity::parameter(0);
  Description d = test::two_links();
  d.links[1].inertia = i;
  d.parameters = {{"m", ParameterKind::inertial, {}, {}}};
  Diagnostics diagnostics;
  EXPECT_TRUE(build(d, diagnostics).has_value());
  EXPECT_TRUE(diagnostics.all().empty());
}

TEST(MassProperties, AcceptsATinyMass) {
  EXPECT_EQ(codes_of(test::ball(1e-9, 1e-15)), Codes{});
}

}  // namespace
}  // namespace robcogen::model::mass_properties_test
