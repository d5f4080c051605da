#include "model/quantity.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace robcogen::model::quantity_test {
namespace {

const std::vector<Parameter> kParameters = {
    {"a", ParameterKind::length, {}, {}},
    {"b", ParameterKind::length, {}, {}},
    {"c", ParameterKind::length, {}, {}}};

Quantity constant(double value) {
  return Quantity(value);
}
Quantity a() {
  return Quantity::parameter(0);
}
Quantity b() {
  return Quantity::parameter(1);
}
Quantity c() {
  return Quantity::parameter(2);
}
std::string text(const Quantity& q) {
  return print(q, kParameters, {"q_hip"});
}

TEST(Quantity, IsZeroByDefault) {
  EXPECT_TRUE(Quantity().is_zero());
  EXPECT_EQ(text(Quantity()), "0.0");
}

TEST(Quantity, ComparesOperationsNotValues) {
  EXPECT_EQ(a() + b() * sin(c()), a() + b() * sin(c()));
  EXPECT_NE(a() + b(), b() + a());
  EXPECT_NE(a() - b(), a() + b());
  EXPECT_NE(a(), Quantity::variable(0));
  EXPECT_NE(constant(0.5), constant(0.25));
  EXPECT_NE(sin(a()), -sin(a()));
  EXPECT_EQ(Quantity(), constant(0.0));
}

TEST(Quantity, FoldsConstantsExactly) {
  const Quantity right_angle(Number::pi_multiple(1, 2));
  EXPECT_TRUE(cos(right_angle).is_zero());
  EXPECT_EQ(sin(right_angle).number(), Number::rational(1));
  EXPECT_TRUE((right_angle - right_angle).is_zero());
  const Quantity tenth(*Number::parse("0.1")), fifth(*Number::parse("0.2"));
  EXPECT_EQ((tenth + fifth).number(), *Number::parse("0.3"));  // 0.1 + 0.2 in doubles is not
  EXPECT_EQ((constant(6.0) / constant(4.0)).number().value(), 1.5);
  EXPECT_EQ(sqrt(constant(9.0)).number().value(), 3.0);
  EXPECT_TRUE(tan(Quantity()).is_zero());
}

TEST(Quantity, FoldsNeutralOperands) {
  const Quantity zero, one = constant(1.0), minus_one = constant(-1.0);
  for (const Quantity& same :
       {a() + zero, zero + a(), a() - zero, a() * one, one * a(), a() / one, -(-a()), zero - (-a())}) {
    EXPECT_EQ(text(same), "a");
  }
  for (const Quantity& opposite : {zero - a(), a() * minus_one, minus_one * a(), a() / minus_one, -a()}) {
    EXPECT_EQ(text(opposite), "-a");
  }
  for (const Quantity& nothing : {a() * zero, zero * a(), zero / a()}) EXPECT_TRUE(nothing.is_zero());
  EXPECT_EQ(text(a() + (-b())), "a - b");
  EXPECT_EQ(text(a() - (-b())), "a + b");
}

TEST(Quantity, KeepsADivisionByZeroVisible) {
  EXPECT_FALSE(std::isfinite((constant(1.0) / Quantity()).number().value()));
  EXPECT_EQ((a() / Quantity()).op(), Quantity::Op::divide);
}

TEST(Quantity, EvaluatesLikeDoubles) {
  const std::array<double, 3> p = {0.7, -1.3, 2.5};
  const std::array<double, 1> q = {0.4};
  const Quantity variable = Quantity::variable(0);
  const Quantity expression =
      sqrt(a() * a() + b() * b()) / (c() - sin(variable)) + cos(a() * variable) - tan(-b()) * constant(0.1);
  const double expected =
      std::sqrt(p[0] * p[0] + p[1] * p[1]) / (p[2] - std::sin(q[0])) + std::cos(p[0] * q[0]) - std::tan(-p[1]) * 0.1;
  EXPECT_DOUBLE_EQ(evaluate(expression, p, q), expected);
}

TEST(Quantity, PrintsTheSpellingsOfAllDialects) {
  EXPECT_EQ(text(constant(0.5) * a()), "0.5 a");
  EXPECT_EQ(text(a() / constant(2.0)), "a/2.0");
  EXPECT_EQ(text(Quantity(Number::pi_multiple(1, 2))), "PI/2.0");
  EXPECT_EQ(text(Quantity(Number::pi_multiple(-1))), "-PI");
  EXPECT_EQ(text(constant(-0.5) * Quantity::variable(0)), "-0.5 q_hip");
}

TEST(Quantity, PrintsOnlyNeededParentheses) {
  EXPECT_EQ(text(a() + b() + c()), "a + b + c");
  EXPECT_EQ(text(a() + (b() + c())), "a + (b + c)");
  EXPECT_EQ(text(a() - (b() - c())), "a - (b - c)");
  EXPECT_EQ(text(a() * b() + c()), "a*b + c");
  EXPECT_EQ(text(a() * (b() + c())), "a*(b + c)");
  EXPECT_EQ(text((a() + b()) / c()), "(a + b)/c");
  EXPECT_EQ(text(a() / (b() / c())), "a/(b/c)");
  EXPECT_EQ(text(a() / b() * c()), "a/b*c");
  EXPECT_EQ(text(-(a() * b())), "-(a*b)");
  EXPECT_EQ(text(a() * (-b())), "a*(-b)");
  EXPECT_EQ(text(a() + constant(-2.0)), "a + (-2.0)");
  EXPECT_EQ(text(a() / Quantity(Number::pi_multiple(1, 2))), "a/(PI/2.0)");
  EXPECT_EQ(text(sqrt(a() + b())), "sqrt(a + b)");
  EXPECT_EQ(text(-sin(a())), "-sin(a)");
}

}  // namespace
}  // namespace robcogen::model::quantity_test
