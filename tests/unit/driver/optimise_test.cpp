// From programs to cheaper programs with the same results, in the forms that languages support.
#include "driver/optimise.h"

#include <algorithm>
#include <utility>

#include "documents.h"
#include "driver/declare.h"
#include "pass/passes.h"
#include "symbolic/cost.h"
#include "symbolic/interpret.h"

namespace robcogen::driver::optimise_test {
namespace {

using namespace test;
using symbolic::Program;
using symbolic::Role;

const symbolic::Arrays<double> kState = {{"q", {0.4, -1.1}}, {"qd", {1.5, 0.25}}, {"qdd", {-2.0, 3.0}}};

Functions optimised(const Model& model, const Steps& steps, const backend::Features& features = {}) {
  const std::vector<std::string> groups = {"inverse_dynamics"};
  return optimise(model, declare(model, groups), steps, features);
}

std::vector<double> tau_of(const Program& program, symbolic::Arrays<double> inputs = kState) {
  return symbolic::interpret<double>(program, inputs).at("tau");
}

void expect_same(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t j = 0; j < found.size(); ++j) EXPECT_NEAR(found[j], expected[j], 1e-12) << j;
}

bool reads(const Program& program, Role role) {
  return std::any_of(program.inputs.begin(), program.inputs.end(), [&](const symbolic::InputArray& array) {
    return array.role == role;
  });
}

TEST(Optimise, PassesMakeProgramsCheaperAndKeepResults) {
  const Model model = rods();
  Steps no_passes{algorithm::choices()};
  const Program before = optimised(model, no_passes).list.at(0).program;
  const Program after = optimised(model, {}).list.at(0).program;
  EXPECT_LE(symbolic::work(after), symbolic::work(before));
  expect_same(tau_of(after), tau_of(before));
  const Program plain = optimised(model, {{}}).list.at(0).program;
  EXPECT_LT(symbolic::work(after), symbolic::work(plain));
  expect_same(tau_of(after), tau_of(plain));
}

// Rounding errors of a robot's functions are measured; here they amount to a few roundings.
TEST(Optimise, RoundingErrorsAreMeasured) {
  for (const Function& f : optimised(rods(), {}).list) {
    ASSERT_TRUE(f.error);
    EXPECT_GT(f.error->in_double, 0);
    EXPECT_LT(f.error->in_double, 10);
    ASSERT_TRUE(f.results);
    EXPECT_TRUE(f.results->are_kept_by(f.program));
  }
}

TEST(Optimise, LanguagesThatTakeSinesGetThem) {
  const Model model = rods();
  const Functions without = optimised(model, {}), with = optimised(model, {}, {.takes_sines = true});
  EXPECT_FALSE(without.trigonometry);
  EXPECT_GT(symbolic::cost(without.list.at(0).program).sincos, 0);
  ASSERT_TRUE(with.trigonometry);
  EXPECT_GE(with.trigonometry->angle_count, 2);  // at least one for each joint
  EXPECT_TRUE(with.list.at(0).core);
}

TEST(Optimise, ParametersAreSplitOffWhereALanguageCachesThem) {
  const Folder folder;
  const Model model = loaded(folder.file("rods.kindsl", replaced(kRods, "mass = 2.0", "mass = heavy[2.0]")));
  const Functions whole = optimised(model, {}), split = optimised(model, {}, {.caches_parameters = true});
  EXPECT_TRUE(whole.updates.empty());
  ASSERT_EQ(split.updates.size(), 3U);  // kinematics, dynamics, both
  ASSERT_EQ(split.numbers.size(), 1U);
  const Program& kernel = split.list.at(0).program;
  ASSERT_TRUE(reads(kernel, Role::parameters));
  // Filling the cache part by part and then calling the function gives the result of the whole function of the
  // parameters.
  symbolic::Arrays<double> with_cache = kState, with_parameters = kState;
  const double heavy = 3.25;
  std::vector<double>& cache = with_cache[kernel.inputs.at(0).name];
  for (const backend::Function& update : split.updates) {
    symbolic::Arrays<double> inputs;
    if (!update.program.inputs.empty()) inputs[update.program.inputs[0].name] = {heavy};
    for (const auto& [name, part] : symbolic::interpret<double>(update.program, inputs))
      cache.insert(cache.end(), part.begin(), part.end());
  }
  const Program& reference = whole.list.at(0).program;
  with_parameters[reference.inputs.at(0).name] = {heavy};
  expect_same(tau_of(kernel, with_cache), tau_of(reference, with_parameters));
  EXPECT_LE(symbolic::cost(kernel).mul, symbolic::cost(reference).mul);
}

// Four legs with three joints each: one statement serves all legs.
TEST(Optimise, CongruentLimbsShareLanes) {
  const Model model = loaded(fs::path(ROBCOGEN_ROBOTS_DIR) / "quadruped_fixed" / "quadruped_fixed.kindsl");
  const Steps fast{all_steps(), 0}, no_lanes{pass::names(), 0};
  const auto first = [&](const Steps& steps, bool has_lanes) {
    return optimised(model, steps, {.has_lanes = has_lanes}).list.at(0);
  };
  EXPECT_FALSE(first(fast, false).in_lanes);
  EXPECT_FALSE(first(no_lanes, true).in_lanes);
  const Function f = first(fast, true);
  ASSERT_TRUE(f.in_lanes);
  ASSERT_EQ(f.limbs_in_lanes.size(), 1U);
  EXPECT_EQ(std::count(f.limbs_in_lanes[0].begin(), f.limbs_in_lanes[0].end(), ','), 3);
  EXPECT_LT(2 * symbolic::cost(*f.in_lanes).instructions, symbolic::cost(f.program).instructions);
  symbolic::Arrays<double> state;
  for (const char* array : {"q", "qd", "qdd"})
    for (int j = 0; j < 12; ++j) state[array].push_back(0.1 * j - 0.5);
  expect_same(tau_of(*f.in_lanes, state), tau_of(f.program, state));
}

TEST(Optimise, TransformsAreOptimisedToo) {
  const Folder folder;
  const Model model = loaded(folder.file("arm.ctdsl", kTransforms));
  const Functions functions = optimise(model, declare(model, {kTransformsGroup}), {}, {.takes_sines = true});
  ASSERT_EQ(functions.list.size(), 6U);
  EXPECT_FALSE(functions.trigonometry);
  for (const Function& f : functions.list) {
    const symbolic::Cost c = symbolic::cost(f.program);
    EXPECT_EQ(c.sincos, 1) << f.name;
    EXPECT_LE(c.mul, 4) << f.name;
  }
}

}  // namespace
}  // namespace robcogen::driver::optimise_test
