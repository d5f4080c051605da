#include "backend/python/functions.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "backend/common/meaning.h"
#include "backend/common/names.h"
#include "backend/common/python_names.h"
#include "support/concat.h"
#include "support/index.h"

namespace robcogen::backend::python {
namespace {

using symbolic::InputArray;
using symbolic::OutputArray;
using symbolic::Role;

Array argument(const cpp::Api& api, const InputArray& input, const std::string& name) {
  const auto size = static_cast<int>(input.elements.size());
  Array a{name, 1, size};
  a.is_parameters = input.role == Role::parameters && api.is_parametric();
  a.quaternions = input.quaternions;
  a.meaning = meaning(input.role);
  // Without a robot, parameters and variables are arrays of the elements that the function reads.
  if (!api.library->has_robot()) a.elements = input.elements;
  if (input.role == Role::link_wrenches) {
    a.rank = 2;
    a.rows = size / 6;
    a.columns = 6;
    a.is_by_rows = true;
    a.meaning = "external wrench on each link (N m, N) about its origin in its coordinates, moment first, base first";
  } else if (symbolic::is_square_input(input.role)) {
    a.rank = 2;
    a.rows = a.columns = static_cast<int>(std::lround(std::sqrt(size)));
  }
  return a;
}

bool is_matrix_result(const OutputArray& output) {
  return cpp::type_of(output) != "Scalar" && (symbolic::is_matrix(output.role) || output.columns > 1);
}

Array result_of(const backend::Function& function, std::size_t place, const std::string& name) {
  const std::vector<OutputArray>& outputs = function.program.outputs;
  const OutputArray& output = outputs[place];
  Array a{name, 1, output.rows, output.columns};
  a.meaning = meaning(output.role);
  if (cpp::type_of(output) == "Scalar") {
    a.rank = 0;
  } else if (is_matrix_result(output)) {
    a.rank = 2;
    a.is_by_rows = output.role == Role::inertia_matrix;  // symmetric
  }
  // The derivative of a matrix has a dimension more.
  for (const symbolic::DerivativeBlock& d : function.derivatives) {
    const OutputArray& of = outputs[at(d.of)];
    if (at(d.place) != place || !is_matrix_result(of) || of.rows * of.columns != output.rows) continue;
    a = {name, 3, of.rows, of.columns, output.columns};
  }
  return a;
}

std::string shape(const Array& a) {
  if (a.rank == 0) return "()";
  if (a.rank == 1) return "(" + std::to_string(a.rows) + ",)";
  return "(" + std::to_string(a.rows) + ", " + std::to_string(a.columns) +
         (a.rank == 3 ? ", " + std::to_string(a.pages) : "") + ")";
}

std::string signature(const Function& f, bool is_stub) {
  const std::string array = is_stub ? ": ArrayLike" : "", none = is_stub ? " | None = None" : "=None";
  std::string text = "(";
  int k = 0;
  for (const Array& a : f.arguments) {
    text += (k > 0 ? ", " : "") + a.name + (is_stub && a.is_parameters ? ": Parameters" : array);
    if (k++ >= f.required) text += none;
  }
  text += std::string(k > 0 ? ", " : "") + "*, out";
  if (is_stub) text += f.results.size() == 1 ? ": Array" : ": tuple[Array, ...]";
  return text + none + ")";
}

std::string last_of(const std::string& scope) {
  return scope.substr(scope.rfind('.') + 1);
}

// The documentation of one function in the stub. Characters that would end the string are replaced.
std::string text_in_quotes(const Function& f, const std::string& margin) {
  std::string text;
  const std::vector<std::string> lines = documentation_of(f);
  for (std::size_t i = 2; i < lines.size(); ++i) {
    std::string line = lines[i];
    for (char& c : line)
      if (c == '\\' || c == '"') c = '\'';
    text += (i > 2 && !line.empty() ? margin : "") + line + (i + 1 < lines.size() ? "\n" : "");
  }
  return margin + "\"\"\"" + text + "\"\"\"\n";
}

std::string class_name(const Function& f) {
  std::string name = f.scope + (f.scope.empty() ? "" : "_") + f.name + "_result";
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

std::string print_function(const Function& f, const std::string& margin) {
  std::string type = "Array";
  if (f.results.size() != 1) {
    type = class_name(f);
  } else if (f.results.front().rank == 0) {
    type = "float | Array";
  }
  return (margin.empty() ? "" : margin + "@staticmethod\n") + margin + "def " + f.name + signature(f, true) + " -> " +
         type + ":\n" + text_in_quotes(f, margin + "    ") + margin + "    ...\n";
}

// The scopes as nested classes.
std::string print_scope(const std::vector<Function>& all, const std::string& scope, const std::string& margin) {
  std::string text;
  std::vector<std::string> inner;
  const std::string start = scope.empty() ? "" : scope + ".";
  for (const Function& f : all) {
    if (f.scope == scope) text += "\n" + print_function(f, margin);
    if (f.scope == scope || f.scope.rfind(start, 0) != 0) continue;
    const std::string below = start + f.scope.substr(start.size(), f.scope.find('.', start.size()) - start.size());
    if (std::find(inner.begin(), inner.end(), below) == inner.end()) inner.push_back(below);
  }
  for (const std::string& below : inner)
    text += "\n" + margin + "class " + last_of(below) + ":\n" + print_scope(all, below, margin + "    ").substr(1);
  return text;
}

std::string print_parameters(const Library& library) {
  if (library.parameters().empty()) return "";
  std::string members, arguments;
  bool has_keywords = false;
  for (const model::Parameter& p : library.parameters()) {
    has_keywords = has_keywords || is_python_keyword(p.name);
    if (is_python_keyword(p.name)) continue;
    members += "    @property\n    def " + p.name + "(self) -> float: ...\n";
    arguments += ", " + p.name + ": float" + (p.default_value ? " = ..." : "");
  }
  const std::string star = arguments.empty() ? "" : ", *";
  return "\nclass Parameters:\n    def __init__(self" + star + arguments + (has_keywords ? ", **others: float" : "") +
         ") -> None: ...\n" + members + "\nparameter_names: tuple[str, ...]\n";
}

}  // namespace

std::vector<Function> functions(const cpp::Api& api) {
  std::vector<Function> result;
  std::map<std::pair<std::string, std::string>, std::size_t> known;
  for (const cpp::Callable& c : api.callables) {
    const auto [place, is_new] = known.insert({{c.function->scope, c.name}, result.size()});
    if (is_new) result.push_back({dotted(c.function->scope), c.name, {}});
    result[place->second].overloads.push_back(&c);
  }
  for (Function& f : result) {
    std::stable_sort(f.overloads.begin(), f.overloads.end(), [](const cpp::Callable* a, const cpp::Callable* b) {
      return a->function->program.inputs.size() < b->function->program.inputs.size();
    });
    const backend::Function& longest = *f.overloads.back()->function;
    const symbolic::Program& program = longest.program;
    const std::vector<KernelArray>& names = f.overloads.back()->parameters;
    for (std::size_t i = 0; i < program.inputs.size(); ++i)
      f.arguments.push_back(argument(api, program.inputs[i], names[i].name));
    for (std::size_t i = 0; i < program.outputs.size(); ++i)
      f.results.push_back(result_of(longest, i, names[program.inputs.size() + i].name));
    const std::vector<InputArray>& fewest = f.overloads.front()->function->program.inputs;
    const bool may_omit = !api.library->tree.floating_base && !fewest.empty() && fewest.back().role == Role::gravity;
    f.required = static_cast<int>(fewest.size()) - (may_omit ? 1 : 0);
    f.summary = longest.summary;
    f.remark = remark_on_positions(program);
  }
  for (Function& f : pose_functions(api)) result.push_back(std::move(f));
  return result;
}

std::vector<std::string> documentation_of(const Function& f) {
  std::vector<std::string> lines = {f.name + signature(f, false), "--", ""};
  lines.insert(lines.end(), f.summary.begin(), f.summary.end());
  lines.emplace_back();
  const auto describe = [&](const Array& a, const std::string& line) {
    lines.push_back(line);
    if (!a.meaning.empty()) lines.push_back("    " + a.meaning);
    if (!a.elements.empty()) lines.push_back("    " + joined(a.elements));
  };
  for (std::size_t i = 0; i < f.arguments.size(); ++i) {
    const Array& a = f.arguments[i];
    const std::string defaults = i < at(f.required)    ? ""
                                 : a.name == "gravity" ? "; default (0, 0, -9.81)"
                                                       : "; default zero";
    describe(a, a.name + ": " + (a.is_parameters ? "Parameters" : shape(a)) + defaults);
  }
  for (const Array& a : f.results) describe(a, "returns " + a.name + ": " + shape(a));
  if (!f.remark.empty()) lines.push_back(f.remark);
  lines.emplace_back("For many states, arrays have one more dimension in front.");
  return lines;
}

std::string print_stub(const Library& library, const std::vector<Function>& all) {
  std::string text = "# " + library.name + ".pyi: generated by robcogen. Edit the model, not this file.\n";
  text += "from typing import Any, NamedTuple\n\nimport numpy as np\nfrom numpy.typing import ArrayLike, NDArray\n\n";
  text += "Array = NDArray[np.floating[Any]]\n\nframe_names: tuple[str, ...]\n";
  const auto is_derivative = [](const Function& f) {
    return !f.overloads.empty() && !f.overloads.front()->function->derivatives.empty();
  };
  // robcogen.jax and robcogen.torch make the functions for these libraries.
  if (std::any_of(all.begin(), all.end(), is_derivative)) text += "jax: Any\ntorch: Any\n";
  if (library.has_robot()) {
    text += "dof: int\nlink_parents: tuple[int, ...]\n";
    for (const char* name : {"joint_names", "position_names", "link_names"})
      text += std::string(name) + ": tuple[str, ...]\n";
    for (const char* name : {"joint_lower", "joint_upper", "joint_velocity", "joint_effort"})
      text += std::string(name) + ": tuple[float, ...]\n";
    text += "\nclass Limb(NamedTuple):\n    name: str\n    part: str\n    first_link: int\n";
    for (const char* list : {"links", "joints", "frames"}) text += std::string("    ") + list + ": dict[str, int]\n";
    text += "\nlimbs: dict[str, Limb]\n" + print_parameters(library);
  }
  for (const Function& f : all) {
    if (f.results.size() == 1) continue;
    text += "\nclass " + class_name(f) + "(NamedTuple):\n";
    for (const Array& a : f.results) text += "    " + a.name + ": " + (a.rank == 0 ? "float | Array" : "Array") + "\n";
    if (f.results.empty()) text += "    ...\n";
  }
  return text + print_scope(all, "", "");
}

}  // namespace robcogen::backend::python
