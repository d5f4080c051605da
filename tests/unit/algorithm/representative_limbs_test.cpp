// Congruent limbs that differ in zeros get numbers that fold in the same way and keep their values.
#include "algorithm/formulation/representative_limbs.h"

#include <array>
#include <cmath>
#include <numbers>

#include "algorithm/dynamics/traced_robot.h"
#include "random_robots.h"

namespace robcogen::algorithm::representative_limbs_test {
namespace {

using namespace test;
using model::KinematicTree;

// The poses and mass properties of the model, and the numbers that represent them.
struct Representatives {
  explicit Representatives(KinematicTree robot) : tree(std::move(robot)) {
    q = trace.joint_input("q", symbolic::Role::joint_position);
    const TracedRobot traced(trace, q);
    poses = traced.poses;
    masses = traced.masses;
    links = representative_links(tree, poses, masses);
  }

  KinematicTree tree;
  Trace trace{tree};
  std::vector<Expression> q;
  std::vector<Pose> poses;
  std::vector<MassProperties> masses;
  RepresentativeLinks links;

  std::size_t joint(const char* name) const { return static_cast<std::size_t>(*tree.find_joint(name)); }
  const MassProperties& mass(const char* joint_name) const {
    return masses[static_cast<std::size_t>(tree.joints[joint(joint_name)].child)];
  }
  void fold() {
    for (std::size_t j = 0; j < links.size(); ++j) {
      fold_like(trace, links[j], poses[j]);
      fold_like(trace, links[j], masses[static_cast<std::size_t>(tree.joints[j].child)]);
    }
  }
  // Computes the shank's mass properties about the thigh's origin.
  symbolic::Program shank_in_thigh(const char* knee) const {
    const MassProperties m = to_parent(poses[joint(knee)], mass(knee));
    std::vector<Expression> values = flat(m.pseudo_inertia);
    for (const Expression& e : m.first_moment.element) values.push_back(e);
    return test::program(trace.graph, tree.joints.size(), values);
  }
};

constexpr std::size_t kMomentY = 2;  // of RepresentativeLink::mass
constexpr double kRightY = -0.1875;  // differs from all other numbers of the robot; otherwise sums would be shared

TEST(RepresentativeLimbs, EqualLimbsNeedNone) {
  EXPECT_TRUE(Representatives(two_legs(0, 0)).links.empty());
  EXPECT_TRUE(Representatives(two_legs(0.1, -0.1)).links.empty());
}

// The numbers differ, but a zero of one limb is a zero of the other.
TEST(RepresentativeLimbs, LimbsThatFoldInTheSameWayNeedNone) {
  EXPECT_TRUE(Representatives(two_legs(0.1, -0.25)).links.empty());
}

TEST(RepresentativeLimbs, RobotsWithoutCongruentLimbsNeedNone) {
  EXPECT_TRUE(Representatives(two_rods()).links.empty());
}

// One magnitude, between those of the limbs, represents both; numbers that they share stay.
TEST(RepresentativeLimbs, AMagnitudeStandsForTheZero) {
  const Representatives r(two_legs(0, kRightY));
  ASSERT_EQ(r.links.size(), 4U);
  const RepresentativeLink &left = r.links[r.joint("L_knee")], &right = r.links[r.joint("R_knee")];
  EXPECT_EQ(left.mass[kMomentY], -right.mass[kMomentY]);  // with the sign of each limb
  EXPECT_GT(left.mass[kMomentY], 0);
  EXPECT_LT(left.mass[kMomentY], -kRightY);
  EXPECT_TRUE(std::isnan(left.mass[0]));
  for (const double number : r.links[r.joint("L_hip")].mass) EXPECT_TRUE(std::isnan(number));
}

TEST(RepresentativeLimbs, NumbersFoldLikeThemAndKeepTheirValues) {
  Representatives r(two_legs(0, kRightY));
  const std::vector<double> q = {0.3, 0.8, -0.4, 1.2};  // L_hip, L_knee, R_hip, R_knee
  const symbolic::Program left = r.shank_in_thigh("L_knee"), right = r.shank_in_thigh("R_knee");
  ASSERT_LT(symbolic::work(left), symbolic::work(right));

  EXPECT_TRUE(r.mass("L_knee").first_moment[1].is_zero());
  r.fold();
  const Expression& moment = r.mass("L_knee").first_moment[1];
  EXPECT_FALSE(moment.is_zero());
  EXPECT_EQ(moment.number().value(), 0.0);
  EXPECT_EQ(r.mass("R_knee").first_moment[1].number().value(), kRightY);

  const symbolic::Program left_like = r.shank_in_thigh("L_knee"), right_like = r.shank_in_thigh("R_knee");
  EXPECT_EQ(symbolic::work(left_like), symbolic::work(right_like));
  EXPECT_EQ(symbolic::work(right_like), symbolic::work(right));
  expect_near(run(left_like, {{"in", q}}), run(left, {{"in", q}}));
  expect_near(run(right_like, {{"in", q}}), run(right, {{"in", q}}));
}

// Two legs; the right knee is turned by 90 degrees more than the left one, plus a rounding error.
KinematicTree legs_with_a_rounding() {
  KinematicTree tree = two_legs(0.1, -0.1);
  const auto rotation = [&](const char* joint) -> auto& {
    return tree.joints[static_cast<std::size_t>(*tree.find_joint(joint))].placement.rotation;
  };
  rotation("R_knee")[0] = model::Quantity(3.14159265358);
  rotation("R_hip")[1] = model::Quantity(-1.57079632679);
  rotation("L_hip")[1] = model::test::pi(1, 2);
  return tree;
}

// A plane that only one limb has is added to the others: it folds like that one, but its angle is zero.
TEST(RepresentativeLimbs, APlaneOfOneLimbStandsInAll) {
  Representatives r(legs_with_a_rounding());
  const auto rotation = [&](const char* joint) -> const Rotation& { return r.poses[r.joint(joint)].rotation; };
  ASSERT_LT(rotation("L_knee").planes.size(), rotation("R_knee").planes.size());
  std::vector<Vector3> before, after;
  const std::vector<const char*> joints = {"L_hip", "R_hip", "L_knee", "R_knee"};
  const Vector3 v{r.q[0], r.q[1], r.q[2]};
  for (const char* joint : joints) before.push_back(to_parent(rotation(joint), v));
  r.fold();
  for (const char* joint : joints) after.push_back(to_parent(rotation(joint), v));

  for (const char* of : {"hip", "knee"}) {
    const Rotation &left = rotation((std::string("L_") + of).c_str()),
                   &right = rotation((std::string("R_") + of).c_str());
    ASSERT_EQ(left.planes.size(), right.planes.size()) << of;
    EXPECT_EQ(left.quarter.image, right.quarter.image) << of;
    for (std::size_t k = 0; k < left.planes.size(); ++k) {
      EXPECT_EQ(left.planes[k].axis, right.planes[k].axis);
      EXPECT_EQ(left.planes[k].s.is_zero(), right.planes[k].s.is_zero());
      EXPECT_EQ(left.planes[k].c.is_constant(), right.planes[k].c.is_constant());
    }
  }
  EXPECT_EQ(rotation("L_knee").planes.front().s.number().value(), 0.0);
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const auto value = [&](const Vector3& vector) {
      std::vector<Expression> elements(vector.element.begin(), vector.element.end());
      return run(test::program(r.trace.graph, r.tree.joints.size(), elements), {{"in", {0.3, 0.8, -0.4, 1.2}}});
    };
    expect_near(value(after[k]), value(before[k]));
  }
}

// Two legs; the knees are turned by other angles about other axes.
KinematicTree legs_with_knees(const std::array<double, 3>& left, const std::array<double, 3>& right) {
  KinematicTree tree = two_legs(0.1, -0.1);
  for (const bool is_left : {true, false}) {
    auto& rotation =
        tree.joints[static_cast<std::size_t>(*tree.find_joint(is_left ? "L_knee" : "R_knee"))].placement.rotation;
    for (std::size_t k = 0; k < 3; ++k) rotation[k] = model::Quantity(is_left ? left[k] : right[k]);
  }
  return tree;
}

// Rotations that are written in different ways take one form in both limbs.
TEST(RepresentativeLimbs, AnyTwoRotationsGetTheSamePlanes) {
  constexpr double kQuarter = std::numbers::pi / 2;
  const std::array<std::array<std::array<double, 3>, 2>, 6> knees = {{
      {{{0.3, 0, 0}, {0, 0.3, 0}}},
      {{{0, 0, kQuarter}, {2 * kQuarter, 0, -kQuarter}}},
      {{{kQuarter, 0, 0.2}, {0.1, -0.4, 1.3}}},
      {{{0, 0, 0}, {0, 0, 0.25}}},
      {{{0, 1e-7, 0}, {1e-7, 0, 0.5}}},
      {{{0, 0, 3.1415926}, {-1.5707963, 1.5707963, 0.1}}},
  }};
  for (std::size_t i = 0; i < knees.size(); ++i) {
    Representatives r(legs_with_knees(knees[i][0], knees[i][1]));
    const Vector3 v{r.q[0], r.q[1], r.q[2]};
    const auto value = [&](const Rotation& rotation) {
      const Vector3 vector = to_parent(rotation, v);
      const std::vector<Expression> elements(vector.element.begin(), vector.element.end());
      return run(test::program(r.trace.graph, r.tree.joints.size(), elements), {{"in", {0.3, 0.8, -0.4, 1.2}}});
    };
    const Rotation &left = r.poses[r.joint("L_knee")].rotation, &right = r.poses[r.joint("R_knee")].rotation;
    const std::vector<double> of_left = value(left), of_right = value(right);
    r.fold();
    expect_near(value(left), of_left);
    expect_near(value(right), of_right);
    ASSERT_EQ(left.planes.size(), right.planes.size()) << i;
    EXPECT_EQ(left.quarter.image, right.quarter.image) << i;
    for (std::size_t k = 0; k < left.planes.size(); ++k) {
      EXPECT_EQ(left.planes[k].axis, right.planes[k].axis) << i;
      EXPECT_EQ(left.planes[k].c.is_constant(), right.planes[k].c.is_constant()) << i;
      EXPECT_EQ(left.planes[k].c.is_zero(), right.planes[k].c.is_zero()) << i;
      EXPECT_EQ(left.planes[k].s.is_zero(), right.planes[k].s.is_zero()) << i;
    }
  }
}

}  // namespace
}  // namespace robcogen::algorithm::representative_limbs_test
