// <name>/kernel/<group>.h, the kernels as text, and <name>/<group>.cpp, that compiles them for double and float.
#include "backend/cpp/layout.h"
#include "backend/cpp/lower.h"
#include "backend/cpp/printers.h"
#include "symbolic/count.h"

namespace robcogen::backend::cpp {
namespace {

std::string counts(const symbolic::Program& program) {
  const symbolic::OperationCount c = symbolic::count(program);
  std::string result = std::to_string(c.mul) + " mul, " + std::to_string(c.add) + " add";
  const auto append = [&](int count, const char* what) {
    if (count) result += ", " + std::to_string(count) + " " + what;
  };
  append(c.div, "div");
  append(c.sqrt, "sqrt");
  append(c.sincos, "sincos");
  if (c.instructions == 0) return result + ".";
  return result + ": " + std::to_string(c.instructions) +
         " instructions when products are fused into sums; critical path " + std::to_string(c.critical_path) +
         " cycles.";
}

std::string signature(const Kernel& kernel) {
  std::vector<std::string> list;
  for (const Parameter& p : kernel.parameters)
    list.push_back((p.output ? "Scalar* " : "const Scalar* ") + (p.used ? p.name : "/*" + p.name + "*/"));
  const char* tail = kernel.lines.empty() ? " noexcept {}" : " noexcept {";
  return "template <class Scalar>\n" + declaration("void " + kernel.name, list, tail);
}

std::string body(const Kernel& kernel) {
  if (kernel.lines.empty()) return "";
  std::string result;
  for (const std::string& function : kernel.functions) result += "  using std::" + function + ";\n";
  if (!kernel.functions.empty()) result += "\n";
  for (std::size_t i = 0; i < kernel.lines.size(); ++i) {
    const Line& line = kernel.lines[i];
    if (line.kind != Line::Kind::section)
      result += "  " + text(line) + "\n";
    else
      result += (i ? "\n" : "") + comment(line.expression, 2);
  }
  return result + "}\n";
}

// `0:HAA, 1:HFE`
std::string numbered(const std::vector<std::string>& names) {
  std::string result;
  for (std::size_t i = 0; i < names.size(); ++i) result += (i ? ", " : "") + std::to_string(i) + ":" + names[i];
  return result.empty() ? "none" : result;
}

// The elements of a kernel's arrays, where they differ from function to function.
std::string arrays(const Library& library, const symbolic::Program& program) {
  if (library.has_robot()) return "";
  std::string result;
  for (const symbolic::InputArray& input : program.inputs)
    result += comment(input.name + ": " + numbered(input.elements) + ".");
  return result;
}

std::string print_kernel(const Library& library, const Callable& callable) {
  std::string result;
  for (const std::string& line : callable.function->summary) result += comment(line);
  result += comment(counts(callable.function->program));
  result += arrays(library, callable.function->program);
  const Kernel kernel = lower(callable.function->program, callable.kernel);
  return result + signature(kernel) + body(kernel);
}

// What holds for all kernels.
std::string conventions(const Library& library) {
  const std::string overlap = "Outputs must not overlap inputs.";
  if (!library.has_robot()) return overlap;
  std::vector<std::string> joints;
  for (const JointData& joint : library.joints) joints.push_back(joint.name);
  return overlap + " Joints: " + numbered(joints) + ".";
}

std::string explicit_instantiations(const Callable& callable) {
  std::string result;
  for (const std::string scalar : {"double", "float"}) {
    std::vector<std::string> types;
    for (const Parameter& p : parameters(callable.function->program))
      types.push_back(p.output ? scalar + "*" : "const " + scalar + "*");
    result += declaration("template void " + callable.kernel, types, " noexcept;");
  }
  return result;
}

std::vector<Callable> callables_of(const Api& api, const std::string& group) {
  std::vector<Callable> result;
  for (const std::vector<Callable>* list : {&api.callables, &api.updates, &api.numbers})
    for (const Callable& c : *list)
      if (c.function->group == group) result.push_back(c);
  return result;
}

// The three updates in one.
std::string whole_update(const Api& api) {
  std::string result =
      "// All of the cache, from values in the order of kParameterNames: for scalars that Parameters does not know.\n"
      "template <class Scalar>\nvoid update(const Scalar* parameters, Scalar* cache) noexcept {\n";
  int begin = 0;
  for (const Callable& c : api.updates) {
    const std::string part = begin == 0 ? "cache" : "cache + " + std::to_string(begin);
    result += "  " + c.kernel + "(parameters, " + part + ");\n";
    begin += c.function->program.outputs.front().rows;
  }
  return result + "}\n";
}

}  // namespace

std::string kernel_declaration(const Callable& callable) {
  std::vector<std::string> list;
  for (const Parameter& p : parameters(callable.function->program))
    list.push_back((p.output ? "Scalar* " : "const Scalar* ") + p.name);
  return "template <class Scalar>\n" + declaration("void " + callable.kernel, list, " noexcept;");
}

std::string print_kernels(const Api& api, const std::string& group, const std::string& path) {
  if (group == kParameters && !api.is_parametric())
    return paragraphs({banner(*api.library, path, "no kernels, as it has no parameters"), "#pragma once\n"});
  std::vector<std::string> kernels;
  for (const Callable& c : callables_of(api, group)) kernels.push_back(print_kernel(*api.library, c));
  if (group == kParameters && api.is_parametric()) kernels.push_back(whole_update(api));
  return paragraphs(
      {banner(*api.library, path, "kernels for any scalar type, without Eigen") + comment(conventions(*api.library)),
       "#pragma once\n", includes({"<cmath>"}), includes({"\"robcogen/sincos_of.h\"", "\"robcogen/version.h\""}),
       runtime_check(api), in_namespace(api.space + "::kernel", paragraphs(kernels))});
}

std::string print_instantiations(const Api& api, const std::string& group, const std::string& path) {
  std::vector<std::string> kernels;
  for (const Callable& c : callables_of(api, group)) kernels.push_back(explicit_instantiations(c));
  return paragraphs(
      {banner(*api.library, path, "kernels compiled for double and float"),
       includes({"\"" + kernel_path(api.library->name, group) + "\""}),
       in_namespace(api.space + "::kernel", paragraphs(kernels))});
}

}  // namespace robcogen::backend::cpp
