// From files to models: one call loads robots and coordinate transforms in any language.
#include "driver/load.h"

#include <algorithm>
#include <cmath>

#include "algorithm/catalogue/catalogue.h"
#include "algorithm/catalogue/transform_functions.h"
#include "algorithm/dynamics/dynamics.h"
#include "documents.h"
#include "symbolic/interpret.h"

namespace robcogen::driver::load_test {
namespace {

using namespace test;
using Codes = std::vector<std::string>;

class Load : public testing::Test {
 protected:
  Folder folder;
  Diagnostics diagnostics;

  std::optional<Model> try_load(const std::string& name, const std::string& text, const LoadOptions& options = {}) {
    diagnostics = Diagnostics();
    return load(folder.file(name, text), options, diagnostics);
  }
  Codes codes(Severity severity) const {
    Codes result;
    for (const Diagnostic& d : diagnostics.all())
      if (d.severity == severity) result.push_back(d.code);
    return result;
  }
};

TEST_F(Load, ARobotInEitherLanguage) {
  if (!READS_URDF) GTEST_SKIP() << "built without urdfdom";
  const Model document = loaded(folder.file("rods.kindsl", kRods)), urdf = loaded(folder.file("rods.urdf", kRodsUrdf));
  for (const Model* model : {&document, &urdf}) {
    ASSERT_TRUE(model->robot());
    EXPECT_FALSE(model->transforms());
    EXPECT_EQ(model->name(), "Rods");
    const model::KinematicTree& tree = model->robot()->tree;
    ASSERT_EQ(tree.dof(), 2);
    EXPECT_EQ(tree.joints[0].name, "shoulder");
    // The inertia matrix of two point masses, by hand.
    const double q2 = -0.7, both = kM2 * kL1 * kL2 * std::cos(q2), far = kM2 * kL2 * kL2;
    const auto H = symbolic::interpret<double>(algorithm::joint_space_inertia(tree, "H"), {{"q", {0.4, q2}}}).at("H");
    EXPECT_NEAR(H[0], (kM1 + kM2) * kL1 * kL1 + far + 2 * both, 1e-12);
    EXPECT_NEAR(H[1], far + both, 1e-12);
    EXPECT_NEAR(H[3], far, 1e-12);
  }
}

TEST_F(Load, MotionsAndTransformsAreOneModel) {
  for (const fs::path& file : {folder.file("arm.motdsl", kMotions), folder.file("arm.ctdsl", kTransforms)}) {
    const Model model = loaded(file);
    ASSERT_TRUE(model.transforms()) << file;
    EXPECT_FALSE(model.robot());
    EXPECT_EQ(model.name(), "Arm");
    EXPECT_EQ(model.file, file);
    const model::CoordinateTransforms& document = model.transforms()->document;
    EXPECT_EQ(document.variables, std::vector<std::string>{"a"});
    ASSERT_EQ(document.transforms.size(), 2U) << "a transform and its inverse";
    const auto functions = algorithm::transform_functions(document);
    const auto forth = std::find_if(functions.begin(), functions.end(), [](const symbolic::Function& f) {
      return f.name == "base_X_hand" && f.scope == "transforms::homogeneous";
    });
    ASSERT_NE(forth, functions.end());
    const std::string input = forth->program.inputs.at(0).name, output = forth->program.outputs.at(0).name;
    const auto X = symbolic::interpret<double>(forth->program, {{input, {0.3}}}).at(output);
    EXPECT_NEAR(X[13], 0.5 * std::cos(0.3), 1e-15);  // the origin of the hand, in y and z of the base
    EXPECT_NEAR(X[14], 0.5 * std::sin(0.3), 1e-15);
  }
}

TEST_F(Load, AListChoosesTransforms) {
  LoadOptions options;
  options.desired = folder.file(
      "rods.dtdsl",
      "Robot Rods Frames { fr_base, tip } Transforms { fr_base <- tip } Jacobians { base = fr_base, target = tip }");
  const Model model = loaded(folder.file("rods.kindsl", kRods), options);
  ASSERT_EQ(model.robot()->desired.transforms.size(), 1U);
  EXPECT_EQ(model.robot()->desired.transforms[0].right.name, "tip");
  EXPECT_EQ(model.read, (std::vector<fs::path>{model.file, *options.desired}));
  EXPECT_GT(loaded(model.file.parent_path() / "rods.kindsl").robot()->desired.transforms.size(), 1U);

  options.desired = folder.file("arm.dtdsl", "Model Arm Frames { ^base, hand } Transforms { hand <- ^base }");
  for (const fs::path& file : {folder.file("arm.motdsl", kMotions), folder.file("arm.ctdsl", kTransforms)}) {
    const Model frames = loaded(file, options);
    ASSERT_EQ(frames.transforms()->document.transforms.size(), 1U) << file;
    EXPECT_EQ(frames.transforms()->document.transforms[0].left, "hand");
  }
}

// Layout and comments do not change the canonical text; a changed number does.
TEST_F(Load, CanonicalTextIsThatOfTheContent) {
  const std::string text = kRods;
  const auto canonical = [&](const std::string& t) { return loaded(folder.file("rods.kindsl", t)).canonical; };
  EXPECT_EQ(canonical(text), canonical("// a comment\n" + replaced(text, "mass = 2.0  CoM", "mass = 2.00\nCoM")));
  EXPECT_NE(canonical(text), canonical(replaced(text, "0.75, 0.0, 0.0) rot", "0.8, 0.0, 0.0) rot")));
  EXPECT_NE(canonical(text), "");
}

TEST_F(Load, ErrorsAreReportedWithTheirPlace) {
  EXPECT_FALSE(try_load("rods.kindsl", replaced(kRods, "lower via elbow", "lwer via elbow")));
  ASSERT_FALSE(codes(Severity::error).empty());
  EXPECT_EQ(diagnostics.all()[0].place.source->locate(diagnostics.all()[0].place.span.begin).line, 9U)
      << diagnostics.render();
  EXPECT_FALSE(try_load("arm.motdsl", "Model Arm Convention = local base -> hand : turn(a)"));
  EXPECT_TRUE(diagnostics.has_errors());
}

TEST_F(Load, TwoTransformsOfOneNameAreAnError) {
  EXPECT_FALSE(try_load("arm.ctdsl", "Model Arm MovedFramePos = right {A}_X_{B} = Rz(q) [A_X_C] {A}_X_{C} = Rx(q)"));
  EXPECT_EQ(codes(Severity::error), Codes{"duplicate-name"});
}

TEST_F(Load, StrictnessMakesErrorsOfWarnings) {
  const std::string text = replaced(kRods, "mass = 2.0", "mass = 2.0 kg");
  EXPECT_TRUE(try_load("rods.kindsl", text));
  const Codes warnings = codes(Severity::warning);
  ASSERT_FALSE(warnings.empty());
  EXPECT_FALSE(try_load("rods.kindsl", text, {.strict = true}));
  EXPECT_EQ(codes(Severity::error), warnings);
}

// A point mass at the axis of a massless wrist: the inertia about the wrist's joint is zero.
TEST_F(Load, GroupsThatARobotCannotHaveAreErrorsWhereTheyAreAskedFor) {
  const std::string text = replaced(
      replaced(kRods, "(1.25, 0.0, 0.0)", "(0.0, 0.0, 0.0)"), "Iy = 0.78125  Iz = 0.78125", "Iy = 0.0  Iz = 0.0");
  EXPECT_TRUE(try_load("rods.kindsl", text)) << diagnostics.render();
  EXPECT_FALSE(codes(Severity::warning).empty());
  EXPECT_TRUE(try_load("rods.kindsl", text, {.groups = {"inverse_dynamics"}}));
  EXPECT_FALSE(try_load("rods.kindsl", text, {.groups = {"forward_dynamics"}}));
  EXPECT_FALSE(codes(Severity::error).empty());
}

// The mass properties allow the group, but its code would be too long: a chain of many links, solved for many columns.
TEST_F(Load, GroupsWhoseCodeWouldBeTooLongAreErrorsWhereTheyAreAskedFor) {
  std::string links, joints;
  constexpr int kLinks = 60;
  for (int i = 1; i <= kLinks; ++i) {
    const std::string number = std::to_string(i), next = std::to_string(i + 1);
    links +=
        "link l" + number + " { id = " + number +
        " inertia_params { mass = 1.0 CoM = (0.1, 0.0, 0.0) Ix = 0.1 Iy = 0.2 Iz = 0.2 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 "
        "} children {" +
        (i < kLinks ? " l" + next + " via j" + next : "") + " } }\n";
    joints += "r_joint j" + number + " { ref_frame { translation = (0.3, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }\n";
  }
  const std::string text = "Robot Snake { RobotBase ground { children { l1 via j1 } }\n" + links + joints + "}";
  EXPECT_TRUE(try_load("snake.kindsl", text)) << diagnostics.render();
  EXPECT_TRUE(try_load("snake.kindsl", text, {.groups = {"inverse_dynamics_derivatives"}}));
  EXPECT_FALSE(try_load("snake.kindsl", text, {.groups = {"forward_dynamics_derivatives"}}));
  EXPECT_EQ(codes(Severity::error), Codes{"unavailable-group"}) << diagnostics.render();
}

TEST_F(Load, ContactsOfAnOptionTakeThePlaceOfTheList) {
  const std::string list =
      folder.file("rods.dtdsl", "Robot Rods Frames { } Transforms { } Contacts { surface fr_upper }").string();
  const auto contacts = [&](const LoadOptions& options) {
    std::string found;
    const std::optional<Model> model = try_load("rods.kindsl", kRods, options);
    if (!model) return diagnostics.render();
    for (const model::ContactFrame& contact : model->robot()->desired.contacts)
      found += contact.frame.name + (contact.is_surface ? "* " : " ");
    return found;
  };
  EXPECT_EQ(contacts({}), "");
  EXPECT_EQ(contacts({.desired = list}), "fr_upper* ");
  EXPECT_EQ(contacts({.desired = list, .contacts = {"fr_lower", "fr_upper:point"}}), "fr_lower fr_upper ");
  EXPECT_EQ(contacts({.contacts = {"fr_lower:surface"}}), "fr_lower* ");
}

class Frames : public Load {
 protected:
  // `base_X_tip tip_X_base | base_J_tip`, or the messages.
  std::string pairs(const LoadOptions& options, const std::string& text = kRods) {
    const std::optional<Model> model = try_load("rods.kindsl", text, options);
    if (!model) return diagnostics.render();
    std::string found;
    for (const model::FramePair& p : model->robot()->desired.transforms)
      found += p.left.name + "_X_" + p.right.name + " ";
    found += "|";
    for (const model::FramePair& p : model->robot()->desired.jacobians)
      found += " " + p.left.name + "_J_" + p.right.name;
    return found;
  }
};

TEST_F(Frames, LimitTheFunctionsToThoseThatAreNamed) {
  const std::string tip = "fr_base_X_tip tip_X_fr_base | fr_base_J_tip";
  for (const char* pattern : {"tip", "t*", "?ip", "*p"}) EXPECT_EQ(pairs({.frames = {pattern}}), tip);
  const std::string upper = "fr_base_X_fr_upper fr_upper_X_fr_base | fr_base_J_fr_upper";
  for (const char* pattern : {"fr_upper", "upper", "upp*", "fr_u*"}) EXPECT_EQ(pairs({.frames = {pattern}}), upper);
  // A joint frame has no functions by default, but a name.
  EXPECT_EQ(pairs({.frames = {"elbow"}}), "fr_base_X_fr_elbow fr_elbow_X_fr_base | fr_base_J_fr_elbow");
  // Once each, in the order of the robot.
  EXPECT_EQ(
      pairs({.frames = {"t*", "*p", "upper"}}),
      "fr_base_X_fr_upper fr_upper_X_fr_base fr_base_X_tip tip_X_fr_base | fr_base_J_fr_upper fr_base_J_tip");
  EXPECT_EQ(pairs({.frames = {"base"}}), "|");
  EXPECT_EQ(
      pairs({.frames = {"*"}}),
      "fr_base_X_fr_upper fr_upper_X_fr_base fr_base_X_fr_lower fr_lower_X_fr_base fr_base_X_tip tip_X_fr_base | "
      "fr_base_J_fr_upper fr_base_J_fr_lower fr_base_J_tip");
}

TEST_F(Frames, LimitAList) {
  const fs::path list = folder.file(
      "rods.dtdsl",
      "Robot Rods Frames { fr_base, fr_upper, fr_lower, tip } "
      "Transforms { fr_base <- tip  fr_upper <- tip  fr_base <- fr_lower  fr_upper <- fr_base } "
      "Jacobians { base = fr_base, target = tip  base = fr_upper, target = tip } Contacts { point tip }");
  EXPECT_EQ(pairs({.desired = list, .frames = {"tip"}}), "fr_base_X_tip | fr_base_J_tip");
  EXPECT_EQ(
      pairs({.desired = list, .frames = {"tip", "up*"}}),
      "fr_base_X_tip fr_upper_X_tip fr_upper_X_fr_base | fr_base_J_tip fr_upper_J_tip");
  EXPECT_EQ(
      loaded(folder.file("rods.kindsl", kRods), {.desired = list, .frames = {"upper"}})
          .robot()
          ->desired.contacts.size(),
      1U);
  // The list has no frame of the elbow.
  EXPECT_EQ(
      pairs({.desired = list, .frames = {"elbow"}})
          .find("--frames:1:1: error: the list of desired transforms has no frame 'elbow' [unmatched-frame]"),
      0U);
}

TEST_F(Frames, NamesThatMatchNothingAreErrors) {
  const std::string name = pairs({.frames = {"tip", "uper"}});
  EXPECT_EQ(name.find("--frames:1:5: error: robot 'Rods' has no frame 'uper' [unmatched-frame]"), 0U) << name;
  EXPECT_NE(name.find("hint: did you mean 'upper'? its frames are fr_upper, fr_lower, tip"), std::string::npos) << name;
  const std::string pattern = pairs({.frames = {"*_lowr"}});
  EXPECT_EQ(pattern.find("--frames:1:1: error: no frame of robot 'Rods' matches '*_lowr' [unmatched-frame]"), 0U)
      << pattern;
  EXPECT_NE(pattern.find("hint: should it match 'fr_lower'? its frames are"), std::string::npos) << pattern;
  EXPECT_FALSE(try_load("rods.kindsl", kRods, {.frames = {"a*", "b*", "t*"}}));
  EXPECT_EQ(codes(Severity::error), (Codes{"unmatched-frame", "unmatched-frame"}));
}

// Groups of functions follow the pairs.
TEST_F(Frames, ReachEveryGroup) {
  const Model model = loaded(folder.file("rods.kindsl", kRods), {.frames = {"tip"}});
  for (const std::string& group : algorithm::groups_between_frames()) {
    int count = 0;
    for (const symbolic::Function& f : algorithm::functions(model.robot()->tree, model.robot()->desired, group)) {
      if (f.right.empty()) continue;
      ++count;
      EXPECT_TRUE(f.right == "tip" || f.left == "tip") << group << ' ' << f.name;
    }
    EXPECT_GT(count, 0) << group;
  }
}

TEST_F(Load, ContactsThatCannotBe) {
  EXPECT_FALSE(try_load("rods.kindsl", kRods, {.contacts = {"fr_lower", "fr_upper:line"}}));
  EXPECT_EQ(codes(Severity::error), Codes{"unknown-contact-kind"});
  EXPECT_EQ(
      diagnostics.render().find(
          "--contacts:1:18: error: 'line' is not a kind of contact: point or surface [unknown-contact-kind]"),
      0U)
      << diagnostics.render();
  EXPECT_FALSE(try_load("rods.kindsl", kRods, {.contacts = {"fr_lower", "fr_uper:pont"}}));
  EXPECT_EQ(codes(Severity::error), (Codes{"unknown-contact-kind", "unknown-contact-frame"}));
  const std::string text = diagnostics.render();
  EXPECT_EQ(text.find("--contacts:1:10: error: robot 'Rods' has no frame 'fr_uper' [unknown-contact-frame]"), 0U)
      << text;
  EXPECT_NE(text.find("hint: did you mean 'point'?"), std::string::npos) << text;
  for (const char* group : {"contacts", "constrained_forward_dynamics_derivatives", "operational_space"}) {
    EXPECT_FALSE(try_load("rods.kindsl", kRods, {.groups = {group}}));
    EXPECT_EQ(codes(Severity::error), Codes{"no-contacts"});
    EXPECT_TRUE(try_load("rods.kindsl", kRods, {.groups = {group}, .contacts = {"fr_lower"}}));
  }
}

TEST_F(Load, InversesThatCannotBe) {
  EXPECT_FALSE(try_load("rods.kindsl", kRods, {.inverses = {"fr_base:fr_lower:line", "fr_base"}}));
  EXPECT_EQ(codes(Severity::error), (Codes{"wrong-inverse", "wrong-inverse"}));
  EXPECT_EQ(
      diagnostics.render().find(
          "--inverse-kinematics:1:1: error: 'fr_base:fr_lower:line' does not say what to invert [wrong-inverse]"),
      0U)
      << diagnostics.render();
  EXPECT_FALSE(try_load("rods.kindsl", kRods, {.inverses = {"fr_base:fr_uper", "fr_base:fr_upper:given=wrist"}}));
  EXPECT_EQ(codes(Severity::error), (Codes{"unknown-inverse-frame", "unknown-given-joint"}));
  EXPECT_FALSE(try_load("rods.kindsl", kRods, {.inverses = {"fr_base:fr_lower", "fr_base:fr_lower:point"}}));
  EXPECT_EQ(codes(Severity::error), Codes{"repeated-inverse"});
  EXPECT_FALSE(try_load("rods.kindsl", kRods, {.groups = {"inverse_kinematics"}}));
  EXPECT_EQ(codes(Severity::error), Codes{"no-inverses"});
  EXPECT_TRUE(try_load("rods.kindsl", kRods, {.groups = {"inverse_kinematics"}, .inverses = {"fr_base:fr_lower"}}));
  // What has no closed form: no joint at all, a joint that is not between the frames.
  EXPECT_FALSE(try_load("rods.kindsl", kRods, {.inverses = {"fr_base:fr_base"}}));
  EXPECT_EQ(codes(Severity::error), Codes{"no-closed-form"});
  EXPECT_NE(
      diagnostics.render().find("fr_base_X_fr_base has no inverse in closed form: no joint is between them"),
      std::string::npos)
      << diagnostics.render();
  EXPECT_FALSE(try_load("rods.kindsl", kRods, {.inverses = {"fr_base:fr_upper:given=elbow"}}));
  EXPECT_NE(diagnostics.render().find("joint 'elbow' is not between these frames"), std::string::npos);
  // Tolerances.
  EXPECT_FALSE(try_load(
      "rods.kindsl", kRods,
      {.inverses = {"fr_base:fr_lower:tolerance=small", "fr_base:fr_upper:tolerance=1e-3:point"}}));
  EXPECT_EQ(codes(Severity::error), (Codes{"wrong-inverse", "wrong-inverse"}));
  EXPECT_FALSE(try_load(
      "rods.kindsl", kRods, {.inverses = {"fr_base:fr_lower:tolerance=0", "fr_base:fr_upper:swivel:tolerance=0.5"}}));
  EXPECT_EQ(codes(Severity::error), (Codes{"wrong-tolerance", "wrong-tolerance"}));
  EXPECT_TRUE(try_load("rods.kindsl", kRods, {.inverses = {"fr_base:fr_lower:tolerance=1e-3"}}));
  // Lengths may be parameters.
  const std::string with_length = replaced(kRods, "0.75, 0.0, 0.0) rot", "length, 0.0, 0.0) rot");
  EXPECT_TRUE(try_load("rods.kindsl", with_length, {.inverses = {"fr_base:fr_lower"}}));
  EXPECT_FALSE(try_load("rods.kindsl", with_length, {.inverses = {"fr_base:fr_lower:swivel"}}));
  EXPECT_NE(diagnostics.render().find("a swivel angle needs a chain without parameters"), std::string::npos)
      << diagnostics.render();
}

TEST_F(Load, ParametersAreListedOnDemand) {
  const std::string text = replaced(kRods, "mass = 2.0", "mass = heavy[2.0]");
  ASSERT_TRUE(try_load("rods.kindsl", text));
  EXPECT_TRUE(codes(Severity::note).empty());
  const std::optional<Model> model = try_load("rods.kindsl", text, {.lists_parameters = true});
  ASSERT_TRUE(model);
  ASSERT_EQ(model->parameters().size(), 1U);
  ASSERT_EQ(codes(Severity::note), Codes{"parameters"});
  EXPECT_NE(diagnostics.render().find("heavy[2.0] 6:16"), std::string::npos) << diagnostics.render();
}

TEST_F(Load, FramesAndPathsOfEitherDocument) {
  for (const fs::path& file : {folder.file("arm.motdsl", kMotions), folder.file("arm.ctdsl", kTransforms)}) {
    const auto motions = load_motions_of(file, diagnostics);
    ASSERT_TRUE(motions) << diagnostics.render();
    EXPECT_EQ(motions->frames, (std::vector<std::string>{"base", "hand"}));
    EXPECT_TRUE(model::transform_between(*motions, "hand", "base"));
  }
  EXPECT_FALSE(load_motions_of(folder.file("bad.motdsl", "Model"), diagnostics));
  EXPECT_TRUE(diagnostics.has_errors());
}

}  // namespace
}  // namespace robcogen::driver::load_test
