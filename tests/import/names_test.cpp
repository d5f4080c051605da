// What attributes and elements do: each line of the tables mjcf_names.txt, mjcf_elements.txt and urdf_names.txt adds
// one to a model in which every element stands once, and compares the robot and the messages.
#include <fstream>
#include <map>
#include <sstream>

#include "export/kinematics.h"
#include "import/mjcf.h"
#include "import/mjcf/elements.h"
#include "import/urdf/elements.h"
#include "language/kinematics/document.h"
#include "patterns.h"
#include "reading.h"

namespace robcogen::names_test {
namespace {

struct Line {
  int number = 0;
  std::string element, item, outcome;  // the item is an attribute with its value, or `/child` or `/child=text`
};

// `element attribute='value' outcome`, or `element/child outcome`.
std::vector<Line> lines_of(const std::string& file) {
  std::ifstream text(std::filesystem::path(TEST_SOURCE_DIR) / file);
  std::vector<Line> lines;
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    const std::size_t last = line.rfind(' '), first = line.find(' ');
    Line result{number, line.substr(0, first), "", line.substr(last + 1)};
    const std::size_t slash = result.element.rfind('/');
    if (first == last)
      result.item = result.element.substr(slash), result.element = result.element.substr(0, slash);
    else
      result.item = line.substr(first + 1, last - first - 1);
    lines.push_back(std::move(result));
  }
  EXPECT_FALSE(lines.empty()) << file;
  return lines;
}

std::string child_of(const std::string& item) {
  const std::size_t equals = item.find('=');
  const std::string name = item.substr(1, equals == std::string::npos ? equals : equals - 1);
  const std::string content = equals == std::string::npos ? "" : item.substr(equals + 1);
  return "<" + name + ">" + content + "</" + name + ">";
}

// A model with marks: `@x@` stands for the attributes of element x, and `%x%` for further content.
struct Model {
  std::string text;
  std::map<std::string, std::string> attributes;  // by element, before a line changes them

  std::string with(const std::string& element, const std::string& item) const {
    std::string result;
    bool is_found = false;
    std::size_t at = 0;
    for (const test::Match& match : test::all_matches(text, "([@%])([a-z_/]+)[@%]")) {
      const std::size_t begin = text.find(match[0], at);
      result += text.substr(at, begin - at);
      at = begin + match[0].size();
      const bool is_attribute = match[1] == "@", is_here = match[2] == element && (item[0] == '/') != is_attribute;
      is_found = is_found || is_here;
      if (is_attribute) {
        const auto own = attributes.find(match[2]);
        const std::string given = own == attributes.end() ? "" : own->second;
        result += is_here ? replaced(given, item) : given;
      } else if (is_here) {
        result += child_of(item);
      }
    }
    result += text.substr(at);
    EXPECT_TRUE(is_found || element.empty()) << element;
    return result;
  }

  static std::string replaced(const std::string& attributes, const std::string& item) {
    const std::string same = "(^| )" + item.substr(0, item.find('=')) + "='[^']*'";
    return test::replaced(attributes, same, "") + " " + item;
  }
};

struct Outcome {
  std::string robot;                 // its document; empty if there was an error
  std::map<std::string, int> codes;  // of messages
  std::multiset<std::string> messages;
};

Outcome outcome_of(const std::optional<model::KinematicTree>& tree, const Diagnostics& diagnostics) {
  Outcome result;
  if (tree) result.robot = language::kinematics::print(exporting::kinematics_document(*tree));
  for (const Diagnostic& d : diagnostics.all()) {
    ++result.codes[d.code];
    result.messages.insert(d.message);
  }
  return result;
}

int count(const Outcome& outcome, const std::string& code) {
  const auto found = outcome.codes.find(code);
  return found == outcome.codes.end() ? 0 : found->second;
}

void compare(const Line& line, const Outcome& before, const Outcome& after) {
  const bool is_same = before.robot == after.robot && before.messages == after.messages;
  const bool is_unknown = count(after, "unknown-attribute") + count(after, "unknown-element") > 0;
  std::string messages;
  for (const std::string& message : after.messages) messages += message + "\n";
  if (line.outcome == "none")
    EXPECT_TRUE(is_same) << messages;
  else if (line.outcome == "read")
    EXPECT_TRUE(!is_same && !is_unknown) << messages;
  else if (line.outcome == "note")
    EXPECT_TRUE(before.robot == after.robot && before.codes == after.codes && !is_same) << messages;
  else
    EXPECT_GT(count(after, line.outcome), count(before, line.outcome)) << messages;
}

Outcome mjcf(const std::string& text) {
  Diagnostics diagnostics;
  const auto robot = import::mjcf(std::make_shared<Source>("robot.xml", text), "robot.xml", {}, diagnostics);
  return outcome_of(robot ? std::optional(robot->tree) : std::nullopt, diagnostics);
}

Outcome urdf(const std::string& text) {
  const test::Imported read = test::imported(text);
  return outcome_of(read.tree, read.diagnostics);
}

const Model& mjcf_model() {
  static const Model model = {
      R"(<mujoco @mujoco@>%mujoco%
        <compiler @compiler@>%compiler%</compiler>
        <option @option@>%option%<flag @flag@/></option>
        <default @default@>%default%<equality @default/equality@/>
          <default class='c'><joint armature='2'/><geom density='3'/><site pos='9 9 9'/><equality active='false'/>
            <motor damping='3'/><mesh scale='2 2 2'/></default>
        </default>
        <asset>%asset%<mesh @mesh@/></asset>
        <worldbody @worldbody@>%worldbody%
          <body @body@>%body%
            <joint @joint@>%joint%</joint><site @site@>%site%</site>
            <frame pos='0.5 0 0'><geom @geom@>%geom%</geom></frame>
            <frame @frame@>%frame%<body name='b' euler='10 20 30'><joint name='k' range='-9 9' frictionloss='1'/><geom size='0.1'/>
              <inertial @inertial@>%inertial%</inertial></body></frame>
            <replicate @replicate@><body name='r'><geom size='0.1' pos='0.3 0 0'/></body></replicate>
            <body name='shape'><geom type='mesh' mesh='m'/></body>
          </body>
          <body name='p'><joint name='p'/><geom size='0.1'/>
            <body name='q' pos='1 0 0'><joint name='q'/><geom size='0.1'/></body></body>
          <body name='w' pos='1 1 0'><joint name='w'/><geom size='0.1'/></body>
          <body name='u'><joint name='u' type='slide'/><geom size='0.1'/></body>
          <body name='v'><joint name='v' type='slide'/><geom size='0.1'/></body>
          <body name='y'><joint name='y'/><geom size='0.1'/><body><joint name='z'/><geom size='0.1'/></body></body>
        </worldbody>
        <equality>%equality%<joint @equality/joint@/><connect @equality/connect@/><weld @equality/weld@/>
          <tendon @equality/tendon@/></equality>
        <tendon>%tendon%<fixed @tendon@><joint joint='j' coef='1'/></fixed>
          <fixed name='f'><joint joint='y' coef='1'/></fixed><fixed name='g'><joint joint='z' coef='2'/></fixed></tendon>
        <actuator>%actuator%<motor @actuator@/></actuator>
        <contact>%contact%</contact><deformable>%deformable%</deformable><sensor>%sensor%</sensor>
        <keyframe>%keyframe%</keyframe>
      </mujoco>)",
      {{"mesh", "name='m' vertex='0 0 0 1 0 0 0 1 0 0 0 1' face='0 2 1 0 1 3 0 3 2 1 2 3'"},
       {"body", "name='a'"},
       {"joint", "name='j' stiffness='0.5'"},
       {"site", "name='s' type='capsule'"},
       {"geom", "type='capsule' size='0.1 0.2 0.3'"},
       {"inertial", "pos='0.1 0.2 0.3' mass='1' diaginertia='1 2 2.5'"},
       {"replicate", "count='2'"},
       {"equality/joint", "joint1='k' joint2='j'"},
       {"equality/connect", "body1='q' body2='w' anchor='1 0.5 0'"},
       {"equality/weld", "body1='u' body2='v'"},
       {"equality/tendon", "tendon1='f' tendon2='g'"},
       {"actuator", "joint='j' gear='2' armature='0.5'"}}};
  return model;
}

const Model& free_model() {
  static const Model model = {
      R"(<mujoco><worldbody><body name='a'><freejoint @freejoint@/>
        <inertial pos='1 0 0' mass='1' diaginertia='1 1 1'/></body></worldbody></mujoco>)",
      {}};
  return model;
}

void compare_mjcf(const std::string& file) {
  for (const Line& line : lines_of(file)) {
    SCOPED_TRACE(file + ":" + std::to_string(line.number) + ": " + line.element + " " + line.item);
    const Model& model = line.element == "freejoint" ? free_model() : mjcf_model();
    static const Outcome base = mjcf(mjcf_model().with("", "/")), base_of_free = mjcf(free_model().with("", "/"));
    compare(line, line.element == "freejoint" ? base_of_free : base, mjcf(model.with(line.element, line.item)));
  }
}

TEST(Names, ModelsWithoutALineHaveNoErrors) {
  EXPECT_NE(mjcf(mjcf_model().with("", "/")).robot, "");
  EXPECT_NE(mjcf(free_model().with("", "/")).robot, "");
}

TEST(Names, AttributesOfMjcf) {
  compare_mjcf("mjcf_names.txt");
}

TEST(Names, ElementsOfMjcf) {
  compare_mjcf("mjcf_elements.txt");
}

// The attributes of a line that the reader knows, by element.
std::map<std::string, std::set<std::string>> known_in(const std::string& file) {
  std::map<std::string, std::set<std::string>> result;
  for (const Line& line : lines_of(file))
    if (line.item.front() != '/' && line.outcome != "unknown-attribute" && !line.item.starts_with("xmlns") &&
        !line.item.ends_with("='0'") && !line.item.ends_with("='0 0 0'"))  // zeros of unknown attributes say nothing
      result[line.element].insert(line.item.substr(0, line.item.find('=')));
  return result;
}

TEST(Names, MjcfTableHasEveryAttribute) {
  for (const auto& [element, attributes] : known_in("mjcf_names.txt")) {
    const auto* known = import::from_mjcf::known_element(element);
    ASSERT_NE(known, nullptr) << element;
    std::set<std::string> all(known->attributes.begin(), known->attributes.end());
    all.insert(known->attributes_without_effect.begin(), known->attributes_without_effect.end());
    EXPECT_EQ(attributes, all) << element;
  }
}

const Model& urdf_model() {
  static const Model model = {
      R"(<robot @robot@>%robot%
        <link name='base'/>
        <link @link@>%link%
          <inertial @inertial@>%inertial%<mass @mass@/><inertia @inertia@/></inertial>
          <visual>%visual%<geometry>%geometry%</geometry></visual>
          <collision>%collision%</collision>
        </link>
        <link name='tool'>
          <inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial>
        </link>
        <joint @joint@>%joint%<origin @origin@/><parent @parent@/><child @child@/><axis @axis@/><limit @limit@/>
          <dynamics @dynamics@/></joint>
        <joint name='wrist' type='continuous'><parent link='arm'/><child link='tool'/><mimic @mimic@/>
          <elastic @elastic@/></joint>
        <transmission><joint name='wrist'/><actuator><drake:rotor_inertia value='0.1'/></actuator></transmission>
        <gazebo reference='arm'>%gazebo%</gazebo>
      </robot>)",
      {{"robot", "name='r'"},
       {"link", "name='arm'"},
       {"mass", "value='2'"},
       {"inertia", "ixx='2' ixy='0' ixz='0' iyy='2' iyz='0' izz='2'"},
       {"joint", "name='hinge' type='revolute'"},
       {"origin", "xyz='0 0 1' rpy='0 0 0'"},
       {"parent", "link='base'"},
       {"child", "link='arm'"},
       {"axis", "xyz='0 0 1'"},
       {"limit", "lower='-1' upper='1' effort='1' velocity='1'"},
       {"dynamics", "damping='1'"},
       {"mimic", "joint='hinge' multiplier='1'"},
       {"elastic", "stiffness='3'"}}};
  return model;
}

TEST(Names, AttributesAndElementsOfUrdf) {
  const Outcome base = urdf(urdf_model().with("", "/"));
  EXPECT_NE(base.robot, "");
  for (const Line& line : lines_of("urdf_names.txt")) {
    SCOPED_TRACE("urdf_names.txt:" + std::to_string(line.number) + ": " + line.element + " " + line.item);
    compare(line, base, urdf(urdf_model().with(line.element, line.item)));
  }
}

TEST(Names, UrdfTableHasEveryAttribute) {
  for (const auto& [element, attributes] : known_in("urdf_names.txt")) {
    const auto* known = import::from_urdf::known_element(element);
    ASSERT_NE(known, nullptr) << element;
    std::set<std::string> all(known->required.begin(), known->required.end());
    all.insert(known->optional.begin(), known->optional.end());
    all.insert(known->without_effect.begin(), known->without_effect.end());
    EXPECT_EQ(attributes, all) << element;
  }
}

// 5 kg that stand in a collision were lost without a word.
TEST(Names, MassesInShapesAreReported) {
  const std::string text = urdf_model().with(
      "collision", "/inertial=<mass value='5'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/>");
  const test::Imported read = test::imported(text);
  ASSERT_EQ(read.of_code("mechanics-not-read").size(), 1u);
  EXPECT_EQ(read.of_code("mechanics-not-read")[0]->message, "element 'inertial' of this 'collision' is not read");
}

TEST(Names, AreReportedOnceForAllPlaces) {
  std::string text = urdf_model().with("link", "grip='1'");
  text.insert(text.find("<link name='tool'") + 5, " grip='2'");
  const test::Imported read = test::imported(text);
  ASSERT_EQ(read.of_code("unknown-attribute").size(), 1u);
  EXPECT_EQ(
      read.of_code("unknown-attribute")[0]->message,
      "attribute 'grip' of this 'link' is unknown and ignored (2 times)");
}

}  // namespace
}  // namespace robcogen::names_test
