// Formatting, semantic tokens, inlay hints, and response times.
#include <chrono>
#include <set>

#include "client.h"
#include "run_tool.h"

namespace robcogen::test::text_test {
namespace {

namespace fs = std::filesystem;

// Compares formatting with `robcogen print`.
TEST(Formatting, IsTheCanonicalPrint) {
  int count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(ROBCOGEN_ROBOTS_DIR)) {
    const std::string suffix = entry.path().extension().string();
    if (suffix != ".kindsl" && suffix != ".dtdsl" && suffix != ".motdsl" && suffix != ".ctdsl") continue;
    const std::string uri = file_uri(entry.path()), text = contents(entry.path());
    Client client;
    client.open(uri, text);
    const Json edits =
        client.ask_about("textDocument/formatting", uri, {{"options", {{"tabSize", 4}, {"insertSpaces", true}}}});
    const std::string formatted = edited(text, edits);
    if (++count % 6 == 0) {
      EXPECT_EQ(formatted, run_tool("print " + quoted(entry.path())).output) << entry.path();
    }
    client.change(uri, formatted);
    EXPECT_EQ(client.ask_about("textDocument/formatting", uri), Json::array()) << "once is enough: " << entry.path();
    for (std::size_t at = 0; (at = text.find("//", at)) != std::string::npos; ++at) {
      const std::string comment = text.substr(at, text.find_first_of("\r\n", at) - at);
      if (at > 0 && text[at - 1] == ':') continue;
      EXPECT_NE(formatted.find(comment.substr(0, comment.find_last_not_of(' ') + 1)), std::string::npos) << comment;
    }
  }
  EXPECT_GT(count, 20);
}

TEST(Formatting, LeavesABrokenDocumentAlone) {
  Client client;
  client.open("file:///a.kindsl", "Robot R { link a { ");
  EXPECT_TRUE(client.ask_about("textDocument/formatting", "file:///a.kindsl").is_null());
  client.open("file:///a.dtdsl", "Robot   R\r\nFrames { a }\r\nTransforms { a -> a }\r\n");
  const Json edits = client.ask_about("textDocument/formatting", "file:///a.dtdsl");
  ASSERT_EQ(edits.size(), 1U);
  const std::string text = edits[0].at("newText");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), std::count(text.begin(), text.end(), '\r'));
}

// Returns the words of the document, each with its token type.
std::vector<std::pair<std::string, std::string>> tokens_of(Client& client, const std::string& uri) {
  const Json types = client.capabilities.at("semanticTokensProvider").at("legend").at("tokenTypes");
  const Json data = client.ask_about("textDocument/semanticTokens/full", uri).at("data");
  std::vector<std::string> lines;
  std::istringstream text(client.texts.at(uri));
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  std::vector<std::pair<std::string, std::string>> result;
  std::size_t line = 0, character = 0;
  for (std::size_t i = 0; i < data.size(); i += 5) {
    const auto number = [&](std::size_t k) { return data[i + k].get<std::size_t>(); };
    line += number(0);
    character = number(0) == 0 ? character + number(1) : number(1);
    result.emplace_back(lines.at(line).substr(character, number(2)), types.at(number(3)));
  }
  return result;
}

TEST(SemanticTokens, SayWhatWordsAre) {
  Client client;
  const std::string uri = "file:///r.kindsl";
  client.open(
      uri,
      "// a\nRobot R { RobotBase base { children { rod via pin } }\n/* b\nc */ link rod { id = 1 children {} }\n"
      "r_joint pin { ref_frame { translation = (len, 0.5 PI, sin(0.1))  rotation = (0.0, 0.0, 0.0) } damping = 1 } }");
  using Tokens = std::vector<std::pair<std::string, std::string>>;
  const Tokens expected = {{"// a", "comment"},      {"Robot", "keyword"},       {"R", "type"},
                           {"RobotBase", "keyword"}, {"base", "class"},          {"children", "keyword"},
                           {"rod", "class"},         {"via", "keyword"},         {"pin", "method"},
                           {"/* b", "comment"},      {"c */", "comment"},        {"link", "keyword"},
                           {"rod", "class"},         {"id", "keyword"},          {"1", "number"},
                           {"children", "keyword"},  {"r_joint", "keyword"},     {"pin", "method"},
                           {"ref_frame", "keyword"}, {"translation", "keyword"}, {"len", "parameter"},
                           {"0.5", "number"},        {"PI", "number"},           {"sin", "function"},
                           {"0.1", "number"},        {"rotation", "keyword"},    {"0.0", "number"},
                           {"0.0", "number"},        {"0.0", "number"},          {"damping", "keyword"},
                           {"1", "number"}};
  EXPECT_EQ(tokens_of(client, uri), expected);
}

TEST(SemanticTokens, OfNamesThroughInstancesArePieces) {
  Client client;
  client.open(
      "file:///a.kindsl",
      "Part Leg { root hip via HAA link hip { children {} } r_joint HAA { ref_frame { translation = (0.0, 0.0, 0.0) "
      "rotation = (0.0, 0.0, 0.0) } } }\nRobot R { RobotBase b { children { Leg left() } } }");
  client.open("file:///a.dtdsl", "Robot R\nFrames { fr_left_hip }\nTransforms {}\n");
  const auto tokens = tokens_of(client, "file:///a.dtdsl");
  ASSERT_GE(tokens.size(), 5U);
  EXPECT_EQ(tokens[3], (std::pair<std::string, std::string>("left", "namespace")));
  EXPECT_EQ(tokens[4], (std::pair<std::string, std::string>("hip", "class")));
}

TEST(InlayHints, AreDegreesAndCarriedMasses) {
  Client client;
  const std::string uri = file_uri(robot("hyl"));
  client.open(uri, contents(robot("hyl")));
  const Json whole = {{"start", {{"line", 0}, {"character", 0}}}, {"end", {{"line", 100000}, {"character", 0}}}};
  const Json hints = client.ask_about("textDocument/inlayHint", uri, {{"range", whole}});
  std::set<std::string> labels;
  for (const Json& hint : hints) labels.insert(hint.at("label"));
  // The slider carries 2.638 + 0.881 kg; the base carries 3.982 kg more.
  for (const char* label : {"carries 3.519 kg", "carries 7.501 kg", "carries 0.881 kg", "-90°", "90°"})
    EXPECT_TRUE(labels.contains(label)) << label << hints;
  const Json nothing = {{"start", {{"line", 0}, {"character", 0}}}, {"end", {{"line", 1}, {"character", 0}}}};
  EXPECT_EQ(client.ask_about("textDocument/inlayHint", uri, {{"range", nothing}}), Json::array());
}

// Returns 5,000 lines: a chain of links as people write them.
std::string long_robot() {
  std::string text = "Robot Long {\nRobotBase l0 { children { l1 via j1 } }\n";
  int i = 1;
  for (; std::count(text.begin(), text.end(), '\n') < 4980; ++i) {
    const std::string n = std::to_string(i), next = std::to_string(i + 1);
    text +=
        "link l" + n + " {\n    id = " + n +
        "\n    inertia_params {\n        mass = 1.0\n        CoM = (0.1, 0.0, 0.0)\n        Ix = 0.1\n        Iy = "
        "0.1\n        "
        "Iz = 0.1\n        Ixy = 0.0\n        Ixz = 0.0\n        Iyz = 0.0\n    }\n    children {\n        l" +
        next + " via j" + next + "\n    }\n}\nr_joint j" + n +
        " {\n    ref_frame {\n        translation = (0.1, 0.0, 0.0)\n        rotation = (0.0, PI/2.0, 0.0)\n    }\n}\n";
  }
  const std::string n = std::to_string(i);
  return text + "link l" + n + " { id = " + n + " children {} }\nr_joint j" + n +
         " { ref_frame { translation = (0.1, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) } }\n}\n";
}

// The test machine may be slow and the build may not be optimised, so the test checks only the order of magnitude and
// prints the times.
TEST(Answers, AreQuickOnFiveThousandLines) {
  Client client;
  const std::string uri = "file:///long.kindsl", text = long_robot();
  const auto timed = [](const std::string& what, const auto& action) {
    const auto begin = std::chrono::steady_clock::now();
    action();
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    std::printf("%-36s %6.1f ms\n", what.c_str(), ms);
    EXPECT_LT(ms, 2000.0) << what;
  };
  timed("didOpen", [&] { client.open(uri, text); });
  timed("didChange", [&] { client.change(uri, text + "\n"); });
  for (const char* method :
       {"completion", "definition", "documentHighlight", "documentSymbol", "foldingRange", "formatting", "hover",
        "inlayHint", "prepareRename", "references", "rename", "semanticTokens/full", "codeAction"}) {
    timed(method, [&] {
      client.ask_at(
          std::string("textDocument/") + method, uri, "link l|100 ",
          {{"newName", "other"},
           {"range", {{"start", {{"line", 0}, {"character", 0}}}, {"end", {{"line", 100}, {"character", 0}}}}}});
      EXPECT_TRUE(client.error.is_null()) << client.error;
    });
  }
}

}  // namespace
}  // namespace robcogen::test::text_test
