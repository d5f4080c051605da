#include "backend/gpu/gpu.h"

#include <algorithm>
#include <cmath>

#include "backend/common/cache.h"
#include "backend/common/planned_file.h"
#include "backend/gpu/printers.h"
#include "support/index.h"

namespace robcogen::backend::gpu {
namespace {

using File = PlannedFile<Names>;

std::vector<File> files(const std::string& prefix, const std::vector<std::string>& groups) {
  const std::string folder = prefix + "_gpu", path = folder + "/";
  std::string includes;
  for (const std::string& group : groups) includes += "#include \"" + path + group + ".h\"\n";
  const auto umbrella = [=](const Names& n) { return c::header(n, folder + ".h", "all functions for GPUs", includes); };
  std::vector<File> list = {
      {path + folder + ".h", umbrella},
      {path + "model.h", print_model},
      {path + "batch.h", [=](const Names& n) { return print_batch(n, groups); }},
      {path + "__init__.py", [=](const Names& n) { return print_python(n, groups); }},
      {path + "bench.cu", [=](const Names& n) { return print_bench(n, groups); }}};
  for (const std::string& group : groups) {
    list.push_back({path + group + ".h", [=](const Names& n) { return print_functions(n, group); }});
    list.push_back({path + group + "_kernels.h", [=](const Names& n) { return print_kernels(n, group); }});
    list.push_back({path + group + ".cu", [=](const Names& n) { return print_launches(n, group); }});
  }
  return list;
}

std::vector<std::string> with_parameters(std::vector<std::string> groups) {
  groups.insert(groups.begin(), c::kParametersGroup);
  return groups;
}

std::vector<StatesArray> arrays_of(const c::Names& names, const c::NamedFunction& f) {
  const symbolic::Program& program = f.function->program;
  const std::vector<KernelArray> list = parameters(program, c::dialect(c::kMacros, f.reads_cache));
  std::vector<StatesArray> result;
  for (std::size_t k = 0; k < list.size(); ++k) {
    StatesArray& a = result.emplace_back(StatesArray{list[k]});
    if (k >= program.inputs.size()) {
      const symbolic::OutputArray& output = program.outputs[k - program.inputs.size()];
      a.size = output.values.size();
      a.rows = at(output.rows);
      if (symbolic::is_matrix(output.role) || output.columns > 1) a.columns = at(output.columns);
      continue;
    }
    const symbolic::InputArray& input = program.inputs[k];
    a.size = a.rows = input.role == symbolic::Role::parameters ? at(cache_size(names.library)) : input.elements.size();
    if (symbolic::is_square_input(input.role))
      a.rows = a.columns = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(a.size))));
    a.is_often_same = input.role == symbolic::Role::parameters || input.role == symbolic::Role::gravity;
  }
  return result;
}

}  // namespace

std::vector<StatesFunction> states_functions(const Names& names, const std::string& group) {
  std::vector<StatesFunction> list;
  const std::size_t start = names.prefix.size() + 1;
  if (group == c::kParametersGroup) {
    const std::size_t size = at(cache_size(names.library)), parameters = names.library.parameters().size();
    if (!names.library.updates.empty())
      list.push_back(
          {nullptr, "update", {{{"parameters"}, parameters, parameters, 0, true}, {{"cache", true}, size, size}}});
    return list;
  }
  for (const c::NamedFunction& f : names.functions)
    if (f.function->group == group) {
      const auto stages = names.stages.find(f.function);
      list.push_back(
          {&f, f.name.substr(start), arrays_of(names, f), stages == names.stages.end() ? nullptr : &stages->second});
    }
  return list;
}

std::vector<std::string> outputs(const std::string& prefix, const std::vector<std::string>& groups) {
  return paths(files(prefix, with_parameters(groups)));
}

std::vector<OutputFile> print(const Library& library) {
  return print(library, Lengths());
}

std::vector<OutputFile> print(const Library& library, const Lengths& lengths) {
  const std::string prefix = flat(library.enclosing, library.name);
  return backend::print(files(prefix, with_parameters(library.groups)), names(library, lengths));
}

}  // namespace robcogen::backend::gpu
