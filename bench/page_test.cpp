#include "page.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "comparison.h"
#include "markdown.h"

namespace robcogen::bench {
namespace {

// Tables have one decimal place.
constexpr double kDigits = 0.051;

Results leg() {
  Results r;
  r.robot = "Leg, left";
  r.joints = 2;
  r.functions = {{"inverse_dynamics", "inverse_dynamics", {20, 19, 22}, {}}};
  r.compared = {{"inverse_dynamics", "inverse_dynamics"}};
  r.peers = {"A", "B"};
  r.peer_times = {{"A", "inverse_dynamics", {40, 40, 40}}, {"B", "inverse_dynamics", {90, 90, 90}}};
  return r;
}

Results dog() {
  Results r = leg();
  r.robot = "Dog";
  r.joints = 12;
  r.floating_base = true;
  r.functions.push_back({"forward_dynamics", "forward_dynamics", {50, 50, 50}, {}});
  r.compared["forward_dynamics"] = "forward_dynamics";
  r.peer_times = {{"B", "forward_dynamics", {500, 500, 500}}};
  return r;
}

TEST(Page, ReadsWhatMarkdownWrites) {
  Results alone = leg();
  alone.robot = "Alone";
  alone.peer_times.clear();
  const std::vector<Results> robots = read_page("# Text\n\n" + markdown({leg(), alone, dog()}) + "\nMore | text.\n");
  ASSERT_EQ(robots.size(), 2);
  EXPECT_EQ(robots[0].robot, "Leg, left");
  EXPECT_EQ(robots[1].robot, "Dog");
  EXPECT_EQ(degrees_of_freedom(robots[0]), 2);
  EXPECT_EQ(degrees_of_freedom(robots[1]), 18);
  EXPECT_FALSE(robots[0].floating_base);
  EXPECT_TRUE(robots[1].floating_base);
  const std::vector<Comparison> of_leg = comparisons(robots[0]), of_dog = comparisons(robots[1]);
  ASSERT_EQ(of_leg.size(), 1);
  ASSERT_EQ(of_leg[0].peers.size(), 2);
  EXPECT_NEAR(of_leg[0].time.median, 20, kDigits);
  EXPECT_NEAR(of_leg[0].peers[0].ratio, 2, kDigits);
  EXPECT_NEAR(of_leg[0].peers[1].ratio, 4.5, kDigits);
  ASSERT_EQ(of_dog.size(), 2);
  EXPECT_TRUE(of_dog[0].peers.empty());
  EXPECT_EQ(of_dog[1].peers.at(0).peer, "B");
  EXPECT_NEAR(of_dog[1].peers[0].time.median, 500, 50 * kDigits);
}

TEST(Page, RefusesWhatItCannotRead) {
  const std::string head = "| robot, DoF | | ns | A |\n| --- | --- | --- | --- |\n";
  EXPECT_EQ(read_page(head + "| Leg, 2 | inverse dynamics | 20.0 | 2.0 |\n").size(), 1);
  for (const char* row :
       {"", "| Leg | inverse dynamics | 20.0 | 2.0 |\n", "| Leg, 2 | inverse dynamics | 20.0 |\n",
        "| Leg, 2 | cooking | 20.0 | 2.0 |\n", "| Leg, 2 | inverse dynamics | 20.0 ns | 2.0 |\n",
        "| Leg, 2 | inverse dynamics | - | 2.0 |\n", "| | inverse dynamics | 20.0 | 2.0 |\n"})
    EXPECT_THROW(read_page(head + row), std::runtime_error) << row;
}

TEST(Page, ReadsTheTableOfGenerators) {
  const std::string head = "| robot, DoF | inverse dynamics | inertia matrix |\n| --- | --- | --- |\n";
  const std::string page = "# Text\n\n" + head +
                           "| Leg, 2 | 13.0 (8.0; 2.6) | 10 (7; 2) |\n| Dog, 6 + 12 | 20 (2; 3) | 30 (4; 5) |\n"
                           "| geometric mean | 9.1; 4.7 | 8.9; 4.2 |\n";
  const std::vector<Results> robots = read_generators(page, {"A", "B"});
  ASSERT_EQ(robots.size(), 2);
  EXPECT_EQ(robots[1].robot, "Dog");
  EXPECT_TRUE(robots[1].floating_base);
  const std::vector<Comparison> of_leg = comparisons(robots[0]);
  ASSERT_EQ(of_leg.size(), 2);
  EXPECT_EQ(of_leg[0].time.median, 13);
  EXPECT_EQ(of_leg[0].peers.at(0).time.median, 104);
  EXPECT_EQ(of_leg[1].peers.at(1).ratio, 2);
  for (const char* row : {"", "| Leg, 2 | 13.0 (8.0) | 10 (7; 2) |\n", "| Leg | 13.0 (8.0; 2.6) | 10 (7; 2) |\n"})
    EXPECT_THROW(read_generators(head + row, {"A", "B"}), std::runtime_error) << row;
}

}  // namespace
}  // namespace robcogen::bench
