// The meaning of documents: parameters, constants, arithmetic, poses, desired transforms.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "reading.h"

namespace robcogen::documents_test {
namespace {

using model::KinematicTree;
using model::Parameter;
using model::ParameterKind;
using model::Quantity;

// A robot with one joint and these expressions.
std::string arm(const std::string& mass, const std::string& translation, const std::string& rotation) {
  return "Robot Arm { RobotBase base { children { upper via shoulder } }\n"
         "link upper { id = 1 inertia_params { mass = " +
         mass +
         " CoM = (0.0, 0.0, 0.0)\n"
         "Ix=0.1 Iy=0.1 Iz=0.1 Ixy=0.0 Ixz=0.0 Iyz=0.0 } children { } }\n"
         "r_joint shoulder { ref_frame { translation = " +
         translation + " rotation = " + rotation + " } } }\n";
}

KinematicTree read(const std::string& text) {
  Diagnostics diagnostics;
  const auto tree = test::tree_of(text, diagnostics);
  EXPECT_TRUE(tree.has_value()) << diagnostics.render();
  return tree.value_or(KinematicTree());
}

TEST(Documents, MakeParametersByWhereTheyStand) {
  const KinematicTree tree = read(arm("m[2.5]", "(len, 0.5 len, c)", "(tilt, 0.0, -tilt)"));
  ASSERT_EQ(tree.parameters.size(), 4u);
  const auto expect = [&](std::size_t i, const std::string& name, ParameterKind kind) {
    EXPECT_EQ(tree.parameters[i].name, name);
    EXPECT_EQ(tree.parameters[i].kind, kind);
  };
  expect(0, "m", ParameterKind::inertial);
  expect(1, "len", ParameterKind::length);
  expect(2, "c", ParameterKind::length);
  expect(3, "tilt", ParameterKind::angle);
  EXPECT_EQ(tree.parameters[0].default_value, 2.5);
  EXPECT_EQ(tree.parameters[1].default_value, std::nullopt);
  const std::vector<double> values = {1.0, 2.0, 3.0, 4.0};
  EXPECT_EQ(evaluate(tree.joints[0].placement.translation[1], values), 1.0);
  EXPECT_EQ(evaluate(tree.joints[0].placement.rotation[2], values), -4.0);
}

TEST(Documents, KeepMultiplesOfPiExact) {
  const KinematicTree tree = read(arm("1.0", "(0.0, 0.0, 0.0)", "(PI/2.0, -pi, 3.0*Pi/2.0 - PI/2.0)"));
  const auto& rotation = tree.joints[0].placement.rotation;
  EXPECT_EQ(rotation[0].number(), Number::pi_multiple(1, 2));
  EXPECT_EQ(rotation[1].number(), Number::pi_multiple(-1));
  EXPECT_EQ(rotation[2].number(), Number::pi_multiple(1));
  EXPECT_TRUE(tree.parameters.empty());
}

TEST(Documents, KnowNamedConstants) {
  const KinematicTree tree = read(arm("<m=3.2>", "(0.5*<m>, 0.0, <m>)", "(0.0, 0.0, 0.0)"));
  EXPECT_TRUE(tree.parameters.empty());
  EXPECT_EQ(tree.links[1].inertia->mass.number().value(), 3.2);
  EXPECT_EQ(tree.joints[0].placement.translation[0].number().value(), 1.6);
}

TEST(Documents, MakeOneParameterOfOneName) {
  Diagnostics diagnostics;
  const auto tree = test::tree_of(arm("2.0*x[0.5]", "(x, 0.0, 0.0)", "(x, 0.0, m)"), diagnostics);
  ASSERT_TRUE(tree.has_value());
  EXPECT_EQ(diagnostics.all().size(), 1u);  // the parameter is used as a length and as an angle
  ASSERT_EQ(tree->parameters.size(), 2u);
  const Parameter& x = tree->parameters[0];
  EXPECT_EQ(x.kind, ParameterKind::length);
  EXPECT_EQ(x.default_value, 0.5);
  EXPECT_TRUE(is_kinematics(x) && is_dynamics(x));
  EXPECT_TRUE(is_kinematics(tree->parameters[1]) && !is_dynamics(tree->parameters[1]));
  const std::vector<double> values = {10.0, 20.0};
  EXPECT_EQ(evaluate(tree->links[1].inertia->mass, values), 20.0);
  EXPECT_EQ(evaluate(tree->joints[0].placement.translation[0], values), 10.0);
  EXPECT_EQ(evaluate(tree->joints[0].placement.rotation[0], values), 10.0);
}

// It does not matter whether mass properties are read before or after the placement.
TEST(Documents, TakeTheUnitOfAParameterFromItsPlacement) {
  const KinematicTree tree = read(
      "Robot Arm { RobotBase base { children { upper via shoulder } }\n"
      "link upper { id = 1 inertia_params { mass = 1.0 + 0.0*tilt CoM = (0.0, 0.0, len/2.0)\n"
      "Ix=0.3 + len*len/4.0 Iy=0.3 + len*len/4.0 Iz=0.2 Ixy=0.0 Ixz=0.0 Iyz=0.0 } children { }\n"
      "frames { tip { translation = (0.0, 0.0, len[0.4]) rotation = (tilt, 0.0, 0.0) } } }\n"
      "r_joint shoulder { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } }\n");
  ASSERT_EQ(tree.parameters.size(), 2u);
  for (const Parameter& p : tree.parameters) {
    EXPECT_EQ(p.kind, p.name == "len" ? ParameterKind::length : ParameterKind::angle);
    EXPECT_TRUE(is_kinematics(p) && is_dynamics(p)) << p.name;
  }
}

TEST(Documents, KnowAParameterCalledPi) {
  const KinematicTree tree = read(arm("1.0", "(Pi[3.0], pi, 2.0*Pi)", "(PI, 0.0, 0.0)"));
  ASSERT_EQ(tree.parameters.size(), 1u);
  const std::vector<double> values = {4.0};
  EXPECT_EQ(evaluate(tree.joints[0].placement.translation[2], values), 8.0);
  EXPECT_EQ(tree.joints[0].placement.translation[1].number(), Number::pi_multiple(1));
}

TEST(Documents, GiveAReferenceFrameThatDependsOnAParameter) {
  const std::string text =
      "Robot Arm { RobotBase base { children { upper via shoulder } }\n"
      "link upper { id = 1 inertia_params { mass = 2.0 CoM = (0.0, 0.0, 0.0)\n"
      "Ix=0.1 Iy=0.1 Iz=0.1 Ixy=0.0 Ixz=0.0 Iyz=0.0 ref_frame = com } children { }\n"
      "frames { com { translation = (0.5 len, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } }\n"
      "r_joint shoulder { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } }\n";
  const KinematicTree tree = read(text);
  ASSERT_EQ(tree.parameters.size(), 1u);
  EXPECT_EQ(tree.parameters[0].kind, ParameterKind::length);
  const auto body = model::in_link_frame(*tree.links[1].inertia);
  const std::vector<double> values = {3.0};
  EXPECT_DOUBLE_EQ(evaluate(body.first_moment[0], values), 3.0);
  EXPECT_DOUBLE_EQ(evaluate(body.iyy, values), 0.1 + 2.0 * 1.5 * 1.5);
  EXPECT_DOUBLE_EQ(evaluate(body.ixx, values), 0.1);
}

// A printed quantity reads back as an expression with the same value.
TEST(Documents, ReadPrintedQuantities) {
  constexpr std::uint64_t kSeed = 1999;
  std::mt19937_64 engine(kSeed);
  const auto pick = [&](int below) { return static_cast<int>(engine() % static_cast<unsigned>(below)); };
  const std::vector<Parameter> parameters = {{"a", {}, {}, {}}, {"b", {}, {}, {}}, {"len", {}, {}, {}}};
  const std::vector<double> values = {0.7, 1.9, 0.35};
  const auto random_quantity = [&](const auto& self, int depth) -> Quantity {
    if (depth == 0 || pick(6) == 0) {
      if (pick(2) == 0) return Quantity::parameter(pick(3));
      return pick(3) == 0 ? Quantity(Number::pi_multiple(pick(9) - 4, 1 + pick(3)))
                          : Quantity(Number::rational(pick(19) - 9, 1 + pick(4)));
    }
    const Quantity x = self(self, depth - 1);
    switch (pick(8)) {
      case 0:
        return -x;
      case 1:
        return sin(x);
      case 2:
        return x - self(self, depth - 1);
      case 3:
      case 4:
        return x * self(self, depth - 1);
      case 5:
        return x / Quantity::parameter(pick(3));
      default:
        return x + self(self, depth - 1);
    }
  };
  int compared = 0;
  for (int round = 0; round < 500; ++round) {
    const Quantity quantity = random_quantity(random_quantity, 4);
    const double value = evaluate(quantity, values);
    if (!std::isfinite(value)) continue;
    const std::string text = print(quantity, parameters);
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", round " + std::to_string(round) + ": " + text);
    Diagnostics diagnostics;
    const auto tree =
        test::tree_of(arm("1.0", "(a*0.0 + b*0.0 + len*0.0, " + text + ", 0.0)", "(0.0, 0.0, 0.0)"), diagnostics);
    ASSERT_TRUE(tree.has_value()) << diagnostics.render();
    ASSERT_EQ(tree->parameters.size(), 3u);
    EXPECT_NEAR(evaluate(tree->joints[0].placement.translation[1], values), value, 1e-12 * (1.0 + std::abs(value)));
    ++compared;
  }
  EXPECT_GT(compared, 300);
}

TEST(Documents, ResolveDesiredTransforms) {
  const KinematicTree tree = read(arm("1.0", "(0.0, 0.0, 0.0)", "(0.0, 0.0, 0.0)"));
  Diagnostics diagnostics;
  const auto document = language::desired::parse(
      std::make_shared<Source>(
          "test.dtdsl",
          "Robot Arm Frames { fr_base, fr_upper, fr_shoulder }\n"
          "Transforms { base=fr_base target=fr_upper  fr_base -> fr_shoulder  fr_upper <- fr_upper }\n"
          "Jacobians { base=fr_base target=fr_upper }\n"),
      diagnostics);
  const auto desired = import::desired_transforms(document, tree, diagnostics);
  EXPECT_TRUE(diagnostics.all().empty()) << diagnostics.render();
  ASSERT_EQ(desired.transforms.size(), 3u);
  EXPECT_EQ(desired.transforms[0].left.kind, model::Frame::Kind::link);
  EXPECT_EQ(desired.transforms[0].left.index, 0);
  EXPECT_EQ(desired.transforms[0].right.name, "fr_upper");
  EXPECT_EQ(desired.transforms[1].left.kind, model::Frame::Kind::joint);
  EXPECT_EQ(desired.transforms[1].right.name, "fr_base");
  EXPECT_EQ(desired.transforms[2].left.name, "fr_upper");
  EXPECT_EQ(desired.transforms[2].right.name, "fr_upper");
  ASSERT_EQ(desired.jacobians.size(), 1u);
  EXPECT_EQ(desired.jacobians[0].right.name, "fr_upper");
}

constexpr const char* kTwoLegs = R"(
Part Leg {
    root thigh via hip
    link thigh { children {}  frames { fr_foot { translation = (0.3, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }
                                       knob { translation = (0.1, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } }
    r_joint hip { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
}
Robot Arm { RobotBase trunk floating { children { Leg L() Leg R() mirrored y } } }
)";

std::vector<std::string> pairs_of(const model::DesiredTransforms& desired) {
  std::vector<std::string> pairs;
  for (const auto* list : {&desired.transforms, &desired.jacobians})
    for (const model::FramePair& pair : *list) pairs.push_back(pair.left.name + "," + pair.right.name);
  for (const model::ContactFrame& contact : desired.contacts) pairs.push_back(contact.frame.name);
  return pairs;
}

std::vector<std::string> pairs_of(const std::string& list, const KinematicTree& tree) {
  Diagnostics diagnostics;
  const auto document = language::desired::parse(std::make_shared<Source>("test.dtdsl", list), diagnostics);
  const auto desired = import::desired_transforms(document, tree, diagnostics);
  EXPECT_TRUE(diagnostics.all().empty()) << diagnostics.render();
  return pairs_of(desired);
}

TEST(Documents, ListTheSameWithLoopsAndWithout) {
  const std::string loops =
      "Robot Arm Frames { fr_trunk, for leg in { L, R } { leg.foot, leg.knob, leg.thigh, leg.hip } }\n"
      "Transforms { for leg in { L, R } { trunk -> leg.foot  leg.knob <- leg.thigh } L.foot <- R.fr_foot }\n"
      "Jacobians { for leg in { R, L } { fr_trunk <- leg.hip } } Contacts { for leg in { L, R } { point leg.knob } }\n";
  const std::string plain =
      "Robot Arm Frames { fr_trunk, fr_L_foot L_knob fr_L_thigh fr_L_hip fr_R_foot R_knob fr_R_thigh fr_R_hip }\n"
      "Transforms { fr_trunk -> fr_L_foot  L_knob <- fr_L_thigh fr_trunk -> fr_R_foot  R_knob <- fr_R_thigh\n"
      "             fr_L_foot <- fr_R_foot }\n"
      "Jacobians { fr_trunk <- fr_R_hip fr_trunk <- fr_L_hip } Contacts { L_knob R_knob }\n";
  KinematicTree tree = read(kTwoLegs);
  const std::vector<std::string> pairs = pairs_of(plain, tree);
  EXPECT_EQ(pairs.size(), 9u);
  EXPECT_EQ(pairs_of(loops, tree), pairs);
  tree.limbs.clear();  // as in a robot without parts
  EXPECT_EQ(pairs_of(loops, tree), pairs);
}

TEST(Documents, KnowWhatInstancesHaveBecome) {
  const KinematicTree tree = read(
      "Part Foot { root pad via flex link pad { children {} } p_joint flex { ref_frame { translation = (0.0, 0.0, 0.0) "
      "rotation = (0.0, 0.0, 0.0) } } }\n"
      "Part Leg { root thigh via hip link thigh { children { Foot toe() } frames { fr_knob { translation = (0.0, 0.0, "
      "1.0) rotation = (0.0, 0.0, 0.0) } } } u_joint hip { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, "
      "0.0, 0.0) } } }\n"
      "Robot Arm { RobotBase trunk { children { head via neck Leg L() Leg R() } } link head { id = 1 children {} } "
      "r_joint neck { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } }");
  ASSERT_EQ(tree.limbs.size(), 4u);
  const model::Limb& leg = tree.limbs[2];
  EXPECT_EQ(tree.limbs[1].name, "L_toe");
  EXPECT_EQ(leg.name, "R");
  EXPECT_EQ(leg.part, "Leg");
  EXPECT_EQ(tree.links[static_cast<std::size_t>(leg.first_link)].name, "R_thigh");
  std::string joints;
  for (const auto& [own, index] : leg.joints)
    joints += own + "=" + tree.joints[static_cast<std::size_t>(index)].name + " ";
  EXPECT_EQ(joints, "hip_turn_x=R_hip_turn_x hip_turn_z=R_hip_turn_z toe_flex=R_toe_flex ");
  ASSERT_EQ(leg.links.size(), 2u);
  EXPECT_EQ(leg.links[1].own, "toe_pad");
  ASSERT_EQ(leg.frames.size(), 1u);
  EXPECT_EQ(leg.frames[0].own, "fr_knob");
  EXPECT_EQ(tree.user_frames[static_cast<std::size_t>(leg.frames[0].index)].name, "fr_R_knob");
}

}  // namespace
}  // namespace robcogen::documents_test
