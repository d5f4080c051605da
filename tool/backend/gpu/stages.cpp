// Functions in stages: the kernels that run one after the other, and the functions that these call.
#include "backend/common/columns.h"
#include "backend/gpu/printers.h"
#include "support/index.h"
#include "symbolic/cut_program.h"

namespace robcogen::backend::gpu {

using symbolic::Program;
using symbolic::Stage;

Names names(const Library& library, const Lengths& lengths) {
  const std::string folder = flat(library.enclosing, library.name) + "_gpu";
  Names result{c::names(library, folder, folder), {}};
  for (const Function& f : library.functions) {
    const Program& program = f.solved ? right_sides(library, f).program : f.program;
    const std::size_t length = program.statements.size() + (f.solved ? f.solved->solution.statements.size() : 0);
    if (length <= lengths.longest) continue;
    result.stages[&f] = f.solved ? symbolic::cut_program(program, *f.solved, lengths.stage)
                                 : symbolic::cut_program(program, lengths.stage);
  }
  return result;
}

StatesArray StatesFunction::array(std::size_t k) const {
  if (k < arrays.size()) return arrays[k];
  return {{symbolic::kWorkspace, true}, at(stages->workspace)};
}

std::vector<StatesKernel> StatesFunction::kernels() const {
  std::vector<StatesKernel> list;
  if (!stages) {
    StatesKernel& whole = list.emplace_back(StatesKernel{name, {}});
    for (std::size_t k = 0; k < arrays.size(); ++k) whole.arrays.push_back(k);
    return list;
  }
  const auto add = [&](std::size_t number, std::vector<std::size_t> taken, const Stage::Columns* columns) {
    const std::string own = name + "_stage" + std::to_string(list.size() + 1);
    list.push_back({own, std::move(taken), &stages->list[number], number, columns});
  };
  for (std::size_t number = 0; number < stages->list.size(); ++number) {
    const Stage& stage = stages->list[number];
    if (stage.columns.empty()) add(number, arrays_of(stage, function->function->program), nullptr);
    for (const Stage::Columns& columns : stage.columns)
      add(number, {function->function->program.inputs.size() + at(columns.output), arrays.size()}, &columns);
  }
  return list;
}

std::string stage_name(const Names& names, const StatesFunction& f, std::size_t number) {
  return names.prefix + "__" + f.name + "_" + std::to_string(number + 1);
}

std::string print_stages(const Names& names, const StatesFunction& f) {
  const Dialect d = c::dialect(c::kMacros, f.function->reads_cache);
  std::string text;
  for (std::size_t number = 0; number < f.stages->list.size(); ++number) {
    const Stage& stage = f.stages->list[number];
    std::vector<KernelArray> list = {{symbolic::kColumns, true}, {symbolic::kWorkspace, true}};
    if (stage.columns.empty()) {
      list.clear();
      for (const std::size_t k : arrays_of(stage, f.function->function->program)) list.push_back(f.array(k).array);
    }
    text += "\n" + c::macro_signature(stage_name(names, f, number), list, " {") +
            body(lower(stage.program, stage.program.name, d), d) + "}\n";
  }
  return text;
}

}  // namespace robcogen::backend::gpu
