// Every selection of passes gives the results of the program without passes.
#include <gtest/gtest.h>

#include "pass/passes.h"
#include "pass/statements.h"
#include "symbolic/programs.h"

namespace robcogen::pass::property_test {
namespace {

using symbolic::Program;

std::vector<std::string> chosen(unsigned choice) {
  std::vector<std::string> list;
  for (std::size_t k = 0; k < names().size(); ++k)
    if (choice >> k & 1U) list.push_back(names()[k]);
  return list;
}

std::string text(const std::vector<std::string>& list) {
  std::string result;
  for (const std::string& name : list) result += " " + name;
  return result;
}

TEST(PassProperty, ResultsStayTheSame) {
  const unsigned choices = 1U << names().size();
  for (unsigned seed = 0; seed < 600; ++seed) {
    test::RandomPrograms random(seed);
    const Program original = random.make();
    const std::vector<double> inputs = random.inputs();
    for (unsigned choice = 1; choice < choices; ++choice) {
      const std::vector<std::string> list = chosen(choice);
      const Program changed = run(original, list);
      ASSERT_EQ(verify(changed), "") << "seed " << seed << text(list);
      ASSERT_EQ(test::difference(original, changed, inputs), "") << "seed " << seed << text(list) << "\n"
                                                                 << print(original) << print(changed);
    }
  }
}

// Passes that only move and remove statements do not even change rounding.
TEST(PassProperty, PassesOnStatementsChangeNoBit) {
  for (unsigned seed = 0; seed < 600; ++seed) {
    test::RandomPrograms random(seed);
    const Program original = random.make();
    const symbolic::Arrays<double> inputs{{"a", random.inputs()}};
    const auto expected = symbolic::interpret<double>(original, inputs);
    for (const Program& changed : {sink(original), eliminate_dead_code(original)}) {
      EXPECT_EQ(symbolic::interpret<double>(changed, inputs), expected) << "seed " << seed;
      EXPECT_LE(changed.statements.size(), original.statements.size());
    }
  }
}

TEST(PassProperty, RunsAreIdentical) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Program p = test::RandomPrograms(seed).make();
    EXPECT_EQ(print(run(p)), print(run(p))) << "seed " << seed;
  }
}

// The work of every pass is linear in the program's length, and its depth does not matter.
TEST(PassProperty, LongChainsPass) {
  std::string statements = "in 0\ntmp s0 = a[0] + a[1]\n";
  constexpr int kLength = 20000;
  for (int k = 1; k < kLength; ++k)
    statements +=
        "tmp s" + std::to_string(k) + " = s" + std::to_string(k - 1) + " + a[" + std::to_string(k % 4) + "]\n";
  const Program p = test::small_program(statements + "return out s" + std::to_string(kLength - 1) + "\n");
  const double sum = symbolic::interpret<double>(run(p), {{"a", {1.0, 2.0, 4.0, 8.0}}}).at("out")[0];
  EXPECT_EQ(sum, 1.0 + 2.0 + kLength / 4 * 15.0 - 1.0);
}

}  // namespace
}  // namespace robcogen::pass::property_test
