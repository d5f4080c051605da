// Derivatives of programs in both modes, compared with differences of the interpreter in long double.
#include "symbolic/derivative.h"

#include <stdexcept>

#include "programs.h"

namespace robcogen::symbolic::derivative_test {
namespace {

using Real = long double;
using Values = std::vector<Real>;

Values results(const Program& program, const Values& a, const std::string& output) {
  return interpret<Real>(program, {{"a", a}}).at(output);
}

// Fourth-order central differences, one column for each element of `a`.
Values differences(const Program& program, const Values& a, const std::string& output) {
  constexpr Real kStep = 1e-4L;
  Values columns;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const auto at = [&](Real steps) {
      Values moved = a;
      moved[k] += steps * kStep;
      return results(program, moved, output);
    };
    const Values one = at(1), minus_one = at(-1), two = at(2), minus_two = at(-2);
    for (std::size_t i = 0; i < one.size(); ++i)
      columns.push_back((8 * (one[i] - minus_one[i]) - (two[i] - minus_two[i])) / (12 * kStep));
  }
  return columns;
}

void expect_both_modes(const Program& program, const Values& a) {
  constexpr Real kNear = 1e-11L;
  const Values expected = differences(program, a, "out");
  const Program forward = with_derivatives(program, {"a"});
  EXPECT_EQ(verify(forward), "");
  const Values found = results(forward, a, "d_a");
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_LT(std::abs(found[i] - expected[i]), kNear) << i;

  const Program reverse = with_gradient(program, {{"weights", {"out"}}}, {"a"}, 0);
  EXPECT_EQ(verify(reverse), "");
  EXPECT_EQ(reverse.inputs.front().name, "weights");
  const std::size_t rows = reverse.inputs.front().elements.size();
  for (std::size_t row = 0; row < rows; ++row) {
    Values weights(rows);
    weights[row] = -2;
    const Values gradient = interpret<Real>(reverse, {{"a", a}, {"weights", weights}}).at("d_a");
    ASSERT_EQ(gradient.size(), a.size());
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_LT(std::abs(gradient[k] + 2 * expected[row + k * rows]), kNear);
  }

  const Program tangents = with_tangents(program, {"a"}, 1);
  EXPECT_EQ(verify(tangents), "");
  EXPECT_EQ(tangents.inputs.back().name, "a_tangent");
  Values rates, sums(rows);
  for (std::size_t k = 0; k < a.size(); ++k) rates.push_back(1.0L + 0.5L * static_cast<Real>(k));
  for (std::size_t i = 0; i < expected.size(); ++i) sums[i % rows] += expected[i] * rates[i / rows];
  const Values tangent = interpret<Real>(tangents, {{"a", a}, {"a_tangent", rates}}).at("out_tangent");
  ASSERT_EQ(tangent.size(), rows);
  for (std::size_t row = 0; row < rows; ++row) EXPECT_LT(std::abs(tangent[row] - sums[row]), 10 * kNear);
}

TEST(Derivative, EveryOperation) {
  const Values a = {0.3L, 0.7L, -2.0L, 5.0L};
  for (const char* statement :
       {"a[0] + a[1]", "a[0] - a[1]", "a[0] * a[2]", "a[0] * a[0]", "a[0] / a[2]", "sqrt a[1]", "sqrt -a[2]",
        "sin a[3]", "cos a[3]"})
    expect_both_modes(test::small_program("let x = " + std::string(statement) + "\nreturn out -x\n"), a);
}

TEST(Derivative, SharedValuesSeveralResultsAndNone) {
  const Program p = test::small_program(
      "let s = sin a[0]\nlet c = cos a[0]\nlet x = s * a[1]\nlet y = x / c\nlet z = y - x\nlet r = z * z\n"
      "return out r 0 a[2] -y\n",
      4);
  expect_both_modes(p, {0.3L, 0.7L, -2.0L, 5.0L});
}

// The cheaper mode: reverse mode for one result of many inputs, forward mode for many results of one input.
TEST(Derivative, CheapestMode) {
  const Program product =
      test::small_program("let x = a[0] * a[1]\nlet y = x * a[2]\nlet z = y * a[3]\nreturn out z\n");
  const Program many = test::small_program("let x = sin a[0]\nlet y = x * x\nlet z = y * x\nreturn out x y z 0\n", 4);
  for (const Program& p : {product, many}) {
    const std::optional<Program> found = with_derivatives(p, {"a"}, DerivativeMode::cheaper, 1000);
    ASSERT_TRUE(found);
    EXPECT_EQ(verify(*found), "");
    const Values a = {0.3L, 0.7L, -2.0L, 5.0L}, expected = differences(p, a, "out"), d = results(*found, a, "d_a");
    ASSERT_EQ(d.size(), expected.size());
    for (std::size_t i = 0; i < d.size(); ++i) EXPECT_LT(std::abs(d[i] - expected[i]), 1e-11L) << i;
    EXPECT_LE(found->statements.size(), with_derivatives(p, {"a"}).statements.size());
  }
  EXPECT_FALSE(with_derivatives(product, {"a"}, DerivativeMode::cheaper, 8));
  EXPECT_EQ(
      print(*with_derivatives(product, {"a"}, DerivativeMode::forward, 1000)), print(with_derivatives(product, {"a"})));
}

// An output itself may have the name of a derivative.
TEST(Derivative, OfADerivative) {
  const Program p = test::program(
      "program test\ninput q value 0\noutput d_q value 1 1\nsection hip link hip\nlet x = q[0] * q[0]\nreturn d_q x\n");
  const Program d = with_derivatives(p, {"q"});
  EXPECT_EQ(verify(d), "");
  EXPECT_EQ(d.outputs[1].name, "d_q_d_q");
}

// Derivatives with respect to an input on which a value does not depend are literal zeros.
TEST(Derivative, ZerosAreLiteral) {
  const Program p = with_derivatives(test::small_program("let x = a[0] * a[1]\nreturn out x\n"), {"a"});
  ASSERT_EQ(p.outputs.size(), 2U);
  EXPECT_EQ(p.outputs[1].rows, 1);
  EXPECT_EQ(p.outputs[1].columns, 4);
  EXPECT_EQ(p.statements.size(), 1U);
  EXPECT_TRUE(is_constant(p.outputs[1].values[2]));
}

TEST(Derivative, OfAnExpression) {
  Graph graph;
  const Expression x = graph.input(0), y = graph.input(1);
  EXPECT_EQ(derivative(-(x * y) + graph.constant(3), x), -y);
  EXPECT_EQ(derivative(x, x), graph.one());
  EXPECT_EQ(derivative(-sin(x), x), -cos(x));
  EXPECT_TRUE(derivative(sin(x), y).is_zero());
  EXPECT_TRUE(derivative(Expression(), x).is_zero());
}

TEST(Derivative, ByWhatIsNotThere) {
  const Program p = test::small_program("return out a[0]\n");
  EXPECT_THROW(with_derivatives(p, {"q"}), std::logic_error);
  EXPECT_THROW(with_gradient(p, {{"weights", {"out"}}}, {"q"}, 0), std::logic_error);
  EXPECT_THROW(with_tangents(p, {kBaseRotation}, 0), std::logic_error);
}

}  // namespace
}  // namespace robcogen::symbolic::derivative_test
