// Functions of collision shapes as compiled C++: plain, in single precision, and over many states.
#include <gtest/gtest.h>
#include <shapes_test/chain/batch.h>
#include <shapes_test/chain/chain.h>

#include <algorithm>

#include "chain.h"

namespace robcogen::test::compiled_test {
namespace {

namespace compiled = ::shapes_test::chain;
using robcogen::batch::by_element;

// A brute-force minimum is not exact; axes that are nearly parallel may count as too far apart.
constexpr double kBruteForce = 1e-6;
// Of distances of metres in single precision, whose rounding errors an ill-conditioned pair of axes magnifies.
constexpr float kSingle = 2e-4F;

template <class JointState>
JointState vector_of(const Numbers& q) {
  JointState result;
  for (std::size_t k = 0; k < q.size(); ++k)
    result(static_cast<Eigen::Index>(k)) = static_cast<typename JointState::Scalar>(q[k]);
  return result;
}

TEST(CompiledCollision, ShapesAreWhereTheirLinksAre) {
  EXPECT_STREQ(compiled::collision_spheres_columns[1], "l4");
  EXPECT_STREQ(compiled::collision_capsules_columns[2], "l3");
  for (const Numbers& q : states(5)) {
    const auto spheres = compiled::collision_spheres(vector_of<compiled::JointState>(q));
    const auto capsules = compiled::collision_capsules(vector_of<compiled::JointState>(q));
    for (Eigen::Index k = 0; k < 3; ++k) {
      const auto row = static_cast<std::size_t>(k);
      EXPECT_NEAR(spheres.centers(k, 0), end_in_base(1, 0, q)[row], 1e-14);
      EXPECT_NEAR(spheres.centers(k, 1), end_in_base(4, 0, q)[row], 1e-14);
      const std::size_t links[] = {0, 2, 3};
      for (Eigen::Index c = 0; c < 3; ++c) {
        EXPECT_NEAR(capsules.ends(k, c), end_in_base(links[c], 0, q)[row], 1e-14);
        EXPECT_NEAR(capsules.ends(3 + k, c), end_in_base(links[c], 1, q)[row], 1e-14);
      }
    }
    EXPECT_EQ(spheres.radii, Eigen::Vector2d(0.05, 0.125));
    EXPECT_EQ(capsules.radii, Eigen::Vector3d(0.1, 0.07, 0.08));
  }
}

TEST(CompiledCollision, DistanceIsThatOfTheNearestPair) {
  for (const Numbers& q : states(40)) {
    const double expected = least_distance(q);
    EXPECT_NEAR(compiled::self_distance(vector_of<compiled::JointState>(q)), expected, kBruteForce);
    EXPECT_NEAR(compiled::f32::self_distance(vector_of<compiled::f32::JointState>(q)), expected, kSingle);
  }
}

TEST(CompiledCollision, ManyStatesAreThoseOfSingleCalls) {
  const std::vector<Numbers> all = states(21);
  const auto n = static_cast<std::ptrdiff_t>(all.size());
  std::vector<double> q(4 * all.size()), distance(all.size()), found(all.size()), gradient(4 * all.size());
  std::vector<float> q_single(q.size()), found_single(all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) q[k * all.size() + i] = all[i][k];
  std::copy(q.begin(), q.end(), q_single.begin());
  compiled::batch::self_distance(n, by_element(q.data(), n), by_element(found.data(), n));
  compiled::f32::batch::self_distance(n, by_element(q_single.data(), n), by_element(found_single.data(), n));
  compiled::batch::self_distance_d_q(
      n, by_element(q.data(), n), by_element(distance.data(), n), by_element(gradient.data(), n));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto one = compiled::self_distance_d_q(vector_of<compiled::JointState>(all[i]));
    EXPECT_NEAR(found[i], compiled::self_distance(vector_of<compiled::JointState>(all[i])), 1e-12);
    EXPECT_NEAR(found_single[i], found[i], kSingle);
    EXPECT_NEAR(distance[i], found[i], 1e-12);
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(gradient[k * all.size() + i], one.d_q(0, static_cast<Eigen::Index>(k)), 1e-9);
  }
}

}  // namespace
}  // namespace robcogen::test::compiled_test
