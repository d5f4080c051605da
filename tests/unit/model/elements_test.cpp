// The elements of a robot as generated code lists them.
#include "model/elements.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "trees.h"

namespace robcogen::model::elements_test {
namespace {

using Names = std::vector<std::string>;
using Vector = std::array<double, 3>;

Parameter parameter(const std::string& name, std::optional<double> value) {
  Parameter p;
  p.name = name;
  p.default_value = value;
  return p;
}

// base -slide-> cart -a-> b -wheel-> rim. `a` follows `slide` and `wheel`: q_a = 2 q_slide - q_wheel + 0.5.
KinematicTree coupled() {
  KinematicTree tree = test::only_base("Coupled", "base");
  test::add_link(tree, "slide", JointType::prismatic, 0, "cart", test::body(2, {0, 0, 0.5}));
  test::add_link(tree, "a", JointType::revolute, 1, "b", {}, test::vector(1, 0, 0));
  test::add_link(tree, "wheel", JointType::revolute, 2, "rim");
  test::add_frame(tree, "tip", 3);
  tree.couplings.push_back({1, {{0, Quantity(2.0)}, {2, Quantity(-1.0)}}, Quantity(0.5)});
  return tree;
}

TEST(Elements, IndependentJointsPrecedeTheOthers) {
  const KinematicTree tree = coupled();
  EXPECT_EQ(names_of(tree, independent_joints_first(tree)), (Names{"slide", "wheel", "a"}));
  EXPECT_EQ(coupled_names(tree), Names{"a"});
  EXPECT_EQ(carrying_joints(tree), (std::vector<int>{-1, 0, 2, 1}));
  EXPECT_EQ(link_names(tree), (Names{"base", "cart", "b", "rim"}));
  EXPECT_EQ(place_of_frame(tree, "fr_a"), 5);
  EXPECT_EQ(frame_names(tree).back(), "tip");
  EXPECT_FALSE(has_own_positions(tree));
}

TEST(Elements, ACouplingHasAFactorForEachCoordinate) {
  const KinematicTree tree = coupled();
  const CouplingNumbers numbers = coupling_numbers(tree, tree.couplings[0], DefaultValues({}));
  EXPECT_EQ(numbers.factors, (std::vector<double>{2, -1}));
  EXPECT_EQ(numbers.offset, 0.5);
}

TEST(Elements, AJointThatFollowsThroughALoopHasNoNumbers) {
  KinematicTree tree = coupled();
  tree.loops.emplace_back();
  tree.closures.emplace_back();
  tree.closures[0].loops = {0};
  tree.couplings[0].closure = 0;
  CouplingNumbers numbers = coupling_numbers(tree, tree.couplings[0], DefaultValues({}));
  EXPECT_TRUE(std::isnan(numbers.factors[0]) && std::isnan(numbers.offset));
  EXPECT_EQ(numbers.assembled, 0);
  tree.loops[0].takes_other_branch = true;
  EXPECT_EQ(coupling_numbers(tree, tree.couplings[0], DefaultValues({})).assembled, 0.5);
}

TEST(Elements, ComponentsOfASphericalJointStandForTheWhole) {
  KinematicTree tree = test::only_base("Ball", "base");
  for (const std::string axis : {"x", "y", "z"}) {
    const int parent = tree.dof();
    test::add_link(tree, "hip_" + axis, JointType::spherical, parent, axis, {}, test::vector(parent + 1, 0, 0));
    tree.joints.back().spherical = "hip";
    tree.joints.back().axis = parent;
  }
  std::swap(tree.links[1], tree.links[3]);  // repeated links come last
  tree.joints[0].child = tree.joints[1].parent = 3;
  tree.joints[2].child = 1;
  tree.links[2].is_repeated = tree.links[3].is_repeated = true;
  EXPECT_EQ(parent_link(tree, 1), 0);
  EXPECT_EQ(child_link(tree, 0), 1);
  EXPECT_EQ(DefaultValues({})(placement_of_joint(tree, 2).translation), (Vector{1, 0, 0}));
  EXPECT_EQ(carrying_joints(tree), (std::vector<int>{-1, 0}));
  EXPECT_EQ(quaternions(tree), std::vector<int>{0});
  EXPECT_TRUE(has_own_positions(tree));
}

// Numbers that depend on a parameter without a default are NaN; all others are known.
TEST(Elements, ParametersWithoutDefaultLeaveNoNumbers) {
  KinematicTree tree = coupled();
  tree.parameters = {parameter("heavy", {}), parameter("light", 0.5)};
  tree.links[1].inertia->mass = Quantity::parameter(0);
  tree.links[2].inertia = test::body(0);
  tree.links[2].inertia->mass = Quantity::parameter(1);
  const DefaultValues value(tree.parameters);
  EXPECT_TRUE(std::isnan(mass_properties(tree.links[1], value).mass));
  EXPECT_EQ(mass_properties(tree.links[1], value).com, (Vector{0, 0, 0.5}));
  EXPECT_EQ(mass_properties(tree.links[2], value).mass, 0.5);
  EXPECT_EQ(mass_properties(tree.links[3], value).mass, 0);
}

TEST(Elements, MassPropertiesAreInTheLinkFrame) {
  KinematicTree tree = coupled();
  tree.links[1].inertia->reference = Placement{test::vector(0, 0, 1), {}};
  const MassProperties link = mass_properties(tree.links[1], DefaultValues({}));
  EXPECT_EQ(link.com, (Vector{0, 0, 1.5}));
  EXPECT_EQ(link.inertia, (std::array<double, 6>{4, 4, 0, 0, 0, 0}));  // parallel axes: 2 kg * (1.5^2 - 0.5^2) m^2
}

TEST(Elements, ADriveHasItsNumbersAndThoseOfItsRotor) {
  KinematicTree tree = coupled();
  tree.joints[0].drive.friction = Quantity(3.0);
  EXPECT_EQ(rotor_carrier(tree.joints[0]), -1);
  tree.joints[0].drive.rotor = Rotor{Quantity(0.01), Quantity(50.0)};
  tree.joints[0].drive.rotor->carrier = 1;
  const DefaultValues value({});
  EXPECT_EQ(drive_numbers(tree.joints[0], value), (std::array<double, 8>{0, 3, 0, 0, 0, 0, 0.01, 50}));
  EXPECT_EQ(rotor_axis(tree.joints[0], value), (Vector{0, 0, 1}));
  EXPECT_EQ(rotor_carrier(tree.joints[0]), 1);
  EXPECT_EQ(rotor_axis(tree.joints[2], value), Vector());
}

TEST(Elements, LimbsWithOneNameAreToldApartByTheirParts) {
  KinematicTree tree = coupled();
  tree.limbs = {
      {"left", "arm", 1, {{"cart", 1}}, {{"slide", 0}, {"a", 1}, {"wheel", 2}}, {{"tip", 0}}},
      {"left", "leg", 2, {}, {}, {}}};
  EXPECT_EQ(limb_names(tree), (Names{"left_arm", "left_leg"}));
  const Limb limb = listed_limbs(tree)[0];
  ASSERT_EQ(limb.joints.size(), 2U);  // the coupled joint has no element in joint arrays
  EXPECT_EQ(limb.joints[1].index, 1);
  EXPECT_EQ(limb.frames[0].index, place_of_frame(tree, "tip"));
}

}  // namespace
}  // namespace robcogen::model::elements_test
