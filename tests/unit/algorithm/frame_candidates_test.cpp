// Candidates for link frames: which numbers they make zero, and how far the frames may move.
#include "algorithm/search/frame_candidates.h"

#include <cmath>

#include "random_robots.h"

namespace robcogen::algorithm::frame_candidates_test {
namespace {

using namespace test;
using model::KinematicTree;
using model::Quantity;

// Rounding errors of moments of size 10, with candidates merged that are closer than 1e-9.
constexpr double kVanishes = 1e-8;

double value(const Candidate& c) {
  return c.value.number().value();
}

bool any_of(const std::vector<Candidate>& list, const std::function<bool(double)>& condition) {
  return std::any_of(list.begin(), list.end(), [&](const Candidate& c) { return condition(value(c)); });
}

// A chain in which the model's mass properties stay at their links.
class FrameCandidatesOf : public testing::TestWithParam<int> {
 protected:
  static constexpr int kJoints = 4;
  Numbers n{static_cast<unsigned>(GetParam())};
  KinematicTree tree = random_robot(n, kJoints, true);
  FrameCandidates candidates{tree, plain_formulation()};
  LinkFrames frames = LinkFrames(kJoints);

  // Returns the first moment and pseudo-inertia of a joint's child in a frame that is turned by an angle about z.
  std::pair<Eigen::Vector3d, Eigen::Matrix3d> turned(int joint, double angle) {
    const MassProperties m = mass_properties(n.trace, tree.links[static_cast<std::size_t>(joint + 1)]);
    const Eigen::Matrix3d r = turn(2, -angle);
    return {r * n.value(m.first_moment), r * n.value(m.pseudo_inertia) * r.transpose()};
  }
};

TEST_P(FrameCandidatesOf, KeepWhatThereIsFirstAndNothingTwice) {
  for (LinkFrame& frame : frames) frame = {Quantity(n.real()), Quantity(n.real() / 10)};
  for (int j = 0; j < kJoints; ++j) {
    const LinkFrame& now = frames[static_cast<std::size_t>(j)];
    for (const bool turns : {true, false}) {
      const std::vector<Candidate> list = turns ? candidates.turns(j, frames) : candidates.slides(j, now.turn, frames);
      ASSERT_FALSE(list.empty());
      EXPECT_EQ(list[0].rule, 0);
      EXPECT_EQ(value(list[0]), (turns ? now.turn : now.slide).number().value());
      for (std::size_t a = 0; a < list.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) {
          EXPECT_GT(list[a].rule, list[b].rule);
          EXPECT_GT(std::abs(value(list[a]) - value(list[b])), 1e-9);
        }
    }
  }
}

// Turns align an axis of the frame with the centre of mass, with a principal axis of the cross-section, or with the
// products of inertia with z.
TEST_P(FrameCandidatesOf, TurnsMakeMomentsAndProductsVanish) {
  for (int j = 0; j < kJoints; ++j) {
    const std::vector<Candidate> turns = candidates.turns(j, frames);
    EXPECT_TRUE(any_of(turns, [&](double a) { return std::abs(turned(j, a).first.x()) < kVanishes; }));
    EXPECT_TRUE(any_of(turns, [&](double a) { return std::abs(turned(j, a).first.y()) < kVanishes; }));
    EXPECT_TRUE(any_of(turns, [&](double a) { return std::abs(turned(j, a).second(0, 1)) < kVanishes; }));
    EXPECT_TRUE(any_of(turns, [&](double a) { return std::abs(turned(j, a).second(0, 2)) < kVanishes; }));
    EXPECT_TRUE(any_of(turns, [&](double a) { return std::abs(turned(j, a).second(1, 2)) < kVanishes; }));
  }
}

// Moving the origin by s along z subtracts s h from the products with z.
TEST_P(FrameCandidatesOf, SlidesMakeProductsVanish) {
  const double angle = n.real();
  for (int j = 0; j < kJoints; ++j) {
    const std::pair<Eigen::Vector3d, Eigen::Matrix3d> moments = turned(j, angle);
    const Eigen::Vector3d& h = moments.first;
    const Eigen::Matrix3d& S = moments.second;
    const std::vector<Candidate> slides = candidates.slides(j, Quantity(angle), frames);
    for (int axis : {0, 1}) {
      const double needed = S(axis, 2) / h[axis];
      if (std::abs(needed) > 1) continue;  // may exceed the robot's length
      EXPECT_TRUE(any_of(slides, [&](double s) { return std::abs(S(axis, 2) - s * h[axis]) < kVanishes; }))
          << j << "xy"[axis];
    }
  }
}

// Slides are no longer than all offsets of the chain together.
TEST_P(FrameCandidatesOf, SlidesStayWithinTheRobot) {
  double length = 0;
  for (const model::Joint& joint : tree.joints)
    for (const Quantity& t : joint.placement.translation) length += std::abs(t.number().value());
  for (const Quantity& c : tree.links.back().inertia->com) length += std::abs(c.number().value());
  double longest = length;  // the longest path that ends in an earlier link
  for (const model::Link& link : tree.links)
    if (link.inertia)
      for (const Quantity& c : link.inertia->com) longest += std::abs(c.number().value());
  for (int j = 0; j < kJoints; ++j)
    EXPECT_FALSE(any_of(candidates.slides(j, Quantity(), frames), [&](double s) { return std::abs(s) > longest; }));
}

INSTANTIATE_TEST_SUITE_P(, FrameCandidatesOf, testing::Range(0, 20));

// A slightly tilted second axis, at a distance of 0.5 m: the common normal meets the first axis far outside the robot.
KinematicTree tilted_axes(double tilt) {
  model::Description d = model::test::two_links();
  d.joints[1].placement.translation[1] = Quantity(0.5);
  d.joints[1].placement.rotation[0] = Quantity(tilt);
  return built(d);
}

TEST(FrameCandidates, FeetOfCommonNormalsCountWithinTheRobot) {
  const auto feet = [](double tilt) {
    const KinematicTree tree = tilted_axes(tilt);
    return FrameCandidates(tree, plain_formulation()).slides(0, Quantity(), LinkFrames(2));
  };
  // z' = (0, -sin, cos) through (0, 0.5, 0) meets the first axis at z = 0.5 / tan.
  const auto is_foot = [](double tilt) { return [=](double s) { return std::abs(s - 0.5 / std::tan(tilt)) < 1e-12; }; };
  EXPECT_TRUE(any_of(feet(1.0), is_foot(1.0)));
  EXPECT_FALSE(any_of(feet(0.5), is_foot(0.5)));  // 0.9 m, in a robot of half a metre
  EXPECT_FALSE(any_of(feet(0.01), is_foot(0.01)));
}

TEST(FrameCandidates, ParallelAxesOfferTheirOffset) {
  model::Description d = model::test::two_links();
  d.joints[1].placement.translation[0] = Quantity(0.3);
  d.joints[1].placement.translation[1] = Quantity(0.4);
  const KinematicTree tree = built(d);
  const std::vector<Candidate> turns = FrameCandidates(tree, plain_formulation()).turns(0, LinkFrames(2));
  EXPECT_TRUE(any_of(turns, [](double a) { return std::abs(a - std::atan2(0.4, 0.3)) < 1e-12; }));
}

TEST(FrameCandidates, NumbersAreThoseOfTheModel) {
  const KinematicTree tree = two_legs(0.1, -0.25);
  const auto numbers = FrameCandidates(tree, plain_formulation()).numbers();
  ASSERT_TRUE(numbers);
  ASSERT_EQ(numbers->masses.size(), tree.links.size());
  ASSERT_EQ(numbers->placements.size(), tree.joints.size());
  const MassNumbers& shank = numbers->masses[static_cast<std::size_t>(*tree.find_link("R_shank"))];
  EXPECT_EQ(shank.mass.value(), 1.0);
  EXPECT_NEAR(shank.first_moment[1].value(), -0.25, kByHand);
  EXPECT_NEAR(shank.pseudo_inertia[0][1].value(), 0.25 * -0.25, kByHand);
  EXPECT_NEAR(shank.pseudo_inertia[2][2].value(), 0.125 * 0.125, kByHand);
}

TEST(FrameCandidates, ParametersLeaveNoNumbers) {
  model::Description d = model::test::two_links();
  d.parameters = {{"length", model::ParameterKind::length, 0.5, {}}};
  d.joints[1].placement.translation[0] = Quantity::parameter(0);
  const KinematicTree tree = built(d);
  const FrameCandidates candidates(tree, plain_formulation());
  EXPECT_FALSE(candidates.numbers());
  EXPECT_FALSE(candidates.turns(0, LinkFrames(2)).empty());
}

}  // namespace
}  // namespace robcogen::algorithm::frame_candidates_test
