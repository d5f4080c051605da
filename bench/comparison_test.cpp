#include "comparison.h"

#include <gtest/gtest.h>

namespace robcogen::bench {
namespace {

Results leg() {
  Results r;
  r.robot = "Leg";
  r.joints = 2;
  r.functions = {
      {"joint_space_inertia", "joint_space_inertia", {10, 9, 12}, {}},
      {"inverse_dynamics", "inverse_dynamics", {20, 20, 20}, {}}};
  r.compared = {{"inertia_matrix", "joint_space_inertia"}, {"inverse_dynamics", "inverse_dynamics"}};
  r.peers = {"Late", "Early"};
  r.peer_times = {
      {"Early", "inverse_dynamics", {40, 38, 50}},
      {"Late", "inverse_dynamics", {200, 200, 200}},
      {"Early", "inertia_matrix", {80, 80, 80}}};
  return r;
}

Results dog() {
  Results r = leg();
  r.robot = "Dog";
  r.floating_base = true;
  r.peers = {"Early"};
  r.peer_times = {{"Early", "inverse_dynamics", {640, 640, 640}}};
  return r;
}

TEST(Comparison, RatiosOfMediansInTheOrderOfQuantitiesAndPeers) {
  const std::vector<Comparison> all = comparisons(leg());
  ASSERT_EQ(all.size(), 2);
  EXPECT_EQ(all[0].quantity, "inverse_dynamics");
  ASSERT_EQ(all[0].peers.size(), 2);
  EXPECT_EQ(all[0].peers[0].peer, "Late");
  EXPECT_DOUBLE_EQ(all[0].peers[0].ratio, 10);
  EXPECT_DOUBLE_EQ(all[0].peers[1].ratio, 2);
  EXPECT_EQ(all[1].function, "joint_space_inertia");
  ASSERT_EQ(all[1].peers.size(), 1);
  EXPECT_DOUBLE_EQ(all[1].peers[0].ratio, 8);
}

TEST(Comparison, AQuantityThatTheLibraryLacksIsLeftOut) {
  Results r = leg();
  r.functions.pop_back();
  ASSERT_EQ(comparisons(r).size(), 1);
  EXPECT_EQ(comparisons(r)[0].quantity, "inertia_matrix");
}

TEST(Comparison, GeometricMeansOverTheRobotsThatAPeerHas) {
  const std::vector<Mean> means = geometric_means({leg(), dog()});
  ASSERT_EQ(means.size(), 3);
  EXPECT_EQ(means[0].peer, "Late");
  EXPECT_DOUBLE_EQ(means[0].ratio, 10);
  EXPECT_EQ(means[0].robots, 1);
  EXPECT_EQ(means[1].peer, "Early");
  EXPECT_EQ(means[1].quantity, "inverse_dynamics");
  EXPECT_DOUBLE_EQ(means[1].ratio, 8);  // of 2 and 32
  EXPECT_EQ(means[1].robots, 2);
}

TEST(Comparison, APeerOfFewRobotsIsListedInItsPlace) {
  Results first = leg(), second = leg();
  first.peers = {"KDL", "DART"};
  second.peers = {"KDL", "KDL chain", "DART", "MuJoCo"};
  EXPECT_EQ(all_peers({first, second}), second.peers);
}

TEST(Comparison, ChartCountsTheFloatingBase) {
  const std::vector<ChartPanel> panels = chart_panels({leg(), dog()});
  ASSERT_EQ(panels.size(), 3);
  EXPECT_EQ(panels[0].title, "inverse dynamics");
  ASSERT_EQ(panels[0].series.size(), 3);
  const std::vector<ChartPoint>& ours = panels[0].series[0].points;
  ASSERT_EQ(ours.size(), 2);
  EXPECT_EQ(ours[1].degrees_of_freedom, 8);
  EXPECT_TRUE(ours[1].floating_base);
  EXPECT_EQ(panels[0].series[2].name, "Early");
  EXPECT_EQ(panels[0].series[2].points[1].nanoseconds, 640);
}

// The function that calls the kernel for the processor is small; the other copies are those of one unit.
TEST(KernelSizes, AreThoseOfTheKernelNotOfItsCaller) {
  const std::string listing =
      "0 10 t void robcogen_level::(anonymous namespace)::leg::kernel::core::f<double>(double const*)\n"
      "0 200 t void robcogen_level::(anonymous namespace)::leg::kernel::f<double>(double const*)\n"
      "0 6 W void leg::kernel::f<double>(double const*)\n"
      "0 1ff W void leg::kernel::avx2::f<double>(double const*)\n"
      "0 8 d leg::kernel::(anonymous namespace)::chosen::f<double>\n";
  EXPECT_EQ(kernel_sizes(listing), (std::map<std::string, long>{{"f", 0x200}}));
}

}  // namespace
}  // namespace robcogen::bench
