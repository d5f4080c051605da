// The ways to assemble loops that do not close from where they are drawn.
#pragma once

#include <string>
#include <vector>

#include "model/loop_context.h"

namespace robcogen::model {

struct LoopAssembly {
  std::vector<double> positions;  // rad, m; of LoopAssemblies::dependents
  // The dependent joint for which this position alone leads to the assembly; -1: all of them are needed.
  int leader = -1;
};

struct LoopAssemblies {
  std::vector<int> dependents;     // joints
  std::vector<LoopAssembly> assemblies;  // nearest to the drawing first; at most two
  // At the start, the loops determine fewer joints than in an assembly: it leads to none of the assemblies.
  bool is_start_stretched = false;
};

// Searches from positions all around the start, of the candidates for dependent joints, best first. The other joints
// remain at the start. The list is empty if the loops cannot be closed.
LoopAssemblies find_assemblies(
    const LoopContext& context,
    const std::vector<int>& loops,
    const std::vector<double>& start,
    const std::vector<int>& candidates);

// Adds what the assemblies say to the report that a loop, or loops, do not close from where they are drawn. `subject`
// is `loop 'bar' is` or `loops 'a', 'b' are`.
void explain_open(
    const LoopContext& context,
    const LoopAssemblies& assemblies,
    const std::string& subject,
    const std::string& where,
    PlaneFault& fault);

}  // namespace robcogen::model
