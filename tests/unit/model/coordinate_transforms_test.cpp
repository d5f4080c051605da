#include "model/coordinate_transforms.h"

#include <gtest/gtest.h>

#include <map>

#include "descriptions.h"

namespace robcogen::model::coordinate_transforms_test {
namespace {

// Coordinates stay within a few metres through chains of a dozen primitives.
constexpr double kTolerance = 1e-12;

std::string text(const CoordinateTransform& transform, const RigidMotions& motions) {
  std::string result;
  for (const PrimitiveTransform& p : transform.primitives) {
    if (!result.empty()) result += " ";
    result += p.rotation ? "R" : "T";
    result += "xyz"[static_cast<int>(p.axis)];
    result += "(";
    result += print(p.amount, motions.parameters, motions.variables);
    result += ")";
  }
  return result;
}

std::string between(
    const RigidMotions& motions,
    const std::string& left,
    const std::string& right,
    MovedFramePosition position = MovedFramePosition::right) {
  const auto transform = transform_between(motions, left, right, position);
  return transform ? text(*transform, motions) : "none";
}

ElementaryMotion turn(Axis axis, int variable) {
  return {true, axis, Quantity::variable(variable)};
}
ElementaryMotion shift(Axis axis, int variable) {
  return {false, axis, Quantity::variable(variable)};
}

// Fig. 4 of the paper: sequences of Euler angles.
RigidMotions euler_angles() {
  RigidMotions motions;
  motions.variables = {"a11", "a12", "a13", "a21", "a22", "a23", "a31", "a32", "a33"};
  motions.motions = {
      {"S", "Exyz", {turn(Axis::x, 0), turn(Axis::y, 1), turn(Axis::z, 2)}, "xyz"},
      {"S", "Exzy", {turn(Axis::x, 3), turn(Axis::z, 4), turn(Axis::y, 5)}, ""},
      {"S", "Eyxz", {turn(Axis::y, 6), turn(Axis::x, 7), turn(Axis::z, 8)}, ""}};
  return motions;
}

TEST(TransformBetween, GivesTheTransformsOfThePapersFigure4) {
  const RigidMotions motions = euler_angles();
  EXPECT_EQ(between(motions, "S", "Exyz"), "Rx(a11) Ry(a12) Rz(a13)");
  EXPECT_EQ(between(motions, "Exyz", "S"), "Rz(-a13) Ry(-a12) Rx(-a11)");
  EXPECT_EQ(between(motions, "Eyxz", "S"), "Rz(-a33) Rx(-a32) Ry(-a31)");
  EXPECT_EQ(between(motions, "Exzy", "Exyz"), "Ry(-a23) Rz(-a22) Rx(-a21) Rx(a11) Ry(a12) Rz(a13)");
}

TEST(TransformBetween, NegatesEveryArgumentForTheLeft) {
  const RigidMotions motions = euler_angles();
  EXPECT_EQ(between(motions, "S", "Exyz", MovedFramePosition::left), "Rx(-a11) Ry(-a12) Rz(-a13)");
  EXPECT_EQ(between(motions, "Exyz", "S", MovedFramePosition::left), "Rz(a13) Ry(a12) Rx(a11)");
}

TEST(TransformBetween, ArrangesMotionsAboutFixedAxes) {
  RigidMotions motions = euler_angles();
  motions.convention = MotionConvention::fixed;
  motions.motions = {{"S", "E", {turn(Axis::x, 0), shift(Axis::x, 1), turn(Axis::y, 2), shift(Axis::z, 3)}, ""}};
  EXPECT_EQ(between(motions, "S", "E"), "Tx(a12) Tz(a21) Ry(a13) Rx(a11)");
  EXPECT_EQ(between(motions, "E", "S"), "Rx(-a11) Ry(-a13) Tz(-a21) Tx(-a12)");
  EXPECT_EQ(between(motions, "S", "E", MovedFramePosition::left), "Tx(-a12) Tz(-a21) Ry(-a13) Rx(-a11)");
}

TEST(TransformBetween, NamesOnlyTheTransformOfTheMotionItself) {
  const RigidMotions motions = euler_angles();
  EXPECT_EQ(transform_between(motions, "S", "Exyz")->name, "xyz");
  EXPECT_EQ(transform_between(motions, "Exyz", "S")->name, "");
  EXPECT_EQ(transform_between(motions, "Exzy", "Exyz")->name, "");
}

TEST(TransformBetween, IsTheIdentityFromAFrameToItself) {
  EXPECT_EQ(between(euler_angles(), "S", "S"), "");
}

TEST(TransformBetween, RefusesFramesThatAreUnknownOrApart) {
  RigidMotions motions = euler_angles();
  EXPECT_EQ(between(motions, "S", "T"), "none");
  EXPECT_EQ(between(motions, "T", "T"), "none");
  motions.frames = {"T"};
  EXPECT_EQ(between(motions, "T", "T"), "");
  EXPECT_EQ(between(motions, "S", "T"), "none");
}

TEST(MotionsOf, GiveThePapersFigure9) {
  Description d = test::two_links();
  d.joints[1].placement.translation = {Quantity(), Quantity(*Number::parse("0.13")), Quantity(*Number::parse("-0.08"))};
  d.joints[1].placement.rotation = {test::pi(-1, 2), Quantity(), test::pi(1, 2)};
  d.joints[0].type = JointType::prismatic;
  Placement sole;
  sole.rotation[1] = Quantity::parameter(0);
  d.links[1].frames = {{"sole", sole, {}}, {"fr_one", {}, {}}};
  d.parameters = {{"tilt", ParameterKind::angle, {}, {}}};
  Diagnostics diagnostics;
  const RigidMotions motions = motions_of(*build(d, diagnostics));
  EXPECT_EQ(motions.name, "two_links");
  EXPECT_EQ(motions.variables, (std::vector<std::string>{"q_a", "q_b"}));
  EXPECT_EQ(between(motions, "fr_base", "fr_a"), "");
  EXPECT_EQ(between(motions, "fr_a", "fr_one"), "Tz(q_a)");
  EXPECT_EQ(between(motions, "fr_one", "fr_b"), "Ty(0.13) Tz(-0.08) Rx(-PI/2.0) Rz(PI/2.0)");
  EXPECT_EQ(between(motions, "fr_b", "fr_two"), "Rz(q_b)");
  EXPECT_EQ(between(motions, "fr_two", "sole"), "Ry(tilt)");
  EXPECT_EQ(
      between(motions, "sole", "fr_base"), "Ry(-tilt) Rz(-q_b) Rz(-PI/2.0) Rx(PI/2.0) Tz(0.08) Ty(-0.13) Tz(-q_a)");
}

TEST(MotionsOf, KnowTheFrameOfALoneBase) {
  Description d;
  d.base = test::link("rock");
  Diagnostics diagnostics;
  EXPECT_EQ(between(motions_of(*build(d, diagnostics)), "fr_rock", "fr_rock"), "");
}

// --- numerically, against poses that are moved step by step ---------------------------------------------------

Eigen::Isometry3d elementary(bool rotation, Axis axis, double amount) {
  const Eigen::Vector3d unit = Eigen::Vector3d::Unit(static_cast<int>(axis));
  return rotation ? Eigen::Isometry3d(Eigen::AngleAxisd(amount, unit))
                  : Eigen::Isometry3d(Eigen::Translation3d(amount * unit));
}

// Returns from_T_to: the pose to which `motion` carries its frame.
Eigen::Isometry3d carried(const Motion& motion, MotionConvention convention, const std::vector<double>& variables) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (const ElementaryMotion& step : motion.steps) {
    const Eigen::Isometry3d move = elementary(step.rotation, step.axis, evaluate(step.amount, {}, variables));
    if (convention == MotionConvention::local) {
      pose = pose * move;
    } else if (step.rotation) {
      pose.linear() = move.linear() * pose.linear();  // about the moved origin
    } else {
      pose.translation() += move.translation();
    }
  }
  return pose;
}

Eigen::Isometry3d product(
    const CoordinateTransform& transform,
    MovedFramePosition position,
    const std::vector<double>& variables) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  for (const PrimitiveTransform& p : transform.primitives) {
    const Eigen::Isometry3d right = elementary(p.rotation, p.axis, evaluate(p.amount, {}, variables));
    result = result * (position == MovedFramePosition::right ? right : right.inverse());
  }
  return result;
}

TEST(TransformBetween, AgreesWithPosesMovedStepByStep) {
  constexpr std::uint64_t kSeed = 4711;
  std::mt19937_64 engine(kSeed);
  const auto pick = [&](int below) { return static_cast<int>(engine() % static_cast<unsigned>(below)); };
  std::uniform_real_distribution<double> any(-2.0, 2.0);
  for (int round = 0; round < 100; ++round) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", round " + std::to_string(round));
    RigidMotions motions;
    motions.convention = round % 2 == 0 ? MotionConvention::local : MotionConvention::fixed;
    const int frames = 2 + pick(12);
    std::vector<double> variables;
    std::map<std::string, Eigen::Isometry3d> world = {{"f0", Eigen::Isometry3d::Identity()}};
    for (int i = 1; i < frames; ++i) {
      const std::string known = "f" + std::to_string(pick(i)), added = "f" + std::to_string(i);
      const bool outwards = pick(2) == 0;
      Motion motion{outwards ? known : added, outwards ? added : known, {}, ""};
      for (int steps = pick(6); steps > 0; --steps) {
        const Quantity variable = Quantity::variable(static_cast<int>(variables.size()));
        motion.steps.push_back({pick(2) == 0, static_cast<Axis>(pick(3)), variable});
        variables.push_back(any(engine));
      }
      motions.motions.push_back(motion);
      const Eigen::Isometry3d pose = carried(motion, motions.convention, variables);
      world[added] = world[known] * (outwards ? pose : pose.inverse());
    }
    for (const auto& [left, left_pose] : world) {
      for (const auto& [right, right_pose] : world) {
        for (const auto position : {MovedFramePosition::left, MovedFramePosition::right}) {
          const auto transform = transform_between(motions, left, right, position);
          ASSERT_TRUE(transform.has_value());
          EXPECT_TRUE(product(*transform, position, variables).isApprox(left_pose.inverse() * right_pose, kTolerance))
              << left << "_X_" << right;
        }
      }
    }
  }
}

}  // namespace
}  // namespace robcogen::model::coordinate_transforms_test
