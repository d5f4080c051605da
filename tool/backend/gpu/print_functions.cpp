// Functions for kernels of users, kernels over many states, and sizes.
#include <algorithm>

#include "backend/common/cache.h"
#include "backend/gpu/printers.h"

namespace robcogen::backend::gpu {
namespace {

std::string print_kernel(const Names& names, const StatesFunction& f, const StatesKernel& kernel) {
  std::vector<std::string> arguments = {"const int rc_n"}, passed;
  std::string states;
  for (const std::size_t k : kernel.arrays) {
    const StatesArray a = f.array(k);
    const std::string kind = a.array.output ? "OUT(" : "IN(";
    arguments.push_back("RC_STATES_" + kind + std::to_string(arguments.size()) + ", " + a.array.name + ")");
    passed.push_back(c::passed(a.array, c::kMacros));
    states += "    RC_STATE_" + kind + a.array.name + ", " + std::to_string(a.size) + ");\n";
  }
  std::string loops = "RC_FOR_STATES(rc_n)", called = names.prefix + "_" + f.name;
  if (kernel.lanes > 1) {
    loops = "RC_FOR_STATES_IN_LANES(rc_n, " + std::to_string(kernel.lanes) + ")";
    called = names.prefix + "_" + kernel.name;
  }
  if (kernel.stage) called = stage_name(names, f, kernel.number);
  if (const symbolic::Stage::Columns* columns = kernel.columns) {
    loops = "RC_FOR_RUNS(" + std::to_string(columns->runs) + ") " + loops;
    passed.front() = "RC_FROM(" + f.array(kernel.arrays.front()).array.name + ", " + std::to_string(columns->first) +
                     " + rc_run * " + std::to_string(columns->stride) + ")";
  }
  return c::wrapped(
             "RC_KERNEL(" + std::to_string(kernel.arrays.size()) + ") " + names.prefix + "_kernel_" + kernel.name + "(",
             arguments, ") {") +
         "  " + loops + " {\n" + states + c::wrapped("    RC_CALL(" + called + ")(", passed, ");") + "  }\n}\n";
}

// The header of macros has templates of up to this many arrays.
constexpr std::size_t kMaxArrays = 24;

// The macros for more.
std::string print_templates(const Names& names) {
  std::size_t most = 0;
  for (const c::NamedFunction& f : names.functions) {
    const symbolic::Program& program = f.function->program;
    const std::size_t workspace = names.stages.count(f.function);
    most = std::max(most, program.inputs.size() + program.outputs.size() + workspace);
  }
  std::string text;
  for (std::size_t count = kMaxArrays + 1; count <= most; ++count)
    text += "#define RC_ARRAYS" + std::to_string(count) + " RC_ARRAYS" + std::to_string(count - 1) +
            ", class RC_ARRAY" + std::to_string(count) + "\n";
  return text.empty() ? "" : c::comment("Templates of functions with many arrays.") + text + "\n";
}

}  // namespace

std::string print_model(const Names& names) {
  const std::string size = std::to_string(std::max(cache_size(names.library), 1));
  const std::string cache = names.library.updates.empty()
                                ? ""
                                : c::comment("Elements of the array that functions read in place of the parameters.") +
                                      "enum { " + names.prefix + "_cache_size = " + size + " };\n";
  return c::header(names, "model.h", "sizes", print_templates(names) + cache + c::enumeration(names));
}

std::string print_functions(const Names& names, const std::string& group) {
  const std::string includes = "#include <robcogen/gpu/dialect.h>\n\n#include \"" + names.folder + "/model.h\"\n";
  return c::header(
      names, group + ".h", group + " for GPUs",
      includes + c::print_bodies(names, group, c::kMacros) + print_in_lanes(names, group));
}

std::string print_kernels(const Names& names, const std::string& group) {
  std::string text =
      "#include \"" + names.folder + "/" + group + ".h\"\n\n" +
      c::comment(
          "Element by element in each array, one state in each thread; on the host, all states one after "
          "another.");
  for (const StatesFunction& f : states_functions(names, group)) {
    if (f.stages) text += print_stages(names, f);
    for (const StatesKernel& kernel : f.kernels()) text += "\n" + print_kernel(names, f, kernel);
    if (const std::optional<StatesKernel> kernel = f.kernel_in_lanes())
      text += "\n" + where_lanes_are(print_kernel(names, f, *kernel));
  }
  return c::header(names, group + "_kernels.h", group + " over many states", text);
}

}  // namespace robcogen::backend::gpu
