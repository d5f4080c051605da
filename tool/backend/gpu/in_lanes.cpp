// Functions whose congruent limbs are computed by neighbouring threads: the program with lanes, in C++.
#include <algorithm>

#include "backend/gpu/printers.h"

namespace robcogen::backend::gpu {

using symbolic::Program;

namespace {

std::string type(int width) {
  return "Lanes" + std::to_string(width);
}

// The array from this element on: the text of an element with another macro.
std::string from(const std::string& element) {
  const std::string at = "RC_AT(";
  return element.starts_with(at) ? "RC_FROM(" + element.substr(at.size()) : "&" + element;
}

// A call as a line without indentation.
std::string called(const std::string& head, const std::vector<std::string>& arguments) {
  std::string text = c::wrapped("  " + head + "(", arguments, ");");
  return text.substr(2, text.size() - 3);
}

std::string line_with_lanes(const Line& line) {
  const std::string width = std::to_string(line.width), count = std::to_string(line.count);
  const std::string stride = std::to_string(line.stride);
  switch (line.kind) {
    case Line::Kind::sincos:
      if (line.width == 1) break;
      return called("RC_SINCOS_IN_LANES", {width, line.expression, line.targets[0], line.targets[1]});
    case Line::Kind::pick:
      return "const auto [" + line.targets[0] + ", " + line.targets[1] + "] = " + line.expression + ";";
    case Line::Kind::definition:
    case Line::Kind::binding:
      if (line.width == 1) break;
      return "const " + type(line.width) + " " + line.targets[0] + " = " + line.expression + ";";
    case Line::Kind::load_block:
      return "const auto " + line.targets[0] + " = robcogen::gpu::load_lanes<REAL, " + width + ", " + count + ", " +
             stride + ">(" + from(line.expression) + ");";
    case Line::Kind::store_block: {
      std::vector<std::string> arguments = {from(line.targets[0])};
      arguments.insert(arguments.end(), line.values.begin(), line.values.end());
      return called("robcogen::gpu::store_lanes<" + stride + ">", arguments);
    }
    case Line::Kind::fill:
      return called("robcogen::gpu::fill<" + count + ">", {from(line.targets[0]), line.expression});
    default:
      break;
  }
  return c::dialect(c::kMacros, true).text(line);
}

const Dialect& dialect() {
  static const Dialect with_lanes = [] {
    Dialect d = c::dialect(c::kMacros, true);
    d.used_names.insert(d.used_names.end(), {"Lanes2", "Lanes4", "Lanes8", "sum_lanes"});
    d.type = type;
    d.text = line_with_lanes;
    return d;
  }();
  return with_lanes;
}

}  // namespace

std::optional<StatesKernel> StatesFunction::kernel_in_lanes() const {
  if (stages || !function || !function->function->in_lanes) return std::nullopt;
  const Program& program = *function->function->in_lanes;
  const bool has_parameters = std::any_of(program.inputs.begin(), program.inputs.end(), [](const auto& input) {
    return input.role == symbolic::Role::parameters;
  });
  if (has_parameters && !function->reads_cache) return std::nullopt;
  StatesKernel kernel = kernels().front();
  kernel.name = kInLanes + name;
  for (const symbolic::Statement& s : program.statements)
    kernel.lanes = std::max(kernel.lanes, s.width);
  return kernel;
}

std::string where_lanes_are(const std::string& text) {
  return text.empty() ? "" : "#if RC_HAS_LANES\n" + text + "#endif\n";
}

std::string print_in_lanes(const Names& names, const std::string& group) {
  std::string text;
  for (const StatesFunction& f : states_functions(names, group)) {
    const std::optional<StatesKernel> kernel = f.kernel_in_lanes();
    if (!kernel) continue;
    const Kernel lowered = lower(*f.function->function->in_lanes, kernel->name, dialect());
    text += "\n" + c::comment(
                        f.name + " by " + std::to_string(kernel->lanes) + " neighbouring threads for each state.");
    for (const std::string& limbs : f.function->function->limbs_in_lanes)
      text += c::comment("In lanes: the limbs that start with joints " + limbs + ".");
    text += c::macro_signature(names.prefix + "_" + kernel->name, lowered.parameters, " {");
    for (const KernelArray& p : lowered.parameters)
      if (!p.used) text += "  RC_UNUSED(" + p.name + ");\n";
    for (const int width : lowered.widths)
      text += "  using " + type(width) + " = robcogen::gpu::Lanes<REAL, " + std::to_string(width) + ">;\n";
    text += body(lowered, dialect()) + "}\n";
  }
  return where_lanes_are(text);
}

}  // namespace robcogen::backend::gpu
