// Quick fixes: each is applied, and what it is a fix of is gone.
#include "client.h"

namespace robcogen::test {
namespace {

namespace fs = std::filesystem;

const fs::path kRooms = fs::path(TEST_SOURCE_DIR).parent_path();

Json fixes_of(Client& client, const std::string& uri, const Json& range) {
  return client.ask_about(
      "textDocument/codeAction", uri, {{"range", range}, {"context", {{"diagnostics", Json::array()}}}});
}

std::size_t count(const std::vector<std::string>& codes, const std::string& code) {
  return static_cast<std::size_t>(std::count(codes.begin(), codes.end(), code));
}

// Of all documents that are wrong: a fix leaves fewer diagnostics of its code, or none that proposes the same.
TEST(QuickFixes, RemoveWhatTheyFix) {
  std::map<std::string, int> fixed;
  for (const char* room : {"language", "model", "parts"}) {
    for (const auto& entry : fs::directory_iterator(kRooms / room / "bad")) {
      if (!entry.is_regular_file() || entry.path().extension() == ".expected") continue;
      const std::string uri = file_uri(entry.path()), text = contents(entry.path());
      if (text.size() > 100000 || text.find("\r") != std::string::npos) continue;
      Client client;
      client.open(uri, text);
      const Json diagnostics = client.diagnostics[uri];
      for (const Json& d : diagnostics) {
        if (d["code"] == "unchecked-list") continue;
        for (const Json& action : fixes_of(client, uri, d["range"])) {
          const Json& of = action.at("diagnostics").at(0);
          if (of != d) continue;
          const std::string code = of.at("code");
          const std::vector<std::string> before = client.codes(uri);
          client.change(uri, edited(text, action.at("edit").at("changes").at(uri)));
          Json left = client.diagnostics[uri];
          EXPECT_EQ(std::count(left.begin(), left.end(), d), 0) << uri << "\n" << d.dump(1) << action.dump(1);
          const bool is_better = count(client.codes(uri), code) < count(before, code);
          fixed[code] += is_better ? 1 : 0;
          client.change(uri, text);
        }
      }
    }
  }
  // Fixes of each kind did what they are for.
  for (const char* code :
       {"unknown-link", "unknown-joint", "missing-item", "unknown-frame", "unexpected-token", "similar-name",
        "unit-as-name"})
    EXPECT_GT(fixed[code], 0) << code;
}

TEST(QuickFixes, DeclareWhatIsMissing) {
  const std::string uri = "file:///nowhere/arm.kindsl";
  const std::string text = "Robot Arm {\n    RobotBase base { children { upper via shoulder } }\n}\n";
  Client client;
  client.open(uri, text);
  std::string repaired = text;
  for (int round = 0; round < 5 && !client.diagnostics[uri].empty(); ++round) {
    const Json first = client.diagnostics[uri][0];
    const Json actions = fixes_of(client, uri, first["range"]);
    if (actions.empty()) break;
    repaired = edited(repaired, actions[0].at("edit").at("changes").at(uri));
    client.change(uri, repaired);
  }
  for (const std::string& code : client.codes(uri)) EXPECT_EQ(code, "no-inertia") << repaired;
  EXPECT_NE(repaired.find("link upper {\n        id = 1\n        children {}\n    }"), std::string::npos) << repaired;
  EXPECT_NE(repaired.find("r_joint shoulder {"), std::string::npos) << repaired;
}

}  // namespace
}  // namespace robcogen::test
