// The desired-transforms language: every spelling, its canonical text, and the comparison of documents.
#include "language/desired/document.h"

#include "reading.h"

namespace robcogen::language::desired::desired_test {
namespace {

using test::Codes;
using test::desired_codes;
using test::read_desired;

std::string text_of(const std::vector<Pair>& pairs) {
  std::string text;
  for (const Pair& pair : pairs) text += (text.empty() ? "" : " ") + pair.left.text + "_X_" + pair.right.text;
  return text;
}

std::string transforms(const std::string& pairs) {
  return text_of(read_desired("Robot R Frames { } Transforms { " + pairs + " }").transforms);
}

TEST(Desired, ReadsEverySpellingOfAPair) {
  for (const char* pair :
       {"base=A, target=B", "base = A target = B", "target=B, base=A", "target=B base=A", "left=A, right=B",
        "left_frame=A, right_frame=B", "right_frame=B left_frame=A", "base=A right=B", "right = B, left_frame = A",
        "left=A target=B", "A <- B", "B -> A", "A<-B", "B->A"}) {
    EXPECT_EQ(transforms(pair), "A_X_B") << pair;
  }
}

TEST(Desired, ReadsPairsInARow) {
  EXPECT_EQ(transforms("A <- B  C -> D base=E target=F G<-H"), "A_X_B D_X_C E_X_F G_X_H");
  EXPECT_EQ(transforms(""), "");
}

TEST(Desired, ReadsEverySpellingOfADocument) {
  for (const char* text :
       {"Robot R Frames { A, B, C } Transforms { A <- B } Jacobians { base=A target=C }",
        "Model R Frames { A B C } Transforms { A <- B } Jacobians { base=A target=C }",
        "\xef\xbb\xbfRobot R\r\nFrames { , A\r\n , B\r\n C }\r\nTransforms { A <- B }\r\nJacobians { C -> A }\r\n",
        "Robot R Transforms { A <- B } Jacobians { A <- C } Frames { A B C }"}) {
    const Document d = read_desired(text);
    EXPECT_EQ(d.robot.text, "R");
    ASSERT_EQ(d.frames.size(), 3u) << text;
    EXPECT_EQ(d.frames[2].text, "C");
    EXPECT_EQ(text_of(d.transforms), "A_X_B");
    EXPECT_EQ(text_of(d.jacobians), "A_X_C");
  }
}

// `Contacts`, `point` and `surface` may be names of frames.
TEST(Desired, ReadsContacts) {
  const auto contacts = [](const std::string& text) {
    std::string found;
    for (const Contact& c : read_desired("Robot R Frames { Contacts } Transforms { } " + text).contacts)
      found += c.frame.text + (c.is_surface ? "* " : " ");
    return found;
  };
  EXPECT_EQ(contacts("Contacts { A, point B surface C, surface, point }"), "A B C* surface point ");
  EXPECT_EQ(contacts("Contacts { surface surface, point point, Contacts }"), "surface* point Contacts ");
  EXPECT_EQ(contacts("Contacts { }"), "");
  EXPECT_EQ(contacts(""), "");
  EXPECT_EQ(desired_codes("Robot R Frames { } Transforms { } Contacts { A } Contacts { B }"), Codes{"duplicate-item"});
  EXPECT_EQ(desired_codes("Robot R Frames { } Transforms { } Contacts { A, }"), Codes{"unexpected-token"});
}

// The words of tasks may be names of frames.
TEST(Desired, ReadsInverseKinematics) {
  const auto inverses = [](const std::string& text) {
    const Document document = read_desired("Robot R Frames { } Transforms { } InverseKinematics {" + text + "}");
    std::string found;
    for (const Inverse& i : document.inverses) {
      found += i.pair.left.text + "_X_" + i.pair.right.text;
      found += i.task == Inverse::Task::point ? " point" : i.task == Inverse::Task::axis ? " axis" : "";
      found += i.task == Inverse::Task::swivel ? " swivel" : "";
      found += i.task == Inverse::Task::given ? " " + i.given.text : "";
      found += (i.tolerance ? " " + std::to_string(*i.tolerance) : "") + ";";
    }
    return found;
  };
  EXPECT_EQ(inverses("base = A, target = B"), "A_X_B;");
  EXPECT_EQ(inverses("base = A, target = B point A <- C, axis D -> A given J7"), "A_X_B point;A_X_C axis;A_X_D J7;");
  EXPECT_EQ(
      inverses("A <- B  point <- axis point  given <- A  swivel <- B, swivel"),
      "A_X_B;point_X_axis point;given_X_A;swivel_X_B swivel;");
  EXPECT_EQ(inverses(""), "");
  EXPECT_EQ(
      inverses("A <- B tolerance = 1e-3  A <- C, given J7, tolerance = 0.5  A -> tolerance, tolerance = -1"),
      "A_X_B 0.001000;A_X_C J7 0.500000;tolerance_X_A -1.000000;");
  const std::string before = "Robot R Frames { } Transforms { } InverseKinematics ";
  EXPECT_EQ(desired_codes(before + "{ A <- B tolerance = small }"), Codes{"unexpected-token"});
  EXPECT_EQ(desired_codes(before + "{ A <- B tolerance = 1e-3 point }"), Codes{"unexpected-token"});
  EXPECT_EQ(desired_codes(before + "{ A <- B given }"), Codes{"unexpected-token"});
  EXPECT_EQ(desired_codes(before + "{ A <- B, C <- D }"), Codes{"unexpected-token"});
  EXPECT_EQ(desired_codes(before + "{ } InverseKinematics { }"), Codes{"duplicate-item"});
}

constexpr const char* kList = R"(/* of a leg */
Robot Leg

Frames {
    fr_base,
    ^base
}

Transforms {
    base = fr_base, target = ^base
    base = ^base, target = fr_base
}

Jacobians {
    base = fr_base, target = ^base
}

Contacts {
    point fr_base,
    surface ^base
}

InverseKinematics {
    base = fr_base, target = ^base
    base = fr_base, target = hand, point
    base = fr_base, target = nozzle, axis
    base = fr_base, target = tool, given J7, tolerance = 0.001
}

Functions {
    control = bias_forces + jacobians.fr_base_J_tip
}
)";

TEST(Desired, PrintsTheCanonicalText) {
  EXPECT_EQ(
      print(read_desired("Model Leg Frames{fr_base ^base}Transforms{fr_base <- ^base fr_base->^base}\n"
                         "/* of a leg */ Jacobians{right=^base left=fr_base}Contacts{fr_base surface ^base}"
                         "InverseKinematics{fr_base <- ^base fr_base <- hand point  fr_base <- nozzle axis "
                         "base=fr_base target=tool given J7 tolerance=1e-3}"
                         "Functions{control=bias_forces+jacobians::fr_base_J_tip}")),
      kList);
  EXPECT_EQ(print(read_desired(kList)), kList);
  EXPECT_EQ(print(read_desired("Robot A Frames {} Transforms {}")), "Robot A\n\nFrames {\n}\n\nTransforms {\n}\n");
}

TEST(Desired, KnowsWhereThingsStand) {
  const Document d = read_desired("Robot R Frames { fr_a } Transforms { target=B, base=A  C -> D }");
  const auto at = [&](Span span) { return std::string(d.source->text().substr(span.begin, span.end - span.begin)); };
  EXPECT_EQ(at(d.robot.span), "R");
  EXPECT_EQ(at(d.frames[0].span), "fr_a");
  EXPECT_EQ(at(d.transforms[0].span), "target=B, base=A");
  EXPECT_EQ(at(d.transforms[0].left.span), "A");
  EXPECT_EQ(at(d.transforms[1].span), "C -> D");
  EXPECT_EQ(at(d.transforms[1].left.span), "D");
}

TEST(Desired, TellsDocumentsApart) {
  const Document list = read_desired(kList);
  EXPECT_TRUE(equal(list, read_desired(kList)));
  const std::vector<std::pair<std::string, std::string>> changes = {
      {"of a leg", "of an arm"},
      {"Leg", "Arm"},
      {"    fr_base,\n", ""},
      {"fr_base,\n", "fr_tip,\n"},
      {"target = ^base\n", "target = tip\n"},
      {"base = ^base, target = fr_base\n", ""},
      {"Jacobians {\n    base = fr_base, target = ^base\n}", ""},
      {"surface", "point"},
      {"point fr_base", "point fr_tip"},
      {"control", "estimate"},
      {"bias_forces + ", ""},
      {"_J_tip", "_J_base"}};
  for (const auto& [from, to] : changes) {
    std::string text = kList;
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    EXPECT_FALSE(equal(read_desired(text.replace(at, from.size(), to)), list)) << from << " to " << to;
  }
}

TEST(Desired, ReadsLoopsAndPrintsThem) {
  const std::string plain = R"(Robot Leg

Frames {
    fr_base,
    for side in { left, ^base } {
        side.tip,
        side.tap
    },
    for,
    in
}

Transforms {
    for side in { left, right, LF } {
        base = ^base, target = side.tip
        base = side.tip, target = left.tip
    }
    base = for, target = in
    for side in { left } {
        base = ^base, target = side.tip
    }
}

Contacts {
    for leg in { LF } {
        surface leg.tip
    }
}

InverseKinematics {
    for leg in { LF } {
        base = ^base, target = leg.tip, point
    }
}
)";
  const Document list = read_desired(plain);
  EXPECT_EQ(print(list), plain);
  ASSERT_EQ(list.loops.size(), 5u);
  EXPECT_EQ(list.loops[1].instances.size(), 3u);
  EXPECT_EQ(list.transforms[0].right.instance, "side");
  EXPECT_EQ(list.transforms[2].left.loop, Name::kNoLoop);
  for (const auto& [from, to] :
       {std::pair("left, right", "left, wrong"), {"side.tap", "other.tap"}, {"LF }", "RF }"}}) {
    std::string changed = plain;
    changed.replace(changed.find(from), std::string(from).size(), to);
    EXPECT_FALSE(equal(read_desired(changed), list)) << from;
  }
}

TEST(Desired, TellsAllErrorsOfAFileAndNoOthers) {
  EXPECT_EQ(
      desired_codes("Robot R Frames { A, , B } Transforms { base=A targt=B  A <- B  base=A base=B  A B  C -> D }"
                    " Jacobins { } Jacobians { base A  A <- }"),
      (Codes{
          "unexpected-token", "unexpected-token", "unexpected-token", "unexpected-token", "unexpected-token",
          "unexpected-token", "unexpected-token"}));
}

TEST(Desired, MayBePrintedAfterErrors) {
  for (const char* text : {"", "Robot", "Robot R Frames {", "Robot R Frames { A } Transforms { A <-"}) {
    Diagnostics diagnostics;
    const Document document = parse(test::source(text), diagnostics);
    EXPECT_TRUE(diagnostics.has_errors()) << text;
    EXPECT_FALSE(print(document).empty());
  }
}

}  // namespace
}  // namespace robcogen::language::desired::desired_test
