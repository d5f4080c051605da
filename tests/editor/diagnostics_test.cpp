// The server reports the diagnostics of the command line, at the same places.
#include <set>

#include "client.h"
#include "goldens.h"
#include "patterns.h"

namespace robcogen::test::diagnostics_test {
namespace {

namespace fs = std::filesystem;

const fs::path kRooms = fs::path(TEST_SOURCE_DIR).parent_path();

// Documents whose messages on the command line are recorded, of these folders.
const std::vector<std::string> kRoomsOfMessages = {"language", "model", "parts", "import"};

// False for documents that need a command-line option, and for files that the command line refuses before parsing.
bool is_compared(const GoldenDocument& document) {
  const std::string options =
      "-snap|-free-mimic|-floating-base|-allow-implausible|-checked|not-original|nul\\b|utf-16|-binary|garbage|"
      "other-format|-mjcf|-urdf|unreadable-import";
  return !first_match(document.file.stem().string(), options);
}

// Returns the document without a leading byte order mark, which editors omit.
std::string text_for_editor(const fs::path& file) {
  std::string text = contents(file);
  return text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text;
}

// A message of the command line: its head, and the number of underlined characters.
struct Message {
  std::string file, severity, code, text;
  std::size_t line = 0, column = 0, width = 0;
};

std::vector<Message> messages_in(const std::string& rendered) {
  std::vector<Message> result;
  const std::string head = R"(^(?:[^\n:]*/)?([^\n:/]+):(\d+):(\d+): (error|warning): (.*) \[([a-z0-9-]+)\]$)";
  std::istringstream lines(rendered);
  for (std::string line; std::getline(lines, line);) {
    if (const std::optional<Match> found = whole_match(line, head)) {
      const Match& m = *found;
      result.push_back({m[1], m[4], m[6], m[5], std::stoul(m[2]), std::stoul(m[3]), 0});
    } else if (!result.empty() && result.back().width == 0) {
      const std::size_t caret = line.find_first_not_of(" \t");
      if (caret != std::string::npos && line[caret] == '^') result.back().width = line.size() - caret;
    }
  }
  return result;
}

// Counts the characters in a range of one line, given in byte positions.
std::size_t characters(const Client& client, const std::string& uri, const Json& range) {
  const auto begin = range["start"]["character"].get<std::size_t>(), end = range["end"]["character"].get<std::size_t>();
  const std::string text = client.texts.contains(uri) ? client.texts.at(uri) : contents(uri.substr(7));
  std::istringstream lines(text);
  std::string line;
  for (std::size_t i = 0; i <= range["start"]["line"]; ++i) std::getline(lines, line);
  const std::string marked = line.substr(begin, end - begin);
  return static_cast<std::size_t>(std::count_if(
      marked.begin(), marked.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

void expect_same_diagnostics(const GoldenDocument& document) {
  const fs::path& file = document.file;
  SCOPED_TRACE(file);
  Client client;
  client.open(file_uri(file), text_for_editor(file));
  fs::path list = file;
  if (list.replace_extension(".dtdsl") != file && fs::exists(list)) client.open(file_uri(list), contents(list));

  const std::vector<Message> expected = messages_in(document.messages);
  for (const Message& m : expected) {
    bool is_found = false;
    for (const auto& [uri, shown] : client.diagnostics) {
      if (fs::path(uri).filename() != m.file) continue;
      for (const Json& d : shown) {
        const Json &begin = d["range"]["start"], &end = d["range"]["end"];
        const bool is_same_place = begin["line"] == m.line - 1 && begin["character"] == m.column - 1;
        const bool is_same = d["code"] == m.code && d["message"].get<std::string>().starts_with(m.text) &&
                             d["severity"] == (m.severity == "error" ? 1 : 2);
        if (!is_same || !is_same_place) continue;
        is_found = true;
        EXPECT_EQ(end["line"], begin["line"]);
        const std::size_t width = characters(client, uri, d["range"]);
        // At the end of a line there is nothing to underline, and the command line shortens long lines.
        if (width != 0 && m.column < 100 && m.width < 60) {
          EXPECT_EQ(width, m.width) << d;
        }
      }
    }
    EXPECT_TRUE(is_found) << m.line << ":" << m.column << " " << m.code << " " << m.text << "\n"
                          << Json(client.diagnostics).dump(1);
  }
}

// There is one test for each folder, because starting a process for each of hundreds of files takes longer than the
// test itself.
class SameDiagnostics : public testing::TestWithParam<std::string> {};

TEST_P(SameDiagnostics, AsOnTheCommandLine) {
  int count = 0;
  const UnpackedGoldens goldens({GetParam()});
  for (const GoldenDocument& document : goldens.documents) {
    if (!is_compared(document)) continue;
    expect_same_diagnostics(document);
    ++count;
  }
  EXPECT_GT(count, 15);
}

INSTANTIATE_TEST_SUITE_P(
    Bad,
    SameDiagnostics,
    testing::ValuesIn(kRoomsOfMessages),
    [](const testing::TestParamInfo<std::string>& room) { return room.param; });

// Every code that these files expect was compared, and there are many of them.
TEST(Diagnostics, OfEveryCodeAreCompared) {
  std::set<std::string> all, compared;
  const UnpackedGoldens goldens(kRoomsOfMessages);
  for (const GoldenDocument& document : goldens.documents) {
    for (const Message& m : messages_in(document.messages)) {
      all.insert(m.code);
      if (is_compared(document)) compared.insert(m.code);
    }
  }
  EXPECT_GT(compared.size(), 100U);
  // The server reads no shapes.
  const std::set<std::string> not_of_files = {"geom-bits",   "not-original", "not-utf-8",      "other-format",
                                              "shape-size",  "unknown-body", "unread-geom",    "unread-mask",
                                              "unread-mesh", "unread-pair",  "unread-submesh", "unreadable-import"};
  for (const std::string& code : all)
    EXPECT_TRUE(not_of_files.contains(code) || compared.contains(code))
        << code << " is in no document that the server was given";
  for (const std::string& code : not_of_files) EXPECT_FALSE(compared.contains(code)) << code << " is compared now";
}

const std::string kRobot = R"(Robot Arm {
    RobotBase base { children { upper via shoulder } }
    link upper {
        id = 1
        inertia_params {
            mass = 1.0  CoM = (0.0, 0.0, 0.0)
            Ix = 0.1  Iy = 0.1  Iz = 0.1  Ixy = 0.0  Ixz = 0.0  Iyz = 0.0
        }
        children {}
        frames { tip { translation = (1.0, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) } }
    }
    r_joint shoulder { ref_frame { translation = (0.0, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) } }
}
)";

std::string replaced(std::string text, const std::string& a, const std::string& b) {
  for (std::size_t at = text.find(a); at != std::string::npos; at = text.find(a, at + b.size()))
    text.replace(at, a.size(), b);
  return text;
}

using Codes = std::vector<std::string>;

TEST(Diagnostics, OfAListFollowItsRobot) {
  const std::string robot = "file:///nowhere/arm.kindsl", list = "file:///nowhere/arm.dtdsl";
  Client client;
  client.open(list, "Robot Arm\nFrames { fr_base, tip }\nTransforms { base = fr_base, target = tip }\n");
  EXPECT_EQ(client.codes(list), Codes{"unchecked-list"});
  client.open(robot, kRobot);
  EXPECT_EQ(client.codes(list), Codes{});
  client.change(robot, replaced(kRobot, "tip", "tool"));
  EXPECT_EQ(client.codes(list), (Codes{"unknown-frame", "unknown-frame"}));
  client.change(robot, kRobot);
  EXPECT_EQ(client.codes(list), Codes{});
  client.close(robot);
  EXPECT_EQ(client.codes(list), Codes{"unchecked-list"});
}

TEST(Diagnostics, OfAListFollowTheRobotOfItsName) {
  Client client;
  client.open("file:///nowhere/some.dtdsl", "Robot Arm\nFrames { tipp }\nTransforms {}\n");
  client.open("file:///elsewhere/robot.kindsl", kRobot);
  const Json& d = client.diagnostics.at("file:///nowhere/some.dtdsl");
  ASSERT_EQ(d.size(), 1U) << d;
  EXPECT_EQ(d[0].at("code"), "unknown-frame");
}

// The robots of a folder are found by name; the example is the folder robots/.
TEST(Diagnostics, OfAListFollowTheRobotInTheWorkspace) {
  Client client(kRooms.parent_path() / "robots");
  client.open("file:///nowhere/some.dtdsl", "Robot Wrist\nFrames { fr_nothing }\nTransforms {}\n");
  EXPECT_EQ(client.codes("file:///nowhere/some.dtdsl"), Codes{"unknown-frame"});
  // Two examples have this name, so the list is not checked until one of them is open.
  client.open("file:///nowhere/other.dtdsl", "Robot HyL\nFrames { fr_nothing }\nTransforms {}\n");
  EXPECT_EQ(client.codes("file:///nowhere/other.dtdsl"), Codes{"unchecked-list"});
  const fs::path hyl = kRooms.parent_path() / "robots/hyl/hyl.kindsl";
  client.open(file_uri(hyl), contents(hyl));
  EXPECT_EQ(client.codes("file:///nowhere/other.dtdsl"), Codes{"unknown-frame"});
}

TEST(Diagnostics, OfAnImportedDocumentThatIsOpenAreThoseOfItsText) {
  const std::string part = "file:///nowhere/leg.kindsl", robot = "file:///nowhere/biped.kindsl";
  const std::string leg = R"(Part Leg {
    root hip via HAA
    link hip { children {} }
    r_joint HAA { ref_frame { translation = (0.0, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) } }
}
)";
  Client client;
  client.open(robot, "import \"leg.kindsl\"\nRobot Biped { RobotBase trunk { children { Leg left() } } }\n");
  EXPECT_EQ(client.codes(robot), Codes{"unknown-file"});
  client.open(part, leg);
  for (const std::string& code : client.codes(robot)) EXPECT_NE(code, "unknown-file");
  client.change(part, replaced(leg, "root hip", "root hop"));
  EXPECT_EQ(client.codes(part), Codes{"unknown-root"}) << "once, though both documents yield it";
}

TEST(Diagnostics, AreRemovedWhenTheDocumentIsClosed) {
  const std::string robot = "file:///nowhere/arm.kindsl";
  Client client;
  client.open(robot, "Robot");
  EXPECT_EQ(client.codes(robot).size(), 1U);
  client.close(robot);
  EXPECT_EQ(client.codes(robot), Codes{});
}

TEST(Diagnostics, OfWhatIsNoTextAndOfOtherLanguages) {
  Client client;
  client.open("file:///a.kindsl", std::string("Rob\0t", 5));
  EXPECT_EQ(client.codes("file:///a.kindsl"), Codes{"not-text"});
  client.open("file:///a.cpp", "int main() {}", "cpp");
  EXPECT_FALSE(client.diagnostics.contains("file:///a.cpp"));
  client.open("untitled:1", "Robot", "kindsl");
  EXPECT_EQ(client.codes("untitled:1").size(), 1U);
}

TEST(Diagnostics, NotesBecomeRelatedPlaces) {
  const std::string robot = "file:///nowhere/arm.kindsl";
  Client client;
  client.open(robot, replaced(kRobot, "link upper", "link upper { id = 2 children {} } link upper"));
  const Json& d = client.diagnostics.at(robot).at(0);
  EXPECT_EQ(d.at("relatedInformation").at(0).at("location").at("uri"), robot) << d;
}

}  // namespace
}  // namespace robcogen::test::diagnostics_test
