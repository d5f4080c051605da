#include "backend/cpp/batch_kernels.h"

#include <cmath>

#include "backend/cpp/layout.h"
#include "backend/cpp/lower.h"

namespace robcogen::backend::cpp {
namespace {

using symbolic::InputArray;
using symbolic::OutputArray;
using symbolic::Program;
using symbolic::Role;

std::string input_type(const InputArray& input) {
  const auto size = static_cast<int>(input.elements.size());
  if (input.role != Role::inertia_factor) return type_of(input);
  const auto rows = static_cast<int>(std::lround(std::sqrt(size)));
  return matrix_type(rows, rows);
}

// The type of an array as a parameter of compiled functions.
std::string strided(const BatchArray& array, const std::string& scalar) {
  if (array.is_parameters) return "const " + scalar + "*";
  return "const robcogen::batch::Strided<" + std::string(array.is_output ? "" : "const ") + scalar + ">&";
}

}  // namespace

std::vector<BatchArray> batch_arrays(const Program& program) {
  std::vector<BatchArray> result;
  const std::vector<KernelArray> names = parameters(program);
  for (std::size_t i = 0; i < program.inputs.size(); ++i) {
    const InputArray& input = program.inputs[i];
    const auto size = static_cast<int>(input.elements.size());
    result.push_back(
        {names[i].name, input_type(input), size, size, false, input.role == Role::parameters,
         input.role == Role::gravity});
  }
  for (std::size_t i = 0; i < program.outputs.size(); ++i) {
    const OutputArray& output = program.outputs[i];
    const std::string& name = names[program.inputs.size() + i].name;
    result.push_back({name, type_of(output), output.rows * output.columns, output.rows, true, false, false});
  }
  return result;
}

bool is_symmetric(const Callable& callable) {
  const std::vector<OutputArray>& outputs = callable.function->program.outputs;
  return outputs.size() == 1 && outputs.front().role == Role::inertia_matrix;
}

std::vector<BatchKernel> batch_kernels(const std::vector<const Callable*>& callables) {
  std::vector<BatchKernel> result;
  for (const Callable* c : callables) {
    result.push_back({c, false});
    if (is_symmetric(*c)) result.push_back({c, true});
  }
  return result;
}

std::vector<BatchKernel> batch_kernels(const Api& api) {
  std::vector<const Callable*> callables;
  for (const Callable& c : api.callables) callables.push_back(&c);
  return batch_kernels(callables);
}

std::vector<std::string> batch_parameters(const BatchKernel& kernel, const std::string& scalar, bool with_names) {
  const auto name = [&](const std::string& n) { return with_names ? " " + n : ""; };
  std::vector<std::string> list, others;
  for (const BatchArray& a : batch_arrays(kernel.callable->function->program))
    (a.is_parameters ? list : others).push_back(strided(a, scalar) + name(a.name));
  list.push_back("std::ptrdiff_t" + name("n"));
  list.insert(list.end(), others.begin(), others.end());
  return list;
}

std::string batch_instantiations(
    const Api& api,
    const BatchKernel& kernel,
    const std::string& arguments,
    const std::vector<std::string>& extra) {
  std::string text;
  for (const std::string& scalar : api.scalars()) {
    std::vector<std::string> list = batch_parameters(kernel, scalar, false);
    list.insert(list.end(), extra.begin(), extra.end());
    text += declaration("template void " + kernel.name() + "<" + arguments + scalar + ">", list, " noexcept;");
  }
  return text;
}

std::string batch_body_declaration(const BatchKernel& kernel, const std::string& tail) {
  return "template <robcogen::batch::Level kLevel, class Scalar>\n" +
         declaration("void " + kernel.name(), batch_parameters(kernel, "Scalar", true), tail);
}

}  // namespace robcogen::backend::cpp
