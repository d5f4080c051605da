// Stages, run one after the other, compute what the whole program computes, to the last bit.
#include "symbolic/cut_program.h"

#include <limits>

#include "run_stage.h"
#include "support/index.h"

namespace robcogen::symbolic::cut_program_test {
namespace {

constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();

// What the stages make of the outputs. They read no element of the workspace before one of them writes it.
Arrays<double> run(const Stages& stages, const Arrays<double>& inputs, const std::vector<OutputArray>& outputs) {
  Arrays<double> all = inputs;
  for (const OutputArray& output : outputs) all[output.name].assign(at(output.rows * output.columns), kUnset);
  all[kWorkspace].assign(at(stages.workspace), kUnset);
  for (const Stage& stage : stages.list) {
    EXPECT_FALSE(stage.program.outputs.empty());
    if (stage.columns.empty()) test::run_stage(stage.program, all);
    for (const Stage::Columns& columns : stage.columns) {
      std::vector<double>& array = all.at(outputs[at(columns.output)].name);
      for (int k = 0; k < columns.runs; ++k) {
        const auto first = array.begin() + columns.first + k * columns.stride;
        all[kColumns].assign(first, first + columns.stride);
        test::run_stage(stage.program, all);
        std::copy(all.at(kColumns).begin(), all.at(kColumns).end(), first);
      }
    }
  }
  for (const auto& [name, values] : inputs) all.erase(name);
  all.erase(kWorkspace);
  all.erase(kColumns);
  return all;
}

TEST(CutProgram, ChangesNoBit) {
  std::size_t most = 0;
  int passed = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    test::RandomPrograms random(seed);
    const Program whole = random.make();
    const Arrays<double> inputs{{"a", random.inputs()}};
    const Arrays<double> expected = interpret<double>(whole, inputs);
    for (const int longest : {1, 4, 1000}) {
      const Stages stages = cut_program(whole, longest);
      if (longest == 1000) {
        EXPECT_EQ(stages.list.size(), 1u);
      }
      most = std::max(most, stages.list.size());
      passed += stages.workspace;
      ASSERT_EQ(run(stages, inputs, whole.outputs), expected) << "seed " << seed << "\n" << print(whole);
    }
  }
  EXPECT_GT(most, 5u);
  EXPECT_GT(passed, 100);
}

// Squares of squares, from x0 on.
std::string squares(const std::string& x, int count) {
  std::string text;
  for (int k = 1; k < count; ++k) {
    const std::string last = x + std::to_string(k - 1);
    text += "tmp " + x + std::to_string(k) + " = " + last + " * " + last + "\n";
  }
  return text;
}

// What took a hundred operations passes from the first stage to the second one, which needs as many; a sine is computed
// again.
TEST(CutProgram, PassesWhatCostsMoreToCompute) {
  const std::string text = "tmp s = sin a[0]\ntmp z = a[2] * a[3]\ntmp x0 = a[1] + s\n" + squares("x", 100) +
                           "tmp y = x99 * s\nin 1\ntmp w0 = x99 + y\n" + squares("w", 100) +
                           "tmp v = w99 * y\nreturn out v z\n";
  const Stages stages = cut_program(test::small_program(text, 2), 103);
  ASSERT_EQ(stages.list.size(), 2u);
  EXPECT_EQ(stages.workspace, 1);
  Program second = stages.list[1].program;
  EXPECT_EQ(second.statements.size(), 103u);
  ASSERT_EQ(second.outputs.size(), 1u);
  EXPECT_EQ(second.outputs[0].values[1], kNotWritten);
  second.outputs[0].values.pop_back();
  second.outputs[0].rows = 1;
  EXPECT_NE(
      print(second).find("in 0\ntmp s = sin a[0]\ntmp y = workspace[0] * s\nin 1\ntmp w0 = workspace[0] + y\n"),
      std::string::npos)
      << print(second);
  // The first stage writes the other element of the result, which is its own statement.
  const std::vector<OutputArray>& first = stages.list[0].program.outputs;
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[0].values[0], kNotWritten);
  EXPECT_NE(first[0].values[1], kNotWritten);
}

// An element of the workspace holds one value after another.
TEST(CutProgram, ReusesTheWorkspace) {
  std::string text = "tmp x0 = a[0] * a[1]\ntmp y0 = x0 * x0\n";
  for (int k = 1; k < 20; ++k) {
    const std::string last = std::to_string(k - 1), next = std::to_string(k);
    text += "tmp x" + next + " = y" + last + " + a[1]\ntmp y" + next + " = x" + next + " * x" + last + "\n";
  }
  const Program whole = test::small_program(text + "return out y19\n");
  const Stages stages = cut_program(whole, 4);
  EXPECT_GE(stages.list.size(), 10u);
  EXPECT_LE(stages.workspace, 4);
  const Arrays<double> inputs{{"a", {0.5, 0.25, 0, 0}}};
  EXPECT_EQ(run(stages, inputs, whole.outputs), interpret<double>(whole, inputs));
}

// Right-hand sides B, whose columns x with x0 = b0 * f0, x1 = (b1 - x0) * f1 replace them.
TEST(CutProgram, SolvesForColumnsTogether) {
  const std::string head = "program sides\ninput a value 0 1 2 3\noutput B matrix 2 ";
  for (const int columns : {1, 2, 3, 4, 8}) {
    std::string sides = head + std::to_string(columns + 1) +
                        "\noutput factor value 2 1\nsection hip link hip\nin 0\ntmp f = a[0] * a[1]\ntmp g = f + a[2]\n"
                        "tmp h = g * f\nreturn B";
    for (int k = 0; k <= columns; ++k) sides += std::string(k % 2 == 0 ? " h" : " g") + (k % 3 == 0 ? " -f" : " a[3]");
    const Program right_sides = test::program(sides + "\nreturn factor f g\n");
    SolvedColumns solved;
    solved.solution = test::program(
        "program solution\ninput factor value 0 1\ninput b value 0 1\noutput x value 2 1\nsection hip link hip\nin 0\n"
        "tmp square = factor[1] * factor[1]\ntmp x0 = b[0] * factor[0]\ntmp d = b[1] - x0\ntmp x1 = d * square\n"
        "return x x0 x1\n");
    solved.blocks = {{0, columns}};  // the last column stays
    const std::vector<OutputArray> outputs = {right_sides.outputs.front()};
    const Arrays<double> inputs{{"a", {0.5, -0.75, 0.25, 2}}};
    Arrays<double> expected = interpret<double>(right_sides, inputs);
    const std::vector<double> factor = expected.at("factor");
    expected.erase("factor");
    std::vector<double>& B = expected.at("B");
    for (int k = 0; k < columns; ++k) {
      const std::vector<double> x =
          interpret<double>(solved.solution, {{"factor", factor}, {"b", {B[at(2 * k)], B[at(2 * k + 1)]}}}).at("x");
      std::copy(x.begin(), x.end(), B.begin() + 2 * k);
    }
    for (const int longest : {1, 2, 100})
      EXPECT_EQ(run(cut_program(right_sides, solved, longest), inputs, outputs), expected) << columns << " columns";
    // What no right-hand side affects is computed once for all columns of a thread.
    const Program& last = cut_program(right_sides, solved, 100).list.back().program;
    EXPECT_EQ(last.statements.size(), 1u + 3u * static_cast<unsigned>(columns % 3 == 0 ? 3 : columns % 3));
  }
}

}  // namespace
}  // namespace robcogen::symbolic::cut_program_test
