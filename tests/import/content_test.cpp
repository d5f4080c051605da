// The import of URDFs, compared with numbers computed by hand.
#include <clocale>
#include <cmath>
#include <limits>
#include <locale>
#include <set>

#include "import/identifier.h"
#include "reading.h"

namespace robcogen::content_test {
namespace {

using model::KinematicTree;
using model::Placement;
using model::Quantity;
using test::tree_of;

constexpr const char* kUnitInertial =
    R"(<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>)";

std::string link(const std::string& name, const std::string& inertial = kUnitInertial) {
  return "<link name=\"" + name + "\">" + inertial + "</link>\n";
}

std::string joint(
    const std::string& name,
    const std::string& type,
    const std::string& parent,
    const std::string& child,
    const std::string& inner) {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent + "\"/><child link=\"" + child +
         "\"/>" + inner + "</joint>\n";
}

std::string robot(const std::string& body) {
  return "<robot name=\"robot\">\n" + body + "</robot>\n";
}

constexpr const char* kAboutZ = R"(<axis xyz="0 0 1"/><limit effort="1" velocity="1"/>)";

// A base and an arm that turns about z; `more` and `inner` are added to the robot and to the joint.
std::string arm(const std::string& inertial, const std::string& more = "", const std::string& inner = kAboutZ) {
  return robot(link("base", "") + link("arm", inertial) + joint("hinge", "revolute", "base", "arm", inner) + more);
}

std::string inertial(const std::string& origin, const std::string& mass, const std::string& tensor) {
  return "<inertial>" + origin + "<mass value=\"" + mass + "\"/><inertia " + tensor + "/></inertial>";
}

const model::Inertia& inertia_of(const KinematicTree& tree, const std::string& name) {
  return *tree.links[static_cast<std::size_t>(*tree.find_link(name))].inertia;
}

const model::UserFrame& frame(const KinematicTree& tree, const std::string& name) {
  for (const model::UserFrame& f : tree.user_frames)
    if (f.name == name) return f;
  ADD_FAILURE() << "no frame '" << name << "'";
  return tree.user_frames.front();
}

// Spells quantities as a document would.
std::string text(const Quantity& q) {
  return model::print(q, {});
}
std::string text(const std::array<Quantity, 3>& v) {
  return text(v[0]) + " " + text(v[1]) + " " + text(v[2]);
}
std::string text(const Placement& p) {
  return text(p.translation) + ", " + text(p.rotation);
}
std::string moments(const model::Inertia& i) {
  return text(i.ixx) + " " + text(i.iyy) + " " + text(i.izz);
}
std::string products(const model::Inertia& i) {
  return text(i.ixy) + " " + text(i.ixz) + " " + text(i.iyz);
}

// --- faults that tools of this kind have had ---------------------------------------------------------------------

TEST(HistoricalFaults, FixedJointIsLumpedInTheFrameOfTheLinkThatCarriesIt) {
  // The tool is a point mass of 2 kg at (0, 0, 1) in its frame. The frame is at (1, 0, 0), turned by a quarter turn
  // about x, so the mass is at (1, -1, 0) in the arm. Angles are snapped, so that all numbers are exact.
  const std::string tool =
      link("tool", inertial("<origin xyz=\"0 0 1\"/>", "2", R"(ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="3")")) +
      joint("mount", "fixed", "arm", "tool", R"(<origin xyz="1 0 0" rpy="1.5707963267948966 0 0"/>)");
  const KinematicTree tree = tree_of(arm("", tool), {.snap_angles = true});
  const model::Inertia& i = inertia_of(tree, "arm");
  EXPECT_EQ(text(i.mass), "2.0");
  EXPECT_EQ(text(i.com), "1.0 -1.0 0.0");
  // About the centre of mass, y and z change places: (1, 3, 2). Moving it adds 2 kg * (1, 1, 2) and the product 2 * 1 *
  // -1.
  EXPECT_EQ(moments(i), "3.0 5.0 6.0");
  EXPECT_EQ(products(i), "-2.0 0.0 0.0");
  EXPECT_EQ(text(frame(tree, "tool").placement), "1.0 0.0 0.0, PI/2.0 0.0 0.0");
}

TEST(HistoricalFaults, LumpedMassesKeepTheirDecimals) {
  const std::string more =
      link("tool", inertial("<origin xyz=\"0.4 0 0\"/>", "0.1", R"(ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0")")) +
      joint("mount", "fixed", "arm", "tool", R"(<origin xyz="0.2 0 0"/>)");
  const KinematicTree tree = tree_of(arm(
      inertial("<origin xyz=\"0.3 0 0\"/>", "0.2", R"(ixx="0" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1")"), more));
  const model::Inertia& i = inertia_of(tree, "arm");
  EXPECT_TRUE(i.mass.number() == *Number::parse("0.3"));
  EXPECT_TRUE(i.com[0].number() == *Number::parse("0.4"));  // (0.2 * 0.3 + 0.1 * 0.6) / 0.3
  EXPECT_TRUE(i.izz.number() == *Number::parse("0.154"));   // 0.1 + 0.2 * 0.09 + 0.1 * 0.36
}

TEST(HistoricalFaults, InertialRpyTurnsTheTensor) {
  const KinematicTree tree = tree_of(
      arm(inertial(
          R"(<origin rpy="0 0 1.5707963267948966"/>)", "1", R"(ixx="1" ixy="0.2" ixz="0" iyy="2" iyz="0" izz="2.5")")),
      {.snap_angles = true});
  EXPECT_EQ(moments(inertia_of(tree, "arm")), "2.0 1.0 2.5");
  // The turn changes the sign of the tensor's ixy; the model has the product of inertia, which has the opposite sign.
  EXPECT_EQ(products(inertia_of(tree, "arm")), "0.2 0.0 0.0");
}

TEST(HistoricalFaults, InertialRpyCountsAlsoWhenItsAnglesSumToZero) {
  const KinematicTree tree = tree_of(
      arm(inertial(
          R"(<origin rpy="1.5707963267948966 0 -1.5707963267948966"/>)", "1",
          R"(ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="2.5")")),
      {.snap_angles = true});
  // R = Rz(-PI/2) Rx(PI/2) maps x to -y, y to z, z to -x.
  EXPECT_EQ(moments(inertia_of(tree, "arm")), "2.5 1.0 2.0");
}

TEST(HistoricalFaults, ProductsOfInertiaHaveTheOtherSignOfTensorElements) {
  const KinematicTree tree =
      tree_of(arm(inertial("", "1", R"(ixx="1" ixy="0.1" ixz="-0.2" iyy="1" iyz="0.3" izz="1")")));
  EXPECT_EQ(products(inertia_of(tree, "arm")), "-0.1 0.2 -0.3");
}

TEST(HistoricalFaults, InertiaAboutTheCentreOfMassIsMovedToTheOrigin) {
  const KinematicTree tree =
      tree_of(arm(inertial(R"(<origin xyz="1 2 3"/>)", "2", R"(ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1")")));
  const model::Inertia& i = inertia_of(tree, "arm");
  EXPECT_EQ(text(i.com), "1.0 2.0 3.0");
  EXPECT_EQ(moments(i), "27.0 21.0 11.0");  // 1 + 2 (4 + 9), 1 + 2 (1 + 9), 1 + 2 (1 + 4)
  EXPECT_EQ(products(i), "4.0 6.0 12.0");
}

TEST(HistoricalFaults, MasslessLeafIsAWarningThatNamesItsJoint) {
  const auto result =
      test::imported(arm(kUnitInertial, link("hand", "") + joint("wrist", "revolute", "arm", "hand", kAboutZ)));
  ASSERT_TRUE(result.tree);
  EXPECT_TRUE(result.tree->inertia_defects.is_singular());
  ASSERT_EQ(result.of_code("singular-inertia").size(), 1u);
  EXPECT_FALSE(result.diagnostics.has_errors());
  EXPECT_NE(result.of_code("singular-inertia")[0]->message.find("'wrist'"), std::string::npos);
}

TEST(HistoricalFaults, DecimalCommaIsAnErrorAndNotTheNumberBeforeIt) {
  const auto result = test::imported(arm(inertial("", "1,5", R"(ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1")")));
  EXPECT_FALSE(result.tree);
  ASSERT_EQ(result.of_code("not-a-number").size(), 1u);
  EXPECT_NE(result.of_code("not-a-number")[0]->message.find("'1,5'"), std::string::npos);
}

struct Comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST(HistoricalFaults, LocaleWithADecimalCommaChangesNothing) {
  const std::string document = arm(
      inertial(
          R"(<origin xyz="0.125 0 0" rpy="0 0.3 0"/>)", "1.5", R"(ixx="1.25" ixy="0" ixz="0" iyy="1" iyz="0" izz="1")"),
      "", R"(<axis xyz="0 0 1"/><limit lower="-0.5" upper="0.75" effort="1.5" velocity="2.5"/>)");
  const KinematicTree here = tree_of(document);
  const std::string c = std::setlocale(LC_ALL, nullptr);
  const std::locale cpp = std::locale::global({std::locale(), new Comma});
  std::setlocale(LC_ALL, "de_DE.UTF-8");  // if the system has this locale
  const KinematicTree there = tree_of(document);
  std::locale::global(cpp);
  std::setlocale(LC_ALL, c.c_str());
  EXPECT_EQ(text(inertia_of(there, "arm").com), "0.125 0.0 0.0");
  EXPECT_EQ(moments(inertia_of(there, "arm")), moments(inertia_of(here, "arm")));
  EXPECT_TRUE(there.joints[0].limits == here.joints[0].limits);
  EXPECT_EQ(there.joints[0].limits.upper, 0.75);
}

TEST(HistoricalFaults, NamesThatBecomeOneAreAnErrorThatShowsBoth) {
  const auto result = test::imported(robot(link("a-b") + link("a_b") + joint("j", "fixed", "a-b", "a_b", "")));
  EXPECT_FALSE(result.tree);
  ASSERT_EQ(result.of_code("name-collision").size(), 1u);
  const std::string& message = result.of_code("name-collision")[0]->message;
  EXPECT_NE(message.find("'a-b'"), std::string::npos);
  EXPECT_NE(message.find("'a_b'"), std::string::npos);
}

// --- drives ------------------------------------------------------------------------------------------------------

TEST(Urdf, DampingAndFrictionAreConstantsUntilTheyAreAskedFor) {
  const std::string document =
      arm(kUnitInertial, "",
          R"(<axis xyz="0 0 1"/><limit effort="1" velocity="1"/><dynamics damping="0.25" friction="0.5"/>)");
  const KinematicTree tree = tree_of(document);
  EXPECT_EQ(model::evaluate(tree.joints[0].drive.damping), 0.25);
  EXPECT_EQ(model::evaluate(tree.joints[0].drive.friction), 0.5);
  EXPECT_FALSE(tree.uses_passive_forces);
  import::UrdfOptions options;
  options.passive_forces = true;
  const auto asked = test::imported(document, options);
  ASSERT_TRUE(asked.tree);
  EXPECT_TRUE(asked.tree->uses_passive_forces);
  EXPECT_TRUE(asked.of_code("passive-forces-not-used").empty());
}

TEST(Urdf, FrictionIsSmoothWithAVelocity) {
  const std::string document =
      arm(kUnitInertial, "",
          R"(<axis xyz="0 0 1"/><limit effort="1" velocity="1"/><dynamics damping="0.25" friction="0.5"/>)");
  import::UrdfOptions options;
  options.passive_forces = true;
  EXPECT_EQ(model::evaluate(test::imported(document, options).tree->joints[0].drive.friction_velocity), 0);
  options.friction_velocity = 0.02;
  EXPECT_EQ(model::evaluate(test::imported(document, options).tree->joints[0].drive.friction_velocity), 0.02);
}

// --- frames ------------------------------------------------------------------------------------------------------

TEST(Urdf, JointFrameHasZAlongTheAxis) {
  const KinematicTree tree =
      tree_of(arm(kUnitInertial, "", R"(<origin xyz="1 2 3"/><axis xyz="0 1 0"/><limit effort="1" velocity="1"/>)"));
  EXPECT_EQ(text(tree.joints[0].placement), "1.0 2.0 3.0, -PI/2.0 0.0 0.0");
  EXPECT_EQ(text(frame(tree, "arm").placement), "0.0 0.0 0.0, PI/2.0 0.0 0.0");
}

TEST(Urdf, AxisThatIsNotGivenIsX) {
  const KinematicTree tree = tree_of(arm(kUnitInertial, "", R"(<limit effort="1" velocity="1"/>)"));
  EXPECT_EQ(text(tree.joints[0].placement), "0.0 0.0 0.0, 0.0 PI/2.0 0.0");
}

TEST(Urdf, FixedAxisAnglesAreRollThenPitchThenYaw) {
  const KinematicTree tree = tree_of(
      arm(kUnitInertial, "",
          R"(<origin rpy="1.5707963 1.5707963 0"/><axis xyz="0 0 1"/><limit effort="1" velocity="1"/>)"),
      {.snap_angles = true});
  // Ry(PI/2) Rx(PI/2) maps x to -z, y to x, z to -y.
  const auto R = model::rotation_matrix(tree.joints[0].placement);
  const double wanted[3][3] = {{0, 1, 0}, {0, 0, -1}, {-1, 0, 0}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(model::evaluate(R[i][j]), wanted[i][j]) << i << " " << j;
}

TEST(Urdf, EveryLinkIsAUserFrame) {
  const KinematicTree tree = tree_of(
      arm(kUnitInertial, link("palm", "") +
                             joint("mount", "fixed", "arm", "palm", R"(<origin xyz="0.5 0 0" rpy="0.3 0 0"/>)") +
                             link("tip", "") + joint("end", "fixed", "palm", "tip", R"(<origin xyz="1 0 0"/>)")));
  ASSERT_EQ(tree.user_frames.size(), 4u);
  EXPECT_EQ(tree.links.size(), 2u);
  EXPECT_EQ(frame(tree, "base").link, 0);
  EXPECT_EQ(text(frame(tree, "base").placement), "0.0 0.0 0.0, 0.0 0.0 0.0");
  EXPECT_EQ(text(frame(tree, "palm").placement), "0.5 0.0 0.0, 0.3 0.0 0.0");
  EXPECT_EQ(text(frame(tree, "tip").placement), "1.5 0.0 0.0, 0.3 0.0 0.0");
  EXPECT_EQ(frame(tree, "tip").link, 1);
}

TEST(Urdf, KeepsTheOrderOfTheFile) {
  const KinematicTree tree = tree_of(robot(
      joint("z", "revolute", "m", "a", kAboutZ) + link("q") + link("m") + joint("y", "revolute", "root", "q", kAboutZ) +
      link("a") + link("root", "") + joint("x", "prismatic", "root", "m", kAboutZ)));
  std::string links, joints;
  for (const model::Link& l : tree.links) links += l.name + " ";
  for (const model::Joint& j : tree.joints) joints += j.name + " ";
  EXPECT_EQ(links, "root q m a ");
  EXPECT_EQ(joints, "z y x ");
  EXPECT_EQ(tree.joints[2].type, model::JointType::prismatic);
}

// --- limits, base, names -----------------------------------------------------------------------------------------

model::JointLimits limits_of(const std::string& type, const std::string& limit) {
  return tree_of(robot(
                     link("base", "") + link("arm") +
                     joint("hinge", type, "base", "arm", R"(<axis xyz="0 0 1"/>)" + limit)))
      .joints[0]
      .limits;
}

TEST(Urdf, LimitsAreThoseOfTheDocument) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(
      (limits_of("revolute", R"(<limit lower="-1.5" upper="2" effort="3" velocity="0.1"/>)") ==
       model::JointLimits{-1.5, 2, 0.1, 3}));
  EXPECT_TRUE((limits_of("prismatic", "") == model::JointLimits{}));
  // If a limit is given, its missing positions are zero in URDF.
  EXPECT_TRUE((limits_of("prismatic", R"(<limit upper="2"/>)") == model::JointLimits{0, 2, kNone, kNone}));
  EXPECT_TRUE(
      (limits_of("continuous", R"(<limit lower="-1" upper="1" effort="3" velocity="4"/>)") ==
       model::JointLimits{-kNone, kNone, 4, 3}));
  EXPECT_TRUE((limits_of("continuous", "") == model::JointLimits{}));
  EXPECT_TRUE(
      (limits_of("prismatic", R"(<limit lower="-1e9" upper="1e+12" effort="1e9" velocity="999999999"/>)") ==
       model::JointLimits{-kNone, kNone, 999999999, kNone}));
  EXPECT_TRUE(
      (limits_of("revolute", R"(<limit lower="-1" upper="1" effort="-1" velocity="-1"/>)") ==
       model::JointLimits{-1, 1, kNone, kNone}));
}

TEST(Urdf, RootFloatsWhenAskedTo) {
  const std::string body = link("trunk") + link("leg") + joint("hip", "revolute", "trunk", "leg", kAboutZ);
  EXPECT_FALSE(tree_of(robot(body)).floating_base);
  const KinematicTree tree = tree_of(robot(body), {.floating_base = true});
  EXPECT_TRUE(tree.floating_base);
  EXPECT_EQ(tree.links[0].name, "trunk");
  EXPECT_TRUE(tree.links[0].inertia.has_value());
}

TEST(Urdf, FloatingJointOfTheRootMakesItsChildTheBase) {
  const auto result = test::imported(robot(
      link("world", "") + link("trunk") + joint("free", "floating", "world", "trunk", R"(<origin xyz="0 0 1"/>)") +
      link("leg") + joint("hip", "revolute", "trunk", "leg", kAboutZ)));
  ASSERT_TRUE(result.tree) << result.diagnostics.render();
  EXPECT_TRUE(result.tree->floating_base);
  EXPECT_EQ(result.tree->links[0].name, "trunk");
  EXPECT_EQ(result.tree->user_frames.size(), 2u);
  EXPECT_EQ(text(frame(*result.tree, "trunk").placement), "0.0 0.0 0.0, 0.0 0.0 0.0");
  EXPECT_EQ(result.of_code("root-left-out").size(), 1u);
}

TEST(Urdf, NamesBecomeIdentifiers) {
  const auto result = test::imported(robot(
      link("2nd base", "") + link("löwer/arm") + joint("löwer/arm", "revolute", "2nd base", "löwer/arm", kAboutZ)));
  ASSERT_TRUE(result.tree) << result.diagnostics.render();
  EXPECT_EQ(result.tree->links[0].name, "_2nd_base");
  EXPECT_EQ(result.tree->links[1].name, "lu00F6wer_arm");
  EXPECT_EQ(result.tree->joints[0].name, "lu00F6wer_arm_joint");
  EXPECT_EQ(result.of_code("joint-renamed").size(), 1u);
}

TEST(Urdf, NamesBeyondAsciiStayDistinct) {
  EXPECT_EQ(import::identifier("左"), "u5DE6");
  EXPECT_EQ(import::identifier("右"), "u53F3");
  EXPECT_EQ(import::identifier("é-🦿"), "u00E9_u1F9BF");
  EXPECT_EQ(import::identifier("4左"), "_4u5DE6");
  EXPECT_EQ(import::identifier("a\xE5\xB7"), "a__");     // cut short
  EXPECT_EQ(import::identifier("\xC0\xAF\xFF"), "___");  // not UTF-8
  const auto result = test::imported(robot(
      link("base", "") + link("左") + link("右") + joint("左関節", "revolute", "base", "左", kAboutZ) +
      joint("右関節", "revolute", "base", "右", kAboutZ)));
  ASSERT_TRUE(result.tree) << result.diagnostics.render();
  EXPECT_EQ(result.tree->links[1].name, "u5DE6");
  EXPECT_EQ(result.tree->links[2].name, "u53F3");
  EXPECT_EQ(result.of_code("names-changed").size(), 1u);
}

// Every frame of the document has a name of its own by which it is found.
TEST(Urdf, FramesThatHaveNamesOfTheModelStayReachable) {
  const auto result = test::imported(robot(
      link("base", "") + link("hip") + link("fr_hip") + link("fr_hip_frame") + link("fr_knee") +
      joint("a", "revolute", "base", "hip", kAboutZ) +
      joint("m", "fixed", "hip", "fr_hip", R"(<origin xyz="1 2 3"/>)") +
      joint("n", "fixed", "hip", "fr_hip_frame", R"(<origin xyz="4 5 6"/>)") +
      joint("knee", "revolute", "hip", "fr_knee", R"(<origin xyz="7 8 9"/>)" + std::string(kAboutZ))));
  ASSERT_TRUE(result.tree) << result.diagnostics.render();
  const KinematicTree& tree = *result.tree;
  EXPECT_EQ(result.of_code("frame-renamed").size(), 2u);
  EXPECT_EQ(result.of_code("frame-hidden").size(), 0u);
  std::set<std::string> names;
  for (const model::Frame& frame : tree.frames()) {
    EXPECT_TRUE(names.insert(frame.name).second) << frame.name;
    const auto found = tree.find_frame(frame.name);
    ASSERT_TRUE(found) << frame.name;
    EXPECT_EQ(found->kind, frame.kind);
    EXPECT_EQ(found->index, frame.index);
  }
  EXPECT_EQ(text(frame(tree, "fr_hip_frame_2").placement), "1.0 2.0 3.0, 0.0 0.0 0.0");
  EXPECT_EQ(text(frame(tree, "fr_hip_frame").placement), "4.0 5.0 6.0, 0.0 0.0 0.0");
  EXPECT_EQ(frame(tree, "fr_knee_frame").link, 2);
}

TEST(Urdf, LinkWithAnInertialOfZerosIsMassless) {
  const KinematicTree tree = tree_of(
      arm(inertial(R"(<origin xyz="1 2 3"/>)", "0", R"(ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0")"),
          link("tool") + joint("mount", "fixed", "arm", "tool", "")));
  EXPECT_EQ(text(inertia_of(tree, "arm").mass), "1.0");
  EXPECT_EQ(text(inertia_of(tree, "arm").com), "0.0 0.0 0.0");
}

// --- angles ------------------------------------------------------------------------------------------------------

TEST(Urdf, AnglesAreSnappedOnlyOnRequest) {
  const std::string document =
      arm(kUnitInertial, "",
          R"(<origin rpy="0.3 1.5707963267948966 0.261799"/><axis xyz="0 0 1"/><limit effort="1" velocity="1"/>)");
  const auto as_is = test::imported(document);
  ASSERT_EQ(as_is.of_code("angles-near-multiples").size(), 1u);
  EXPECT_NE(as_is.of_code("angles-near-multiples")[0]->message.find("2 angles"), std::string::npos);
  EXPECT_TRUE(as_is.of_code("angle-snapped").empty());

  const auto snapped = test::imported(document, {.snap_angles = true});
  EXPECT_TRUE(snapped.of_code("angles-near-multiples").empty());
  ASSERT_EQ(snapped.of_code("angle-snapped").size(), 2u);
  const std::string& message = snapped.of_code("angle-snapped")[1]->message;
  EXPECT_NE(message.find("yaw of the origin of joint 'hinge': 0.261799 becomes PI/12.0"), std::string::npos) << message;
}

TEST(Urdf, NearIsAMillionthOfARadian) {
  const auto result = test::imported(
      arm(kUnitInertial, "",
          R"(<origin rpy="1.5707954 1.5707952 -1.5707952"/><axis xyz="0 0 1"/><limit effort="1" velocity="1"/>)"));
  ASSERT_EQ(result.of_code("angles-near-multiples").size(), 1u);
  EXPECT_EQ(result.of_code("angles-near-multiples")[0]->message.find("an angle of this robot"), 0u);
}

TEST(Urdf, AnglesOfLinksWithoutMassAreNotCounted) {
  const std::string none =
      inertial(R"(<origin rpy="1.5707963 0 0"/>)", "0", R"(ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0")");
  const auto result = test::imported(arm(kUnitInertial, link("tip", none) + joint("end", "fixed", "arm", "tip", "")));
  EXPECT_TRUE(result.of_code("angles-near-multiples").empty());
}

// --- a root that is not declared ---------------------------------------------------------------------------------

TEST(ImplicitWorld, IsTheRootThatADocumentWithItHas) {
  const std::string body = link("upper") +
                           link("lower", inertial("", "2", R"(ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1")")) +
                           joint("mount", "fixed", "world", "upper", R"(<origin xyz="0 0 1"/>)") +
                           joint("hinge", "revolute", "upper", "lower", kAboutZ) +
                           joint("other", "revolute", "world", "side", kAboutZ) + link("side");
  const auto result = test::imported(robot(body));
  ASSERT_TRUE(result.tree) << result.diagnostics.render();
  EXPECT_EQ(result.of_code("implicit-world").size(), 1u);
  const auto declared = test::imported(robot(body + link("world", "")));
  ASSERT_TRUE(declared.tree);
  EXPECT_TRUE(declared.of_code("implicit-world").empty());
  EXPECT_EQ(result.tree->links[0].name, "world");
  ASSERT_EQ(result.tree->links.size(), declared.tree->links.size());
  for (std::size_t l = 0; l < declared.tree->links.size(); ++l)
    EXPECT_EQ(result.tree->links[l].name, declared.tree->links[l].name);
  EXPECT_EQ(text(frame(*result.tree, "upper").placement), text(frame(*declared.tree, "upper").placement));
  EXPECT_EQ(moments(inertia_of(*result.tree, "lower")), moments(inertia_of(*declared.tree, "lower")));
}

TEST(ImplicitWorld, MayCarryTheJointOfAFloatingBase) {
  const auto result = test::imported(robot(link("trunk") + joint("root", "floating", "world", "trunk", "")));
  ASSERT_TRUE(result.tree) << result.diagnostics.render();
  EXPECT_TRUE(result.tree->floating_base);
  EXPECT_EQ(result.tree->links[0].name, "trunk");
}

// --- sizes -------------------------------------------------------------------------------------------------------

// A chain in which every other joint is fixed, with names in alphabetical order.
std::string chain(int links) {
  constexpr int kFirst = 1000000;
  std::string body = link("l" + std::to_string(kFirst), "");
  for (int i = kFirst + 1; i < kFirst + links; ++i) {
    const std::string n = std::to_string(i), before = std::to_string(i - 1);
    body += link("l" + n) +
            joint(
                "j" + n, i % 2 == 0 ? "fixed" : "revolute", "l" + before, "l" + n,
                R"(<origin xyz="0.1 0 0" rpy="0.1 0.2 0.3"/><axis xyz="0 1 0"/><limit effort="1" velocity="1"/>)");
  }
  return robot(body);
}

TEST(Urdf, LongChainsNeedNoDeepStack) {
  constexpr int kLinks = 20000;
  EXPECT_EQ(tree_of(chain(kLinks)).dof(), kLinks / 2);
}

TEST(Urdf, LineOfMegabytesIsRead) {
  const std::string blanks(std::size_t{10} << 20, ' ');
  EXPECT_EQ(tree_of(robot(blanks + link("base", "") + blanks)).links.size(), 1u);
}

TEST(Urdf, TextThatIsTooLargeIsRefused) {
  const auto result = test::imported(robot(std::string(std::size_t{65} << 20, ' ')));
  EXPECT_EQ(result.of_code("too-large").size(), 1u);
}

// An element of RobCoGen's own.
TEST(ElasticJoints, HaveMotors) {
  const KinematicTree tree = tree_of(arm(
      kUnitInertial, "",
      R"(<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="7" velocity="2"/><dynamics armature="0.5" damping="3"/>
         <elastic stiffness="200" damping="0.4"/>)"));
  ASSERT_EQ(tree.joints.size(), 2U);
  const model::Joint &joint = tree.joints[0], &motor = tree.joints[1];
  EXPECT_EQ(motor.name, "hinge_motor");
  EXPECT_EQ(text(motor.drive.armature) + " " + text(joint.drive.armature), "0.5 0.0");
  EXPECT_EQ(text(motor.drive.damping) + " " + text(joint.drive.damping), "0.0 3.0");
  EXPECT_EQ(motor.limits.effort, 7.0);
  EXPECT_EQ(joint.limits.velocity, 2.0);
  EXPECT_TRUE(std::isinf(joint.limits.effort) && std::isinf(motor.limits.velocity));
  ASSERT_EQ(tree.tendons.size(), 1U);
  EXPECT_EQ(text(tree.tendons[0].stiffness) + " " + text(tree.tendons[0].damping), "200.0 0.4");
  EXPECT_FALSE(tree.uses_passive_forces);
}

}  // namespace
}  // namespace robcogen::content_test
