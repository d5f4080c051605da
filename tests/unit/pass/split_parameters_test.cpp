// Values that depend only on parameters are computed separately; the rest of the program reads them from the cache.
#include "pass/split_parameters.h"

#include "symbolic/cost.h"
#include "symbolic/programs.h"

namespace robcogen::pass::split_parameters_test {
namespace {

using symbolic::Program;

// p: a length, an angle, a mass; a: variables.
Program parametric(const std::string& statements) {
  return test::program(
      "program test\n"
      "input p parameters length angle mass\n"
      "input a value 0 1\n"
      "output out value 2 1\n"
      "section hip link hip\n"
      "in 0\n" +
      statements);
}

const std::vector<Interfaces> kInterfaces = {{true, false}, {true, false}, {false, true}};

std::vector<double> run(const Program& program, const symbolic::Arrays<double>& inputs) {
  return symbolic::interpret<double>(program, inputs).at("out");
}

// The cache that the three updates fill.
std::vector<double> cache(const SplitPrograms& split, const std::vector<double>& parameters) {
  std::vector<double> all;
  for (const Program* update : {&split.kinematics, &split.dynamics, &split.both}) {
    const auto part = symbolic::interpret<double>(*update, {{"p", parameters}}).at("cache");
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

const char* const kPendulum =
    "let c = cos p[1]\n"
    "let torque = p[0] * p[2]\n"
    "let turned = torque * c\n"
    "tmp x = a[0] * turned\n"
    "tmp y = x + p[0]\n"
    "return out y -torque\n";

TEST(SplitParameters, LeavesWhatVariablesNeed) {
  const Program program = parametric(kPendulum);
  const SplitPrograms split = split_parameters({program}, kInterfaces);
  ASSERT_EQ(split.programs.size(), 1u);
  EXPECT_EQ(symbolic::cost(split.programs[0]).mul, 1);
  EXPECT_EQ(symbolic::cost(split.programs[0]).add, 1);
  EXPECT_EQ(symbolic::cost(split.programs[0]).sincos, 0);
  // The cache contains the length itself, nothing that depends only on masses, the torque and the turned torque.
  EXPECT_EQ(split.kinematics.outputs[0].rows, 1);
  EXPECT_EQ(split.dynamics.outputs[0].rows, 0);
  EXPECT_EQ(split.both.outputs[0].rows, 2);
  EXPECT_EQ(split.programs[0].inputs[0].elements, (std::vector<std::string>{"length", "turned", "torque"}));
}

TEST(SplitParameters, ChangesNoResult) {
  const Program program = parametric(kPendulum);
  const SplitPrograms split = split_parameters({program}, kInterfaces);
  const std::vector<double> a = {0.7, -0.2};
  for (const std::vector<double>& p : {std::vector<double>{0.5, 1.1, 3.0}, {2.0, -0.4, 0.25}}) {
    const std::vector<double> expected = run(program, {{"p", p}, {"a", a}});
    const std::vector<double> found = run(split.programs[0], {{"p", cache(split, p)}, {"a", a}});
    EXPECT_DOUBLE_EQ(found[0], expected[0]);
    EXPECT_DOUBLE_EQ(found[1], expected[1]);
  }
}

TEST(SplitParameters, SharesTheCacheAmongPrograms) {
  const Program first = parametric(kPendulum);
  const Program second = parametric("let t = p[2] * p[0]\ntmp z = t * a[1]\nreturn out z p[1]\n");
  const SplitPrograms split = split_parameters({first, second}, kInterfaces);
  // The second program adds the angle; the product of length and mass is already there.
  EXPECT_EQ(split.programs[1].inputs[0].elements, split.programs[0].inputs[0].elements);
  EXPECT_EQ(split.programs[0].inputs[0].elements, (std::vector<std::string>{"length", "angle", "turned", "torque"}));
}

// A value that depends on a parameter of both interfaces is computed by both updates.
TEST(SplitParameters, ComputesWithBothUpdatesWhatBothRead) {
  const Program program = parametric(kPendulum);
  const SplitPrograms split = split_parameters({program}, {{true, true}, {true, false}, {false, true}});
  EXPECT_EQ(split.kinematics.outputs[0].rows, 0);
  EXPECT_EQ(split.dynamics.outputs[0].rows, 0);
  EXPECT_EQ(split.programs[0].inputs[0].elements, (std::vector<std::string>{"turned", "length", "torque"}));
  const std::vector<double> p = {0.5, 1.1, 3.0}, a = {0.7, -0.2};
  const std::vector<double> expected = run(program, {{"p", p}, {"a", a}});
  EXPECT_DOUBLE_EQ(run(split.programs[0], {{"p", cache(split, p)}, {"a", a}})[0], expected[0]);
}

TEST(SplitParameters, LeavesAloneWhatHasNone) {
  const Program program = test::small_program("in 0\ntmp x = a[0] * a[1]\nreturn out x\n");
  const SplitPrograms split = split_parameters({program}, {});
  EXPECT_EQ(symbolic::print(split.programs[0]), symbolic::print(program));
  EXPECT_EQ(split.both.outputs[0].rows, 0);
}

TEST(SplitParameters, FoldsWhatCancels) {
  const Program program = parametric("let d = p[0] - p[0]\ntmp x = a[0] + d\nreturn out x d\n");
  const SplitPrograms split = split_parameters({program}, kInterfaces);
  EXPECT_TRUE(split.programs[0].statements.empty());
  EXPECT_EQ(run(split.programs[0], {{"p", {}}, {"a", {5.0, 0.0}}}), (std::vector<double>{5.0, 0.0}));
}

}  // namespace
}  // namespace robcogen::pass::split_parameters_test
