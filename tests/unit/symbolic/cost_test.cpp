// Costs of programs small enough to count by hand, and of programs that are not built.
#include "symbolic/cost.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "programs.h"

namespace robcogen::symbolic::cost_test {
namespace {

Cost counted(const std::string& statements, int outputs = 1) {
  return cost(test::small_program(statements, outputs));
}

TEST(Cost, NothingCostsNothing) {
  const Cost c = counted("return out -a[0]\n");
  EXPECT_EQ(c.mul + c.add + c.div + c.sqrt + c.sincos + c.instructions + c.critical_path, 0);
}

TEST(Cost, EachOperationInItsColumn) {
  const Cost c = counted(
      "let a1 = a[0] + a[1]\n"
      "let a2 = a1 - a[2]\n"
      "let m1 = a2 * a[3]\n"
      "let d1 = m1 / a[1]\n"
      "let r1 = sqrt d1\n"
      "let s1 = sin r1\n"
      "return out s1 r1\n",
      2);
  EXPECT_EQ(c.add, 2);
  EXPECT_EQ(c.mul, 1);
  EXPECT_EQ(c.div, 1);
  EXPECT_EQ(c.sqrt, 1);
  EXPECT_EQ(c.sincos, 1);
  EXPECT_EQ(c.instructions, 3);  // divisions, roots and sines are counted separately
  EXPECT_EQ(c.critical_path, 4 + 4 + 4 + 14 + 14);
}

TEST(Cost, SineAndCosineOfOneAngleAreOne) {
  EXPECT_EQ(counted("let s = sin a[0]\nlet c = cos a[0]\nreturn out s c\n", 2).sincos, 1);
  EXPECT_EQ(counted("let s = sin a[0]\nlet c = cos -a[0]\nreturn out s c\n", 2).sincos, 1);
  EXPECT_EQ(counted("let s = sin a[0]\nlet c = cos a[1]\nreturn out s c\n", 2).sincos, 2);
  // Statement 0 is different from input 0.
  EXPECT_EQ(counted("let t = a[0] * a[1]\nlet s = sin t\nlet c = cos a[0]\nreturn out s c\n", 2).sincos, 2);
}

TEST(Cost, ASumSwallowsOneProduct) {
  EXPECT_EQ(counted("let m = a[0] * a[1]\nlet s = m + a[2]\nreturn out s\n").instructions, 1);
  EXPECT_EQ(counted("let m = a[0] * a[1]\nlet s = a[2] - m\nreturn out s\n").instructions, 1);
  EXPECT_EQ(counted("let m = a[0] * a[1]\nlet n = a[2] * a[3]\nlet s = m + n\nreturn out s\n").instructions, 2);
}

TEST(Cost, AProductThatSomethingElseReadsStays) {
  EXPECT_EQ(counted("let m = a[0] * a[1]\nlet s = m + a[2]\nreturn out s m\n", 2).instructions, 2);
  EXPECT_EQ(counted("let m = a[0] * a[1]\nlet s = m + a[2]\nlet n = m * a[2]\nreturn out s n\n", 2).instructions, 3);
}

TEST(Cost, AProductInTwoSumsIsSwallowedByBoth) {
  EXPECT_EQ(counted("let m = a[0] * a[1]\nlet s = m + a[2]\nlet t = m + a[3]\nreturn out s t\n", 2).instructions, 2);
}

// fma(a, b, m) would still need m.
TEST(Cost, ASumOfAProductWithItselfSwallowsNothing) {
  EXPECT_EQ(counted("let m = a[0] * a[1]\nlet s = m + m\nreturn out s\n").instructions, 2);
}

// m, which has one use, fuses with the sum that it shares with n; n, which has two uses, is then needed separately.
TEST(Cost, ProductsWithFewestUsesAreSwallowedFirst) {
  EXPECT_EQ(
      counted(
          "let n = a[0] * a[1]\n"
          "let m = a[2] * a[3]\n"
          "let s = n + m\n"
          "let t = n + a[2]\n"
          "return out s t\n",
          2)
          .instructions,
      3);
}

// A chain of n fused operations: one product that is not fused, then n - 1 sums, each fused with a product.
TEST(Cost, ADotProductIsAChain) {
  const Cost c = counted(
      "let m0 = a[0] * a[0]\n"
      "let m1 = a[1] * a[1]\n"
      "let s1 = m0 + m1\n"
      "let m2 = a[2] * a[2]\n"
      "let s2 = s1 + m2\n"
      "return out s2\n");
  EXPECT_EQ(c.mul, 3);
  EXPECT_EQ(c.add, 2);
  EXPECT_EQ(c.instructions, 3);
  EXPECT_EQ(c.critical_path, 4 + 4 + 4);
}

TEST(Cost, TheCriticalPathFusesAtTheLaterFactor) {
  // x is ready at 4, and fma(x, a, b) at 8.
  EXPECT_EQ(counted("let x = a[0] + a[1]\nlet m = x * a[2]\nlet s = m + a[3]\nreturn out s\n").critical_path, 8);
  // The addend is late; in fused form, the sum waits only for the addend.
  EXPECT_EQ(
      counted("let x = a[0] / a[1]\n"
              "let m = a[2] * a[3]\n"
              "let s = m - x\n"
              "return out s\n")
          .critical_path,
      14 + 4);
}

TEST(Cost, TheCriticalPathIsOfTheLatestOutput) {
  EXPECT_EQ(
      counted("let x = a[0] + a[1]\nlet y = a[0] / a[1]\nlet dead = sqrt y\nreturn out x y\n", 2).critical_path, 14);
}

TEST(Cost, SinesAreGiven) {
  EXPECT_EQ(counted("let x = a[0] + a[1]\nlet s = sin x\nlet m = s * a[2]\nreturn out m\n").critical_path, 4);
}

// Programs of two arrays of two elements: k, which has this role, and variables x.
Program of_two_inputs(const std::string& role, const std::string& statements, const std::string& returns) {
  return test::program(
      "program test\n"
      "input k " +
      role +
      " 0 1\n"
      "input x value 0 1\n"
      "output out value 2 1\n"
      "section hip link hip\n"
      "in 0\n" +
      statements + "return out " + returns + "\n");
}

// Parameters change rarely, so values that depend only on them take no time.
TEST(PredictedTime, IsThatBetweenTwoChangesOfTheParameters) {
  const auto program = [](const std::string& role) {
    return of_two_inputs(
        role,
        "let d = k[0] / k[1]\n"
        "let e = sqrt d\n"
        "let y = e * x[0]\n"
        "let z = y + x[1]\n",
        "z e");
  };
  EXPECT_EQ(predicted_time(program("value")), 14 + 14 + 4);
  EXPECT_EQ(predicted_time(program("parameters")), 4);
}

// An operation on all lanes counts once; bringing numbers together or apart is a move.
TEST(Cost, LanesCountOnce) {
  const Cost c = cost(of_two_inputs(
      "value", "tmp a = gather k[0] k[1]\ntmp b = gather x[0] x[1]\ntmp m = a * b\ntmp s = m + a\n", "s@0 s@1"));
  EXPECT_EQ(c.mul, 1);
  EXPECT_EQ(c.add, 1);
  EXPECT_EQ(c.instructions, 1);
  EXPECT_EQ(c.moves, 1 + 1 + 2);  // gathers, and outputs that are lanes
  EXPECT_EQ(c.critical_path, 4);
}

// All lanes together count as one sine, from which a single lane can be read; sines of single lanes count one each.
TEST(Cost, SinesOfLanesAreOneAndThoseOfSingleLanesOneEach) {
  const std::string x = "tmp x = gather k[0] k[1]\n";
  EXPECT_EQ(cost(of_two_inputs("value", x + "tmp s = sin x\ntmp c = cos x@0\n", "s@0 c")).sincos, 1);
  EXPECT_EQ(cost(of_two_inputs("value", x + "tmp s = sin x@0\ntmp c = cos x@0\n", "s c")).sincos, 1);
  EXPECT_EQ(cost(of_two_inputs("value", x + "tmp s = sin x@0\ntmp c = cos x@1\n", "s c")).sincos, 2);
}

TEST(Cost, ASumOfLanesWaitsForHalves) {
  const Cost c =
      cost(of_two_inputs("value", "tmp a = gather k[0] k[1]\ntmp m = a * x[0]\ntmp s = sum_lanes m\n", "s s"));
  EXPECT_EQ(c.instructions, 1);
  EXPECT_EQ(c.moves, 1 + 2);
  EXPECT_EQ(c.critical_path, 4 + 3 + 4);
}

// Vectors of numbers are prepared in advance; a gather of computed values has to be waited for.
TEST(Cost, AGatherOfNumbersIsFree) {
  const Cost numbers =
      cost(of_two_inputs("value", "tmp a = gather 0.5 -0.25\ntmp m = a * x[0]\ntmp s = sum_lanes m\n", "s s"));
  EXPECT_EQ(numbers.moves, 2);
  const Cost computed = cost(of_two_inputs(
      "value", "tmp y = x[0] + x[1]\ntmp a = gather y x[1]\ntmp m = a * x[0]\ntmp s = sum_lanes m\n", "s s"));
  EXPECT_EQ(computed.critical_path, 4 + 3 + 4 + 3 + 4);
}

// A gather of parameters depends only on them, and so does everything computed from it.
TEST(Work, AGatherOfParametersIsGiven) {
  const auto program = [](const std::string& role) {
    return of_two_inputs(
        role, "tmp f = gather k[0] k[1]\ntmp g = gather x[0] x[1]\ntmp r = f * f\ntmp m = r * g\ntmp s = m + x[1]\n",
        "s@0 s@1");
  };
  EXPECT_EQ(work(program("value")), 2 * 3 - 1);
  EXPECT_EQ(work(program("parameters")), 2 * 2 - 1);
}

// A gather with a lane that is not a parameter is not counted as given.
TEST(Work, AGatherOfParametersAndOthersIsNotGiven) {
  const Program program = of_two_inputs("parameters", "tmp f = gather k[0] x[0]\ntmp r = f * f\n", "r@0 r@1");
  EXPECT_EQ(work(program), 2);
  EXPECT_EQ(
      work(of_two_inputs("parameters", "tmp f = gather k[0] k[1]\ntmp r = f * f\ntmp m = r@0 * x[0]\n", "m r@1")), 2);
}

// The program with these outputs.
Program program_of(const Graph& graph, const std::vector<std::vector<Expression>>& outputs) {
  std::vector<OutputArray> shapes;
  for (const std::vector<Expression>& values : outputs)
    shapes.push_back({"out" + std::to_string(shapes.size()), Role::value, static_cast<int>(values.size()), 1, {}});
  return graph.program("test", {{"a", Role::value, std::vector<std::string>(4)}}, shapes, outputs);
}

void expect_cost_of_program(const Graph& graph, const std::vector<std::vector<Expression>>& outputs) {
  const Program program = program_of(graph, outputs);
  const TracedCost found = traced_cost(graph, outputs);
  double largest = 0.0;
  for (const Constant& c : program.constants) largest = std::max(largest, c.value());
  EXPECT_EQ(found.work, work(program));
  EXPECT_EQ(found.statements, static_cast<long>(program.statements.size()));
  EXPECT_EQ(found.largest_constant, largest);
}

TEST(TracedCost, OfProductsInSums) {
  Graph graph;
  const Expression a = graph.input(0), b = graph.input(1), c = graph.input(2), d = graph.input(3);
  const Expression product = a * b, shared = c * d;
  const TracedCost fused = traced_cost(graph, {{product + c}});
  EXPECT_EQ(fused.work, 3);  // two operations in one instruction
  EXPECT_EQ(fused.statements, 2);
  EXPECT_EQ(traced_cost(graph, {{product + c, product}}).work, 4);          // the product is also a result
  EXPECT_EQ(traced_cost(graph, {{shared + a, shared + b}}).work, 5);        // both sums fuse with it
  EXPECT_EQ(traced_cost(graph, {{sqrt(shared), shared + b}}).work, 8 + 4);  // the root, which needs it
}

TEST(TracedCost, LeavesOutWhatNoOutputNeeds) {
  Graph graph;
  const Expression a = graph.input(0), b = graph.input(1);
  const Expression needed = graph.constant(3.0) * a, other = graph.constant(5.0) * b;
  EXPECT_EQ(traced_cost(graph, {{needed}}).statements, 1);
  EXPECT_EQ(traced_cost(graph, {{needed}}).largest_constant, 3.0);
  EXPECT_EQ(traced_cost(graph, {{needed}, {other}}).largest_constant, 5.0);
  EXPECT_EQ(traced_cost(graph, {{a}}).work, 0);
}

TEST(TracedCost, IsThatOfTheProgram) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    std::mt19937 random(seed);
    const auto pick = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
    Graph graph;
    std::vector<Expression> known = {graph.input(0), graph.input(1),      graph.input(2),
                                     graph.input(3), graph.constant(0.5), graph.constant(7.0)};
    for (int i = 0; i < 120; ++i) {
      const Expression a = known[pick(known.size())], b = known[pick(known.size())];
      const Expression e[] = {a + b, a - b, a * b, a * b, sin(a), b.is_zero() ? a : a / b};
      const Expression& chosen = e[pick(std::size(e))];
      if (!chosen.is_constant()) known.push_back(chosen);
    }
    std::vector<std::vector<Expression>> outputs(2);
    for (int i = 0; i < 6; ++i) outputs[pick(2)].push_back(known[pick(known.size())]);
    SCOPED_TRACE(seed);
    expect_cost_of_program(graph, outputs);
  }
}

// A product costs 2, or nothing itself if it is fused with a sum; divisions and roots cost 8; sines cost nothing here,
// because they are needed anyway.
TEST(WorkSince, TheMark) {
  Graph graph;
  const Expression a = graph.input(0), b = graph.input(1), c = graph.input(2);
  const std::size_t begin = graph.mark();
  EXPECT_EQ(work_since(graph, begin), 0);
  const Expression product = a * b;
  EXPECT_EQ(work_since(graph, begin), 2);
  product + c;
  EXPECT_EQ(work_since(graph, begin), 3);
  const std::size_t middle = graph.mark();
  a + c;
  EXPECT_EQ(work_since(graph, middle), 2);
  a / c;
  EXPECT_EQ(work_since(graph, middle), 10);
  sqrt(a);
  EXPECT_EQ(work_since(graph, middle), 18);
  sin(a);
  cos(a);
  graph.constant(0.3);
  a* b;  // known already
  EXPECT_EQ(work_since(graph, middle), 18);
  EXPECT_EQ(work_since(graph, begin), 21);
}

}  // namespace
}  // namespace robcogen::symbolic::cost_test
