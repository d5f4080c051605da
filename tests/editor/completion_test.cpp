// Completion by context; the vocabulary is compared with the guide's grammars.
#include <set>

#include "client.h"
#include "patterns.h"
#include "run_tool.h"
#include "server/vocabulary.h"

namespace robcogen::test::completion_test {
namespace {

using Labels = std::vector<std::string>;

// The labels offered at the mark `|` in the text.
Labels completed(const std::string& uri, std::string text) {
  const std::size_t mark = text.find('|');
  text.erase(mark, 1);
  Client client;
  client.open("file:///arm.kindsl", R"(Robot Arm {
    RobotBase base { children { upper via shoulder } }
    link upper { id = 1 children {} frames { tip { translation = (size[1.0], 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) } } }
    r_joint shoulder { ref_frame { translation = (0.0, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) } }
})");
  client.open(uri, text);
  const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(mark), '\n');
  const std::size_t begin = mark == 0 ? std::string::npos : text.rfind('\n', mark - 1);
  const Json items = client.ask_about(
      "textDocument/completion", uri,
      {{"position", {{"line", line}, {"character", mark - (begin == std::string::npos ? 0 : begin + 1)}}}});
  Labels labels;
  for (const Json& item : items) labels.push_back(item.at("label"));
  return labels;
}

Labels in_robot(const std::string& text) {
  return completed("file:///robot.kindsl", text);
}
Labels in_list(const std::string& text) {
  return completed("file:///arm.dtdsl", text);
}

bool has(const Labels& labels, const std::string& label) {
  return std::count(labels.begin(), labels.end(), label) == 1;
}

const std::string kLinks = "link a { id = 1 children {} } link b { id = 2 children {} } r_joint j { } r_joint k { }";

TEST(Completion, OfRobots) {
  EXPECT_EQ(in_robot("|"), (Labels{"Robot", "Part", "import"}));
  EXPECT_TRUE(has(in_robot("Robot R { li| }"), "link"));
  EXPECT_TRUE(has(in_robot("Robot R { RobotBase b { children {} } \n| }"), "r_joint"));
  EXPECT_EQ(in_robot("Robot R { link a { | } }"), (Labels{"id", "inertia_params", "children", "frames"}));
  EXPECT_TRUE(has(in_robot("Robot R { link a { inertia_params { ma| } } }"), "mass"));
  EXPECT_EQ(in_robot("Robot R { r_joint a { ref_frame { | } } }"), (Labels{"translation", "rotation"}));
  EXPECT_EQ(in_robot("Robot R { r_joint a { limits { | } } }"), (Labels{"position", "velocity", "effort"}));
  EXPECT_TRUE(has(in_robot("Robot R { c_joint a { | } }"), "slide"));
  EXPECT_FALSE(has(in_robot("Robot R { r_joint a { | } }"), "slide"));
  EXPECT_EQ(in_robot("Robot R { link | }"), Labels{}) << "a new name";
  EXPECT_EQ(in_robot("Robot R { // li|\n }"), Labels{});
}

TEST(Completion, OfNamesInRobots) {
  EXPECT_EQ(in_robot("Robot R { RobotBase base { children { | } } " + kLinks + " }"), (Labels{"a", "b"}));
  EXPECT_EQ(in_robot("Robot R { RobotBase base { children { a via j | } } " + kLinks + " }"), (Labels{"b", "a"}))
      << "those without a parent first";
  EXPECT_EQ(in_robot("Robot R { RobotBase base { children { a via | } } " + kLinks + " }"), (Labels{"j", "k"}));
  EXPECT_EQ(in_robot("Robot R { RobotBase base { children { a | } } " + kLinks + " }"), (Labels{"via", "at"}));
  EXPECT_EQ(in_robot("Part Leg { root | " + kLinks + " }"), (Labels{"a", "b"}));
  EXPECT_TRUE(
      has(in_robot("Part Leg { root a via j " + kLinks + " } Robot R { RobotBase base { children { | } } }"), "Leg"));
  EXPECT_EQ(
      in_robot(
          "Part Leg { root a via j " + kLinks +
          " } Robot R { RobotBase base { children { Leg left() mirrored y same sense { | } } } }"),
      (Labels{"j", "k"}));
  EXPECT_EQ(in_robot("Robot R { " + kLinks + " r_joint l { rotor { carrier = | } } }"), (Labels{"a", "b"}));
  EXPECT_EQ(in_robot("Robot R { link a { inertia_params { ref_frame = | } frames { tip {} } } }"), Labels{"tip"});
  EXPECT_TRUE(has(in_robot("Robot R { " + kLinks + " couplings { | } }"), "j"));
  EXPECT_TRUE(has(in_robot("Robot R { " + kLinks + " tendons { t { length = | } } }"), "j"));
  EXPECT_EQ(
      in_robot("Robot R { " + kLinks + " tendons { t { | } } }"), (Labels{"length", "stiffness", "damping", "rest"}));
  const Labels values = in_robot("Robot R { link a { inertia_params { mass = size[1.0] CoM = (0.0, |");
  EXPECT_TRUE(has(values, "size") && has(values, "PI") && has(values, "sin"));
  EXPECT_FALSE(has(values, "mass"));
}

TEST(Completion, OfLists) {
  EXPECT_TRUE(has(in_list("Robot Arm |"), "Frames"));
  EXPECT_EQ(in_list("Robot Arm Frames { | }"), (Labels{"for", "fr_base", "fr_upper", "fr_shoulder", "tip"}));
  EXPECT_EQ(in_list("Robot Arm Frames { tip, | }"), (Labels{"for", "fr_base", "fr_upper", "fr_shoulder"}));
  const Labels pair = in_list("Robot Arm Frames { tip } Transforms { base = | }");
  EXPECT_EQ(pair, (Labels{"tip", "fr_base", "fr_upper", "fr_shoulder"})) << "those of the list first";
  EXPECT_TRUE(has(in_list("Robot Arm Frames { tip } Transforms { | }"), "target"));
  EXPECT_TRUE(has(in_list("Robot Arm Contacts { | }"), "surface"));
  const std::string functions =
      "Robot Arm Frames { fr_base, tip } Jacobians { base = fr_base, target = tip } Functions { ";
  EXPECT_EQ(in_list(functions + "| }"), Labels()) << "a name of the user's";
  const Labels parts = in_list(functions + "terms = bias_forces + | }");
  EXPECT_TRUE(has(parts, "passive_forces") && has(parts, "jacobians.fr_base_J_tip"));
  EXPECT_FALSE(has(parts, "terms"));
  const Labels jacobians = in_list(functions + "terms = bias_forces + jacobians.| }");
  EXPECT_TRUE(has(jacobians, "fr_base_J_tip") && has(jacobians, "spatial.fr_base_J_tip"));
  EXPECT_FALSE(has(jacobians, "passive_forces"));
  EXPECT_EQ(in_list(functions + "terms = jacobians.fr| }"), jacobians) << "the client filters";
  EXPECT_EQ(in_list(functions + "terms = jacobians.spatial.| }"), Labels{"fr_base_J_tip"});
}

TEST(Completion, OfMotionsAndTransforms) {
  const Labels steps = completed("file:///m.motdsl", "Model M\nConvention = local\na -> b : trx(1.0) | ");
  EXPECT_TRUE(has(steps, "rotz"));
  EXPECT_TRUE(has(completed("file:///m.motdsl", "Model M\nConvention = | "), "fixed"));
  EXPECT_TRUE(has(completed("file:///m.motdsl", "Model M\nConvention = local\na -> b : trx(1.0)\nb -> | "), "a"));
  EXPECT_TRUE(has(completed("file:///m.motdsl", "Model M\nConvention = local\na -> b : trx(len) try(| "), "len"));
  EXPECT_TRUE(has(completed("file:///c.ctdsl", "Model M\nMovedFramePos = right\n{a}_X_{b} = Tx(1.0) | "), "Rz"));
  EXPECT_TRUE(has(completed("file:///c.ctdsl", "Model M\nMovedFramePos = right\n{a}_X_{b} = Tx(1.0)\n{| "), "b"));
}

// Completion offers exactly the words of the guide's grammars.
TEST(Vocabulary, IsThatOfTheGrammars) {
  const std::string guide = contents(std::filesystem::path(TEST_SOURCE_DIR) / "../../tool/language/README.md");
  const std::vector<std::pair<std::string, driver::Language>> grammars = {
      {"Document  ::=", driver::Language::robot},
      {"Desired  ::=", driver::Language::desired},
      {"Motions    ::=", driver::Language::motions},
      {"Transforms ::=", driver::Language::transforms}};
  for (const auto& [first, language] : grammars) {
    const std::size_t begin = guide.find(first);
    ASSERT_NE(begin, std::string::npos) << first;
    const std::string grammar = guide.substr(begin, guide.find("```", begin) - begin);
    std::set<std::string> expected, words;
    for (const Match& word : all_matches(grammar, R"re(['"]([A-Za-z_]+)['"])re")) expected.insert(word[1]);
    for (const std::string& word : server::keywords(language)) words.insert(word);
    for (const std::string& word : server::contextual_words(language)) words.insert(word);
    EXPECT_EQ(words, expected) << first;
  }
}

// The parser accepts every word that is offered in a block of a robot in that block.
TEST(Vocabulary, OfEachBlockIsKnownToTheParser) {
  const std::set<std::string> not_of_blocks = {"",         "Robot",  "Part",      "RobotBase", "link",
                                               "children", "frames", "couplings", "sense",     "at"};
  for (const server::BlockWords& block : server::block_words(driver::Language::robot)) {
    if (not_of_blocks.contains(std::string(block.block))) continue;
    for (const std::string_view word : block.words) {
      const std::string b(block.block), w(word), item = b + " { " + w + " ";
      std::string text;
      if (b.find("joint") != std::string::npos)
        text = b + " j { " + w;
      else if (b == "slide" || b == "turn")
        text = "c_joint j { " + item;
      else if (b == "turn_x" || b == "turn_z")
        text = "u_joint j { " + item;
      else if (b == "slide_x" || b == "slide_y")
        text = "planar_joint j { " + item;
      else if (b.starts_with("inertia_"))
        text = "link a { " + item;
      else
        text = "r_joint j { " + item;
      Client client;
      client.open("file:///r.kindsl", "Robot R { RobotBase b { children {} } " + text + " } } }");
      for (const Json& d : client.diagnostics["file:///r.kindsl"])
        EXPECT_EQ(d["message"].get<std::string>().find("found '" + w + "'"), std::string::npos) << text << d;
    }
  }
}

}  // namespace
}  // namespace robcogen::test::completion_test
