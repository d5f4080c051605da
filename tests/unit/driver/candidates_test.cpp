// Passes keep the accuracy of the plain recursions; candidates that lose digits are followed by others.
#include "driver/candidates.h"

#include <map>
#include <set>
#include <string>
#include <vector>

#include "documents.h"
#include "driver/declare.h"
#include "driver/steps.h"
#include "pass/passes.h"
#include "symbolic/cost.h"
#include "symbolic/text.h"
#include "symbolic/verify.h"

namespace robcogen::driver::candidates_test {
namespace {

using namespace test;
using symbolic::Program;

struct Inverse {
  Model model = rods();
  Functions functions = declare(model, {"inverse_dynamics"});
  FormulationsByEffort by_effort{*model.robot(), Steps().formulation()};
  Formulations& formulations = by_effort.with(1);

  Program program(Formulated formulated) { return traced(functions.list.at(0), formulations.of(formulated)).program; }
};

TEST(Candidates, TheFirstOneIsWhatThePassesMake) {
  Inverse f;
  const Functions after = choose_candidates(*f.model.robot(), f.functions, f.by_effort, pass::names(), {});
  ASSERT_EQ(after.list.size(), f.functions.list.size());
  const Function& chosen = after.list.front();
  EXPECT_EQ(chosen.name, f.functions.list.front().name);
  EXPECT_EQ(print(chosen.program), print(pass::run(f.program(Formulated::searched), pass::names())));
  EXPECT_TRUE(chosen.is_first_choice);
  ASSERT_TRUE(chosen.results && chosen.error);
  EXPECT_EQ(chosen.results->error_of(chosen.program).in_double, chosen.error->in_double);
}

// Each search takes the effort with which its first function costs least, and of equal ones the most.
TEST(Candidates, TakeTheEffortThatCostsLeast) {
  Inverse f;
  FormulationsByEffort by_effort(*f.model.robot(), Steps{.effort = 5}.formulation());
  EXPECT_EQ(by_effort.efforts(), (std::vector<int>{5, 2, 1, 0}));
  const Functions declared = declare(f.model, {"inverse_dynamics", "joint_space_inertia", "transforms"});
  const auto efforts_if = [&](const CostOfPrinted& cost) {
    std::map<algorithm::Search, std::set<int>> efforts;
    for (const Function& function : choose_candidates(*f.model.robot(), declared, by_effort, pass::names(), cost).list)
      efforts[function.declared->is->program.search].insert(function.effort);
    return efforts;
  };
  using algorithm::Search;
  using Efforts = std::map<Search, std::set<int>>;
  const auto inertia_at_two = [](const Function& function) {
    return function.name == "joint_space_inertia" && function.effort == 2 ? 0 : 1;
  };
  EXPECT_EQ(
      efforts_if(inertia_at_two), (Efforts{{Search::newton_euler, {5}}, {Search::inertia, {2}}, {Search::none, {5}}}));
  EXPECT_EQ(efforts_if({}), (Efforts{{Search::newton_euler, {5}}, {Search::inertia, {5}}, {Search::none, {5}}}));
  const auto less_is_better = [](const Function& function) { return function.effort; };
  EXPECT_EQ(efforts_if(less_is_better).at(Search::newton_euler), std::set<int>{0});
  // The other overloads may differ.
  const auto less_is_better_for_one = [&](const Function& function) {
    return function.kernel == declared.list.front().kernel ? function.effort : -function.effort;
  };
  EXPECT_EQ(efforts_if(less_is_better_for_one).at(Search::newton_euler), (std::set<int>{0, 5}));
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

// The candidates are traced in turn, as long as they lose digits.
TEST(Candidates, ThatLoseDigitsAreFollowedByTheNext) {
  Inverse f;
  const symbolic::AccurateResults results(f.program(Formulated::reference));
  const std::vector<std::vector<Recipe>> list = recipes({"reassociate", "sum"});
  std::vector<std::string> made;
  const auto first_that_keeps = [&](Formulated formulated) {
    made.clear();
    return choose(list, results, [&](const Recipe& recipe) {
      made.push_back(print(recipe));
      symbolic::Function function;
      function.program = f.program(recipe.formulated);
      if (recipe.formulated != formulated) function.program = with_lost_digits(function.program);
      EXPECT_EQ(verify(function.program), "");
      return function;
    });
  };
  using List = std::vector<std::string>;
  EXPECT_EQ(first_that_keeps(Formulated::searched).recipe, list.at(0).at(0));
  EXPECT_EQ(made, (List{"searched: reassociate, sum"}));
  EXPECT_EQ(first_that_keeps(Formulated::unsearched).recipe, list.at(1).at(0));
  EXPECT_EQ(made, (List{"searched: reassociate, sum", "unsearched: reassociate, sum", "searched: sum"}));
  EXPECT_EQ(first_that_keeps(Formulated::plainly).recipe, list.at(2).at(0));
  const Candidate last = first_that_keeps(Formulated::for_lanes);  // none
  EXPECT_EQ(last.recipe, (Recipe{Formulated::plainly, {}}));
  EXPECT_EQ(made.size(), 5U);
  EXPECT_TRUE(last.function.error);
}

// A new way to compute functions, here without the search and without sums in another order, is one more recipe.
TEST(Candidates, ANewOne) {
  Inverse f;
  std::vector<std::vector<Recipe>> list = recipes(pass::names());
  Passes passes = pass::names();
  std::erase(passes, "reassociate");
  const Recipe added = {Formulated::unsearched, passes};
  list.insert(list.begin() + 1, {added});
  const symbolic::AccurateResults results(f.program(Formulated::reference));
  const Candidate chosen = choose(list, results, [&](const Recipe& recipe) {
    symbolic::Function function = traced(f.functions.list.at(0), f.formulations.of(recipe.formulated));
    function.program = pass::run(function.program, recipe.passes);
    if (recipe == list.front().front()) function.program = with_lost_digits(function.program);
    return function;
  });
  EXPECT_EQ(chosen.recipe, added);
  EXPECT_LT(chosen.function.error->in_double, 10);
}

// Of two candidates of which neither is known to be cheaper, the one with less work is tried first.
TEST(Candidates, OfOneKindAreTriedByTheirWork) {
  Inverse f;
  const Program sound = f.program(Formulated::reference);
  const symbolic::AccurateResults results(sound);
  const Recipe cheap = {Formulated::unsearched, {}}, dear = {Formulated::searched, {}};
  const Candidate chosen = choose({{dear, cheap}}, results, [&](const Recipe& recipe) {
    symbolic::Function function;
    function.program = recipe == dear ? f.program(Formulated::plainly) : pass::run(sound, pass::names());
    return function;
  });
  EXPECT_EQ(chosen.recipe, cheap);
}

}  // namespace
}  // namespace robcogen::driver::candidates_test
