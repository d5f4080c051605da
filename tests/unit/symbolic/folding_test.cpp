// Expressions fold while they are built, and folding keeps their values.
#include <gtest/gtest.h>

#include "programs.h"
#include "symbolic/apply.h"
#include "symbolic/expression.h"

namespace robcogen::symbolic::folding_test {
namespace {

class Folding : public testing::Test {
 protected:
  Graph graph;
  Expression a = graph.input(0);
  Expression b = graph.input(1);

  Expression k(double value) { return graph.constant(value); }
  Expression k(const std::string& literal) { return graph.constant(*Number::parse(literal)); }
};

TEST_F(Folding, ZerosAndOnes) {
  const std::size_t before = graph.nodes().size();
  EXPECT_EQ(a + k(0.0), a);
  EXPECT_EQ(k(0.0) - a, -a);
  EXPECT_TRUE((a * k(0.0)).is_zero());
  EXPECT_TRUE((k(0.0) / a).is_zero());
  EXPECT_EQ(a * graph.one(), a);
  EXPECT_EQ(k(-1.0) * a, -a);
  EXPECT_EQ(-a * k(-1.0), a);
  EXPECT_EQ(a / k(1.0), a);
  EXPECT_EQ(a / k(-1.0), -a);
  EXPECT_TRUE((a - a).is_zero());
  EXPECT_TRUE((-a + a).is_zero());
  EXPECT_EQ(graph.nodes().size(), before);
  EXPECT_EQ(cos(k(0.0)), graph.one());
}

TEST_F(Folding, ConstantsFoldExactly) {
  EXPECT_EQ(k("0.1") + k("0.2"), k("0.3"));  // in doubles, 0.1 + 0.2 is not 0.3
  EXPECT_EQ(k("0.1") * k(3.0), k("0.3"));
  EXPECT_EQ(k(1.0) / k(3.0) * k(3.0), graph.one());
  EXPECT_EQ(k("0.1") - k("0.3"), -k("0.2"));
  EXPECT_EQ(sqrt(k(2.25)), k(1.5));
  EXPECT_EQ(sin(k(0.5)).number().value(), std::sin(0.5));
  EXPECT_EQ(cos(k(-0.5)).number().value(), std::cos(0.5));
}

TEST_F(Folding, MultiplesOfPiFoldExactly) {
  const Expression pi = graph.constant(Number::pi_multiple(1));
  EXPECT_TRUE(sin(pi).is_zero());
  EXPECT_EQ(cos(pi), -graph.one());
  EXPECT_TRUE(cos(pi / k(2.0)).is_zero());
  EXPECT_EQ(sin(pi / k(-2.0)), -graph.one());
  EXPECT_EQ(cos(pi / k(3.0)), k(0.5));
  EXPECT_EQ(sin(pi / k(4.0)), cos(pi / k(4.0)));
  EXPECT_TRUE((pi / k(2.0) + pi / k(2.0) - pi).is_zero());
}

TEST_F(Folding, OnARewritingGraphLikeTermsAreCollected) {
  EXPECT_TRUE(a + a == 2.0 * a);
  EXPECT_TRUE(2.0 * a + 3.0 * a == 5.0 * a);
  EXPECT_TRUE(2.0 * a - 3.0 * a == -a);
  EXPECT_TRUE(a + 2.0 * a == 3.0 * a);
  EXPECT_TRUE(-a - 2.0 * a == -3.0 * a);
  EXPECT_TRUE(k("0.1") * a + k("0.2") * a == k("0.3") * a);
  EXPECT_TRUE((2.0 * a - 1.0 * a) == a);
  EXPECT_TRUE((2.0 * a - 2.0 * a).is_zero());
}

TEST_F(Folding, OnARewritingGraphFactorsAreCollected) {
  EXPECT_TRUE(2.0 * (3.0 * a) == 6.0 * a);
  EXPECT_TRUE((3.0 * a) * k(-2.0) == -6.0 * a);
  EXPECT_TRUE(2.0 * (0.5 * a) == a);
}

TEST_F(Folding, OnARewritingGraphConstantsOfSumsAreCollected) {
  EXPECT_TRUE((a + k(1.0)) + k(2.0) == a + k(3.0));
  EXPECT_TRUE((a - k(1.0)) + k(3.0) == a + k(2.0));
  EXPECT_TRUE((k(1.0) - a) + k(2.0) == k(3.0) - a);
  EXPECT_TRUE(k(2.0) - (a + k(5.0)) == -(a + k(3.0)));
  EXPECT_TRUE((a + k(1.0)) - k(1.0) == a);
}

TEST_F(Folding, OnARewritingGraphOppositesCancel) {
  EXPECT_TRUE((a + b) - b == a);
  EXPECT_TRUE((a + b) - a == b);
  EXPECT_TRUE((a - b) + b == a);
  EXPECT_TRUE((a - b) - a == -b);
  EXPECT_TRUE(a - (a + b) == -b);
  EXPECT_TRUE(b + (a - b) == a);
  EXPECT_TRUE(b - (b - a) == a);
}

TEST_F(Folding, NearMissesStay) {
  EXPECT_NE((a + b) + b, a);
  EXPECT_NE((a - b) - b, a);
  EXPECT_NE((a + b) + a, b);
  EXPECT_NE(a * b + b, a);
  EXPECT_NE(a / a, graph.one());  // a may be zero
  EXPECT_NE(2.0 * a + 2.0 * b, 4.0 * a);
  EXPECT_NE(sqrt(a * a), a);
}

Program built(const Program& p, Graph& graph) {
  std::vector<Expression> values;
  const auto read = [&](const Operand& o) {
    const auto i = static_cast<std::size_t>(o.index);
    const Expression e = o.kind == Operand::Kind::constant ? graph.constant(p.constants[i])
                         : o.kind == Operand::Kind::input  ? graph.input(o.index)
                                                           : values[i];
    return o.negative ? -e : e;
  };
  for (const Statement& s : p.statements) {
    const Expression x = read(s.a), y = is_binary(s.op) ? read(s.b) : Expression();
    values.push_back(apply(s.op, x, y));
  }
  std::vector<Expression> outputs;
  for (const Operand& o : p.outputs[0].values) outputs.push_back(read(o));
  OutputArray shape = p.outputs[0];
  shape.values.clear();
  return graph.program(p.name, p.inputs, {shape}, {outputs});
}

TEST_F(Folding, KeepsTheValuesOfRandomExpressions) {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    test::RandomPrograms random(seed);
    const Program original = random.make();
    ASSERT_EQ(verify(original), "") << "seed " << seed;
    Graph fresh;
    const Program folded = built(original, fresh);
    ASSERT_EQ(verify(folded), "") << "seed " << seed;
    ASSERT_EQ(test::difference(original, folded, random.inputs()), "") << "seed " << seed << "\n"
                                                                       << print(original) << print(folded);
  }
}

}  // namespace
}  // namespace robcogen::symbolic::folding_test
