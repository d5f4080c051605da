// Quick fixes: each is applied, and the diagnostic that it fixes is gone.
#include "client.h"
#include "goldens.h"

namespace robcogen::test::quick_fixes_test {
namespace {

Json fixes_of(Client& client, const std::string& uri, const Json& range) {
  return client.ask_about(
      "textDocument/codeAction", uri, {{"range", range}, {"context", {{"diagnostics", Json::array()}}}});
}

std::size_t count(const std::vector<std::string>& codes, const std::string& code) {
  return static_cast<std::size_t>(std::count(codes.begin(), codes.end(), code));
}

// Applied to all wrong documents. A fix removes its diagnostic, and fixes of each kind reduce the diagnostics of their
// code.
TEST(QuickFixes, RemoveWhatTheyFix) {
  std::map<std::string, int> fixed;
  const UnpackedGoldens goldens({"language", "model", "parts"});
  for (const GoldenDocument& document : goldens.documents) {
    const std::string uri = file_uri(document.file), text = contents(document.file);
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
  // At least one fix of each kind reduced the diagnostics of its code.
  for (const char* code :
       {"unknown-link", "unknown-joint", "missing-item", "unknown-frame", "unexpected-token", "similar-name",
        "unit-as-name", "decimal-comma", "number-runs-into-name", "signed-product", "duplicate-id",
        "child-before-parent", "large-angle", "old-dialect", "bad-number"})
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

// Returns the text after the fix of the first diagnostic with this code.
std::string fixed(const std::string& text, const std::string& code) {
  const std::string uri = "file:///nowhere/arm.kindsl";
  Client client;
  client.open(uri, text);
  for (const Json& d : client.diagnostics[uri]) {
    if (d.at("code") != code) continue;
    const Json actions = fixes_of(client, uri, d.at("range"));
    return actions.empty() ? "" : edited(text, actions[0].at("edit").at("changes").at(uri));
  }
  return "there is no " + code;
}

std::string arm(const std::string& inertia, const std::string& ids, const std::string& placement) {
  return "Robot Arm {\nRobotBase base { children { upper via a } }\nlink upper {\n    id = " + ids.substr(0, 1) +
         "\n    inertia_params { " + inertia +
         " }\n    children { lower via b }\n}\nlink lower { id = " + ids.substr(1) + " children {} }\nr_joint a { " +
         placement + " }\nr_joint b { " + placement + " }\n}\n";
}
const std::string kPlaced = "ref_frame { translation = (0.0, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) }";
const std::string kRod =
    "mass = 2.0  CoM = (0.5, 0.25, 0.0)  Ix = 0.0  Iy = 0.1  Iz = 0.1  Ixy = 0.0  Ixz = 0.0  Iyz = 0.0";

TEST(QuickFixes, MoveMomentsToTheOrigin) {
  // The moments increase by m y^2, m x^2 and m (x^2 + y^2); the product of inertia is m x y.
  EXPECT_EQ(
      fixed(arm(kRod, "12", kPlaced), "inertia-not-positive"),
      arm("mass = 2.0  CoM = (0.5, 0.25, 0.0)  Ix = 0.125  Iy = 0.6  Iz = 0.725  Ixy = 0.25  Ixz = 0.0  Iyz = 0.0",
          "12", kPlaced));
}

TEST(QuickFixes, NumberLinksAnew) {
  EXPECT_EQ(fixed(arm(kRod, "21", kPlaced), "child-before-parent"), arm(kRod, "12", kPlaced));
  EXPECT_EQ(fixed(arm(kRod, "11", kPlaced), "duplicate-id"), arm(kRod, "12", kPlaced));
}

TEST(QuickFixes, BringOldPlacementsUpToDate) {
  EXPECT_EQ(
      fixed(arm(kRod, "12", "translation : (0.0, 0.0, 0.0)  rotation : (0.0, 0.0, 0.0)"), "old-dialect"),
      arm(kRod, "12", kPlaced));
  EXPECT_EQ(
      fixed(arm(kRod, "12", "ref_frame { translation : (0.0, 0.0, 0.0)  rotation : (0.0, 0.0, 0.0) }"), "old-dialect"),
      arm(kRod, "12", kPlaced));
}

TEST(QuickFixes, TurnDegreesIntoRadians) {
  const auto turned = [](const std::string& angle) {
    return arm(kRod, "12", "ref_frame { translation = (0.0, 0.0, 0.0)  rotation = (0.0, " + angle + ", 0.0) }");
  };
  const std::string once = fixed(turned("90"), "large-angle");
  EXPECT_NE(once.find("rotation = (0.0, 90.0 PI/180.0, 0.0)"), std::string::npos) << once;
}

}  // namespace
}  // namespace robcogen::test::quick_fixes_test
