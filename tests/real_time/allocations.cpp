// Runs every function of one generated library while allocation aborts the program, and prints the cost of each. The
// functions come from the library's own table, so that none is left out. Compiled once per robot, with
//     ROBCOGEN_REFLECTION_HEADER   the generated header, as <…>
//     ROBCOGEN_ROBOT_NAMESPACE     the namespace of the generated code
//     ROBCOGEN_BATCH_HEADER        where the library has functions over many states
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <random>
#include <vector>

#include ROBCOGEN_REFLECTION_HEADER

#include "allocation_hook.h"

namespace {

constexpr int kCalls = 20;
// A value that no function computes.
constexpr double kUnwritten = 0x1.234567p+900;

// Moderate numbers. They are not a valid state of a robot with parameters, because its cache is random, too: a function
// must not allocate whatever its inputs are.
std::vector<double> random_numbers(std::mt19937_64& engine, int count) {
  std::vector<double> numbers(static_cast<std::size_t>(count));
  for (double& x : numbers) x = 0x1p-62 * static_cast<double>(engine() >> 1) - 1;
  return numbers;
}

#ifdef ROBCOGEN_BATCH_HEADER
constexpr const auto& kBatches = ROBCOGEN_ROBOT_NAMESPACE::reflection::batch_functions;
#else
constexpr robcogen::reflection::BatchFunctions kBatches = {nullptr, 0};
#endif

// Runs the same function over many states, element by element, if the library has it. Returns whether all results were
// written.
bool run_over_states(std::mt19937_64& engine, const robcogen::reflection::Function& f) {
  constexpr int kStates = 19;
  for (const robcogen::reflection::BatchFunction& many : kBatches) {
    if (std::strcmp(many.name, f.name) != 0) continue;
    const std::vector<double> parameters = random_numbers(engine, f.inputs - many.inputs);
    const std::vector<double> in = random_numbers(engine, kStates * many.inputs);
    std::vector<double> out(static_cast<std::size_t>(kStates * many.outputs), kUnwritten);
    {
      const robcogen::NoAllocation during(f.name);
      many.call(
          parameters.data(), kStates, {in.data(), kStates, 1}, {out.data(), kStates, 1}, robcogen::batch::best_level());
    }
    return std::count(out.begin(), out.end(), kUnwritten) == 0;
  }
  return true;
}

}  // namespace

int main() {
  const robcogen::reflection::Robot& robot = ROBCOGEN_ROBOT_NAMESPACE::reflection::robot;
  std::mt19937_64 engine(1);
  std::printf(
      "%s: %d functions, and %d over many states, without allocation\n%-44s %6s %6s %4s %4s %6s %12s %8s\n", robot.name,
      robot.functions.size, kBatches.size, "function", "mul", "add", "div", "sqrt", "sincos", "instructions", "cycles");
  for (const robcogen::reflection::Function& f : robot.functions) {
    const auto& n = f.count;
    std::printf(
        "%-44s %6d %6d %4d %4d %6d %12d %8d\n", f.name, n.mul, n.add, n.div, n.sqrt, n.sincos, n.instructions,
        n.critical_path);
    std::vector<double> out(static_cast<std::size_t>(f.outputs), kUnwritten);
    for (int i = 0; i < kCalls; ++i) {
      const std::vector<double> in = random_numbers(engine, f.inputs);
      const robcogen::NoAllocation during(f.name);
      f.call(in.data(), out.data());
    }
    if (std::count(out.begin(), out.end(), kUnwritten) > 0 || !run_over_states(engine, f)) {
      std::printf("%s leaves results out\n", f.name);
      return 1;
    }
  }
  std::printf("Straight-line code: the counts are those of every call. Cycles: the critical path.\n");
}
