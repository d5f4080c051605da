// Extreme input is read or refused in bounded time and memory.
#include <sstream>

#include "reading.h"

namespace robcogen::extremes_test {
namespace {

using test::Codes;
using test::desired_codes;
using test::robot_codes;

std::string repeated(const std::string& text, int times) {
  std::string result;
  result.reserve(text.size() * static_cast<std::size_t>(times));
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

std::string robot_with_rotation(const std::string& expression) {
  return "Robot A { RobotBase b { children {} } r_joint j { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (" +
         expression + ", 0.0, 0.0) } } }";
}

TEST(Extremes, ALineOfTenMegabytes) {
  const std::string blanks = repeated(" ", 10'000'000);
  EXPECT_EQ(robot_codes("Robot A {" + blanks + "RobotBase b { children {} } }"), Codes{});
  Diagnostics diagnostics;
  language::kinematics::parse(
      test::source("Robot A {" + blanks + "RobotBase b { childen {} }" + blanks + "}"), diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(
      diagnostics.render(),
      "test:1:10000024: error: expected 'inertia_params', 'inertia_properties', 'children', 'frames' or '}' in base "
      "'b', found 'childen' [unknown-item]\n    …" +
          std::string(66, ' ') + "RobotBase b { childen {} }" + std::string(68, ' ') + "…\n     " +
          std::string(80, ' ') + "^~~~~~~\nhint: did you mean 'children'?\n");
}

TEST(Extremes, ANameOfTenMegabytes) {
  EXPECT_EQ(
      robot_codes("Robot " + repeated("a", 10'000'000) + " { RobotBase b { children {} } }"), Codes{"name-too-long"});
}

TEST(Extremes, ANumberOfAMillionDigits) {
  const std::string digits = repeated("7", 1'000'000);
  EXPECT_EQ(robot_codes(robot_with_rotation(digits)), Codes{"number-too-large"});
  EXPECT_EQ(robot_codes(robot_with_rotation("0." + digits)), Codes{});
}

TEST(Extremes, ACommentOfTenMegabytes) {
  EXPECT_EQ(robot_codes("Robot A { /*" + repeated("*", 10'000'000) + "*/ RobotBase b { children {} } }"), Codes{});
}

TEST(Extremes, NestingOfTenThousandLevels) {
  const int deep = 10'000;
  EXPECT_EQ(
      robot_codes(robot_with_rotation(repeated("(", deep) + "1.0" + repeated(")", deep))), Codes{"nesting-too-deep"});
  EXPECT_EQ(robot_codes(robot_with_rotation(repeated("-", deep) + "a")), Codes{"nesting-too-deep"});
  EXPECT_EQ(
      robot_codes(robot_with_rotation(repeated("sin(", deep) + "a" + repeated(")", deep))), Codes{"nesting-too-deep"});
  EXPECT_EQ(robot_codes(repeated("{", deep)), Codes{"unexpected-token"});
  EXPECT_EQ(
      robot_codes("Robot A { RobotBase b { children {} } x " + repeated("{", deep) + repeated("}", deep) + " }"),
      Codes{"unknown-element"});
  EXPECT_EQ(desired_codes("Robot A Frames " + repeated("{", deep)), Codes{"unexpected-token"});
}

TEST(Extremes, HalfAMillionErrors) {
  Diagnostics diagnostics;
  language::kinematics::parse(
      test::source("Robot A { RobotBase b { children {} } " + repeated("lnk x {} ", 500'000) + "}"), diagnostics);
  EXPECT_EQ(diagnostics.error_count(), 500'000u);
  EXPECT_TRUE(diagnostics.render().ends_with("… and 499900 more errors\n"));
  EXPECT_LT(diagnostics.render().size(), 100'000u);
}

// Every byte, inserted at positions all over a document.
TEST(Extremes, EveryByte) {
  const std::string robot = robot_with_rotation("0.5 PI");
  for (int byte = 0; byte < 256; ++byte) {
    for (std::size_t at = 0; at <= robot.size(); at += 3) {
      std::string text = robot;
      text.insert(at, 1, static_cast<char>(byte));
      Diagnostics diagnostics;
      const auto document = language::kinematics::parse(test::source(text), diagnostics);
      if (!diagnostics.has_errors()) {
        EXPECT_TRUE(equal(document, test::read_robot(print(document)))) << text;
      }
      EXPECT_LT(diagnostics.all().size(), 6u) << text << "\n" << diagnostics.render();
    }
  }
}

// Every proper prefix of a document is refused, with few messages.
TEST(Extremes, EveryBeginning) {
  const std::string robot = robot_with_rotation("-PI/2.0");
  for (std::size_t length = 0; length < robot.size(); ++length) {
    Diagnostics diagnostics;
    language::kinematics::parse(test::source(robot.substr(0, length)), diagnostics);
    EXPECT_TRUE(diagnostics.has_errors()) << robot.substr(0, length);
    EXPECT_LE(diagnostics.all().size(), 2u) << diagnostics.render();  // the end, and a truncated word before it
  }
  const std::string list = "Robot R Frames { a, b } Transforms { base=a, target=b a <- b }";
  for (std::size_t length = 0; length < list.size(); ++length) {
    Diagnostics diagnostics;
    language::desired::parse(test::source(list.substr(0, length)), diagnostics);
    EXPECT_TRUE(diagnostics.has_errors()) << list.substr(0, length);
    EXPECT_LE(diagnostics.all().size(), 2u) << diagnostics.render();
  }
}

// An optimised build reads a hundred thousand in a second; quadratic work would not end.
TEST(Extremes, ManyLinks) {
  constexpr int links = ROBCOGEN_TEST_EVERYTHING ? 100'000 : 20'000;
  std::ostringstream text;
  text << "Robot Chain { RobotBase base { children { l0 via j0 } }\n";
  for (int i = 0; i < links; ++i) {
    text << "link l" << i << " { id = " << i
         << "\n inertia_params { mass = 1.25 CoM = (0.1, -0.2, 0.3) Ix=0.1 Iy=0.1 Iz=0.1 Ixy=0.0 Ixz=0.0 Iyz=0.0 }\n"
         << " children { ";
    if (i + 1 < links) text << "l" << i + 1 << " via j" << i + 1;
    text << " } } // link " << i << "\nr_joint j" << i
         << " { ref_frame { translation = (0.0, 0.0, 0.5) rotation = (PI/2.0, 0.0, 0.0) } }\n";
  }
  text << "}\n";
  const auto source = test::source(text.str());
  Diagnostics diagnostics;
  const auto document = language::kinematics::parse(source, diagnostics);
  EXPECT_TRUE(diagnostics.all().empty());
  EXPECT_EQ(document.joints.size(), static_cast<std::size_t>(links));
}

}  // namespace
}  // namespace robcogen::extremes_test
