// Editor features for the joints that close loops, and for couplings.
#include "client.h"

namespace robcogen::test::loops_test {
namespace {

const std::filesystem::path kRobots = ROBCOGEN_ROBOTS_DIR;

std::string text_of_hover(const Json& hover) {
  return hover.is_null() ? "" : hover.at("contents").at("value").get<std::string>();
}

std::vector<std::string> labels(const Json& items) {
  std::vector<std::string> result;
  for (const Json& item : items) result.push_back(item.at("label"));
  return result;
}

class Loops : public testing::Test {
 protected:
  Client client;
  const std::string uri = file_uri(kRobots / "five_bar" / "five_bar.kindsl");

  void SetUp() override { client.open(uri, contents(kRobots / "five_bar" / "five_bar.kindsl")); }
};

TEST_F(Loops, SayWhatTheyHold) {
  EXPECT_EQ(
      text_of_hover(client.ask_at("textDocument/hover", uri, "ti|p {")),
      "**loop** `tip`, hinge\n\n- frame `tool` of link `left_rod` and `right_end` of link `right_rod`\n"
      "- `LEFT_ELBOW` follows\n- `RIGHT_ELBOW` follows");
  std::string text = client.texts.at(uri);
  text.replace(text.find("type = hinge"), 12, "distance = 0.0 + 0.01");
  client.change(uri, text);
  EXPECT_EQ(
      text_of_hover(client.ask_at("textDocument/hover", uri, "ti|p {")).find("**loop** `tip`, distance 0.01 m"), 0U);
}

TEST_F(Loops, AreNamesOfTheDocument) {
  const Json place = client.ask_at("textDocument/definition", uri, "ti|p {");
  ASSERT_EQ(place.size(), 1U);
  EXPECT_EQ(place[0].at("range").at("start"), client.position(uri, "tip {"));
  const Json edits = client.ask_at("textDocument/rename", uri, "ti|p {", {{"newName", "meeting"}});
  EXPECT_EQ(edits.at("changes").at(uri).size(), 1U);
  const Json outline = client.ask_about("textDocument/documentSymbol", uri);
  const Json& last = outline.at(0).at("children").back();
  EXPECT_EQ(last.at("name"), "tip");
  EXPECT_EQ(last.at("detail"), "loop of tool and right_end");
}

TEST_F(Loops, AreCompleted) {
  const std::string whole = client.texts.at(uri);
  const std::size_t at = whole.find("tool ~ right_end");
  for (const char* written : {"", "tool ~ "}) {
    client.change(uri, whole.substr(0, at) + written + "\n" + whole.substr(whole.find(" type = hinge")));
    const Json items =
        client.ask_at("textDocument/completion", uri, std::string("frames = ") + written + "|\n type = hinge");
    const std::vector<std::string> found = labels(items);
    EXPECT_NE(std::find(found.begin(), found.end(), "tool"), found.end()) << items;
    EXPECT_NE(std::find(found.begin(), found.end(), "right_end"), found.end()) << items;
    for (const char* other : {"hinge", "PI", "sin", "LEFT"})
      EXPECT_EQ(std::find(found.begin(), found.end(), other), found.end()) << other;
  }
}

// `rad/m` is a unit, not a parameter.
TEST(Couplings, HaveUnits) {
  Client client;
  const std::string uri = file_uri(kRobots / "gripper" / "gripper.kindsl");
  client.open(uri, contents(kRobots / "gripper" / "gripper.kindsl"));
  EXPECT_TRUE(client.ask_at("textDocument/hover", uri, "80.0 ra|d/m").is_null());
  EXPECT_EQ(client.ask_at("textDocument/definition", uri, "80.0 rad/|m"), Json::array());
  const std::vector<std::string> found = labels(client.ask_at("textDocument/completion", uri, "RIGHT = 1.0 * |LEFT"));
  EXPECT_NE(std::find(found.begin(), found.end(), "LEFT"), found.end());
  for (const char* unit : {"rad", "m"}) EXPECT_EQ(std::find(found.begin(), found.end(), unit), found.end()) << unit;
}

}  // namespace
}  // namespace robcogen::test::loops_test
