// Link frames of congruent limbs: numbers that vanish in the frames of the first limb also vanish in those of the
// others.
#include "algorithm/search/corresponding_frames.h"

#include <cmath>

#include "algorithm/dynamics/traced_robot.h"
#include "algorithm/search/frame_candidates.h"
#include "random_robots.h"

namespace robcogen::algorithm {
namespace {

using namespace test;
using model::KinematicTree;
using model::Quantity;

// Rounding errors of moments of size 1.
constexpr double kVanishes = 1e-12;

std::size_t joint(const KinematicTree& tree, const char* name) {
  return static_cast<std::size_t>(*tree.find_joint(name));
}

// Returns which numbers of a joint's child vanish in these frames: offset, slide, moments.
std::vector<bool> vanishing(const KinematicTree& tree, Formulation formulation, const LinkFrames& frames, int joint) {
  formulation.frames = frames;
  Trace trace(tree);
  const TracedRobot robot(trace, trace.joint_input("q", symbolic::Role::joint_position), formulation);
  const Pose& pose = robot.poses[static_cast<std::size_t>(joint)];
  const MassProperties& mass =
      robot.masses[static_cast<std::size_t>(tree.joints[static_cast<std::size_t>(joint)].child)];
  std::vector<Expression> numbers(pose.offset.element.begin(), pose.offset.element.end());
  numbers.push_back(pose.slide);
  numbers.insert(numbers.end(), mass.first_moment.element.begin(), mass.first_moment.element.end());
  for (const Vector3& row : mass.pseudo_inertia.row)
    numbers.insert(numbers.end(), row.element.begin(), row.element.end());
  std::vector<bool> result;
  for (const Expression& e : numbers) result.push_back(e.is_constant() && std::abs(e.number().value()) < kVanishes);
  return result;
}

class CorrespondingFrames : public testing::TestWithParam<bool> {};

// The second leg is mirrored, or its shank has another centre of mass.
TEST_P(CorrespondingFrames, MakeTheSameNumbersVanish) {
  const KinematicTree tree = two_legs(0.125, GetParam() ? -0.125 : 0.375);
  Formulation formulation;
  const FrameCandidates candidates(tree, formulation);
  const std::size_t left = joint(tree, "L_knee"), right = joint(tree, "R_knee");
  int compared = 0;
  for (const Candidate& turn : candidates.turns(static_cast<int>(left), LinkFrames(tree.joints.size()))) {
    formulation.frames = LinkFrames(tree.joints.size());
    formulation.frames[left] = {turn.value, Quantity(), true};
    formulation.frames[right] = {Quantity(0.7), Quantity(0.1), false};
    const LinkFrames frames = corresponding_frames(tree, formulation);
    ASSERT_EQ(frames.size(), tree.joints.size());
    EXPECT_EQ(frames[left], formulation.frames[left]);
    EXPECT_EQ(frames[right].slide, Quantity());
    EXPECT_TRUE(frames[right].turns_with_joint);
    const auto of = [&](std::size_t j) { return vanishing(tree, formulation, frames, static_cast<int>(j)); };
    EXPECT_EQ(of(left), of(right)) << turn.rule;
    ++compared;
  }
  EXPECT_GT(compared, 2);
}

INSTANTIATE_TEST_SUITE_P(Legs, CorrespondingFrames, testing::Bool());

// No rule gives this turn, so it may have a reason in another limb; the frames stay unchanged.
TEST(CorrespondingFrames, OfATurnByNoRuleAreThoseThatThereWere) {
  const KinematicTree tree = two_legs(0.125, -0.125);
  Formulation formulation;
  formulation.frames = LinkFrames(tree.joints.size());
  formulation.frames[joint(tree, "L_knee")].turn = Quantity(0.123);
  formulation.frames[joint(tree, "R_knee")].turn = Quantity(0.456);
  EXPECT_EQ(corresponding_frames(tree, formulation), formulation.frames);
}

TEST(CorrespondingFrames, OfTheModelAreTheModels) {
  EXPECT_TRUE(corresponding_frames(two_legs(0.125, -0.125), Formulation()).empty());
}

}  // namespace
}  // namespace robcogen::algorithm
