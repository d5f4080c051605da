// Joints with several coordinates, compared with the motions that they represent.
#include "model/compound.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "descriptions.h"

namespace robcogen::model::compound_test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;
using test::number;
using test::pi;

constexpr double kTolerance = 1e-14;

// A ball on a joint of this type.
Description ball_on(CompoundType type, const Placement& placement, Diagnostics& diagnostics) {
  Description d;
  d.base.name = "base";
  d.base.children = {{"ball", "j", {}, {}}};
  d.links = {test::link("ball")};
  d.links[0].inertia = test::ball(2.0, 0.1);
  DescribedCompound joint;
  joint.name = "j";
  joint.type = type;
  joint.placement = placement;
  joint.coordinates.resize(coordinates_of(type).size());
  add_compound(joint, d, diagnostics);
  return d;
}

KinematicTree tree_of(const Description& d) {
  Diagnostics diagnostics;
  const std::optional<KinematicTree> tree = build(d, diagnostics);
  EXPECT_TRUE(tree.has_value()) << diagnostics.render();
  EXPECT_EQ(diagnostics.render(), "");  // the links between have no inertia, but each joint moves some
  return *tree;
}

// Returns the pose of the last link in the base.
Isometry3d pose_of_child(const KinematicTree& tree, const std::vector<double>& q) {
  Isometry3d pose = Isometry3d::Identity();
  for (const int j : tree.topological()) {
    const Joint& joint = tree.joints[static_cast<std::size_t>(j)];
    const double position = q[static_cast<std::size_t>(j)];
    pose = pose * test::pose(joint.placement) * AngleAxisd(turns(joint.type) ? position : 0.0, Vector3d::UnitZ()) *
           Translation3d(evaluate(slide_of(joint)) * position * Vector3d::UnitZ());
  }
  return pose;
}

Isometry3d motion(CompoundType type, const std::vector<double>& q) {
  Isometry3d result = Isometry3d::Identity();
  switch (type) {
    case CompoundType::cylindrical:
      return Translation3d(0, 0, q[0]) * (result * AngleAxisd(q[1], Vector3d::UnitZ()));
    case CompoundType::universal:
      return result * AngleAxisd(q[0], Vector3d::UnitX()) * AngleAxisd(q[1], Vector3d::UnitZ());
    case CompoundType::planar:
      return Translation3d(q[0], q[1], 0) * (result * AngleAxisd(q[2], Vector3d::UnitZ()));
  }
  return result;
}

Placement placed(const Quantity& a, const Quantity& b, const Quantity& c) {
  return {{number(0.1), number(-0.2), number(0.3)}, {a, b, c}};
}

class Compounds : public testing::TestWithParam<CompoundType> {};

TEST_P(Compounds, MoveTheirChildAsTheyShould) {
  const std::vector<double> q = {0.4, -0.7, 1.1};
  const Quantity zero;
  for (const Placement& placement :
       {placed(zero, zero, zero), placed(number(0.3), number(-0.8), zero), placed(pi(1, 2), zero, pi(1, 2)),
        placed(zero, pi(-1, 2), pi(1)), placed(number(0.3), number(1.9), number(-2.8)),
        placed(pi(1, 3), number(-0.1), pi(1, 2))}) {
    Diagnostics diagnostics;
    const KinematicTree tree = tree_of(ball_on(GetParam(), placement, diagnostics));
    EXPECT_FALSE(diagnostics.has_errors());
    const Isometry3d expected = test::pose(placement) * motion(GetParam(), q);
    EXPECT_TRUE(pose_of_child(tree, q).isApprox(expected, kTolerance));
  }
}

// Quarter turns stay exact, so that products with zeros vanish.
TEST_P(Compounds, KeepQuarterTurnsExact) {
  for (const int quarters : {0, 1, 2, 3}) {
    Diagnostics diagnostics;
    const KinematicTree tree =
        tree_of(ball_on(GetParam(), placed(pi(quarters, 2), pi(-quarters, 2), pi(1, 2)), diagnostics));
    for (const Joint& joint : tree.joints)
      for (const auto& row : rotation_matrix(joint.placement))
        for (const Quantity& element : row) EXPECT_EQ(std::abs(evaluate(element)), element.is_zero() ? 0.0 : 1.0);
  }
}

TEST_P(Compounds, AreJointsOfOneCoordinateOnLinksWithoutMass) {
  Diagnostics diagnostics;
  const KinematicTree tree = tree_of(ball_on(GetParam(), placed({}, {}, {}), diagnostics));
  const auto coordinates = coordinates_of(GetParam());
  ASSERT_EQ(tree.joints.size(), coordinates.size());
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    EXPECT_EQ(tree.joints[k].name, coordinate_name("j", coordinates[k]));
    EXPECT_EQ(tree.joints[k].type, coordinates[k].type);
    const Link& child = tree.links[static_cast<std::size_t>(tree.joints[k].child)];
    EXPECT_EQ(child.is_virtual, k + 1 < coordinates.size());
    EXPECT_EQ(child.inertia.has_value(), !child.is_virtual);
  }
  // No transforms of the frames between are generated, because nobody asked for them.
  for (const FramePair& pair : default_desired(tree).transforms)
    EXPECT_TRUE(pair.left.name == "fr_base" || pair.left.name == "fr_ball") << pair.left.name;
}

INSTANTIATE_TEST_SUITE_P(
    ,
    Compounds,
    testing::Values(CompoundType::cylindrical, CompoundType::universal, CompoundType::planar));

TEST(Compound, NeedsARotationWithoutThirdAngleForParameters) {
  const Quantity angle = Quantity::parameter(0);
  for (const auto& [placement, fits] :
       {std::pair(placed(angle, angle, {}), true), std::pair(placed({}, {}, angle), false)}) {
    Diagnostics diagnostics;
    Description d = ball_on(CompoundType::universal, placement, diagnostics);
    EXPECT_EQ(diagnostics.has_errors(), !fits) << diagnostics.render();
    Diagnostics cylindrical;
    ball_on(CompoundType::cylindrical, placement, cylindrical);
    EXPECT_FALSE(cylindrical.has_errors());
  }
}

TEST(Compound, WithoutChildKeepsItsName) {
  Description d;
  d.base.name = "base";
  DescribedCompound joint;
  joint.name = "j";
  joint.coordinates.resize(2);
  Diagnostics diagnostics;
  add_compound(joint, d, diagnostics);
  EXPECT_FALSE(build(d, diagnostics).has_value());
  EXPECT_NE(diagnostics.render().find("joint 'j' connects no links"), std::string::npos) << diagnostics.render();
}

}  // namespace
}  // namespace robcogen::model::compound_test
