// The options --lock and --keep: which joints they remove, and their messages.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "documents.h"
#include "driver/load.h"
#include "export/kinematics.h"
#include "language/kinematics/document.h"

namespace robcogen::driver::changes_test {
namespace {

using namespace test;

// Fingers of a hand on an arm, and an eye in a socket.
constexpr const char* kHand = R"(Robot Hand {
RobotBase base { children { upper via shoulder } }
link upper {
    id = 1
    inertia_params { mass = 2.0 CoM = (0.0, 0.0, 0.1) Ix=0.1 Iy=0.1 Iz=0.05 Ixy=0.0 Ixz=0.0 Iyz=0.0 }
    children { palm via elbow }
}
link palm {
    id = 2
    inertia_params { mass = 1.0 CoM = (0.25, 0.0, 0.0) Ix=0.01 Iy=0.08 Iz=0.08 Ixy=0.0 Ixz=0.0 Iyz=0.0 ref_frame = grip }
    children { tip_a via finger_a  tip_b via finger_b  tip_c via thumb  eye via ball }
    frames { grip { translation = (0.5, 0.0, 0.0) rotation = (0.0, 0.0, PI/2.0) } }
}
link tip_a { id = 3 inertia_params { mass = 0.1 CoM = (0.0, 0.0, 0.0) Ix=0.01 Iy=0.01 Iz=0.01 Ixy=0.0 Ixz=0.0 Iyz=0.0 } children {} }
link tip_b { id = 4 inertia_params { mass = 0.1 CoM = (0.0, 0.0, 0.0) Ix=0.01 Iy=0.01 Iz=0.01 Ixy=0.0 Ixz=0.0 Iyz=0.0 } children {} }
link tip_c { id = 5 inertia_params { mass = 0.1 CoM = (0.0, 0.0, 0.0) Ix=0.01 Iy=0.01 Iz=0.01 Ixy=0.0 Ixz=0.0 Iyz=0.0 } children {} }
link eye { id = 6 inertia_params { mass = 0.1 CoM = (0.0, 0.0, 0.2) Ix=0.01 Iy=0.01 Iz=0.01 Ixy=0.0 Ixz=0.0 Iyz=0.0 } children {} }
r_joint shoulder { ref_frame { translation = (0.0, 0.0, height[0.5]) rotation = (tilt[0.1], 0.0, 0.0) } }
r_joint elbow {
    ref_frame { translation = (0.0, 0.0, 0.5) rotation = (PI/2.0, 0.0, 0.0) }
    limits { position = (-1.0, 2.0) }
}
p_joint finger_a { ref_frame { translation = (0.1, 0.02, 0.0) rotation = (0.0, 0.0, 0.0) } }
p_joint finger_b { ref_frame { translation = (0.1, -0.02, 0.0) rotation = (0.0, 0.0, 0.0) } }
p_joint thumb { ref_frame { translation = (0.1, 0.0, 0.02) rotation = (0.0, 0.0, 0.0) } }
s_joint ball { ref_frame { translation = (0.0, 0.1, 0.0) rotation = (0.0, 0.0, 0.0) } }
}
)";

// finger_b follows finger_a, and thumb both finger_a and elbow.
std::string coupled_hand() {
  std::string text = kHand;
  return text.insert(
      text.rfind('}'), "couplings { finger_b = 0.5 * finger_a + 0.01  thumb = finger_a + 0.1 m/rad * elbow }");
}

// A parallel crank with sides of 1 m and 0.5 m.
constexpr const char* kFourBar = R"(Robot Bars {
RobotBase base { children { crank via turn  rocker via swing } frames { foot { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } }
link crank { id = 1 children { rod via pin } }
link rod { id = 2 children {} frames { end { translation = (1.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } }
link rocker { id = 3 children {} frames { top { translation = (0.6, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } }
r_joint turn { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, PI/2.0) } }
r_joint pin { ref_frame { translation = (0.5, 0.0, 0.0) rotation = (0.0, 0.0, -PI/2.0) } }
r_joint swing { ref_frame { translation = (1.0, 0.0, 0.0) rotation = (0.0, 0.0, PI/2.0) } }
loops { joined { frames = end ~ top  type = hinge } }
independent { turn }
}
)";

class Changes : public testing::Test {
 protected:
  Folder folder;
  Diagnostics diagnostics;

  std::optional<Model> change(const std::string& text, const ChangeOptions& changes) {
    diagnostics = Diagnostics();
    return load(folder.file("robot.kindsl", text), {.changes = changes}, diagnostics);
  }
  // The names of the joints that remain; or the errors, without the lines of the source.
  std::string joints(const std::string& text, const ChangeOptions& changes) {
    const std::optional<Model> model = change(text, changes);
    if (!model) return errors();
    std::string names;
    for (const model::Joint& joint : model->robot()->tree.joints)
      if (joint.is_first()) names += (names.empty() ? "" : " ") + joint.declared_name();
    return names;
  }
  std::string errors() const {
    std::string text;
    for (const Diagnostic& d : diagnostics.all())
      if (d.severity == Severity::error) {
        const LineColumn at = d.place.source->locate(d.place.span.begin);
        text += (text.empty() ? "" : "\n") + d.place.source->name() + ":" + std::to_string(at.column) + " " +
                d.message + " [" + d.code + "]" + (d.hint.empty() ? "" : "; " + d.hint);
      }
    return text;
  }
  std::string note(const std::string& code) const {
    for (const Diagnostic& d : diagnostics.all())
      if (d.code == code) return d.message;
    return "";
  }
};

TEST_F(Changes, RemoveJoints) {
  EXPECT_EQ(joints(kHand, {.locks = {"elbow = 0.3"}}), "shoulder finger_a finger_b thumb ball");
  EXPECT_EQ(joints(kHand, {.locks = {"finger_? = 0", "thumb=0.01,ball = (1, 0, 0, 0)"}}), "shoulder elbow");
  EXPECT_EQ(joints(kHand, {.kept = {"shoulder", "finger*"}}), "shoulder finger_a finger_b");
  EXPECT_EQ(joints(kHand, {.locks = {"* = 0"}}), "");
}

// Numbers stay exact, names remain, and the document of what remains has the same robot.
TEST_F(Changes, LumpMassesAndKeepFrames) {
  const std::optional<Model> model =
      change(kHand, {.locks = {"elbow = PI/2", "finger_* = 0.5", "thumb = 0", "ball = 0"}});
  ASSERT_TRUE(model) << diagnostics.render();
  const model::KinematicTree& tree = model->robot()->tree;
  ASSERT_EQ(tree.links.size(), 2U);
  const model::Inertia& inertia = *tree.links[1].inertia;
  EXPECT_EQ(inertia.mass.number(), Number::rational(34, 10));
  // upper, palm at (0, 0, 1) with its centre 0.25 m beyond, tips and eye.
  EXPECT_EQ((inertia.com[2] * inertia.mass).number().value(), 2.0 * 0.1 + 1.0 * (0.5 + 0.5) + 0.3 * 0.6 + 0.1 * 0.5);
  for (const char* name : {"fr_palm", "fr_elbow", "grip", "fr_eye", "fr_ball", "fr_tip_a", "fr_finger_a"})
    EXPECT_TRUE(tree.find_frame(name)) << name;
  const model::Placement grip = tree.placement_of(*tree.find_frame("grip"));
  EXPECT_EQ(grip.translation[2].number(), Number::rational(1));
  EXPECT_TRUE(grip.translation[0].is_zero() && grip.translation[1].is_zero());
  EXPECT_EQ(grip.rotation[2].number(), Number::pi_multiple(1));
  std::string frames;
  for (const model::Frame& frame : model::link_and_user_frames(tree)) frames += frame.name + " ";
  EXPECT_EQ(frames, "fr_upper grip fr_palm fr_tip_a fr_tip_b fr_tip_c fr_eye ");
  const std::string text = language::kinematics::print(exporting::kinematics_document(tree));
  EXPECT_EQ(joints(text, {}), "shoulder");
}

TEST_F(Changes, FollowCouplings) {
  EXPECT_EQ(joints(coupled_hand(), {.locks = {"finger_a = 0.02"}}), "shoulder elbow thumb ball");
  EXPECT_EQ(note("locked-too"), "locked joints determine further joints, which are locked too: 'finger_b' at 0.02");
  EXPECT_EQ(joints(coupled_hand(), {.locks = {"finger_b = 0.02"}}), "shoulder elbow thumb ball");
  EXPECT_EQ(note("locked-too"), "locked joints determine further joints, which are locked too: 'finger_a' at 0.02");
  EXPECT_EQ(joints(coupled_hand(), {.locks = {"finger_* = 0.1 elbow = 0.5"}}), "shoulder ball");
  EXPECT_EQ(joints(coupled_hand(), {.locks = {"thumb = 0.1 finger_a = 0.05"}}), "shoulder ball");
  EXPECT_EQ(
      note("locked-too"),
      "locked joints determine further joints, which are locked too: 'elbow' at 0.5, 'finger_b' at 0.035");
  EXPECT_EQ(joints(coupled_hand(), {.kept = {"thumb"}}), "elbow finger_a finger_b thumb");
}

TEST_F(Changes, CloseLoops) {
  for (const char* lock : {"turn = 0.3", "swing = 0.2", "pin = -0.2"}) {
    EXPECT_EQ(joints(kFourBar, {.locks = {lock}}), "") << lock;
    EXPECT_TRUE(change(kFourBar, {.locks = {lock}})->robot()->tree.loops.empty());
  }
  EXPECT_EQ(joints(kFourBar, {.locks = {"turn = 0"}}), "");
  EXPECT_EQ(joints(kFourBar, {.kept = {"swing"}}), "turn pin swing");
}

TEST_F(Changes, OfParameters) {
  const std::optional<Model> model = change(kHand, {.locks = {"tilt = 0.2"}});
  ASSERT_TRUE(model) << diagnostics.render();
  ASSERT_EQ(model->parameters().size(), 1U);
  EXPECT_EQ(model->parameters()[0].name, "height");
  EXPECT_EQ(model->robot()->tree.joints[0].placement.rotation[0].number().value(), 0.2);
  // The axis of the elbow is turned about x, as the parameter is; but a turned shoulder is between them.
  EXPECT_EQ(joints(kHand, {.locks = {"shoulder = 0"}}), "elbow finger_a finger_b thumb ball");
  EXPECT_EQ(
      joints(
          replaced(kHand, "rotation = (tilt[0.1], 0.0, 0.0)", "rotation = (0.0, 0.0, tilt[0.1])"),
          {.locks = {"shoulder = 0.3"}}),
      "--lock:1 joint 'elbow' cannot be placed beyond a locked joint: its rotation depends on 'tilt' "
      "[lock-parametric-rotation]; lock the parameter, too, at its value: tilt = …");
}

TEST_F(Changes, ThatCannotBeMadeAreErrors) {
  const auto lock = [&](const std::string& text) { return joints(coupled_hand(), {.locks = {text}}); };
  EXPECT_EQ(
      lock("elbw = 0"), "--lock:1 robot 'Hand' has no joint or parameter 'elbw' [lock-unknown]; did you mean 'elbow'?");
  EXPECT_EQ(
      lock("elbow = 0 fingr_* = 0"),
      "--lock:11 no joint of robot 'Hand' matches 'fingr_*' [lock-unknown]; should it match 'finger_a'?");
  EXPECT_EQ(
      joints(kHand, {.kept = {"shoulder", "knee"}}),
      "--keep:10 robot 'Hand' has no joint 'knee' [lock-unknown]; its joints are shoulder, elbow, finger_a, finger_b, "
      "thumb, ball");
  EXPECT_EQ(
      lock("elbow = 3"),
      "--lock:1 joint 'elbow' cannot be locked at 3: its limits are -1 and 2 [lock-outside-limits]; lock it at a "
      "position in "
      "between, as in elbow = 0.5");
  EXPECT_EQ(
      lock("thumb = 0.1"),
      "--lock:1 joint 'thumb' cannot be locked: it follows 'elbow' and 'finger_a', which would remain free to move "
      "against one "
      "another [lock-follower]; lock these joints instead");
  EXPECT_EQ(
      lock("finger_a = 0.1 finger_b = 0.1"),
      "--lock:16 joint 'finger_b' cannot be locked at 0.1: the joints that it follows are locked, and put it at 0.06 "
      "[lock-contradiction]; lock the joints that it follows only");
  EXPECT_EQ(
      lock("ball = 0.3"),
      "--lock:1 joint 'ball' is spherical: its position is not a single number [lock-spherical]; write its unit "
      "quaternion, as "
      "in ball = (1, 0, 0, 0)");
  EXPECT_EQ(lock("ball = (0, 0, 0, 0)"), "--lock:1 the quaternion of joint 'ball' is zero [lock-spherical]");
  EXPECT_EQ(
      lock("elbow = (1, 0, 0, 0)"),
      "--lock:1 joint 'elbow' is not spherical: its position is a single number [lock-spherical]");
  EXPECT_EQ(lock("tilt = (1, 0, 0, 0)"), "--lock:1 the value of parameter 'tilt' is a number [lock-parameter]");
  EXPECT_EQ(
      joints(kFourBar, {.locks = {"turn = 0 swing = 0.3"}}),
      "--lock:1 loop 'joined' cannot close with 'turn' at 0, 'swing' at 0.3: a gap of 0.174 m remains "
      "[lock-open-loop]; "
      "lock one of its joints only, and the others follow; or choose a position that the loop reaches");
  EXPECT_EQ(
      joints(replaced(kFourBar, "translation = (0.6", "translation = (side[0.6]"), {.locks = {"turn = 0"}}),
      "--lock:1 loop 'joined' cannot move any more, but parameter 'side' determines where its joints are "
      "[lock-parametric-loop]; lock the parameter, too, at its value: side = …");
}

TEST_F(Changes, AreReadFromText) {
  const auto lock = [&](const std::string& text) { return joints(kHand, {.locks = {text}}); };
  const std::string hint = "; write elbow = 0.3, or hand_* = 0";
  EXPECT_EQ(lock("elbow"), "--lock:1 expected a name, '=' and a position at 'elbow' [lock-syntax]" + hint);
  EXPECT_EQ(lock("elbow 0.3"), "--lock:1 expected a name, '=' and a position at 'elbow' [lock-syntax]" + hint);
  EXPECT_EQ(lock("= 0.3"), "--lock:1 expected a name, '=' and a position at '=' [lock-syntax]" + hint);
  EXPECT_EQ(lock("elbow ="), "--lock:1 expected a name, '=' and a position at 'elbow' [lock-syntax]" + hint);
  EXPECT_EQ(lock("elbow = wide"), "--lock:1 'wide' is not a number [lock-value]");
  EXPECT_EQ(
      lock("ball = (1, 0, 0)"),
      "--lock:8 a list must have the four numbers of a quaternion: (w, x, y, z) [lock-syntax]");
  EXPECT_NE(lock("elbow = 1/0").find("--lock:"), std::string::npos);
  EXPECT_EQ(lock("elbow=PI/4.0 elbow=0.5"), "shoulder finger_a finger_b thumb ball");
}

TEST_F(Changes, LeaveOutActuators) {
  std::string text = kHand;
  text.insert(text.rfind('}'), "actuators { ram { from = fr_upper  to = grip } }");
  EXPECT_EQ(joints(text, {.locks = {"elbow = 0.3"}}), "shoulder finger_a finger_b thumb ball") << diagnostics.render();
  EXPECT_EQ(note("locked-actuator"), "actuator 'ram' is left out: locked joints connect its ends");
}

// The parameters with their default values.
std::string parameters_of(const Model& model) {
  std::string text;
  for (const model::Parameter& p : model.parameters())
    text += (text.empty() ? "" : " ") + p.name + "[" + print_double(p.default_value.value_or(0.5)) + "]";
  return text;
}

TEST_F(Changes, MakeParameters) {
  const auto made = [&](const std::vector<std::string>& parameters, const std::vector<std::string>& locks = {}) {
    const std::optional<Model> model = change(kHand, {.locks = locks, .parameters = parameters});
    return model ? parameters_of(*model).substr(std::string("height[0.5] tilt[0.1]").size()) : errors();
  };
  EXPECT_EQ(made({"upper.mass", "eye.com"}), " upper_mass[2.0] eye_com_x[0.0] eye_com_y[0.0] eye_com_z[0.2]");
  EXPECT_EQ(
      made({"palm.inertia"}),
      " palm_mass[1.0] palm_com_x[0.25] palm_com_y[0.0] palm_com_z[0.0] palm_ixx[0.01] palm_iyy[0.08] palm_izz[0.08] "
      "palm_ixy[0.0] palm_ixz[0.0] palm_iyz[0.0]");
  EXPECT_EQ(made({"tip_?.mass"}), " tip_a_mass[0.1] tip_b_mass[0.1] tip_c_mass[0.1]");
  EXPECT_EQ(made({"finger_a.translation"}), " finger_a_x[0.1] finger_a_y[0.02] finger_a_z[0.0]");
  EXPECT_EQ(made({"grip.rotation"}), " grip_rx[0.0] grip_ry[0.0] grip_rz[" + print_double(std::acos(0.0)) + "]");
  // What depends on parameters already remains.
  EXPECT_EQ(made({"shoulder.placement"}), " shoulder_x[0.0] shoulder_y[0.0] shoulder_ry[0.0] shoulder_rz[0.0]");
  EXPECT_EQ(made({"elbow.damping", "elbow.armature"}), " elbow_damping[0.0] elbow_armature[0.0]");
  // A parameter of a locked link remains.
  EXPECT_EQ(made({"palm.mass"}, {"elbow = 0.3"}), " palm_mass[1.0]");
  EXPECT_EQ(made({"palm.mass"}, {"palm_mass = 2.0"}), "");
}

// A body at a frame adds to the link, about the frame; without mass, it adds nothing.
TEST_F(Changes, AddBodiesAtFrames) {
  const std::optional<Model> model = change(kHand, {.parameters = {"grip.inertia"}});
  ASSERT_TRUE(model) << diagnostics.render();
  const model::KinematicTree& tree = model->robot()->tree;
  const model::KinematicTree before = change(kHand, {})->robot()->tree;
  const auto inertia = [](const model::KinematicTree& t, const std::vector<double>& values) {
    const model::RigidBodyInertia body = model::in_link_frame(*t.links[2].inertia);
    std::vector<double> numbers;
    for (const model::Quantity& q :
         {body.mass, body.first_moment[0], body.first_moment[1], body.first_moment[2], body.ixx, body.iyy, body.izz,
          body.ixy})
      numbers.push_back(model::evaluate(q, values));
    return numbers;
  };
  std::vector<double> values(tree.parameters.size());
  std::vector<double> own = inertia(before, {0.5, 0.1});
  std::vector<double> found = inertia(tree, values);
  for (std::size_t k = 0; k < own.size(); ++k) EXPECT_NEAR(found[k], own[k], 1e-15) << k;
  // A point mass of 2 kg at 0.1 m along x of the frame, which is turned by a quarter and 0.5 m from the link.
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (tree.parameters[k].name == "grip_mass") values[k] = 2.0;
    if (tree.parameters[k].name == "grip_com_x") values[k] = 0.1;
    if (tree.parameters[k].name == "grip_iyy" || tree.parameters[k].name == "grip_izz") values[k] = 2.0 * 0.01;
  }
  found = inertia(tree, values);
  const double added[] = {2.0, 1.0, 0.2, 0.0, 2.0 * 0.01, 2.0 * 0.25, 2.0 * 0.26, 2.0 * 0.05};
  for (std::size_t k = 0; k < own.size(); ++k) EXPECT_NEAR(found[k], own[k] + added[k], 1e-14) << k;
}

TEST_F(Changes, OfParametersThatNameNothingAreErrors) {
  const auto made = [&](const std::string& text) { return joints(kHand, {.parameters = {text}}); };
  EXPECT_EQ(
      made("palm"),
      "--parameters:1 'palm' is not the quantity of an element [parameter-syntax]; write link.mass, link.inertia, "
      "frame.placement, joint.rotor, …");
  EXPECT_EQ(
      made("palm.masss"),
      "--parameters:6 'masss' is not a quantity that can be a parameter [parameter-quantity]; did you mean 'mass'?");
  EXPECT_EQ(
      made("plam.mass"), "--parameters:1 robot 'Hand' has no link 'plam' [parameter-element]; did you mean 'palm'?");
  EXPECT_EQ(
      made("finger.placement"),
      "--parameters:1 robot 'Hand' has no joint or frame 'finger' [parameter-element]; did you mean 'finger_a'?");
  EXPECT_EQ(
      made("fingr_*.damping"),
      "--parameters:1 no joint of robot 'Hand' with 'damping' matches 'fingr_*' [parameter-element]; should it match "
      "'finger_a'?");
  EXPECT_EQ(made("elbow.rotor"), "--parameters:1 joint 'elbow' of the document has no rotor [parameter-rotor]");
  EXPECT_EQ(
      joints(replaced(kHand, "tilt[0.1]", "palm_mass[0.1]"), {.parameters = {"palm.mass"}}),
      "--parameters:1 the robot already has a parameter 'palm_mass' [parameter-name]");
}

TEST_F(Changes, ThatHaveNoEffectGetAWarning) {
  EXPECT_EQ(joints(kHand, {.parameters = {"base.mass"}}), "shoulder elbow finger_a finger_b thumb ball");
  EXPECT_EQ(note("parameter-unused"), "the mass of the fixed base 'base' has no effect");
  if (!READS_URDF) GTEST_SKIP() << "built without urdfdom";
  load(folder.file("rods.urdf", kRodsUrdf), {.changes = {.parameters = {"elbow.damping"}}}, diagnostics = {});
  EXPECT_EQ(note("parameter-unused"), "the dynamics does not include the damping of joints");
}

TEST_F(Changes, OfRobotsInUrdf) {
  if (!READS_URDF) GTEST_SKIP() << "built without urdfdom";
  const Model model = loaded(folder.file("rods.urdf", kRodsUrdf), {.changes = {.locks = {"elbow = 0.3"}}});
  const model::KinematicTree& tree = model.robot()->tree;
  ASSERT_EQ(tree.dof(), 1);
  const double cosine = std::cos(0.3);
  // The moment of inertia about the shoulder of two point masses, by hand.
  EXPECT_NEAR(
      model::evaluate(model::in_link_frame(*tree.links[1].inertia).izz),
      kM1 * kL1 * kL1 + kM2 * (kL1 * kL1 + kL2 * kL2 + 2 * kL1 * kL2 * cosine), 1e-12);
  std::string frames;
  for (const model::Frame& frame : model::link_and_user_frames(tree)) frames += frame.name + " ";
  EXPECT_EQ(frames, "upper lower ");
}

}  // namespace
}  // namespace robcogen::driver::changes_test
