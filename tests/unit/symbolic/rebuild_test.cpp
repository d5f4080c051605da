// Programs rebuilt through a graph: text in, text out.
#include "symbolic/rebuild.h"

#include "programs.h"

namespace robcogen::symbolic {
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
  Rebuild rebuild(program);
  rebuild.keep_all();
  EXPECT_EQ(print(rebuild.finish()), kProgram);
}

TEST(Rebuild, MovesInputsBehindAnotherArray) {
  const Program program = test::program(kProgram);
  Rebuild rebuild(program, 1, {"more", Role::value, {"0", "1", "2"}});
  rebuild.keep_all();
  std::vector<OutputArray> shapes = program.outputs;
  std::vector<std::vector<Expression>> values = rebuild.outputs();
  shapes.push_back({"last", Role::value, 2, 1, {}});
  values.push_back({rebuild.added_input(2), rebuild.input(2)});
  const Program more = rebuild.finish(shapes, values);
  EXPECT_EQ(verify(more), "");
  EXPECT_EQ(
      print(more),
      "program test\n"
      "input a value 0 1\n"
      "input more value 0 1 2\n"
      "input b value 0\n"
      "output out value 2 1\n"
      "output last value 2 1\n"
      "section hip link hip\n"
      "section knee link knee\n"
      "in 0\n"
      "let sum = a[0] + a[1]\n"
      "in 1\n"
      "let product = sum * b[0]\n"
      "return out -product sum\n"
      "return last more[2] b[0]\n");
}

TEST(Rebuild, TakesNewValues) {
  const Program program = test::program(kProgram);
  Rebuild rebuild(program);
  rebuild.enter_section_of(0);
  rebuild.set(0, rebuild.input(0) + rebuild.input(2));
  rebuild.enter_section_of(1);
  rebuild.set(1, rebuild.compute(1));
  const Program changed = rebuild.finish();
  EXPECT_EQ(interpret<double>(changed, {{"a", {2, 3}}, {"b", {5}}}).at("out"), (std::vector<double>{-35, 7}));
}

}  // namespace
}  // namespace robcogen::symbolic
