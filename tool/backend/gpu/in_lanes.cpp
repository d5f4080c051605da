// Functions whose congruent limbs are computed by neighbouring threads: the program with lanes, in C++.
#include <algorithm>

#include "backend/gpu/printers.h"

namespace robcogen::backend::gpu {

using symbolic::Program;

std::optional<StatesKernel> StatesFunction::kernel_in_lanes() const {
  if (stages || !function || !function->function->in_lanes) return std::nullopt;
  const Program& program = *function->function->in_lanes;
  const bool has_parameters = std::any_of(program.inputs.begin(), program.inputs.end(), [](const auto& input) {
    return input.role == symbolic::Role::parameters;
  });
  if (has_parameters && !function->reads_cache) return std::nullopt;
  StatesKernel kernel = kernels().front();
  kernel.name = kInLanes + name;
  for (const symbolic::Statement& s : program.statements) kernel.lanes = std::max(kernel.lanes, s.width);
  return kernel;
}

std::string where_lanes_are(const std::string& text) {
  return text.empty() ? "" : "#if RC_HAS_LANES\n" + text + "#endif\n";
}

std::string print_in_lanes(const Names& names, const std::string& group) {
  const Dialect d = c::dialect_with_lanes();
  std::string text;
  for (const StatesFunction& f : states_functions(names, group)) {
    const std::optional<StatesKernel> kernel = f.kernel_in_lanes();
    if (!kernel) continue;
    const Kernel lowered = lower(*f.function->function->in_lanes, kernel->name, d);
    text +=
        "\n" + c::comment(f.name + " by " + std::to_string(kernel->lanes) + " neighbouring threads for each state.");
    for (const std::string& limbs : f.function->function->limbs_in_lanes)
      text += c::comment("In lanes: the limbs that start with joints " + limbs + ".");
    text += c::macro_signature(names.prefix + "_" + kernel->name, lowered.parameters, " {");
    for (const KernelArray& p : lowered.parameters)
      if (!p.used) text += "  RC_UNUSED(" + p.name + ");\n";
    for (const int width : lowered.widths)
      text += "  using " + d.type(width) + " = robcogen::gpu::Lanes<REAL, " + std::to_string(width) + ">;\n";
    text += body(lowered, d) + "}\n";
  }
  return where_lanes_are(text);
}

}  // namespace robcogen::backend::gpu
