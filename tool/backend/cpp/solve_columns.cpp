#include "backend/cpp/solve_columns.h"

#include <vector>

#include "backend/cpp/batch_kernels.h"
#include "backend/cpp/layout.h"
#include "support/index.h"

namespace robcogen::backend::cpp {
namespace {

using symbolic::SolvedColumns;

// Prints the solver for columns of limbs.
std::string print_limb_solver(const SolvedColumns::Limbs& limbs) {
  const int numbers = static_cast<int>(limbs.own.size()) / limbs.count;
  std::vector<std::string> places = {"short"}, arguments;
  for (const int element : limbs.own) places.push_back(std::to_string(element));
  for (const int n : {limbs.count, limbs.joints, numbers}) arguments.push_back(std::to_string(n));
  arguments.emplace_back("std::decay_t<decltype(solver)>");
  return template_call("using Places = std::integer_sequence", places, "", 4) +
         declaration(
             "const auto solve_limbs = []",
             {"const auto* f", "const auto* own", "const auto* is_limb", "const auto* b", "auto* x"}, " noexcept {",
             4) +
         "      " + limbs.solution.name + "(f, own, is_limb, b, x);\n    };\n" +
         template_call("const robcogen::LimbSolver", arguments, " of_limbs(solver, factor, Places())", 4);
}

// Prints the solution of all blocks of right-hand sides. Columns of limbs are solved together if they fill the lanes of
// a register. `arrays`: the names of the outputs.
std::string print_solutions_of_blocks(const SolvedColumns& solved, const std::vector<std::string>& arrays) {
  const std::size_t inner = solved.limbs ? 4 : 2;
  std::string one_by_one, of_limbs, rest;
  for (const SolvedColumns::Block& block : solved.blocks) {
    const auto each = [&](std::size_t indent) {
      return call("solver.solve", {arrays[at(block.output)], std::to_string(block.columns), "solve"}, indent);
    };
    if (!block.of_limbs) {
      rest += each(2);
      continue;
    }
    one_by_one += each(inner);
    of_limbs += call("of_limbs.solve", {arrays[at(block.output)], "solve_limbs"}, inner);
  }
  if (!solved.limbs) return rest;
  return "  if constexpr (robcogen::kFillsLanes<Scalar, " + std::to_string(solved.limbs->count) + ">) {\n" +
         print_limb_solver(*solved.limbs) + of_limbs + "  } else {\n" + one_by_one + "  }\n" + rest;
}

}  // namespace

std::string solve_columns(const Callable& callable) {
  const SolvedColumns& solved = *callable.function->solved;
  const std::string factor = solved.right_sides.outputs.front().name;
  const std::string size = std::to_string(solved.right_sides.outputs.front().rows);
  const std::vector<symbolic::OutputArray>& outputs = callable.function->program.outputs;
  const std::string rows = std::to_string(outputs[at(solved.blocks.front().output)].rows);
  std::vector<std::string> arguments = names_of(callable.parameters);
  const std::vector<std::string> results(
      arguments.end() - static_cast<std::ptrdiff_t>(outputs.size()), arguments.end());
  arguments.push_back(factor);
  const std::string head =
      declaration("  const auto solve = []", {"const auto* f", "const auto* b", "auto* x"}, " noexcept {");
  const std::string body = solved.solution.name + "(f, b, x);",
                    line = head.substr(0, head.size() - 1) + " " + body + " };\n";
  const std::string solve = line.size() <= kColumns + 1 ? line : head + "    " + body + "\n  };\n";
  return "  Scalar " + factor + "[" + size + "];\n" + call(solved.right_sides.name, arguments, 2) + solve +
         "  const robcogen::ColumnSolver<" + rows + ", " + size + ", Scalar> solver(" + factor + ");\n" +
         print_solutions_of_blocks(solved, results) +
         (is_symmetric(callable) ? "  robcogen::mirror_lower<" + rows + ">(" + results.front() + ");\n" : "");
}

}  // namespace robcogen::backend::cpp
