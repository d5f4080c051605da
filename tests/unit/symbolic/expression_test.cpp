// Expressions are shared and carry signs; a graph can be rolled back.
#include "symbolic/expression.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace robcogen::symbolic::expression_test {
namespace {

class ExpressionTest : public testing::Test {
 protected:
  Graph graph;
  Expression a = graph.input(0);
  Expression b = graph.input(1);
  Expression c = graph.input(2);

  std::size_t operations() const {
    std::size_t n = 0;
    for (const Node& node : graph.nodes()) n += node.kind == Node::Kind::operation;
    return n;
  }
};

TEST_F(ExpressionTest, TheDefaultIsZeroOfAnyGraph) {
  const Expression zero;
  EXPECT_TRUE(zero.is_zero());
  EXPECT_TRUE(zero.is_constant());
  EXPECT_TRUE(zero.number().is_zero());
  EXPECT_EQ(zero, graph.constant(0.0));
  EXPECT_EQ(zero + a, a);
  EXPECT_EQ(a - zero, a);
  EXPECT_EQ(zero - a, -a);
  EXPECT_TRUE((zero * a).is_zero());
  EXPECT_TRUE((zero / a).is_zero());
  EXPECT_TRUE((zero + zero).is_zero());
  EXPECT_TRUE((3.0 * zero).is_zero());
  EXPECT_TRUE(sin(zero).is_zero());
  EXPECT_TRUE(sqrt(zero).is_zero());
  EXPECT_FALSE(sqrt(graph.constant(-4)).is_constant());
  EXPECT_THROW(cos(zero), std::logic_error);
}

TEST_F(ExpressionTest, EqualOperationsAreOneNode) {
  const Expression sum = a + b, product = a * b, quotient = a / b;
  const Expression sine = sin(a), cosine = cos(a), root = sqrt(a);
  EXPECT_EQ(operations(), 6u);
  EXPECT_EQ(a + b, sum);
  EXPECT_EQ(b + a, sum);
  EXPECT_EQ(a * b, product);
  EXPECT_EQ(b * a, product);
  EXPECT_EQ(a / b, quotient);
  EXPECT_EQ(sin(a), sine);
  EXPECT_EQ(cos(a), cosine);
  EXPECT_EQ(sqrt(a), root);
  EXPECT_EQ(operations(), 6u);
  EXPECT_NE(b / a, quotient);
  EXPECT_NE(sine, cosine);
  EXPECT_EQ(graph.input(1), b);
}

TEST_F(ExpressionTest, EqualConstantsAreOneNode) {
  const std::size_t before = graph.nodes().size();
  const Expression x = graph.constant(0.35);
  EXPECT_EQ(graph.nodes().size(), before + 1);
  EXPECT_EQ(graph.constant(0.35), x);
  EXPECT_EQ(graph.constant(-0.35), -x);
  EXPECT_EQ(graph.nodes().size(), before + 1);
  EXPECT_EQ(graph.constant(-0.35).number().value(), -0.35);
  EXPECT_EQ(graph.constant(1.0), graph.one());
  EXPECT_TRUE(graph.constant(1.0).is_one());
  EXPECT_FALSE(graph.constant(-1.0).is_one());
  EXPECT_TRUE(graph.constant(-0.0).is_zero());
}

// PI and the nearest double are two constants, of which one is exact.
TEST_F(ExpressionTest, AMultipleOfPiIsNotItsDouble) {
  const Expression pi = graph.constant(Number::pi_multiple(1));
  const Expression nearest = graph.constant(Number(pi.number().value()));
  EXPECT_NE(pi, nearest);
  EXPECT_TRUE(sin(pi).is_zero());
  EXPECT_FALSE(sin(nearest).is_zero());
}

TEST_F(ExpressionTest, ConstantsFoldOnlyWhereTheirRepresentativesDo) {
  const Expression zero = graph.constant(Constant().folded_as(0.25)),
                   one = graph.constant(Constant(Number(1.0)).folded_as(2.0));
  EXPECT_TRUE(zero.is_constant());
  EXPECT_FALSE(zero.is_zero());
  EXPECT_FALSE(one.is_one());
  EXPECT_NE(one * a, a);
  EXPECT_NE(a + zero * b, a);
  EXPECT_EQ(graph.constant(Constant().folded_as(0.25)), zero);
  EXPECT_EQ(graph.constant(Constant().folded_as(-0.25)), -zero);
  EXPECT_NE(graph.constant(Constant().folded_as(0.5)), zero);
  // constants fold to their values
  EXPECT_EQ((zero * one + graph.constant(3.0)).number().value(), 3.0);
  EXPECT_TRUE((zero * b - zero * b).is_zero());
}

TEST_F(ExpressionTest, SignsMoveOutwards) {
  EXPECT_EQ(-(-a), a);
  EXPECT_EQ(-a - b, -(a + b));
  EXPECT_EQ(b - a, -(a - b));
  EXPECT_EQ(-a + b, -(a - b));
  EXPECT_EQ((-a) * b, -(a * b));
  EXPECT_EQ((-a) * (-b), a * b);
  EXPECT_EQ((-a) / b, -(a / b));
  EXPECT_EQ(a / (-b), -(a / b));
  EXPECT_EQ((-a) / (-b), a / b);
  EXPECT_EQ(sin(-a), -sin(a));
  EXPECT_EQ(cos(-a), cos(a));
  EXPECT_EQ(operations(), 6u);  // +, -, *, /, sin, cos
}

TEST_F(ExpressionTest, ASquareRootKeepsTheSignOfItsOperand) {
  EXPECT_NE(sqrt(-a), sqrt(a));
  EXPECT_NE(sqrt(-a), -sqrt(a));
  EXPECT_EQ(sqrt(-a), sqrt(-a));
}

TEST_F(ExpressionTest, InternalFaultsAreLogicErrors) {
  Graph other;
  EXPECT_THROW(a + other.input(0), std::logic_error);
  EXPECT_THROW(a * other.input(0), std::logic_error);
  EXPECT_THROW(a / other.input(0), std::logic_error);
  EXPECT_THROW(a / Expression(), std::logic_error);
  EXPECT_THROW(a / (b - b), std::logic_error);
  EXPECT_THROW(graph.constant(std::numeric_limits<double>::infinity()), std::logic_error);
  EXPECT_THROW(graph.constant(std::numeric_limits<double>::quiet_NaN()), std::logic_error);
}

// A computed zero belongs to the graph, so that its cosine is one.
TEST_F(ExpressionTest, WhatCancelsIsAZeroOfTheGraph) {
  EXPECT_EQ(cos(a - a), graph.one());
  EXPECT_EQ(cos((a + b) - (b + a)), graph.one());
  EXPECT_EQ(cos(2.0 * a - 2.0 * a), graph.one());
}

TEST_F(ExpressionTest, RollbackForgetsWhatWasBuiltSince) {
  const Expression kept = a + b;
  const std::size_t mark = graph.mark();
  const std::vector<Expression> tried = {kept * c, sin(kept), graph.constant(0.77), graph.input(9), sqrt(-a)};
  ASSERT_GT(graph.nodes().size(), mark);
  graph.rollback(mark);
  EXPECT_EQ(graph.nodes().size(), mark);
  EXPECT_EQ(graph.mark(), mark);
  EXPECT_EQ(a + b, kept);

  // After the rollback, expressions built in another order are found again and have the right meaning.
  const Expression sine = sin(kept), number = graph.constant(0.88), old_number = graph.constant(0.77);
  EXPECT_EQ(static_cast<std::size_t>(sine.node()), mark);
  EXPECT_EQ(number.number().value(), 0.88);
  EXPECT_EQ(old_number.number().value(), 0.77);
  EXPECT_EQ(graph.constant(0.88), number);
  EXPECT_EQ(sin(kept), sine);
  EXPECT_NE(kept * c, sine);
}

}  // namespace
}  // namespace robcogen::symbolic::expression_test
