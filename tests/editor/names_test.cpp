// Names: declarations, uses and renames, across documents and instances of parts.
#include "client.h"
#include "run_tool.h"

namespace robcogen::test::names_test {
namespace {

namespace fs = std::filesystem;

const std::string kLeg = R"(Part Foot {
    root sole via ankle
    link sole { children {} frames { tip { translation = (0.0, 0.0, 0.1)  rotation = (0.0, 0.0, 0.0) } } }
    r_joint ankle { ref_frame { translation = (0.0, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) } }
}
Part Leg(thigh[0.35]) {
    root hip via HAA
    link hip {
        inertia_params {
            mass = 2.0  CoM = (0.0, 0.0, 0.5 thigh)
            Ix = 1.0  Iy = 1.0  Iz = 0.5  Ixy = 0.0  Ixz = 0.0  Iyz = 0.0
        }
        children { Foot end() at { translation = (thigh, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) } }
    }
    r_joint HAA { ref_frame { translation = (0.0, 0.0, 0.0)  rotation = (0.0, PI/2.0, 0.0) } }
}
)";
const std::string kBiped = R"(import "leg.kindsl"
Robot Biped {
    RobotBase trunk {
        children {
            Leg left(thigh = 0.4) at { translation = (0.0, size[0.2], 0.0)  rotation = (0.0, 0.0, 0.0) }
            Leg right() at { translation = (0.0, -size, 0.0)  rotation = (0.0, 0.0, 0.0) } mirrored y same sense { HAA }
        }
    }
    couplings { right_HAA = 0.5 * left_HAA }
}
)";
const std::string kList =
    "Robot Biped\nFrames { fr_left_hip, left_end_tip, right_end_tip }\n"
    "Transforms { base = fr_left_hip, target = left_end_tip  fr_trunk -> fr_right_end_sole }\n";

class Names : public testing::Test {
 protected:
  Names() : scratch_("names"), client_(scratch_.path) {
    for (const auto& [name, text] : {std::pair("leg.kindsl", kLeg), {"biped.kindsl", kBiped}, {"biped.dtdsl", kList}})
      write_text(scratch_.path / name, text);
    client_.open(leg_, kLeg);
    client_.open(biped_, kBiped);
  }

  const Scratch scratch_;
  Client client_;
  const std::string leg_ = file_uri(scratch_.path / "leg.kindsl"), biped_ = file_uri(scratch_.path / "biped.kindsl"),
                    list_ = file_uri(scratch_.path / "biped.dtdsl");

  // Returns `line:character` of each place, by file.
  static std::map<std::string, std::vector<std::string>> places(const Json& locations) {
    std::map<std::string, std::vector<std::string>> result;
    for (const Json& location : locations) {
      const Json& start = location.at("range").at("start");
      result[fs::path(location.at("uri").get<std::string>()).filename()].push_back(
          start.at("line").dump() + ":" + start.at("character").dump());
    }
    return result;
  }
  // Returns the documents after a rename.
  std::map<std::string, std::string> renamed(const std::string& uri, const std::string& word, const std::string& name) {
    const Json edit = client_.ask_at("textDocument/rename", uri, word, {{"newName", name}});
    std::map<std::string, std::string> texts = {{leg_, kLeg}, {biped_, kBiped}, {list_, kList}};
    EXPECT_TRUE(client_.error.is_null()) << client_.error;
    if (edit.is_null()) return texts;
    for (const auto& [changed, edits] : edit.at("changes").items())
      texts.at(changed) = edited(texts.at(changed), edits);
    return texts;
  }
};

std::string with(std::string text, const std::vector<std::pair<std::string, std::string>>& replacements) {
  for (const auto& [from, to] : replacements)
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
  return text;
}

TEST_F(Names, TheDocumentsAreSound) {
  // The feet are massless.
  EXPECT_EQ(client_.codes(leg_), std::vector<std::string>{"singular-inertia"});
  EXPECT_EQ(client_.codes(biped_), std::vector<std::string>{});
}

TEST_F(Names, AreDeclaredInThePartOfAnInstance) {
  using Places = std::map<std::string, std::vector<std::string>>;
  const auto definition = [&](const std::string& uri, const std::string& word) {
    return places(client_.ask_at("textDocument/definition", uri, word));
  };
  EXPECT_EQ(definition(biped_, "right_H|AA"), (Places{{"leg.kindsl", {{"14:12"}}}}));
  EXPECT_EQ(definition(biped_, "rig|ht_HAA"), (Places{{"biped.kindsl", {{"5:16"}}}}));
  EXPECT_EQ(definition(biped_, "th|igh = 0.4"), (Places{{"leg.kindsl", {{"5:9"}}}}));
  EXPECT_EQ(definition(biped_, "Le|g left"), (Places{{"leg.kindsl", {{"5:5"}}}}));
  EXPECT_EQ(definition(biped_, "-si|ze"), (Places{{"biped.kindsl", {{"4:59"}}}}));
  EXPECT_EQ(definition(biped_, "leg.|kindsl"), (Places{{"leg.kindsl", {{"0:0"}}}}));
  EXPECT_EQ(definition(leg_, "0.5 thi|gh"), (Places{{"leg.kindsl", {{"5:9"}}}}));
  client_.open(list_, kList);
  EXPECT_EQ(definition(list_, "right_end_t|ip"), (Places{{"leg.kindsl", {{"2:37"}}}}));
  EXPECT_EQ(definition(list_, "right_e|nd_tip"), (Places{{"leg.kindsl", {{"12:24"}}}}));
  EXPECT_EQ(definition(list_, "Robot Bi|ped"), (Places{{"biped.kindsl", {{"1:6"}}}}));
  EXPECT_EQ(definition(list_, "Trans|forms"), Places{});
}

TEST_F(Names, AreUsedThroughInstances) {
  const Json uses = client_.ask_at("textDocument/references", leg_, "r_joint H|AA");
  EXPECT_EQ(
      places(uses), (std::map<std::string, std::vector<std::string>>{
                        {"leg.kindsl", {"6:17", "14:12"}}, {"biped.kindsl", {"5:115", "8:22", "8:39"}}}));
  const Json highlights = client_.ask_at("textDocument/documentHighlight", biped_, "-si|ze");
  ASSERT_EQ(highlights.size(), 2U);
  EXPECT_EQ(highlights[0].at("kind"), 3) << "with its default";
}

TEST_F(Names, AreRenamedThroughPartsAndInstances) {
  using Replacements = std::vector<std::pair<std::string, std::string>>;
  const auto expect = [&](const std::string& uri, const std::string& word, const std::string& name,
                          const Replacements& leg, const Replacements& biped, const Replacements& list) {
    const auto texts = renamed(uri, word, name);
    EXPECT_EQ(texts.at(leg_), with(kLeg, leg)) << word;
    EXPECT_EQ(texts.at(biped_), with(kBiped, biped)) << word;
    EXPECT_EQ(texts.at(list_), with(kList, list)) << word;
  };
  expect(leg_, "link h|ip", "pelvis", {{"hip", "pelvis"}}, {}, {{"fr_left_hip", "fr_left_pelvis"}});
  expect(leg_, "r_joint H|AA", "Roll", {{"HAA", "Roll"}}, {{"HAA", "Roll"}}, {});
  expect(leg_, "t|ip {", "toe", {{"tip", "toe"}}, {}, {{"_tip", "_toe"}});
  expect(leg_, "so|le via", "pad", {{"sole", "pad"}}, {}, {{"_sole", "_pad"}});
  expect(leg_, "Foot e|nd", "last", {{"Foot end", "Foot last"}}, {}, {{"_end_", "_last_"}});
  expect(leg_, "Leg(thi|gh", "length", {{"thigh", "length"}}, {{"thigh", "length"}}, {});
  expect(leg_, "Part L|eg", "Limb", {{"Part Leg", "Part Limb"}}, {{"Leg ", "Limb "}}, {});
  expect(biped_, "Leg le|ft", "L", {}, {{"Leg left", "Leg L"}, {"left_HAA", "L_HAA"}}, {{"left_", "L_"}});
  expect(biped_, "RobotBase tr|unk", "body", {}, {{"trunk", "body"}}, {{"fr_trunk", "fr_body"}});
  expect(biped_, "Robot Bi|ped", "Walker", {}, {{"Robot Biped", "Robot Walker"}}, {{"Robot Biped", "Robot Walker"}});
  expect(biped_, "si|ze[", "width", {}, {{"size", "width"}}, {});
}

// The motor of an elastic joint has the name of the joint.
TEST_F(Names, AreRenamedInTendons) {
  const auto biped = [](const std::string& joint) {
    return with(
        kBiped, {{"    couplings { right_HAA = 0.5 * left_HAA }\n",
                  "    link fin { id = 1 children {} }\n    r_joint " + joint +
                      " { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } armature = 0.1 "
                      "elastic { stiffness = 3.0 } }\n    tendons { t { length = " +
                      joint + " - 2.0 * " + joint + "_motor + left_HAA } }\n"},
                 {"        children {\n", "        children {\n            fin via " + joint + "\n"}});
  };
  client_.change(biped_, biped("wave"));
  const Json edit = client_.ask_at("textDocument/rename", biped_, "wave_motor", {{"newName", "flap"}});
  ASSERT_TRUE(client_.error.is_null()) << client_.error;
  EXPECT_EQ(edited(biped("wave"), edit.at("changes").at(biped_)), biped("flap"));
}

// In a loop, `leg.hip` is the part's link; the head of a loop lists instances.
TEST_F(Names, AreRenamedInLoops) {
  const std::string list =
      "Robot Biped\nFrames { fr_trunk for leg in { left, right } { leg.fr_hip leg.end_tip } left.fr_end_sole }\n"
      "Transforms { for leg in { left, right } { fr_trunk -> leg.end_tip } fr_trunk -> left.fr_end_sole }\n";
  const std::string biped = with(
      kBiped, {{"couplings { right_HAA = 0.5 * left_HAA }",
                "couplings { for leg in { left, right } { leg.end_ankle = 0.5 * leg.HAA }  right.HAA = left.HAA }"}});
  const auto expect = [&](const std::string& uri, const std::string& word, const std::string& name,
                          const std::string& in_biped, const std::string& in_list) {
    client_.change(biped_, biped);
    client_.open(list_, list);
    for (const std::string& of : {biped_, list_})
      EXPECT_EQ(client_.codes(of), std::vector<std::string>{}) << client_.diagnostics[of];
    const Json edit = client_.ask_at("textDocument/rename", uri, word, {{"newName", name}});
    ASSERT_TRUE(client_.error.is_null()) << client_.error;
    const Json& changes = edit.at("changes");
    EXPECT_EQ(changes.contains(biped_) ? edited(biped, changes[biped_]) : biped, in_biped) << word;
    EXPECT_EQ(changes.contains(list_) ? edited(list, changes[list_]) : list, in_list) << word;
  };
  expect(leg_, "link h|ip", "pelvis", biped, with(list, {{"fr_hip", "fr_pelvis"}}));
  expect(leg_, "t|ip {", "toe", biped, with(list, {{"_tip", "_toe"}}));
  expect(leg_, "r_joint H|AA", "Roll", with(biped, {{"HAA", "Roll"}}), list);
  expect(leg_, "r_joint an|kle", "Pitch", with(biped, {{"ankle", "Pitch"}}), list);
  expect(
      biped_, "Leg le|ft", "L", with(biped, {{"Leg left", "Leg L"}, {"left.", "L."}, {"left,", "L,"}}),
      with(list, {{"left", "L"}}));
}

TEST_F(Names, AreNotRenamedToWhatIsWrong) {
  const auto refusal = [&](const std::string& word, const std::string& name) {
    client_.ask_at("textDocument/rename", leg_, word, {{"newName", name}});
    return client_.error.is_null() ? "" : client_.error.at("message").get<std::string>();
  };
  EXPECT_NE(refusal("link h|ip", "1st").find("is not a valid identifier"), std::string::npos);
  EXPECT_NE(refusal("link h|ip", "").find("is not a valid identifier"), std::string::npos);
  EXPECT_NE(refusal("link h|ip", "a b").find("is not a valid identifier"), std::string::npos);
  EXPECT_NE(refusal("link h|ip", "children").find("is a keyword"), std::string::npos);
  EXPECT_NE(refusal("|mass", "m").find("no name"), std::string::npos);
  EXPECT_EQ(refusal("link h|ip", "pelvis"), "");
  client_.change(biped_, with(kBiped, {{"couplings", "link left_sole { id = 1 children {} } couplings"}}));
  EXPECT_TRUE(client_.ask_at("textDocument/prepareRename", leg_, "|mass").is_null());
  EXPECT_EQ(client_.ask_at("textDocument/prepareRename", leg_, "link h|ip").at("placeholder"), "hip");
}

TEST_F(Names, ATakenNameIsRefused) {
  const std::string twice = with(
      kBiped, {{"couplings",
                "r_joint spare { ref_frame { translation = (0.0, 0.0, 0.0)  "
                "rotation = (0.0, 0.0, 0.0) } }\n    couplings"},
               {"children {\n", "children { extra via spare\n"},
               {"    r_joint spare", "    link extra { id = 1 children {} }\n    r_joint spare"}});
  client_.change(biped_, twice);
  client_.ask_at("textDocument/rename", biped_, "link ex|tra", {{"newName", "trunk"}});
  ASSERT_FALSE(client_.error.is_null());
  EXPECT_NE(client_.error.at("message").get<std::string>().find("is it already used?"), std::string::npos)
      << client_.error;
  client_.ask_at("textDocument/rename", biped_, "link ex|tra", {{"newName", "other"}});
  EXPECT_TRUE(client_.error.is_null()) << client_.error;
}

// Each name of the example robots is renamed in robot and list; the operation counts stay the same.
TEST(Rename, LeavesExamplesTheSame) {
  for (const char* name : {"hyl", "wrist", "geared_leg"}) {
    const Scratch scratch("rename");
    const fs::path robot_file = scratch.path / (std::string(name) + ".kindsl"),
                   list_file = scratch.path / (std::string(name) + ".dtdsl");
    const std::string robot_text = contents(robot(name)),
                      list_text = contents(fs::path(robot(name)).replace_extension(".dtdsl"));
    write_text(robot_file, robot_text);
    write_text(list_file, list_text);
    Client client(scratch.path);
    client.open(file_uri(robot_file), robot_text);
    client.open(file_uri(list_file), list_text);
    const std::string command = "ops --desired '" + list_file.string() + "' '" + robot_file.string() +
                                "' --algorithms inverse_dynamics,transforms --effort 0";
    const auto numbers = [](const Outcome& run) {
      std::string digits;
      std::istringstream lines(run.output);
      for (std::string line; std::getline(lines, line);)
        digits += line.size() > 45 ? line.substr(line.find_first_of(' ')) : "";
      return digits;
    };
    int renames = 0;
    const Json symbols = client.ask_about("textDocument/documentSymbol", file_uri(robot_file));
    std::vector<Json> names;
    const std::function<void(const Json&)> collect = [&](const Json& list) {
      for (const Json& symbol : list) {
        names.push_back(symbol.at("selectionRange").at("start"));
        if (symbol.contains("children")) collect(symbol["children"]);
      }
    };
    collect(symbols);
    for (std::size_t i = 0; i < names.size(); i += 2) {
      const Json edit = client.ask_about(
          "textDocument/rename", file_uri(robot_file), {{"position", names[i]}, {"newName", "renamed_element"}});
      ASSERT_TRUE(client.error.is_null()) << client.error;
      client.change(file_uri(robot_file), edited(robot_text, edit.at("changes").at(file_uri(robot_file))));
      if (edit["changes"].contains(file_uri(list_file)))
        client.change(file_uri(list_file), edited(list_text, edit["changes"][file_uri(list_file)]));
      EXPECT_EQ(client.codes(file_uri(robot_file)), std::vector<std::string>{}) << client.texts[file_uri(robot_file)];
      EXPECT_EQ(client.codes(file_uri(list_file)), std::vector<std::string>{});
      if (i == 0) {
        const std::string before = numbers(run_tool(command));
        write_text(robot_file, client.texts[file_uri(robot_file)]);
        write_text(list_file, client.texts[file_uri(list_file)]);
        EXPECT_EQ(numbers(run_tool(command)), before);
        write_text(robot_file, robot_text);
        write_text(list_file, list_text);
      }
      client.change(file_uri(robot_file), robot_text);
      client.change(file_uri(list_file), list_text);
      ++renames;
    }
    EXPECT_GT(renames, 2) << name;
  }
}

TEST(Outline, IsTheKinematicTree) {
  Client client;
  const std::string uri = file_uri(robot("hyl"));
  client.open(uri, contents(robot("hyl")));
  const std::function<std::string(const Json&)> text = [&](const Json& list) {
    std::string result;
    for (const Json& symbol : list)
      result += symbol.at("name").get<std::string>() + "(" +
                (symbol.contains("children") ? text(symbol["children"]) : "") + ")";
    return result;
  };
  EXPECT_EQ(
      text(client.ask_about("textDocument/documentSymbol", uri)),
      "HyL(base(slider(upperleg(upperleg_com()lowerleg(lowerleg_com()fr_foot())))))");
  const Json folds = client.ask_about("textDocument/foldingRange", uri);
  EXPECT_GT(folds.size(), 10U);
  for (const Json& fold : folds) EXPECT_LT(fold.at("startLine"), fold.at("endLine"));
}

// Wrong documents: circles, and a chain that is too long for a recursive walk.
TEST(Outline, SurvivesCirclesAndDepth) {
  Client client;
  client.open(
      "file:///a.kindsl",
      "Robot R { RobotBase b { children { a via j } } link a { id = 1 children { c via k } } link c { id = 2 children "
      "{ a via l } } }");
  EXPECT_EQ(client.ask_about("textDocument/documentSymbol", "file:///a.kindsl").size(), 1U);
  std::string chain = "Robot R { RobotBase l0 { children { l1 via j1 } }\n";
  for (int i = 1; i < 3000; ++i)
    chain += "link l" + std::to_string(i) + " { id = 1 children { l" + std::to_string(i + 1) + " via j" +
             std::to_string(i) + " } }\n";
  client.open("file:///b.kindsl", chain + "}");
  EXPECT_EQ(client.ask_about("textDocument/documentSymbol", "file:///b.kindsl").size(), 1U);
}

}  // namespace
}  // namespace robcogen::test::names_test
