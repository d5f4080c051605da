// The Kinematics-DSL: every construct in every spelling, its canonical text, and the comparison of documents.
#include "language/kinematics/document.h"

#include "reading.h"

namespace robcogen::language::kinematics::kinematics_test {
namespace {

using test::Codes;
using test::read_robot;
using test::robot_codes;

constexpr const char* kLeg = R"(
// A leg.
Robot Leg {
  /* holds it */
  RobotBase trunk floating {
    inertia_properties {
      mass = 5.0
      CoM = (0.1, .2, -.3)
      Iz=3.0 Iy=2.0 Ix=1.0  Ixy=0.1 Ixz=-0.2 Iyz=0.3
      ref_frame = com
    }
    children { upper via HFE  other via HAA }
    frames { com { translation = (0.0, 0.0, 1.0) rotation = (PI/2.0, 0.0, 0.0) } }
  }
  link upper {
    id = 7   // a hint
    inertia_params { mass = m CoM = (0, 0, 0) Ix=1 Iy=1 Iz=1 Ixy=0 Ixz=0 Iyz=0 }
    children { }
    frames {
      foot { translation = (len, 0.0, 0.0) rotation = (0.0, -tilt, 0.0) }
      ^link { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }
    }
  }
  link other { id = 0 children {} }
  r_joint HFE { ref_frame { translation = (0.0, 0.0, -1.0) rotation = (0.0, 0.0, 0.0) } }
  p_joint HAA { id = 4 ref_frame { translation = (0.5 len, 0.0, 0.0) rotation = (0.0, 0.0, PI) } }
  // the end
}
// of the file
)";

constexpr const char* kLegInCanonicalForm = R"(// A leg.
Robot Leg {

    /* holds it */
    RobotBase trunk floating {
        inertia_params {
            mass = 5.0
            CoM = (0.1, 0.2, -0.3)
            Ix = 1.0  Iy = 2.0  Iz = 3.0
            Ixy = 0.1  Ixz = -0.2  Iyz = 0.3
            ref_frame = com
        }
        children {
            upper via HFE
            other via HAA
        }
        frames {
            com {
                translation = (0.0, 0.0, 1.0)
                rotation = (PI/2.0, 0.0, 0.0)
            }
        }
    }

    // a hint
    link upper {
        id = 7
        inertia_params {
            mass = m
            CoM = (0.0, 0.0, 0.0)
            Ix = 1.0  Iy = 1.0  Iz = 1.0
            Ixy = 0.0  Ixz = 0.0  Iyz = 0.0
        }
        children {}
        frames {
            foot {
                translation = (len, 0.0, 0.0)
                rotation = (0.0, -tilt, 0.0)
            }
            ^link {
                translation = (0.0, 0.0, 0.0)
                rotation = (0.0, 0.0, 0.0)
            }
        }
    }

    link other {
        id = 0
        children {}
    }

    r_joint HFE {
        ref_frame {
            translation = (0.0, 0.0, -1.0)
            rotation = (0.0, 0.0, 0.0)
        }
    }

    p_joint HAA {
        id = 4
        ref_frame {
            translation = (0.5 len, 0.0, 0.0)
            rotation = (0.0, 0.0, PI)
        }
    }

    // the end
    // of the file
}
)";

std::string text_of(const Vector& v) {
  return language::print(*v[0]) + " " + language::print(*v[1]) + " " + language::print(*v[2]);
}

TEST(Kinematics, TakesASectionOfNoFrames) {
  const Document d = read_robot(
      "Robot R { RobotBase b { children {} frames {} } link l { id = 1 children {} frames { /* none */ } { "
      "f { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } {} } }");
  EXPECT_TRUE(d.links[0].frames.empty());
  ASSERT_EQ(d.links[1].frames.size(), 1u);
  EXPECT_EQ(d.links[1].frames[0].name.text, "f");
  EXPECT_EQ(print(d).find("frames"), print(d).rfind("frames"));  // only those of the link
  EXPECT_TRUE(equal(read_robot(print(d)), d));
}

TEST(Kinematics, ReadsADocument) {
  const Document d = read_robot(kLeg);
  EXPECT_EQ(d.robot.text, "Leg");
  ASSERT_EQ(d.links.size(), 3u);
  const Link& trunk = d.links[0];
  EXPECT_TRUE(trunk.is_base && trunk.floating);
  EXPECT_EQ(trunk.id, std::nullopt);
  ASSERT_TRUE(trunk.inertia.has_value());
  EXPECT_EQ(language::print(*trunk.inertia->mass), "5.0");
  EXPECT_EQ(text_of(trunk.inertia->com), "0.1 0.2 -0.3");
  EXPECT_EQ(text_of({trunk.inertia->ix, trunk.inertia->iy, trunk.inertia->iz}), "1.0 2.0 3.0");
  EXPECT_EQ(text_of({trunk.inertia->ixy, trunk.inertia->ixz, trunk.inertia->iyz}), "0.1 -0.2 0.3");
  ASSERT_TRUE(trunk.inertia->reference.has_value());
  EXPECT_EQ(trunk.inertia->reference->text, "com");
  ASSERT_EQ(trunk.children.size(), 2u);
  EXPECT_EQ(trunk.children[1].link.text, "other");
  EXPECT_EQ(trunk.children[1].joint.text, "HAA");
  ASSERT_EQ(trunk.frames.size(), 1u);
  EXPECT_EQ(trunk.frames[0].name.text, "com");
  EXPECT_EQ(text_of(trunk.frames[0].placement.translation), "0.0 0.0 1.0");
  EXPECT_EQ(text_of(trunk.frames[0].placement.rotation), "PI/2.0 0.0 0.0");

  const Link& upper = d.links[1];
  EXPECT_FALSE(upper.is_base || upper.floating);
  EXPECT_EQ(upper.name.text, "upper");
  EXPECT_EQ(upper.id, 7);
  EXPECT_EQ(upper.inertia->reference, std::nullopt);
  EXPECT_EQ(upper.frames[1].name.text, "link");
  EXPECT_EQ(d.links[2].inertia, std::nullopt);

  ASSERT_EQ(d.joints.size(), 2u);
  EXPECT_EQ(d.joints[0].name.text, "HFE");
  EXPECT_EQ(d.joints[0].type, Joint::Type::revolute);
  EXPECT_EQ(d.joints[0].id, std::nullopt);
  EXPECT_EQ(d.joints[1].type, Joint::Type::prismatic);
  EXPECT_EQ(d.joints[1].id, 4);
  EXPECT_EQ(text_of(d.joints[1].placement.translation), "0.5 len 0.0 0.0");
  EXPECT_EQ(text_of(d.joints[1].placement.rotation), "0.0 0.0 PI");
}

TEST(Kinematics, KnowsWhereThingsStand) {
  const Document d = read_robot(kLeg);
  const auto at = [&](Span span) { return std::string(d.source->text().substr(span.begin, span.end - span.begin)); };
  EXPECT_EQ(at(d.robot.span), "Leg");
  EXPECT_EQ(at(d.links[1].name.span), "upper");
  EXPECT_EQ(at(d.links[1].id_span), "id");
  EXPECT_EQ(at(d.links[1].frames[1].name.span), "^link");
  EXPECT_EQ(at(d.links[2].span), "link other { id = 0 children {} }");
  EXPECT_EQ(at(d.links[0].children[1].joint.span), "HAA");
  EXPECT_EQ(at(d.joints[0].placement.translation[2]->span), "-1.0");
  EXPECT_EQ(at(d.joints[0].placement.span), "{ translation = (0.0, 0.0, -1.0) rotation = (0.0, 0.0, 0.0) }");
  EXPECT_TRUE(at(d.links[0].inertia->span).starts_with("inertia_properties {"));
  EXPECT_TRUE(at(d.links[0].inertia->span).ends_with("com\n    }"));
}

TEST(Kinematics, KeepsComments) {
  const Document d = read_robot(kLeg);
  using Texts = std::vector<std::string>;
  EXPECT_EQ(d.comments, Texts{"// A leg."});
  EXPECT_EQ(d.links[0].comments, Texts{"/* holds it */"});
  EXPECT_EQ(d.links[1].comments, Texts{"// a hint"});  // comments inside an element stay with it
  EXPECT_EQ(d.links[2].comments, Texts{});
  EXPECT_EQ(d.trailing_comments, (Texts{"// the end", "// of the file"}));
}

TEST(Kinematics, PrintsTheCanonicalText) {
  EXPECT_EQ(print(read_robot(kLeg)), kLegInCanonicalForm);
  EXPECT_EQ(print(read_robot(kLegInCanonicalForm)), kLegInCanonicalForm);
}

TEST(Kinematics, ReadsALoneBase) {
  const Document d = read_robot("Robot A { RobotBase base { children {} } }");
  EXPECT_EQ(d.links.size(), 1u);
  EXPECT_EQ(d.joints.size(), 0u);
}

TEST(Kinematics, ReadsElementsInAnyOrder) {
  const Document d = read_robot(
      "Robot A { link b { children {} id=1 }"
      " r_joint j { ref_frame { rotation = (0, 0, 0) translation = (0, 0, 0) } id = 3 }"
      " RobotBase base { frames { f { translation = (0, 0, 0) rotation = (0, 0, 0) } } children { b via j } }"
      " link c { id = 2 children {} } }");
  ASSERT_EQ(d.links.size(), 3u);
  EXPECT_EQ(d.links[0].name.text, "base");  // the base comes first, the others as declared
  EXPECT_EQ(d.links[1].name.text, "b");
  EXPECT_EQ(d.links[2].name.text, "c");
  EXPECT_EQ(d.joints[0].id, 3);
}

TEST(Kinematics, ReadsSeveralBlocksOfFrames) {
  const Document d = read_robot(
      "Robot A { RobotBase base { children {} frames { f { translation = (0, 0, 0) rotation = (0, 0, 0) } }"
      " { g { translation = (0, 0, 0) rotation = (0, 0, 0) } } } }");
  ASSERT_EQ(d.links[0].frames.size(), 2u);
  EXPECT_EQ(d.links[0].frames[1].name.text, "g");
}

TEST(Kinematics, ReadsAnyBlanksAndLineEnds) {
  const std::string text = kLegInCanonicalForm;
  const Document d = read_robot(text);
  std::string crlf, one_line, packed;
  for (char c : print(without_comments(d))) {
    crlf += c == '\n' ? "\r\n" : std::string(1, c);
    one_line += c == '\n' ? ' ' : c;
    packed += c == '\n' ? std::string("\r") : c == ' ' ? std::string("\t") : std::string(1, c);
  }
  for (const std::string& variant : {crlf, one_line, packed, "\xef\xbb\xbf" + crlf})
    EXPECT_TRUE(equal(read_robot(variant), without_comments(d)));
}

TEST(Kinematics, ReadsEscapedKeywordsAsNames) {
  const std::string text =
      "Robot ^Robot { RobotBase ^link { children { ^id via ^via } }"
      " link ^id { id = 1 children {} } r_joint ^via { ref_frame { translation = (^mass, 0, 0)"
      " rotation = (0, 0, 0) } } }";
  const Document d = read_robot(text);
  EXPECT_EQ(d.robot.text, "Robot");
  EXPECT_EQ(d.links[0].children[0].joint.text, "via");
  EXPECT_TRUE(equal(read_robot(print(d)), d));
  EXPECT_EQ(robot_codes("Robot link { RobotBase b { children {} } }"), Codes{"keyword-as-name"});
}

// Documents that differ in one place are not equal.
TEST(Kinematics, TellsDocumentsApart) {
  const Document leg = read_robot(kLeg);
  EXPECT_TRUE(equal(leg, read_robot(kLeg)));
  const std::vector<std::pair<std::string, std::string>> changes = {
      {"Robot Leg", "Robot Arm"},
      {"// A leg.", "// An arm."},
      {"/* holds it */", ""},
      {"floating", ""},
      {"trunk", "body"},
      {"mass = 5.0", "mass = 5.1"},
      {".2, -.3", ".2, .3"},
      {"Iz=3.0", "Iz=3.5"},
      {"Iy=2.0", "Iy=2.5"},
      {"Ix=1.0", "Ix=1.5"},
      {"Ixy=0.1", "Ixy=0.2"},
      {"Ixz=-0.2", "Ixz=0.2"},
      {"Iyz=0.3", "Iyz=0.2"},
      {"ref_frame = com", ""},
      {"ref_frame = com", "ref_frame = moc"},
      {"via HFE", "via HAA"},
      {"other via HAA", ""},
      {"com { trans", "moc { trans"},
      {"rotation = (PI/2.0,", "rotation = (PI/2.5,"},
      {"(0.0, 0.0, 1.0)", "(0.0, 1.0, 1.0)"},
      {"id = 7", "id = 8"},
      {"// a hint", "// an id"},
      {"link other { id = 0", "link another { id = 0"},
      {"id = 0 children", "id = 0 inertia_params { mass=1 CoM=(0,0,0) Ix=0 Iy=0 Iz=0 Ixy=0 Ixz=0 Iyz=0 } children"},
      {"r_joint HFE", "p_joint HFE"},
      {"r_joint HFE", "r_joint KFE"},
      {"id = 4", "id = 5"},
      {"id = 4", ""},
      {"(0.5 len", "(0.5 length"},
      {"0.0, PI)", "0.0, pi)"},
      {"// the end", "// the End"}};
  for (const auto& [from, to] : changes) {
    std::string text = kLeg;
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    EXPECT_FALSE(equal(read_robot(text.replace(at, from.size(), to)), leg)) << from << " to " << to;
  }
  EXPECT_TRUE(equal(without_comments(leg), without_comments(read_robot(kLegInCanonicalForm))));
  EXPECT_FALSE(equal(without_comments(leg), leg));
}

// The damping behind an elastic block is that of the joint, and names of tendons may be words of their items.
TEST(Kinematics, ReadsElasticJointsAndTendons) {
  const std::string text =
      "Robot R { RobotBase base { children {} } r_joint j { ref_frame { translation = (0, 0, 0) rotation = (0, 0, 0) } "
      "elastic { stiffness = 2.0 damping = 3.0 } damping = 4.0 armature = 5.0 } "
      "tendons { rest { length = j stiffness = 6.0 } length { length = 7.0 j damping = 8.0 rest = 9.0 } } }";
  const Document robot = read_robot(text);
  const Joint& joint = robot.joints.at(0);
  ASSERT_TRUE(joint.elasticity && joint.elasticity->damping);
  EXPECT_EQ(language::print(*joint.elasticity->damping) + language::print(*joint.drive.damping), "3.04.0");
  ASSERT_EQ(robot.tendons.size(), 2U);
  EXPECT_EQ(robot.tendons[1].name.text, "length");
  EXPECT_TRUE(equal(read_robot(print(robot)), robot));
  for (const char digit : {'2', '3', '4', '5', '6', '7', '8', '9'}) {
    std::string other = text;
    other[other.find(digit)] = '1';
    EXPECT_FALSE(equal(read_robot(other), robot)) << digit;
  }
}

// One file with errors of several kinds: each is reported once, and nothing else.
TEST(Kinematics, TellsAllErrorsOfAFileAndNoOthers) {
  std::string text = kLeg;
  const auto change = [&](const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
  };
  change("mass = 5.0", "mas = 5.0");
  change("Iyz=0.3", "Iyz=");
  change("other via HAA", "other HAA");
  change("(PI/2.0, 0.0, 0.0)", "(PI/2.0, 0.0)");
  change("id = 7", "id = x");
  change("foot {", "foot");
  change("link other", "lnk other");
  change("p_joint HAA", "p_joint");
  EXPECT_EQ(
      robot_codes(text), (Codes{
                             "unknown-item", "unexpected-token", "unexpected-token", "component-count", "bad-id",
                             "unexpected-token", "unknown-element", "unexpected-token"}));
}

TEST(Kinematics, MayBePrintedAfterErrors) {
  for (const char* text :
       {"", "Robot", "Robot A {", "Robot A { RobotBase b { inertia_params { mass = 1.0 } children {} } }",
        "Robot A { RobotBase b { frames { f { } } children {} } link c { id = 1 } }",
        "Robot A { r_joint j { ref_frame { translation = (0.0, 0.0, 0.0) } } }"}) {
    Diagnostics diagnostics;
    const Document document = parse(test::source(text), diagnostics);
    EXPECT_TRUE(diagnostics.has_errors()) << text;
    EXPECT_FALSE(print(document).empty());
  }
}

}  // namespace
}  // namespace robcogen::language::kinematics::kinematics_test
