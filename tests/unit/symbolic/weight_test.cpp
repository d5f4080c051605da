// The weight of a program that is not built equals the counts of the built program.
#include "symbolic/weight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "symbolic/count.h"

namespace robcogen::symbolic {
namespace {

// The program with these outputs.
Program program_of(const Graph& graph, const std::vector<std::vector<Expression>>& outputs) {
  std::vector<OutputArray> shapes;
  for (const std::vector<Expression>& values : outputs)
    shapes.push_back({"out" + std::to_string(shapes.size()), Role::value, static_cast<int>(values.size()), 1, {}});
  return graph.program("test", {{"a", Role::value, std::vector<std::string>(4)}}, shapes, outputs);
}

void expect_weight_of_program(const Graph& graph, const std::vector<std::vector<Expression>>& outputs) {
  const Program program = program_of(graph, outputs);
  const Weight found = weight(graph, outputs);
  double largest = 0.0;
  for (const Constant& c : program.constants) largest = std::max(largest, c.value());
  EXPECT_EQ(found.work, work(program));
  EXPECT_EQ(found.statements, static_cast<long>(program.statements.size()));
  EXPECT_EQ(found.largest_constant, largest);
}

TEST(Weight, OfProductsInSums) {
  Graph graph;
  const Expression a = graph.input(0), b = graph.input(1), c = graph.input(2), d = graph.input(3);
  const Expression product = a * b, shared = c * d;
  const Weight fused = weight(graph, {{product + c}});
  EXPECT_EQ(fused.work, 3);  // two operations in one instruction
  EXPECT_EQ(fused.statements, 2);
  EXPECT_EQ(weight(graph, {{product + c, product}}).work, 4);      // the product is also a result
  EXPECT_EQ(weight(graph, {{shared + a, shared + b}}).work, 5);    // both sums fuse with it
  EXPECT_EQ(weight(graph, {{sqrt(shared), shared + b}}).work, 4);  // the root needs it
}

TEST(Weight, LeavesOutWhatNoOutputNeeds) {
  Graph graph;
  const Expression a = graph.input(0), b = graph.input(1);
  const Expression needed = graph.constant(3.0) * a, other = graph.constant(5.0) * b;
  EXPECT_EQ(weight(graph, {{needed}}).statements, 1);
  EXPECT_EQ(weight(graph, {{needed}}).largest_constant, 3.0);
  EXPECT_EQ(weight(graph, {{needed}, {other}}).largest_constant, 5.0);
  EXPECT_EQ(weight(graph, {{a}}).work, 0);
}

TEST(Weight, IsThatOfTheProgram) {
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
    expect_weight_of_program(graph, outputs);
  }
}

}  // namespace
}  // namespace robcogen::symbolic
