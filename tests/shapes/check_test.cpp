// Checks that end early, against distances of all pairs of spheres from kinematics that are written down in chain.h.
#include <gtest/gtest.h>
#include <shapes_test/spheres/collision_check.h>
#include <shapes_test/spheres/spheres.h>
#include <vamp/robots/spheres.hh>

#include <algorithm>
#include <cmath>
#include <limits>

#include "chain.h"

namespace robcogen::test::check_test {
namespace {

namespace compiled = ::shapes_test::spheres;
using Shapes = compiled::CollisionShapes;
using Lanes8 = robcogen::Lanes<float, 8>;
// The name Spheres is that of a member.
using Planned = ::vamp::robots::SpheresRobot;
using Block = ::vamp::FloatVector<8, 4>;
using Environment = ::vamp::collision::Environment<::vamp::FloatVector<8>>;

struct Sphere {
  std::size_t link;
  Point center;
  double radius;
};

// Those of spheres.urdf; the camera moves with l2.
const std::vector<Sphere> kSpheres = {{0, {0.5, 0, 0.2}, 0.2},    {0, {0.5, 0, 0.7}, 0.2},   {1, {0, 0, 0.1}, 0.1},
                                      {2, {0, 0.1, 0.2}, 0.1},    {2, {0.1, 0, 0.3}, 0.08},   {2, {0, -0.1, 0.4}, 0.12},
                                      {2, {0.25, 0, 0.25}, 0.05}, {2, {0.35, 0, 0.25}, 0.06}, {4, {0, 0, 0.1}, 0.125},
                                      {4, {0, 0, -0.3}, 0.1}};
const Sphere kObstacle = {0, {0.4, 0.5, 1.2}, 0.3};

// The least distance between spheres of links that no joint connects. (l4 is two joints from l2, and all others are
// farther apart, or neighbours.)
double self_distance(const Numbers& q) {
  double result = std::numeric_limits<double>::infinity();
  for (const Sphere& a : kSpheres)
    for (const Sphere& b : kSpheres)
      if (a.link + 1 < b.link)
        result = std::min(
            result, distance(in_base(a.link, q, a.center), in_base(b.link, q, b.center)) - a.radius - b.radius);
  return result;
}

double distance_to_obstacle(const Numbers& q) {
  double result = std::numeric_limits<double>::infinity();
  for (const Sphere& s : kSpheres)
    result = std::min(result, distance(in_base(s.link, q, s.center), kObstacle.center) - s.radius - kObstacle.radius);
  return result;
}

// Positions next to which single precision decides otherwise are left out.
std::vector<Numbers> clear_states(std::size_t count) {
  std::vector<Numbers> list;
  for (Numbers& q : states(count))
    if (std::abs(self_distance(q)) > 1e-5 && std::abs(distance_to_obstacle(q)) > 1e-5) list.push_back(std::move(q));
  return list;
}

template <class Scalar>
auto obstacle() {
  return [](const Scalar& x, const Scalar& y, const Scalar& z, double radius) {
    const Scalar a[] = {x, y, z},
                 b[] = {Scalar(kObstacle.center[0]), Scalar(kObstacle.center[1]), Scalar(kObstacle.center[2])};
    return robcogen::collision::nearer(a, b, radius + kObstacle.radius);
  };
}

compiled::JointState vector_of(const Numbers& q) {
  return compiled::JointState(q[0], q[1], q[2], q[3]);
}

TEST(CollisionCheck, FindsWhatTheDistancesOfAllPairsTell) {
  int in_self = 0, in_obstacle = 0, free = 0;
  const std::vector<Numbers> all = clear_states(3000);
  for (const Numbers& q : all) {
    const bool is_self = self_distance(q) < 0, is_any = is_self || distance_to_obstacle(q) < 0;
    ASSERT_EQ(compiled::self_collision(vector_of(q)), is_self);
    ASSERT_EQ(compiled::in_collision(vector_of(q), obstacle<double>()), is_any);
    in_self += is_self, in_obstacle += is_any && !is_self, free += !is_any;
  }
  EXPECT_GT(in_self, 100);
  EXPECT_GT(in_obstacle, 100);
  EXPECT_GT(free, 100);
}

TEST(CollisionCheck, TellsWhichLanesCollide) {
  const std::vector<Numbers> all = clear_states(3000);
  for (std::size_t first = 0; first + 8 <= all.size(); first += 8) {
    Lanes8 q[4];
    for (std::size_t k = 0; k < 4; ++k) {
      float row[8];
      for (std::size_t lane = 0; lane < 8; ++lane) row[lane] = static_cast<float>(all[first + lane][k]);
      q[k] = Lanes8::load(row);
    }
    unsigned expected = 0;
    for (std::size_t lane = 0; lane < 8; ++lane) {
      const Numbers& state = all[first + lane];
      expected |= unsigned{self_distance(state) < 0 || distance_to_obstacle(state) < 0} << lane;
    }
    ASSERT_EQ(robcogen::lanes_in_collision<Shapes>(q, obstacle<Lanes8>()), expected);
    ASSERT_EQ(robcogen::in_collision<Shapes>(q, obstacle<Lanes8>()), expected != 0);
  }
}

// The shapes of a link are looked at only where the sphere around it is near, and no link after a hit.
TEST(CollisionCheck, EndsEarly) {
  int calls = 0;
  const auto nothing = [&](double, double, double, double) { return ++calls, false; };
  EXPECT_FALSE(compiled::in_collision(compiled::JointState(0, 0, 0, 0), nothing));
  EXPECT_EQ(calls, 4);  // l4, l2, l1 and l0
  calls = 0;
  const auto everything = [&](double, double, double, double) { return ++calls, true; };
  EXPECT_TRUE(compiled::in_collision(compiled::JointState(0, 0, 0, 0), everything));
  EXPECT_EQ(calls, 2);  // l4, and its first sphere
}

TEST(CollisionCheck, AStateThatIsNotANumberIsNotFree) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(compiled::self_collision(compiled::JointState(none, 0, 0, 0)));
}

Block block_of(const std::vector<Numbers>& all, std::size_t first) {
  Block block;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t lane = 0; lane < 8; ++lane) block[k].data[0][lane] = static_cast<float>(all[first + lane][k]);
  return block;
}

TEST(Vamp, HasTheConstantsOfTheModel) {
  EXPECT_STREQ(Planned::name, "spheres");
  EXPECT_EQ(Planned::dimension, 4U);
  EXPECT_EQ(Planned::n_spheres, 10U);
  EXPECT_FLOAT_EQ(Planned::min_radius, 0.05F);
  EXPECT_FLOAT_EQ(Planned::max_radius, 0.2F);
  EXPECT_EQ(Planned::joint_names[3], "j3");
  EXPECT_STREQ(Planned::end_effector, "tool");
  EXPECT_FLOAT_EQ(Planned::space_measure(), 6 * 2 * 3.14159265F * 5 * 0.75F);
  Planned::Configuration q(std::array<float, 4>{0, 0.5F, 1, 0});
  Planned::scale_configuration(q);
  const std::array<float, 4> expected = {-3, 0, 3, -0.5F};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(q.data[0][k], expected[k], 1e-6F);
  Planned::descale_configuration(q);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(q.data[0][k], k == 1 ? 0.5F : k == 2 ? 1 : 0, 1e-6F);
}

TEST(Vamp, PlacesSpheresAndEndEffector) {
  const std::vector<Numbers> all = states(8);
  Planned::Spheres<8> spheres;
  Planned::sphere_fk<8>(block_of(all, 0), spheres);
  for (std::size_t lane = 0; lane < 8; ++lane) {
    const auto reference = compiled::collision_spheres(vector_of(all[lane]));
    // In any order: those near each other are neighbours.
    for (Eigen::Index column = 0; column < 10; ++column) {
      double nearest = 1;
      for (std::size_t s = 0; s < 10; ++s) {
        const Eigen::Vector4d found(
            spheres.x[s].data[0][lane], spheres.y[s].data[0][lane], spheres.z[s].data[0][lane],
            spheres.r[s].data[0][lane]);
        Eigen::Vector4d expected;
        expected << reference.centers.col(column), reference.radii(column);
        nearest = std::min(nearest, (found - expected).norm());
      }
      EXPECT_LT(nearest, 2e-6);
    }
    const Numbers& q = all[lane];
    const Eigen::Isometry3f X = Planned::eefk(
        {static_cast<float>(q[0]), static_cast<float>(q[1]), static_cast<float>(q[2]), static_cast<float>(q[3])});
    const Point tool = in_base(4, q, {0, 0, 0.25});
    for (Eigen::Index k = 0; k < 3; ++k) EXPECT_NEAR(X.translation()(k), tool[static_cast<std::size_t>(k)], 1e-6);
  }
}

TEST(Vamp, ABlockIsFreeIfAllItsConfigurationsAre) {
  const std::vector<Numbers> all = clear_states(4000);
  const Environment environment{
      {{::vamp::FloatVector<8>(static_cast<float>(kObstacle.center[0])),
        ::vamp::FloatVector<8>(static_cast<float>(kObstacle.center[1])),
        ::vamp::FloatVector<8>(static_cast<float>(kObstacle.center[2])),
        ::vamp::FloatVector<8>(static_cast<float>(kObstacle.radius))}},
      {}};
  int free = 0;
  for (std::size_t first = 0; first < all.size(); ++first) {
    const std::vector<Numbers> same(8, all[first]);
    const bool is_free = self_distance(all[first]) > 0 && distance_to_obstacle(all[first]) > 0;
    ASSERT_EQ(Planned::fkcc<8>(environment, block_of(same, 0)), is_free);
    const Planned::Debug hits = Planned::fkcc_debug<8>(environment, block_of(same, 0));
    bool touches = !hits.second.empty();
    for (const auto& names : hits.first) touches = touches || !names.empty();
    ASSERT_EQ(touches, !is_free);
    free += is_free;
  }
  EXPECT_GT(free, 100);
}

}  // namespace
}  // namespace robcogen::test::check_test
