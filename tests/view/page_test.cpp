// Pages as text.
#include "view/page.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "patterns.h"
#include "robots.h"
#include "view/page_files.h"

namespace robcogen::test::page_test {
namespace {

using Json = nlohmann::json;

struct Page {
  std::string text;
  Json data;
};

Page page_of(const driver::Model& model, const Diagnostics& diagnostics = {}) {
  const view::ViewedRobot robot = view::viewed(model, view::Purpose::page);
  Page page;
  page.text = view::page(model, robot, diagnostics, {some_positions(robot), declared_parameters(robot)});
  const std::string begin = "<script type=\"application/json\" id=\"data\">";
  const std::size_t at = page.text.find(begin) + begin.size();
  page.data = Json::parse(page.text.substr(at, page.text.find("</script>", at) - at));
  return page;
}

TEST(Page, LoadsNothing) {
  const std::string text = page_of(load_robot("hyl")).text;
  for (const char* way : {"src=", "href=", "http:", "https:", "@import", "url(", "fetch(", "import("})
    EXPECT_EQ(text.find(way), std::string::npos) << way;
  EXPECT_EQ(text.find("{{"), std::string::npos);
  EXPECT_EQ(text, page_of(load_robot("hyl")).text);
}

TEST(Page, HasTheFilesOfItsFolder) {
  for (const char* name : {"page.html", "page.css", "main.js", "picture.js"}) {
    EXPECT_GT(view::page_file(name).size(), 500U) << name;
    EXPECT_EQ(view::page_file(name).back(), '\n');
  }
  EXPECT_TRUE(view::page_file("other").empty());
}

// A name neither ends a script of the page nor becomes an element.
TEST(Page, KeepsNamesAsTheyAre) {
  driver::Model model = load_robot("hyl");
  auto& tree = std::get<driver::Robot>(model.content).tree;
  const std::string name = "</script><!--<b>\"'&";
  tree.name = name;
  tree.links[1].name = name;
  const Page page = page_of(model);
  EXPECT_EQ(all_matches(page.text, "</script>").size(), 2U);
  EXPECT_EQ(page.text.find("<!--"), std::string::npos);
  EXPECT_NE(page.text.find("<title>&lt;/script&gt;&lt;!--&lt;b&gt;&quot;'&amp;</title>"), std::string::npos);
}

TEST(Page, HasEveryFrame) {
  const driver::Model model = load_robot("gripper");
  const Json data = page_of(model).data;
  const auto frames = model.robot()->tree.frames();
  ASSERT_EQ(data["frames"].size(), frames.size());
  for (std::size_t f = 0; f < frames.size(); ++f) EXPECT_EQ(data["frames"][f]["name"], frames[f].name);
}

// A warning is shown at the link or joint that it names, otherwise at the element of its place in the document.
TEST(Page, ShowsWarningsAtTheirLinks) {
  const driver::Model model = load_robot("hyl");
  const model::KinematicTree& tree = model.robot()->tree;
  Diagnostics diagnostics;
  diagnostics.warning("a", {}, "mass of link 'lowerleg' is odd").hint = "weigh it";
  diagnostics.warning("b", {}, "joint 'HFE' is odd");
  diagnostics.warning("c", tree.links[1].place, "something is odd");
  diagnostics.warning("d", {}, "all is odd");
  diagnostics.note("e", {}, "nothing is odd");
  const Json warnings = page_of(model, diagnostics).data["warnings"];
  ASSERT_EQ(warnings.size(), 4U);
  EXPECT_EQ(warnings[0]["link"], *tree.find_link("lowerleg"));
  EXPECT_EQ(warnings[0]["hint"], "weigh it");
  EXPECT_EQ(warnings[1]["link"], tree.joints[static_cast<std::size_t>(*tree.find_joint("HFE"))].child);
  EXPECT_EQ(warnings[2]["link"], 1);
  EXPECT_TRUE(whole_match(warnings[2]["where"].get<std::string>(), "hyl.kindsl:\\d+:\\d+"));
  EXPECT_EQ(warnings[3]["link"], -1);
}

// Robots without masses or without joints can be drawn, too.
TEST(Page, OfARobotWithoutDynamics) {
  driver::Model model = load_robot("hyl");
  auto& tree = std::get<driver::Robot>(model.content).tree;
  for (model::Link& link : tree.links) link.inertia.reset();
  const Page page = page_of(model);
  EXPECT_EQ(page.text.find("export "), std::string::npos);
  EXPECT_EQ(page.text.find("function forward_dynamics("), std::string::npos);
  EXPECT_NE(page.text.find("function frame_poses("), std::string::npos);
}

}  // namespace
}  // namespace robcogen::test::page_test
