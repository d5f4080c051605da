// From a graph to a program: which expressions it contains, in which order and section, and under which names.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "symbolic/expression.h"
#include "symbolic/text.h"
#include "symbolic/verify.h"

namespace robcogen::symbolic::program_test {
namespace {

class ProgramOfGraph : public testing::Test {
 protected:
  Graph graph;
  Expression a = graph.input(0);
  Expression b = graph.input(1);

  Program program(const std::vector<Expression>& values) {
    Program p = graph.program(
        "test", {{"q", Role::value, {"A", "B"}}}, {{"out", Role::value, static_cast<int>(values.size()), 1, {}}},
        {values});
    EXPECT_EQ(verify(p), "");
    return p;
  }
};

// The root is the only operation that does not absorb the sign of its operand.
TEST_F(ProgramOfGraph, KeepsTheSignUnderARoot) {
  graph.begin_section("link hip", "hip");
  const std::string text = print(program({sqrt(-a), sqrt(a)}));
  EXPECT_NE(text.find("tmp hip_t0 = sqrt -q[0]\ntmp hip_t1 = sqrt q[0]\n"), std::string::npos) << text;
}

TEST_F(ProgramOfGraph, HoldsWhatOutputsReachInTheOrderOfItsMaking) {
  const Expression dead = 0.5 * a * b;
  graph.begin_section("link hip", "hip");
  const Expression product = a * b;
  const Expression sum = product - graph.constant(0.25);
  graph.begin_section("link knee", "knee");
  const Expression sine = sin(sum);
  EXPECT_FALSE(dead.is_zero());
  EXPECT_EQ(
      print(program({sine, -product, Expression(), -a, graph.constant(-0.25)})),
      "program test\n"
      "input q value A B\n"
      "output out value 5 1\n"
      "section hip link hip\n"
      "section knee link knee\n"
      "in 0\n"
      "tmp hip_t0 = q[0] * q[1]\n"
      "tmp hip_t1 = hip_t0 - 0.25\n"
      "in 1\n"
      "tmp knee_t0 = sin hip_t1\n"
      "return out knee_t0 -hip_t0 0.0 -q[0] -0.25\n");
}

TEST_F(ProgramOfGraph, SectionsWithoutReachedStatementsAreLeftOut) {
  graph.begin_section("empty", "empty");
  graph.begin_section("link hip", "hip");
  const Expression sum = a + b;
  graph.begin_section("empty too", "empty");
  const Program p = program({sum});
  ASSERT_EQ(p.sections.size(), 1u);
  EXPECT_EQ(p.sections[0].title, "link hip");
  EXPECT_EQ(p.statements[0].section, 0);
}

TEST_F(ProgramOfGraph, NumbersRunOnThroughSectionsOfOnePrefix) {
  graph.begin_section("link hip: velocity", "hip");
  const Expression first = a + b;
  graph.begin_section("link knee: velocity", "knee");
  const Expression second = first * a;
  graph.begin_section("link hip: force", "hip");
  const Expression third = second * b;
  const Program p = program({third});
  EXPECT_EQ(statement_names(p), (std::vector<std::string>{"hip_t0", "knee_t0", "hip_t1"}));
}

TEST_F(ProgramOfGraph, NamesAreGivenOnceAndStayUnique) {
  const Expression sum = a + b, product = a * b, sine = sin(a), cosine = cos(a);
  graph.name(sum, {"wx"});
  graph.name(sum, {"wy"});      // already has a name
  graph.name(product, {"wx"});  // already taken
  graph.name(sine, {"wx"});
  graph.name(cosine, {"t_t0"});  // the name that a numbered value would get
  graph.name(a, {"input"});
  graph.name(graph.constant(0.5), {"constant"});
  graph.name(Expression(), {"zero"});
  const Expression unnamed = sqrt(a);
  const Program p = program({sum, product, sine, cosine, unnamed});
  EXPECT_EQ(statement_names(p), (std::vector<std::string>{"wx", "wx_2", "wx_3", "t_t0", "t_t0_2"}));
  EXPECT_TRUE(p.statements[0].named);
  EXPECT_FALSE(p.statements[4].named);
}

// The node of b - a is a - b: a value's name includes its sign.
TEST_F(ProgramOfGraph, ANegatedValueIsCalledSo) {
  const Expression difference = b - a;
  ASSERT_TRUE(difference.negative());
  graph.name(difference, {"az"});
  const Expression product = a * b;
  Quantity moment{"moment"};
  moment.negative = true;
  graph.name(-product, moment);
  const Program p = program({difference, product});
  EXPECT_EQ(statement_names(p), (std::vector<std::string>{"az_neg", "moment"}));
  EXPECT_TRUE(p.outputs[0].values[0].negative);
}

TEST_F(ProgramOfGraph, ConstantsArePositiveAndStandOnce) {
  const Program p = program({0.5 * a, graph.constant(-0.5) * b + graph.constant(0.5), graph.constant(-0.5)});
  ASSERT_EQ(p.constants.size(), 1u);
  EXPECT_EQ(p.constants[0].value(), 0.5);
}

TEST_F(ProgramOfGraph, AnOutputOfTheWrongSizeIsAnInternalFault) {
  EXPECT_THROW(
      graph.program("test", {{"q", Role::value, {"A", "B"}}}, {{"out", Role::value, 2, 2, {}}}, {{a, b}}),
      std::logic_error);
}

TEST_F(ProgramOfGraph, OutputsMayBeEmpty) {
  EXPECT_TRUE(program({}).outputs[0].values.empty());
}

}  // namespace
}  // namespace robcogen::symbolic::program_test
