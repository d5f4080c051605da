// Drawings as text: well-formed, readable on white and on black, and correct.
#include "view/drawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>

#include "patterns.h"
#include "robots.h"
#include "symbolic/interpret.h"
#include "view/canvas.h"

namespace robcogen::test::drawing_test {
namespace {

std::string drawn(const std::string& name, bool with_pattern) {
  const driver::Model model = load_robot(name);
  const view::ViewedRobot robot = view::viewed(model, view::Purpose::drawing);
  const view::Pattern pattern = view::inertia_pattern(model);
  return view::draw(
      robot, view::posture(robot, some_positions(robot), declared_parameters(robot)),
      {.pattern = with_pattern ? &pattern : nullptr});
}

class Drawing : public testing::TestWithParam<std::string> {};

TEST_P(Drawing, IsWellFormedAndTheSameTwice) {
  const std::string text = drawn(GetParam(), true);
  EXPECT_EQ(text, drawn(GetParam(), true));
  std::vector<std::string> open;
  for (const Match& tag : all_matches(text, "<(/?)([a-z]+)([^<>]*?)(/?)>")) {
    if (tag[1] == "/") {
      ASSERT_FALSE(open.empty());
      EXPECT_EQ(open.back(), tag[2]);
      open.pop_back();
    } else if (tag[4] != "/") {
      open.push_back(tag[2]);
    }
  }
  EXPECT_TRUE(open.empty());
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), text.find("inf\""));
}

TEST_P(Drawing, StaysOnThePaper) {
  const std::string text = drawn(GetParam(), false);
  int count = 0;
  for (const Match& number : all_matches(text, " (?:[xc]?[xy][12]?)=\"(-?[0-9.]+)\"")) {
    EXPECT_GE(std::stod(number[1]), 0);
    EXPECT_LE(std::stod(number[1]), 720);
    ++count;
  }
  EXPECT_GT(count, 20);
}

// Every joint has a hub, every link with mass has a centre, and the whole robot has one.
TEST_P(Drawing, HasEveryJointAndMass) {
  const view::ViewedRobot robot = view::viewed(load_robot(GetParam()), view::Purpose::drawing);
  const std::string text = drawn(GetParam(), false);
  const auto hubs = all_matches(text, "<circle [^>]*class=\"(hub|sledge|ball)\"");
  EXPECT_EQ(hubs.size(), robot.library.tree.joints.size() - 2 * robot.library.tree.spherical_joints().size());
  EXPECT_EQ(all_matches(text, "class=\"ball\"").size(), robot.library.tree.spherical_joints().size());
  const view::Posture posture = view::posture(robot, some_positions(robot), declared_parameters(robot));
  const auto masses = std::count_if(posture.masses.begin(), posture.masses.end(), [](double m) { return m > 0; });
  EXPECT_EQ(all_matches(text, "<g transform").size(), static_cast<std::size_t>(masses + 1));
}

INSTANTIATE_TEST_SUITE_P(
    Of,
    Drawing,
    testing::Values("hyl", "hyl_parametric", "scara", "gripper", "ball_leg", "five_bar", "quadruped"),
    [](const auto& robot) { return robot.param; });

double luminance(int r, int g, int b) {
  const auto linear = [](int value) {
    const double c = value / 255.0;
    return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
}

// WCAG 2 requires a contrast of 3 for graphics.
TEST(DrawingColours, StandOutFromWhiteAndFromBlack) {
  constexpr double kContrast = 3;
  int count = 0;
  for (const Match& colour : all_matches(drawn("hyl", true), "#([0-9a-f]{2})([0-9a-f]{2})([0-9a-f]{2})")) {
    const auto part = [&](std::size_t k) { return std::stoi(colour[k], nullptr, 16); };
    const double own = luminance(part(1), part(2), part(3));
    EXPECT_GE(1.05 / (own + 0.05), 0.9 * kContrast) << colour[0];
    EXPECT_GE((own + 0.05) / 0.05, kContrast) << colour[0];
    ++count;
  }
  EXPECT_GT(count, 8);
}

// An element that is not drawn is zero in random positions; a drawn element is not.
TEST(InertiaPattern, IsThatOfTheMatrix) {
  for (const char* name : {"puma560", "scara", "quadruped", "tree5"}) {
    const driver::Model model = load_robot(name);
    const view::Pattern pattern = view::inertia_pattern(model);
    const auto functions = algorithm::functions(model.robot()->tree, model.robot()->desired, "joint_space_inertia");
    const symbolic::Program& program = functions.front().program;
    const std::size_t n = pattern.rows.size();
    ASSERT_EQ(pattern.names.size(), n);
    ASSERT_EQ(program.outputs.front().rows, static_cast<int>(n));
    std::vector<double> largest(n * n, 0);
    for (int state = 0; state < 3; ++state) {
      symbolic::Arrays<double> inputs;
      for (std::size_t k = 0; k < program.inputs.front().elements.size(); ++k)
        inputs[program.inputs.front().name].push_back(0.4 + 0.61 * static_cast<double>(k) + state);
      const auto results = symbolic::interpret<double>(program, inputs);
      for (std::size_t k = 0; k < n * n; ++k)
        largest[k] = std::max(largest[k], std::abs(results.at(program.outputs.front().name)[k]));
    }
    for (std::size_t r = 0; r < n; ++r)
      for (std::size_t c = 0; c < n; ++c) {
        EXPECT_EQ(pattern.rows[r][c], largest[r + c * n] > 1e-15) << name << " " << r << " " << c;
        EXPECT_EQ(pattern.rows[r][c], pattern.rows[c][r]);
      }
  }
}

TEST(DrawingLabels, HideNoOther) {
  view::Canvas canvas(0, 0);
  canvas.line({0, 0, 0}, {0, 1, 1}, "");
  for (int k = 0; k < 40; ++k) canvas.label({0, 0.5, 0.5 + 0.001 * k}, "a name of some length", "");
  const std::string text = canvas.elements(0, 0, 400);
  const auto labels = all_matches(text, "<text x=\"([0-9.]+)\" y=\"([0-9.]+)\" text-anchor=\"([a-z]+)\"");
  EXPECT_GE(labels.size(), 6U);
  EXPECT_LT(labels.size(), 40U);
  std::set<std::string> places;
  for (const Match& label : labels) EXPECT_TRUE(places.insert(label[0]).second);
}

// tool/view/README.md shows this drawing. If ROBCOGEN_UPDATE_DOCUMENTS is set in the environment, it is written again.
TEST(DrawingOfTheGuide, IsThatOfTheRobot) {
  const driver::Model model = load_robot("quadruped");
  const view::ViewedRobot robot = view::viewed(model, view::Purpose::drawing);
  const view::Pattern pattern = view::inertia_pattern(model);
  std::vector<double> q;
  for (int leg = 0; leg < 4; ++leg) q.insert(q.end(), {-0.1, leg < 2 ? 0.6 : -0.6, leg < 2 ? -1.2 : 1.2});
  const std::string text =
      view::draw(robot, view::posture(robot, q, {}), {.azimuth = -50, .elevation = 15, .pattern = &pattern});
  const std::filesystem::path file = std::filesystem::path(TEST_SOURCE_DIR) / "../../tool/view/quadruped.svg";
  if (std::getenv("ROBCOGEN_UPDATE_DOCUMENTS") != nullptr) std::ofstream(file, std::ios::binary) << text;
  std::ifstream stream(file, std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), text);
}

TEST(DrawingText, IsEscaped) {
  EXPECT_EQ(view::escaped("a<b>&\"c\n"), "a&lt;b&gt;&amp;&quot;c ");
}

}  // namespace
}  // namespace robcogen::test::drawing_test
