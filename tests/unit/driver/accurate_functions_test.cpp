// Passes keep the accuracy of the plain recursions; programs that lose digits are traced again.
#include "driver/accurate_functions.h"

#include "documents.h"
#include "driver/trace.h"
#include "pass/passes.h"
#include "symbolic/cost.h"
#include "symbolic/text.h"
#include "symbolic/verify.h"

namespace robcogen::driver {
namespace {

using namespace test;
using symbolic::Program;

Functions traced(const Model& model) {
  return trace(model, {"inverse_dynamics"}, {});
}

TEST(AccurateFunctions, AreThoseThatThePassesMake) {
  const Model model = rods();
  const Functions before = traced(model);
  const Functions after = run_accurate_passes(*model.robot(), before, Steps().formulation(), pass::names());
  ASSERT_EQ(after.list.size(), before.list.size());
  for (std::size_t k = 0; k < after.list.size(); ++k) {
    const Function& f = after.list[k];
    EXPECT_EQ(f.traced.name, before.list[k].traced.name);
    EXPECT_EQ(print(f.traced.program), print(pass::run(before.list[k].traced.program, pass::names())));
    ASSERT_TRUE(f.results && f.traced.error);
    EXPECT_EQ(f.results->error_of(f.traced.program).in_double, f.traced.error->in_double);
  }
}

// A large number is added and subtracted again: the result is mathematically the same, but eight digits are lost.
Program with_lost_digits(Program p) {
  const int large = static_cast<int>(p.constants.size());
  p.constants.push_back(*Number::parse("1e8"));
  using symbolic::Op;
  using symbolic::Operand;
  const Operand number{Operand::Kind::constant, large, false};
  for (Operand& value : p.outputs.at(0).values) {
    for (const Op op : {Op::add, Op::subtract}) {
      const int index = static_cast<int>(p.statements.size());
      p.statements.push_back({op, value, number, "lost_" + std::to_string(index), 0, true});
      value = {Operand::Kind::statement, index, false};
    }
  }
  return p;
}

TEST(AccurateFunctions, ThatLoseDigitsAreTracedAgain) {
  const Model model = rods();
  Functions before = traced(model);
  Function& spoilt = before.list.at(0);
  const Program sound = spoilt.traced.program;
  spoilt.traced.program = with_lost_digits(sound);
  ASSERT_EQ(verify(spoilt.traced.program), "");
  spoilt.congruent = sound;  // dropped together with the program
  const Functions after = run_accurate_passes(*model.robot(), before, Steps().formulation(), {});
  const Function& f = after.list.at(0);
  EXPECT_FALSE(f.results->are_kept_by(spoilt.traced.program));
  EXPECT_TRUE(f.results->are_kept_by(f.traced.program));
  EXPECT_LE(symbolic::cost(f.traced.program).add, symbolic::cost(sound).add + 2);
  EXPECT_FALSE(f.congruent);
  EXPECT_TRUE(after.list.at(1).traced.error);
}

}  // namespace
}  // namespace robcogen::driver
