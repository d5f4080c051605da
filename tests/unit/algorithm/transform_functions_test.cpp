// Programs of transforms without a robot: their values and their small operation counts.
#include "algorithm/catalogue/transform_functions.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "symbolic/cost.h"
#include "symbolic/interpret.h"

namespace robcogen::algorithm::transform_functions_test {
namespace {

using model::Axis;
using model::CoordinateTransform;
using model::CoordinateTransforms;
using model::PrimitiveTransform;
using model::Quantity;

// Products of a dozen rotations, and shifts of a few metres.
constexpr double kTolerance = 1e-13;

constexpr Axis kX = Axis::x, kY = Axis::y, kZ = Axis::z;

PrimitiveTransform turn(Axis axis, const Quantity& angle) {
  return {true, axis, angle};
}
PrimitiveTransform shift(Axis axis, const Quantity& length) {
  return {false, axis, length};
}

Quantity variable(int index) {
  return Quantity::variable(index);
}
Quantity quarters(int count) {
  return Quantity(Number::pi_multiple(count, 2));
}

// A document with one transform A_X_B of four variables.
CoordinateTransforms document(std::vector<PrimitiveTransform> primitives) {
  CoordinateTransforms result;
  result.variables = {"a", "b", "c", "d"};
  result.transforms = {{"A", "B", std::move(primitives), ""}};
  return result;
}

symbolic::Program program(const CoordinateTransforms& document, TransformForm form = TransformForm::homogeneous) {
  return transform_program(document, document.transforms.front(), form, "A_X_B");
}

symbolic::Cost cost(
    const std::vector<PrimitiveTransform>& primitives,
    TransformForm form = TransformForm::homogeneous) {
  return symbolic::cost(program(document(primitives), form));
}

std::vector<double> value(
    const CoordinateTransforms& document,
    const symbolic::Program& program,
    const std::vector<double>& variables) {
  std::vector<double> used;
  for (int i : arguments_of(document, document.transforms.front()).variables)
    used.push_back(variables[static_cast<std::size_t>(i)]);
  symbolic::Arrays<double> inputs;
  if (!used.empty()) inputs["variables"] = used;
  return symbolic::interpret<double>(program, inputs).at("X");
}

Eigen::Isometry3d product(const std::vector<PrimitiveTransform>& primitives, const std::vector<double>& variables) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  for (const PrimitiveTransform& p : primitives) {
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(static_cast<int>(p.axis));
    const double amount = evaluate(p.amount, {}, variables);
    if (p.rotation)
      result = result * Eigen::AngleAxisd(amount, unit);
    else
      result = result * Eigen::Translation3d(amount * unit);
  }
  return result;
}

Eigen::MatrixXd expected(const Eigen::Isometry3d& pose, TransformForm form) {
  if (form == TransformForm::homogeneous) return pose.matrix();
  const Eigen::Matrix3d R = pose.linear();
  const Eigen::Vector3d p = pose.translation();
  Eigen::Matrix3d moment;
  for (int k = 0; k < 3; ++k) moment.col(k) = p.cross(R.col(k));
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(6, 6);
  result.topLeftCorner(3, 3) = result.bottomRightCorner(3, 3) = R;
  (form == TransformForm::spatial_motion ? result.bottomLeftCorner(3, 3) : result.topRightCorner(3, 3)) = moment;
  return result;
}

std::string text(const CoordinateTransforms& document) {
  std::string result;
  for (const PrimitiveTransform& p : document.transforms.front().primitives)
    result += std::string(p.rotation ? " R" : " T") + "xyz"[static_cast<int>(p.axis)] + "(" +
              model::print(p.amount, document.parameters, document.variables) + ")";
  return result;
}

constexpr TransformForm kForms[] = {
    TransformForm::homogeneous, TransformForm::spatial_motion, TransformForm::spatial_force};

class RandomChains : public testing::TestWithParam<unsigned> {
 protected:
  int pick(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  std::vector<double> variables() {
    std::uniform_real_distribution<double> real(-3, 3);
    return {real(random_), real(random_), real(random_), real(random_)};
  }

  // Few names in many places, so that angles add up, cancel, or meet again behind translations.
  PrimitiveTransform primitive() {
    const bool rotation = pick(5) < 3;
    const int name = pick(3);
    Quantity amount = rotation ? variable(name) : Quantity(0.5 + 0.25 * pick(4));
    if (pick(4) == 0) amount = rotation ? quarters(1 + pick(3)) : variable(3);
    if (pick(3) == 0) amount = -amount;
    return {rotation, static_cast<Axis>(pick(3)), amount};
  }
  std::vector<PrimitiveTransform> chain(int most) {
    std::vector<PrimitiveTransform> result;
    for (int n = pick(most + 1); n > 0; --n) result.push_back(primitive());
    return result;
  }

  std::mt19937 random_{GetParam()};
};

TEST_P(RandomChains, AreWhatEigenMultipliesOut) {
  const CoordinateTransforms chain_document = document(chain(12));
  for (const TransformForm form : kForms) {
    const symbolic::Program made = program(chain_document, form);
    const std::vector<double> at = variables();
    const std::vector<double> X = value(chain_document, made, at);
    const Eigen::MatrixXd wanted = expected(product(chain_document.transforms.front().primitives, at), form);
    const Eigen::MatrixXd is = Eigen::Map<const Eigen::MatrixXd>(X.data(), wanted.rows(), wanted.cols());
    EXPECT_LE((is - wanted).cwiseAbs().maxCoeff(), kTolerance * (1 + wanted.cwiseAbs().maxCoeff()))
        << "seed " << GetParam() << ": " << text(chain_document);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomChains, testing::Range(1u, 301u));

// All sequences of three axes in which neighbours differ.
std::vector<std::array<Axis, 3>> euler_sequences() {
  std::vector<std::array<Axis, 3>> result;
  for (const Axis i : {kX, kY, kZ})
    for (const Axis j : {kX, kY, kZ})
      for (const Axis k : {kX, kY, kZ})
        if (i != j && j != k) result.push_back({i, j, k});
  return result;
}

// The four products of the outer sines and cosines, each of these times a function of the middle angle, and the four
// elements next to the middle axis: 12 products. Four elements are sums of two terms.
TEST(TransformPrograms, EulerAnglesTakeTwelveProductsAndFourSums) {
  const auto sequences = euler_sequences();
  ASSERT_EQ(sequences.size(), 12u);
  for (const auto& [i, j, k] : sequences) {
    const std::vector<PrimitiveTransform> there = {turn(i, variable(0)), turn(j, variable(1)), turn(k, variable(2))};
    const std::vector<PrimitiveTransform> back = {turn(k, -variable(2)), turn(j, -variable(1)), turn(i, -variable(0))};
    for (const TransformForm form : kForms) {
      for (const auto& primitives : {there, back}) {
        const symbolic::Cost c = cost(primitives, form);
        EXPECT_EQ(c.mul, 12);
        EXPECT_EQ(c.add, 4);
        EXPECT_EQ(c.sincos, 3);
        EXPECT_EQ(c.instructions, 12);
      }
    }
  }
}

TEST(TransformPrograms, QuarterTurnsAreFree) {
  for (const auto& [i, j, k] : euler_sequences()) {
    EXPECT_EQ(cost({turn(i, quarters(1)), turn(j, quarters(3)), turn(k, quarters(2))}).instructions, 0);
    EXPECT_EQ(cost({turn(i, variable(0)), turn(j, quarters(2)), turn(k, quarters(1))}).instructions, 0);
    // The outer axes then coincide or are at right angles.
    EXPECT_LE(cost({turn(i, variable(0)), turn(j, quarters(1)), turn(k, variable(1))}).instructions, 4);
  }
}

TEST(TransformPrograms, TurnsAboutOneAxisAreOne) {
  const symbolic::Cost sum = cost({turn(kZ, variable(0)), turn(kZ, variable(1)), turn(kZ, variable(2))});
  EXPECT_EQ(sum.sincos, 1);
  EXPECT_EQ(sum.mul, 0);
  EXPECT_EQ(sum.add, 2);
  EXPECT_EQ(cost({turn(kX, variable(0)), turn(kX, -variable(0))}).instructions, 0);
  // Lengths along one axis add up as well, even if other translations come between them.
  const symbolic::Cost lengths = cost({shift(kX, variable(0)), shift(kY, variable(1)), shift(kX, -variable(0))});
  EXPECT_EQ(lengths.instructions, 0);
}

TEST(TransformPrograms, SquaresOfSinesAndCosinesAddUp) {
  const Quantity a = variable(0), half(0.5);
  for (const TransformForm form : kForms) {
    // Turns there and back, with a shift between them: no turn is left, and the shift is rotated.
    const symbolic::Cost back = cost({turn(kX, a), shift(kY, half), turn(kX, -a)}, form);
    EXPECT_EQ(back.instructions, 2);
    EXPECT_EQ(back.sincos, 1);
    // The second turn is about the opposite axis.
    EXPECT_EQ(cost({turn(kZ, a), turn(kX, quarters(2)), turn(kZ, a)}, form).instructions, 0);
    EXPECT_EQ(cost({turn(kZ, a), shift(kX, half)}, form).instructions, 2);
    EXPECT_EQ(cost({shift(kX, half), turn(kZ, a)}, form).sincos, 1);
  }
  // For a shift that follows the turn, [p]x R is R [p]x.
  EXPECT_EQ(cost({turn(kZ, a), shift(kX, half)}, TransformForm::spatial_motion).instructions, 2);
}

// A value that does not depend on the variables is a constant in the program. (In longer chains, one angle about
// several axes can give identities that the generator does not look for.)
TEST_P(RandomChains, HaveNoHiddenConstants) {
  const CoordinateTransforms chain_document = document(chain(5));
  for (const TransformForm form : kForms) {
    const symbolic::Program made = program(chain_document, form);
    std::vector<std::vector<double>> samples;
    for (int i = 0; i < 6; ++i) samples.push_back(value(chain_document, made, variables()));
    for (std::size_t k = 0; k < samples.front().size(); ++k) {
      bool varies = false;
      for (const auto& sample : samples) varies = varies || std::abs(sample[k] - samples[0][k]) > kTolerance;
      const bool is_number = made.outputs.front().values[k].kind == symbolic::Operand::Kind::constant;
      EXPECT_EQ(varies, !is_number) << "element " << k << ", seed " << GetParam() << ": " << text(chain_document);
    }
  }
}

TEST(TransformPrograms, NameTheirArguments) {
  CoordinateTransforms two = document({turn(kX, variable(2)), shift(kY, variable(0) * Quantity::parameter(0))});
  two.parameters = {{"length", model::ParameterKind::length, 0.5, {}}};
  const symbolic::Program made = program(two);
  ASSERT_EQ(made.inputs.size(), 2u);
  EXPECT_EQ(made.inputs[0].role, symbolic::Role::parameters);
  EXPECT_EQ(made.inputs[0].elements, std::vector<std::string>{"length"});
  EXPECT_EQ(made.inputs[1].role, symbolic::Role::variables);
  // The variables are in the document's order, without those on which the transform does not depend.
  EXPECT_EQ(made.inputs[1].elements, (std::vector<std::string>{"a", "c"}));
}

TEST(TransformPrograms, OfTheLeftConventionAreInverted) {
  CoordinateTransforms left = document({turn(kZ, variable(0)), shift(kX, Quantity(0.5))});
  CoordinateTransforms right = document({turn(kZ, -variable(0)), shift(kX, Quantity(-0.5))});
  left.position = model::MovedFramePosition::left;
  const std::vector<double> at = {0.3, 0, 0, 0};
  EXPECT_EQ(value(left, program(left), at), value(right, program(right), at));
}

TEST(TransformFunctions, AreOneAFormAndATransformUnderItsName) {
  CoordinateTransforms named = document({turn(kZ, variable(0))});
  named.transforms.push_back({"B", "A", {turn(kZ, -variable(0))}, "back"});
  const std::vector<symbolic::Function> functions = transform_functions(named);
  std::vector<std::string> names;
  for (const symbolic::Function& f : functions) names.push_back(f.scope + "::" + f.name + " " + f.program.name);
  EXPECT_EQ(
      names, (std::vector<std::string>{
                 "transforms::homogeneous::A_X_B homogeneous_A_X_B", "transforms::homogeneous::back homogeneous_back",
                 "transforms::motion::A_X_B motion_A_X_B", "transforms::motion::back motion_back",
                 "transforms::force::A_X_B force_A_X_B", "transforms::force::back force_back"}));
}

}  // namespace
}  // namespace robcogen::algorithm::transform_functions_test
