#include "backend/common/block_plan.h"

#include <algorithm>

#include "support/index.h"

namespace robcogen::backend {
namespace {

void plan_load(std::size_t load, BlockPlan& plan) {
  const std::vector<symbolic::Operand>& columns = plan.loads[load].columns;
  std::size_t first = at(columns.front().index);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    plan.loaded[at(columns[c].index)] = {load, c};
    first = std::min(first, at(columns[c].index));
  }
  plan.load_at[first] = load;
}

void plan_store(std::size_t store, BlockPlan& plan) {
  const symbolic::Block& block = plan.stores.blocks[store];
  std::size_t last = 0;
  for (std::size_t c = 0; c < block.columns.size(); ++c) {
    for (int lane = 0; lane < block.width; ++lane)
      plan.is_stored[at(block.array)][at(block.first + lane * block.stride) + c] = true;
    if (!is_statement(block.columns[c])) continue;
    const std::size_t statement = at(block.columns[c].index);
    plan.is_column[statement] = true;
    last = std::max(last, statement);
  }
  plan.store_after.emplace(last, store);
}

}  // namespace

BlockPlan block_plan(const symbolic::Program& program) {
  BlockPlan plan;
  plan.loads = symbolic::loads(program);
  plan.stores = symbolic::stores(program);
  plan.is_column.resize(program.statements.size(), false);
  for (const symbolic::OutputArray& array : program.outputs) plan.is_stored.emplace_back(array.values.size(), false);
  for (std::size_t k = 0; k < plan.loads.size(); ++k) plan_load(k, plan);
  for (std::size_t k = 0; k < plan.stores.blocks.size(); ++k) plan_store(k, plan);
  for (const symbolic::Fill& fill : plan.stores.fills)
    for (std::size_t k = at(fill.first); k < at(fill.first + fill.count); ++k)
      if (program.outputs[at(fill.array)].values[k] == fill.value) plan.is_stored[at(fill.array)][k] = true;
  return plan;
}

}  // namespace robcogen::backend
