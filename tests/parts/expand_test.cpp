// The plain document that a document with parts expands to.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "import/kinematics.h"
#include "import/parts.h"

namespace robcogen::expand_test {
namespace {

namespace kinematics = language::kinematics;

constexpr const char* kBase =
    "inertia_params { mass = 10.0 CoM = (0.0, 0.0, 0.0) Ix = 1.0 Iy = 1.0 Iz = 1.0 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 }";

constexpr const char* kFinger = R"(
Part Finger(length[0.1], weight) {
    root knuckle via bend
    link knuckle {
        inertia_params {
            mass = weight
            CoM = (0.5 length, 0.01, 0.02)
            Ix = 1.0  Iy = 1.0  Iz = 1.0
            Ixy = 0.1  Ixz = 0.2  Iyz = 0.3
            ref_frame = fr_middle
        }
        children { nail via slide }
        frames { fr_middle { translation = (length/2.0, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) } }
    }
    link nail { children {}  frames { tip { translation = (0.0, length, 0.0)  rotation = (PI/2.0, 0.0, 0.0) } } }
    r_joint bend {
        ref_frame { translation = (0.0, 0.0, 0.2)  rotation = (0.0, PI/2.0, 0.0) }
        limits { position = (-0.1, 1.5) }
        spring { stiffness = 2.0  rest = 0.3 }
    }
    p_joint slide { ref_frame { translation = (length, 0.0, 0.0)  rotation = (0.0, 0.0, PI/4.0) } }
    couplings { slide = 0.1 m/rad * bend + 0.01 }
}
)";

std::optional<kinematics::Document> read(const std::string& text, Diagnostics& diagnostics) {
  const auto read = import::robot_document(std::make_shared<Source>("test.kindsl", text), {}, diagnostics);
  return read ? std::optional(read->document) : std::nullopt;
}

std::string plain(const std::string& text) {
  Diagnostics diagnostics;
  const auto document = read(text, diagnostics);
  EXPECT_TRUE(document.has_value()) << diagnostics.render();
  return document ? kinematics::print(*document) : "";
}

std::string hand(const std::string& children) {
  return std::string(kFinger) + "Robot Hand { RobotBase palm { " + kBase + " children { " + children + " } } }";
}

// Returns the text of an element of the printed document.
std::string element(const std::string& document, const std::string& head) {
  const std::size_t begin = document.find("    " + head + " {\n");
  if (begin == std::string::npos) return "no " + head;
  return document.substr(begin, document.find("\n    }\n", begin) + 7 - begin);
}

TEST(PlainDocument, HasTheNamesOfInstancesAndTheirArguments) {
  const std::string document =
      plain(hand("Finger a(weight = 2.0) at { translation = (1.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } Finger "
                 "b(weight = 0.5 m0, "
                 "length = 0.3)"));
  EXPECT_EQ(element(document, "link a_knuckle"), R"(    link a_knuckle {
        id = 1
        inertia_params {
            mass = 2.0
            CoM = (0.05, 0.01, 0.02)
            Ix = 1.0  Iy = 1.0  Iz = 1.0
            Ixy = 0.1  Ixz = 0.2  Iyz = 0.3
            ref_frame = fr_a_middle
        }
        children {
            a_nail via a_slide
        }
        frames {
            fr_a_middle {
                translation = (0.05, 0.0, 0.0)
                rotation = (0.0, 0.0, 0.0)
            }
        }
    }
)");
  EXPECT_NE(
      element(document, "link b_knuckle").find("mass = 0.5 m0\n            CoM = (0.15, 0.01"), std::string::npos);
  EXPECT_NE(element(document, "r_joint a_bend").find("translation = (1.0, 0.0, 0.2)"), std::string::npos);
  EXPECT_NE(element(document, "link b_nail").find("id = 4"), std::string::npos);
  EXPECT_NE(document.find("        a_slide = 0.1 m/rad * a_bend + 0.01\n"), std::string::npos) << document;
}

TEST(PlainDocument, ReflectsEveryClause) {
  const std::string mirrored = plain(hand("Finger a(weight = 2.0) mirrored y"));
  EXPECT_NE(mirrored.find("CoM = (0.05, 0.01, -0.02)"), std::string::npos) << mirrored;
  EXPECT_NE(mirrored.find("Ixy = 0.1  Ixz = -0.2  Iyz = -0.3"), std::string::npos) << mirrored;
  EXPECT_NE(mirrored.find("limits { position = (-0.1, 1.5) }"), std::string::npos) << mirrored;

  const std::string same = plain(hand("Finger a(weight = 2.0) mirrored y same sense"));
  EXPECT_NE(same.find("CoM = (0.05, -0.01, 0.02)"), std::string::npos) << same;
  EXPECT_NE(same.find("Ixy = -0.1  Ixz = 0.2  Iyz = -0.3"), std::string::npos) << same;
  EXPECT_NE(same.find("limits { position = (-1.5, 0.1) }"), std::string::npos) << same;
  EXPECT_NE(same.find("spring { stiffness = 2.0 rest = -0.3 }"), std::string::npos) << same;
  EXPECT_NE(same.find("a_slide = -0.1 m/rad * a_bend + 0.01"), std::string::npos) << same;
  // The axis of the joint is in the mirror plane, so its frame does not change.
  EXPECT_EQ(
      element(same, "r_joint a_bend").substr(0, 140),
      element(plain(hand("Finger a(weight = 2.0)")), "r_joint a_bend").substr(0, 140));
}

TEST(PlainDocument, KeepsParametersOfTheRobot) {
  const std::string document = plain(hand(
      "Finger a(weight = m0, length = 2.0 reach) at { translation = (reach, 0.0, 0.0) rotation = (tilt, 0.0, 0.0) } "
      "mirrored x"));
  EXPECT_NE(document.find("mass = m0\n            CoM = (reach, 0.01, -0.02)"), std::string::npos) << document;
  EXPECT_NE(document.find("translation = (reach, "), std::string::npos) << document;
  EXPECT_NE(document.find("rotation = (tilt, PI/2.0, 0.0)"), std::string::npos) << document;
  Diagnostics diagnostics;
  const auto tree = import::kinematic_tree(
      kinematics::parse(std::make_shared<Source>("test.kindsl", document), diagnostics), diagnostics);
  ASSERT_TRUE(tree.has_value()) << diagnostics.render();
  EXPECT_EQ(tree->parameters.size(), 3u);
}

TEST(PlainDocument, NestsPartsInParts) {
  const std::string document = plain(
      std::string(kFinger) +
      "Part Arm(m) { root upper via shoulder link upper { children { Finger thumb(weight = m) at { translation = (0.5, "
      "0.0, "
      "0.0) rotation = (0.0, 0.0, 0.0) } } } r_joint shoulder { ref_frame { translation = (0.0, 0.0, 0.0) rotation = "
      "(0.0, 0.0, 0.0) } } } Robot Ape { RobotBase chest { " +
      kBase + " children { Arm left(m = 3.0) head via neck } } link head { id = 7 " + kBase +
      " children {} } r_joint neck { ref_frame { translation = (0.0, 0.0, 1.0) rotation = (0.0, 0.0, 0.0) } } }");
  // The robot's own links come first.
  EXPECT_LT(document.find("link head"), document.find("link left_upper"));
  EXPECT_NE(element(document, "link left_upper").find("id = 8"), std::string::npos);
  EXPECT_NE(element(document, "link left_thumb_knuckle").find("mass = 3.0"), std::string::npos) << document;
  EXPECT_NE(document.find("fr_left_thumb_middle"), std::string::npos) << document;
  EXPECT_NE(element(document, "r_joint left_thumb_bend").find("translation = (0.5, 0.0, 0.2)"), std::string::npos);
}

TEST(PlainDocument, HasTheCouplingsOfLoopsForEachInstance) {
  const auto couplings = [](const std::string& document) {
    const std::size_t begin = document.find("    couplings {\n") + 16;
    return document.substr(begin, document.find("    }\n", begin) - begin);
  };
  const std::string arm =
      "Part Arm { root upper via shoulder link upper { children { Finger a(weight = 1.0) Finger b(weight = 1.0) } } "
      "r_joint shoulder { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } couplings { for "
      "finger in { a, b } { finger.bend = 2.0 * shoulder + finger.slide * 1.0 rad/m } } }\n";
  std::string finger = kFinger;
  finger.erase(finger.find("    couplings"), finger.rfind('}') - finger.find("    couplings"));
  const std::string document = plain(
      finger + arm + "Robot Ape { RobotBase chest { " + kBase +
      " children { Arm left() Arm right() mirrored y same sense } } couplings { right.shoulder = -0.5 left.shoulder } "
      "}");
  EXPECT_EQ(
      couplings(document),
      "        right_shoulder = -0.5 left_shoulder\n"
      "        left_a_bend = 2.0 left_shoulder + left_a_slide * 1.0 * rad/m\n"
      "        left_b_bend = 2.0 left_shoulder + left_b_slide * 1.0 * rad/m\n"
      "        right_a_bend = 2.0 right_shoulder - right_a_slide * 1.0 * rad/m\n"
      "        right_b_bend = 2.0 right_shoulder - right_b_slide * 1.0 * rad/m\n");
  // Prefixes of other names can serve as instances.
  Diagnostics diagnostics;
  const auto tree = import::kinematic_tree(
      *read(
          "Robot R { RobotBase base { children { a via l_j b via r_j c via m } } link a { id = 1 children {} } link b "
          "{ "
          "id = 2 children {} } link c { id = 3 children {} } r_joint l_j { ref_frame { translation = (0.0, 0.0, 0.0) "
          "rotation = (0.0, 0.0, 0.0) } } r_joint r_j { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, "
          "0.0, "
          "0.0) } } r_joint m { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } couplings { "
          "for "
          "s in { l, r } { s.j = 2.0 * m } } }",
          diagnostics),
      diagnostics);
  ASSERT_TRUE(tree.has_value()) << diagnostics.render();
  EXPECT_EQ(tree->couplings.size(), 2u);
}

TEST(PlainDocument, IsPlain) {
  for (const char* robot : {"quadruped", "quadruped_fixed", "hexapod", "centaur", "humanoid"}) {
    const auto file = std::filesystem::path(ROBCOGEN_SOURCE_DIR) / "robots" / robot / (std::string(robot) + ".kindsl");
    std::ifstream stream(file, std::ios::binary);
    Diagnostics diagnostics;
    const auto source =
        std::make_shared<Source>(file.string(), std::string(std::istreambuf_iterator<char>(stream), {}));
    const auto read = import::robot_document(source, {}, diagnostics);
    ASSERT_TRUE(read.has_value()) << diagnostics.render();
    const std::string text = kinematics::print(read->document);
    EXPECT_EQ(plain(text), text);
    EXPECT_GT(
        std::count(text.begin(), text.end(), '\n'), 2 * std::count(source->text().begin(), source->text().end(), '\n'));
    const auto tree = import::kinematic_tree(read->document, diagnostics);
    EXPECT_TRUE(tree.has_value()) << diagnostics.render();
    EXPECT_TRUE(diagnostics.all().empty()) << diagnostics.render();
  }
}

TEST(PlainDocument, RememberWherePartsAreWrittenAndWhoMetThem) {
  Diagnostics diagnostics;
  const auto document = read(hand("Finger a(weight = 2.0)"), diagnostics);
  ASSERT_TRUE(document.has_value()) << diagnostics.render();
  const kinematics::Name& name = document->links.at(1).name;
  const Place place = written_at({document->source, name.span});
  EXPECT_EQ(place.source->name(), "test.kindsl");
  EXPECT_EQ(place.source->text().substr(place.span.begin, place.span.end - place.span.begin), "knuckle");
  const Source::Use* use = document->source->use_at(name.span.begin);
  ASSERT_NE(use, nullptr);
  EXPECT_EQ(use->note, "'Finger' is attached as 'a' here");
}

}  // namespace
}  // namespace robcogen::expand_test
