// Documents of motions and of coordinate transforms: their meaning, which stays the same if the model is written as a
// document and read back.
#include "import/frames.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

#include "export/frames.h"
#include "reading.h"

namespace robcogen::frames_test {
namespace {

using model::CoordinateTransform;
using model::MotionConvention;
using model::MovedFramePosition;
using model::RigidMotions;

// Products of about a dozen rotations and shifts of a few metres.
constexpr double kTolerance = 1e-13;

RigidMotions motions_of(const std::string& text) {
  Diagnostics diagnostics;
  const auto document = language::motion::parse(std::make_shared<Source>("test.motdsl", text), diagnostics);
  const auto motions = import::rigid_motions(document, diagnostics);
  EXPECT_TRUE(motions.has_value()) << diagnostics.render() << text;
  return motions.value_or(RigidMotions());
}

model::CoordinateTransforms transforms_of(const std::string& text) {
  Diagnostics diagnostics;
  const auto document = language::transforms::parse(std::make_shared<Source>("test.ctdsl", text), diagnostics);
  const auto transforms = import::coordinate_transforms(document, diagnostics);
  EXPECT_TRUE(transforms.has_value()) << diagnostics.render() << text;
  return transforms.value_or(model::CoordinateTransforms());
}

Eigen::Isometry3d primitive(const model::PrimitiveTransform& p, double amount) {
  const Eigen::Vector3d unit = Eigen::Vector3d::Unit(static_cast<int>(p.axis));
  return p.rotation ? Eigen::Isometry3d(Eigen::AngleAxisd(amount, unit))
                    : Eigen::Isometry3d(Eigen::Translation3d(amount * unit));
}

Eigen::Isometry3d value(
    const CoordinateTransform& transform,
    MovedFramePosition position,
    const std::vector<double>& parameters,
    const std::vector<double>& variables) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  for (const model::PrimitiveTransform& p : transform.primitives) {
    const Eigen::Isometry3d right = primitive(p, evaluate(p.amount, parameters, variables));
    result = result * (position == MovedFramePosition::right ? right : right.inverse());
  }
  return result;
}

// All sequences of three axes in which neighbours differ: six with three different axes, six with two.
std::vector<std::string> sequences() {
  std::vector<std::string> result;
  for (const char a : {'x', 'y', 'z'})
    for (const char b : {'x', 'y', 'z'})
      for (const char c : {'x', 'y', 'z'})
        if (a != b && b != c) result.push_back({a, b, c});
  return result;
}

Eigen::Matrix3d about(char axis, double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis - 'x')).toRotationMatrix();
}

std::string document_of_sequences(const std::string& convention) {
  std::string text = "Model Euler\nConvention = " + convention + "\n";
  for (const std::string& s : sequences())
    text += "S -> E" + s + " : rot" + s[0] + "(a) rot" + s[1] + "(b) rot" + s[2] + "(c)\n";
  return text;
}

// Turns about moved axes multiply on the right, turns about fixed axes on the left.
TEST(EulerSequences, AreRotationsAboutMovedOrFixedAxes) {
  ASSERT_EQ(sequences().size(), 12u);
  const std::vector<double> angles = {0.7, -1.1, 2.3};
  for (const std::string convention : {"local", "fixed"}) {
    const RigidMotions motions = motions_of(document_of_sequences(convention));
    for (const std::string& s : sequences()) {
      const Eigen::Matrix3d first = about(s[0], angles[0]), second = about(s[1], angles[1]),
                            third = about(s[2], angles[2]);
      const Eigen::Matrix3d expected =
          convention == "local" ? Eigen::Matrix3d(first * second * third) : Eigen::Matrix3d(third * second * first);
      for (const auto position : {MovedFramePosition::left, MovedFramePosition::right}) {
        const auto there = model::transform_between(motions, "S", "E" + s, position);
        const auto back = model::transform_between(motions, "E" + s, "S", position);
        ASSERT_TRUE(there && back);
        EXPECT_TRUE(value(*there, position, {}, angles).linear().isApprox(expected, kTolerance)) << convention << s;
        EXPECT_TRUE(value(*back, position, {}, angles).linear().isApprox(expected.transpose(), kTolerance))
            << convention << s;
      }
    }
  }
}

// Roll, pitch and yaw about fixed axes are yaw, pitch and roll about moved ones.
TEST(EulerSequences, AboutFixedAxesAreThoseAboutMovedAxesBackwards) {
  const RigidMotions fixed = motions_of(document_of_sequences("fixed"));
  const RigidMotions local = motions_of(document_of_sequences("local"));
  for (const std::string& s : sequences()) {
    const std::string reversed(s.rbegin(), s.rend());
    const auto one = model::transform_between(fixed, "S", "E" + s);
    const auto other = model::transform_between(local, "S", "E" + reversed);
    EXPECT_TRUE(value(*one, MovedFramePosition::right, {}, {0.7, -1.1, 2.3})
                    .isApprox(value(*other, MovedFramePosition::right, {}, {2.3, -1.1, 0.7}), kTolerance))
        << s;
  }
}

TEST(FrameDocuments, TellVariablesFromParameters) {
  const RigidMotions motions = motions_of(
      "Model M Params lengths { l, unused } Convention = local "
      "A -> B : trx(l) try(lengths.l) roty(q) trz(2*p:h[0.5]) rotx(p:t) rotz(x[1.0]) trz(c:k:0.25) trz(q)");
  ASSERT_EQ(motions.parameters.size(), 5u);
  const std::vector<std::string> names = {"l", "unused", "h", "t", "x"};
  for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(motions.parameters[i].name, names[i]);
  EXPECT_EQ(motions.parameters[2].default_value, 0.5);
  EXPECT_EQ(motions.parameters[3].kind, model::ParameterKind::angle);
  EXPECT_EQ(motions.variables, (std::vector<std::string>{"q"}));
  const auto& steps = motions.motions[0].steps;
  EXPECT_EQ(evaluate(steps[3].amount, std::vector<double>{1, 2, 3, 4, 5}), 6.0);
  EXPECT_EQ(evaluate(steps[6].amount), 0.25);
}

TEST(FrameDocuments, APiThatIsDeclaredIsAParameter) {
  const RigidMotions motions = motions_of("Model M Params angles { pi } Convention = local A -> B : rotx(pi) roty(PI)");
  EXPECT_EQ(motions.motions[0].steps[0].amount.op(), model::Quantity::Op::parameter);
  EXPECT_TRUE(motions.motions[0].steps[1].amount.number().is_pi_multiple());
}

// Writes the model as a document and reads it back: the frames are the same, and the transforms between all of them are
// equal.
void expect_same_motions(const RigidMotions& motions) {
  const std::string text = language::motion::print(exporting::motion_document(motions));
  const RigidMotions again = motions_of(text);
  EXPECT_EQ(again.name, motions.name);
  EXPECT_EQ(again.convention, motions.convention);
  EXPECT_EQ(again.motions.size(), motions.motions.size());
  constexpr std::uint64_t kSeed = 91;
  std::mt19937_64 engine(kSeed);
  std::uniform_real_distribution<double> any(-2, 2);
  // Values are given by name, because the order of parameters and variables is that of their first use.
  std::map<std::string, double> parameter_values, variable_values;
  for (const auto& p : motions.parameters) parameter_values[p.name] = any(engine);
  for (const auto& v : motions.variables) variable_values[v] = any(engine);
  const auto parameters = [&](const RigidMotions& m) {
    std::vector<double> values;
    for (const auto& p : m.parameters) values.push_back(parameter_values.at(p.name));
    return values;
  };
  const auto variables = [&](const RigidMotions& m) {
    std::vector<double> values;
    for (const auto& v : m.variables) values.push_back(variable_values.at(v));
    return values;
  };
  for (const model::FrameNames& pair : model::default_transforms(motions)) {
    const auto one = model::transform_between(motions, pair.first, pair.second);
    const auto other = model::transform_between(again, pair.first, pair.second);
    ASSERT_TRUE(one && other) << text;
    EXPECT_TRUE(
        value(*one, MovedFramePosition::right, parameters(motions), variables(motions))
            .isApprox(value(*other, MovedFramePosition::right, parameters(again), variables(again)), kTolerance))
        << pair.first << "_X_" << pair.second << "\n"
        << text;
  }
}

TEST(FrameDocuments, OfMotionsMeanTheSameWhenWrittenByUs) {
  expect_same_motions(motions_of(document_of_sequences("fixed")));
  expect_same_motions(motions_of(
      "Model M Params lengths { l } Params angles { tilt } Convention = fixed "
      "A -> B : trx(l/2) rotz(-tilt) try(2.0 l + 0.1) [there] ^local -> B : rotx(PI/3.0) trz(q)  C -> A : "));
}

TEST(FrameDocuments, OfTransformsMeanTheSameWhenWrittenByUs) {
  const model::CoordinateTransforms transforms = transforms_of(
      "Model M Params lengths { l } MovedFramePos = left "
      "{A}_X_{B} = Rx(q) Tz(-l) Ry(2.0 PI/3.0) [there] {B}_X_{A} = ");
  const model::CoordinateTransforms again =
      transforms_of(language::transforms::print(exporting::transforms_document(transforms)));
  EXPECT_EQ(again.position, MovedFramePosition::left);
  ASSERT_EQ(again.transforms.size(), 2u);
  EXPECT_EQ(again.transforms[0].name, "there");
  EXPECT_TRUE(value(again.transforms[0], again.position, {0.3}, {0.8})
                  .isApprox(value(transforms.transforms[0], transforms.position, {0.3}, {0.8}), kTolerance));
  EXPECT_TRUE(again.transforms[1].primitives.empty());
}

std::vector<std::filesystem::path> corpus(const std::string& extension) {
  std::vector<std::filesystem::path> result;
  if (!std::filesystem::is_directory(ROBCOGEN_CORPUS_DIR)) return result;
  for (const auto& entry : std::filesystem::directory_iterator(ROBCOGEN_CORPUS_DIR))
    if (entry.path().extension() == extension) result.push_back(entry.path());
  std::sort(result.begin(), result.end());
  return result;
}

TEST(FrameDocuments, OfOtherProjectsAreReadWithoutAWord) {
  if (corpus(".motdsl").empty()) GTEST_SKIP() << "no documents in " << ROBCOGEN_CORPUS_DIR;
  for (const auto& file : corpus(".motdsl")) {
    Diagnostics diagnostics;
    const auto motions =
        import::rigid_motions(language::motion::parse(test::source_of_file(file), diagnostics), diagnostics);
    EXPECT_TRUE(diagnostics.all().empty()) << diagnostics.render();
    ASSERT_TRUE(motions.has_value()) << file;
    expect_same_motions(*motions);
  }
  for (const auto& file : corpus(".ctdsl")) {
    Diagnostics diagnostics;
    const auto transforms = import::coordinate_transforms(
        language::transforms::parse(test::source_of_file(file), diagnostics), diagnostics);
    EXPECT_TRUE(diagnostics.all().empty()) << diagnostics.render();
    EXPECT_TRUE(transforms.has_value()) << file;
  }
}

// The motions of a robot, written as a document, stay the same.
TEST(FrameDocuments, OfRobotsAreTheirMotions) {
  const auto document = std::filesystem::path(ROBCOGEN_SOURCE_DIR) / "robots" / "humanoid" / "humanoid.kindsl";
  Diagnostics diagnostics;
  const auto robot = test::tree_of(test::source_of_file(document), diagnostics);
  ASSERT_TRUE(robot.has_value()) << diagnostics.render();
  expect_same_motions(model::motions_of(*robot));

  const auto parametric = test::tree_of(
      "Robot Arm { RobotBase base { children { upper via shoulder } frames { eye { translation = (0.0, h, 0.0) "
      "rotation "
      "= (tilt, 0.0, PI/2.0) } } } link upper { id = 1 inertia_params { mass = m CoM = (0.0, 0.0, 0.0) Ix=0.1 Iy=0.1 "
      "Iz=0.1 Ixy=0.0 Ixz=0.0 Iyz=0.0 } children { } } r_joint shoulder { ref_frame { translation = (0.5 reach, 0.0, "
      "q_shoulder) rotation = (0.0, tilt, 0.0) } } }",
      diagnostics);
  ASSERT_TRUE(parametric.has_value()) << diagnostics.render();
  expect_same_motions(model::motions_of(*parametric));
}

}  // namespace
}  // namespace robcogen::frames_test
