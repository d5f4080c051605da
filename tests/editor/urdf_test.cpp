// Names in URDFs: outline, definitions, references and renames, also from lists and from documents that import the
// URDF.
#include "client.h"
#include "run_tool.h"

namespace robcogen::test::urdf_test {
namespace {

const std::string kUrdf = R"(<?xml version="1.0"?>
<!-- <link name="upper"/> is not one. -->
<robot name="arm">
  <link name="base"/>
  <link name="upper">
    <inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
  </link>
  <link name='lower'>
    <inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
  </link>
  <joint name="elbow" type="continuous">
    <parent link="upper"/><child link="lower"/><axis xyz="0 0 1"/>
  </joint>
  <joint name="shoulder" type="continuous">
    <parent link="base"/>
    <child link="upper"/>
    <axis xyz="0 0 1"/>
  </joint>
  <transmission name="t"><joint name="elbow"/></transmission>
  <gazebo reference="upper"/>
</robot>
)";
const std::string kList = "Robot arm\nFrames { fr_upper, fr_lower }\nTransforms { fr_upper -> fr_lower }\n";
const std::string kCarrier =
    "import \"arm.urdf\"\nRobot Carrier {\n"
    "    RobotBase box { children { arm left at { translation = (0.0, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) } } }\n"
    "    couplings { left_elbow = 0.5 * left_shoulder }\n}\n";

class Urdf : public testing::Test {
 protected:
  Urdf() : scratch_("urdf"), client_(scratch_.path) {
    write_text(scratch_.path / "arm.urdf", kUrdf);
    write_text(scratch_.path / "arm.dtdsl", kList);
    write_text(scratch_.path / "carrier.kindsl", kCarrier);
    client_.open(urdf_, kUrdf);
  }
  const Scratch scratch_;
  Client client_;
  const std::string urdf_ = file_uri(scratch_.path / "arm.urdf"), list_ = file_uri(scratch_.path / "arm.dtdsl"),
                    carrier_ = file_uri(scratch_.path / "carrier.kindsl");
};

TEST_F(Urdf, OutlineIsTheTree) {
  const Json outline = client_.ask_about("textDocument/documentSymbol", urdf_);
  ASSERT_EQ(outline.size(), 1U);
  EXPECT_EQ(outline[0].at("name"), "arm");
  const Json& base = outline[0].at("children").at(0);
  const Json& upper = base.at("children").at(0);
  const Json& lower = upper.at("children").at(0);
  EXPECT_EQ(base.at("name"), "base");
  EXPECT_EQ(upper.at("detail"), "via shoulder");
  EXPECT_EQ(lower.at("name"), "lower");
  EXPECT_FALSE(lower.contains("children"));
  EXPECT_EQ(upper.at("range").at("start").at("line"), 4);
  EXPECT_EQ(upper.at("range").at("end").at("line"), 6);
}

TEST_F(Urdf, NamesAreFound) {
  EXPECT_EQ(client_.ask_at("textDocument/references", urdf_, "<link name=\"|upper\">").size(), 6U);
  EXPECT_EQ(client_.ask_at("textDocument/documentHighlight", urdf_, "child link=\"|upper").size(), 4U);
  const Json definition = client_.ask_at("textDocument/definition", urdf_, "<joint name=\"|elbow\"/>");
  ASSERT_EQ(definition.size(), 1U);
  EXPECT_EQ(definition[0].at("range").at("start"), client_.position(urdf_, "|elbow\" type"));
  client_.open(list_, kList);
  EXPECT_EQ(client_.ask_at("textDocument/definition", list_, "fr_|lower").at(0).at("uri"), urdf_);
  client_.open(carrier_, kCarrier);
  EXPECT_EQ(client_.ask_at("textDocument/definition", carrier_, "left_|shoulder").at(0).at("uri"), urdf_);
  EXPECT_NE(
      client_.ask_at("textDocument/hover", urdf_, "<link name=\"|upper\">").dump().find("2 kg"), std::string::npos);
}

TEST_F(Urdf, NamesAreChangedEverywhere) {
  const auto changed = [&](const std::string& at, const std::string& name) {
    const Json edit = client_.ask_at("textDocument/rename", urdf_, at, {{"newName", name}});
    EXPECT_TRUE(client_.error.is_null()) << client_.error;
    return edit.is_null() ? Json::object() : edit.at("changes");
  };
  const Json link = changed("<link name=\"|upper\">", "arm1");
  std::string text = edited(kUrdf, link.at(urdf_));
  EXPECT_EQ(text.find("\"upper\"", text.find("<robot")), std::string::npos) << text;
  EXPECT_NE(text.find("<!-- <link name=\"upper\"/>"), std::string::npos);
  EXPECT_NE(edited(kList, link.at(list_)).find("Transforms { fr_arm1 -> fr_lower }"), std::string::npos);
  client_.change(urdf_, text);
  EXPECT_EQ(client_.codes(urdf_), (std::vector<std::string>{"ignored-elements"}));

  const Json joint = changed("joint name=\"|elbow", "bend");
  EXPECT_NE(edited(kCarrier, joint.at(carrier_)).find("left_bend = 0.5 * left_shoulder"), std::string::npos);
  // The name is already taken.
  EXPECT_TRUE(client_.ask_at("textDocument/rename", urdf_, "joint name=\"|elbow", {{"newName", "shoulder"}}).is_null());
  EXPECT_FALSE(client_.error.is_null());
}

TEST_F(Urdf, LoopsAndCouplingsReferToLinks) {
  std::string text = kUrdf;
  const std::string more =
      "  <coupling name=\"gear\"><predecessor link=\"upper\"/><successor link=\"lower\"/><ratio "
      "value=\"2\"/></coupling>\n";
  text.insert(text.find("</robot>"), more);
  client_.change(urdf_, text);
  EXPECT_EQ(client_.ask_at("textDocument/documentHighlight", urdf_, "child link=\"|upper").size(), 5U);
  const Json definition = client_.ask_at("textDocument/definition", urdf_, "successor link=\"|lower");
  ASSERT_EQ(definition.size(), 1U);
  EXPECT_EQ(definition[0].at("range").at("start"), client_.position(urdf_, "|lower'>"));
}

// URDFs are not formatted, because formatting would produce a different document; text that cannot be parsed must not
// cause an internal fault.
TEST_F(Urdf, BrokenTextIsLeftAlone) {
  EXPECT_EQ(client_.ask_about("textDocument/formatting", urdf_), Json::array());
  for (const char* broken :
       {"<robot", "<robot name=", "<robot name=\"", "<robot name='a'><link name=\"b",
        "<robot><link></robot></link></a>", "<robot><joint/><joint name=x><child link=\"\"/></joint>",
        "<robot><link =\"x\" name/ ='y'/>", "<robot><!-- ",
        "<robot><link name=\"a\"/><link name=\"a\"/><joint name=\"j\"><parent link=\"a\"/><child "
        "link=\"a\"/></joint>"}) {
    client_.change(urdf_, broken);
    for (const char* method :
         {"documentSymbol", "semanticTokens/full", "foldingRange", "formatting", "documentHighlight"}) {
      client_.ask_about(std::string("textDocument/") + method, urdf_, {{"position", {{"line", 0}, {"character", 8}}}});
      EXPECT_TRUE(client_.error.is_null()) << method << ": " << broken << client_.error;
    }
  }
}

}  // namespace
}  // namespace robcogen::test::urdf_test
