// Random programs: the kernel's text gives the program's results to the last bit.
#include <cmath>

#include "backend/cpp/lower.h"
#include "kernel_evaluator.h"
#include "programs.h"
#include "random_program.h"
#include "symbolic/cost.h"
#include "symbolic/interpret.h"
#include "symbolic/verify.h"

namespace robcogen::backend::cpp::lower_property_test {
namespace {

using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;

// Returns the program with only the statements that its outputs need; their counts are those of the text.
Program without_dead_statements(Program p) {
  std::vector<bool> needed(p.statements.size(), false);
  const auto need = [&](const Operand& o) {
    if (o.kind == Operand::Kind::statement) needed[static_cast<std::size_t>(o.index)] = true;
  };
  for (const symbolic::OutputArray& array : p.outputs)
    for (const Operand& o : array.values) need(o);
  for (std::size_t i = needed.size(); i-- > 0;) {
    if (!needed[i]) continue;
    need(p.statements[i].a);
    if (is_binary(p.statements[i].op)) need(p.statements[i].b);
  }
  std::vector<int> place(needed.size(), -1);
  std::vector<symbolic::Statement> kept;
  const auto move = [&](Operand& o) {
    if (o.kind == Operand::Kind::statement) o.index = place[static_cast<std::size_t>(o.index)];
  };
  for (std::size_t i = 0; i < needed.size(); ++i) {
    if (!needed[i]) continue;
    place[i] = static_cast<int>(kept.size());
    kept.push_back(p.statements[i]);
    move(kept.back().a);
    if (is_binary(kept.back().op)) move(kept.back().b);
  }
  p.statements = std::move(kept);
  for (symbolic::OutputArray& array : p.outputs)
    for (Operand& o : array.values) move(o);
  return p;
}

bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

TEST(LowerProperty, TheTextComputesWhatTheProgramComputes) {
  for (unsigned seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::RandomProgram source(seed);
    const Program program = source.make();
    ASSERT_EQ(symbolic::verify(program), "");

    symbolic::Arrays<double> inputs;
    test::KernelEvaluator::Values elements;
    for (const symbolic::InputArray& array : program.inputs) {
      for (std::size_t k = 0; k < array.elements.size(); ++k) {
        inputs[array.name].push_back(source.value());
        elements[array.name + "[" + std::to_string(k) + "]"] = inputs[array.name].back();
      }
    }
    const symbolic::Arrays<double> expected = symbolic::interpret(program, inputs);

    test::KernelEvaluator evaluator(elements);
    for (const Line& line : lower(program, "random").lines) {
      const std::size_t end = std::min(text(line).find('\n'), text(line).size());
      ASSERT_LE(end, 118u) << text(line);
      ASSERT_LE(text(line).size() - end, 121u) << text(line);
      ASSERT_NO_THROW(evaluator.run(text(line))) << text(line);
    }
    for (const auto& [name, values] : expected) {
      for (std::size_t k = 0; k < values.size(); ++k) {
        const auto found = evaluator.values().find(name + "[" + std::to_string(k) + "]");
        ASSERT_NE(found, evaluator.values().end()) << name << k;
        ASSERT_TRUE(same(found->second, values[k])) << name << k << ": " << found->second << " for " << values[k];
      }
    }

    const symbolic::Cost count = symbolic::cost(without_dead_statements(program));
    EXPECT_EQ(evaluator.count().mul, count.mul);
    EXPECT_EQ(evaluator.count().add, count.add);
    EXPECT_EQ(evaluator.count().div, count.div);
    EXPECT_EQ(evaluator.count().sqrt, count.sqrt);
    EXPECT_EQ(evaluator.count().sincos, count.sincos);
  }
}

// A chain of sums in which each statement could be inlined into the next.
Program chain(int length) {
  Program p = test::leg_program("return tau q[0]\n");
  for (int i = 0; i < length; ++i) {
    symbolic::Statement s;
    s.a = {Operand::Kind::input, i % 4, false};
    s.b = i == 0 ? Operand{Operand::Kind::input, 1, false} : Operand{Operand::Kind::statement, i - 1, false};
    s.name = "t" + std::to_string(i);
    p.statements.push_back(s);
  }
  p.outputs[0].values[0] = {Operand::Kind::statement, length - 1, false};
  return p;
}

// The number of lines for each statement hardly depends on the length; quadratic work would not end.
TEST(LowerProperty, LongChainsAreLoweredLikeShortOnes) {
  const std::size_t few = lower(chain(3000), "chain").lines.size(), many = lower(chain(300000), "chain").lines.size();
  EXPECT_GT(few, 10u);
  // Names with more digits leave less room on a line.
  EXPECT_GT(many, 100 * few);
  EXPECT_LT(many, 200 * few);
}

}  // namespace
}  // namespace robcogen::backend::cpp::lower_property_test
