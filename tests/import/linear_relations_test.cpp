// Following joints, compared with the relations that determine them.
#include "import/linear_relations.h"

#include <gtest/gtest.h>

#include <random>

namespace robcogen::import::from_urdf::linear_relations_test {
namespace {

LinearRelation relation(const std::vector<int>& factors) {
  LinearRelation result;
  for (std::size_t j = 0; j < factors.size(); ++j)
    if (factors[j] != 0) result[static_cast<int>(j)] = Number::rational(factors[j]);
  return result;
}

bool any_joint(int) {
  return true;
}

double value(const LinearRelation& sum, const std::vector<double>& positions) {
  double result = 0.0;
  for (const auto& [joint, factor] : sum) result += factor.value() * positions[static_cast<std::size_t>(joint)];
  return result;
}

TEST(LinearRelations, TheLastJointThatMayFollows) {
  const std::vector<LinearRelation> relations = {relation({2, 4, 8})};
  const auto& all = solve(relations, any_joint).followers;
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all.begin()->first, 2);
  EXPECT_EQ(all.begin()->second.sum.at(0), Number::rational(1, 4));
  EXPECT_EQ(all.begin()->second.sum.at(2), Number::rational(1));
  const auto& second = solve(relations, [](int joint) { return joint == 1; }).followers;
  ASSERT_EQ(second.size(), 1U);
  EXPECT_EQ(second.begin()->first, 1);
  EXPECT_EQ(second.begin()->second.sum.at(2), Number::rational(2));
}

TEST(LinearRelations, RedundantOnesAndThoseWithoutFollowerAreNamed) {
  const std::vector<LinearRelation> relations = {
      relation({1, 1, 0}), relation({1, 0, 0}), relation({2, 2, 0}), relation({})};
  const SolvedRelations solved = solve(relations, [](int joint) { return joint > 0; });
  ASSERT_EQ(solved.followers.size(), 1U);
  EXPECT_EQ(solved.followers.at(1).relation, 0U);
  ASSERT_EQ(solved.unsolved.size(), 3U);
  EXPECT_EQ(solved.unsolved[0].relation, 1U);
  EXPECT_FALSE(solved.unsolved[0].is_redundant);
  EXPECT_EQ(solved.unsolved[1].relation, 2U);
  EXPECT_TRUE(solved.unsolved[1].is_redundant);
  EXPECT_TRUE(solved.unsolved[2].is_redundant);
}

// The leading joints get random positions, the followers the positions of their sums; all relations must hold.
TEST(LinearRelations, SumsOfFollowersImplyTheRelations) {
  constexpr int kJoints = 6;
  constexpr double kRounding = 1e-10;  // of a few sums of small fractions
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> factor(-3, 3), count(1, kJoints);
  std::uniform_real_distribution<double> position(-1.0, 1.0);
  for (int run = 0; run < 300; ++run) {
    std::vector<LinearRelation> relations;
    for (int r = count(random); r > 0; --r) {
      std::vector<int> factors(kJoints);
      for (int& f : factors) f = factor(random);
      relations.push_back(relation(factors));
    }
    const SolvedRelations solved = solve(relations, any_joint);
    EXPECT_EQ(solved.followers.size() + solved.unsolved.size(), relations.size());
    for (const auto& unsolved : solved.unsolved) EXPECT_TRUE(unsolved.is_redundant);
    std::vector<double> positions(kJoints);
    for (double& q : positions) q = position(random);
    for (const auto& [joint, follower] : solved.followers) {
      positions[static_cast<std::size_t>(joint)] = 0.0;
      for (const auto& [other, share] : follower.sum) {
        EXPECT_FALSE(share.is_zero());
        EXPECT_TRUE(other == joint || !solved.followers.contains(other));
      }
    }
    std::vector<double> all = positions;
    for (const auto& [joint, follower] : solved.followers)
      all[static_cast<std::size_t>(joint)] = -value(follower.sum, positions);
    for (const LinearRelation& original : relations) EXPECT_NEAR(value(original, all), 0.0, kRounding);
  }
}

}  // namespace
}  // namespace robcogen::import::from_urdf::linear_relations_test
