// Programs rebuilt through a graph: text in, text out.
#include "symbolic/rebuild.h"

#include <optional>
#include <vector>

#include "programs.h"

namespace robcogen::symbolic::rebuild_test {
namespace {

const char* const kProgram =
    "program test\n"
    "input a value 0 1\n"
    "input b value 0\n"
    "output out value 2 1\n"
    "section hip link hip\n"
    "section knee link knee\n"
    "in 0\n"
    "let sum = a[0] + a[1]\n"
    "in 1\n"
    "let product = sum * b[0]\n"
    "return out -product sum\n";

TEST(Rebuild, KeepsAProgram) {
  const Program program = test::program(kProgram);
  Graph graph;
  Rebuild rebuild(graph, program);
  rebuild.keep_all();
  EXPECT_EQ(print(rebuild.finish()), kProgram);
}

TEST(Rebuild, ReadsReplacements) {
  const Program program = test::program(kProgram);
  Graph graph;
  const auto doubled = [&](const Operand& o) {
    return o.kind == Operand::Kind::input ? std::optional(2.0 * graph.input(o.index)) : std::nullopt;
  };
  Rebuild rebuild(graph, program, doubled);
  rebuild.keep_all();
  std::vector<InputArray> inputs = program.inputs;
  inputs.push_back({"more", Role::value, {"0"}});
  std::vector<OutputArray> shapes = program.outputs;
  std::vector<std::vector<Expression>> values = rebuild.outputs();
  shapes.push_back({"last", Role::value, 1, 1, {}});
  values.push_back({graph.input(3)});
  const Program more = rebuild.finish(inputs, shapes, values);
  EXPECT_EQ(verify(more), "");
  const Arrays<double> results = interpret<double>(more, {{"a", {2, 3}}, {"b", {5}}, {"more", {7}}});
  EXPECT_EQ(results.at("out"), (std::vector<double>{-100, 10}));
  EXPECT_EQ(results.at("last"), (std::vector<double>{7}));
}

TEST(Rebuild, TakesNewValues) {
  const Program program = test::program(kProgram);
  Graph graph;
  Rebuild rebuild(graph, program);
  rebuild.enter_section_of(0);
  rebuild.set(0, graph.input(0) + graph.input(2));
  rebuild.enter_section_of(1);
  rebuild.set(1, rebuild.compute(1));
  const Program changed = rebuild.finish();
  EXPECT_EQ(interpret<double>(changed, {{"a", {2, 3}}, {"b", {5}}}).at("out"), (std::vector<double>{-35, 7}));
}

}  // namespace
}  // namespace robcogen::symbolic::rebuild_test
