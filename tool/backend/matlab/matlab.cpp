#include "backend/matlab/matlab.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "backend/common/product.h"
#include "backend/matlab/dialect.h"
#include "support/number.h"
#include "symbolic/count.h"

namespace robcogen::backend::matlab {
namespace {

using symbolic::InputArray;
using symbolic::OutputArray;
using symbolic::Program;
using symbolic::Role;

// The longest name that MATLAB tells from others.
constexpr std::size_t kLongestName = 63;

using Rows = std::vector<std::vector<std::string>>;

// Functions of one scope and name: each takes the arguments of the one before it and more.
struct Callable {
  std::string scope;
  std::string name;  // legal, and one of its own in the scope
  std::vector<const Function*> overloads;
};

std::vector<Callable> callables(const Library& library) {
  std::vector<Callable> result;
  std::map<std::pair<std::string, std::string>, std::size_t> known;
  std::map<std::string, NameScope> scopes;
  for (const Function& f : library.functions) {
    const auto [place, is_new] = known.insert({{f.scope, f.name}, result.size()});
    if (is_new) {
      NameScope& scope = scopes.try_emplace(f.scope, is_reserved).first->second;
      result.push_back({f.scope, scope.claim(shortened(f.name, kLongestName - 3, is_reserved)), {}});
    }
    result[place->second].overloads.push_back(&f);
  }
  for (Callable& callable : result) {
    std::stable_sort(callable.overloads.begin(), callable.overloads.end(), [](const Function* a, const Function* b) {
      return a->program.inputs.size() < b->program.inputs.size();
    });
  }
  return result;
}

// `+a/+hyl/`, scopes below it.
std::string package(const Library& library, const std::string& scope) {
  std::string path;
  for (const std::string& names : {library.enclosing, library.name, scope}) {
    std::string rest = names;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find("::"), rest.size());
      path += "+" + identifier(rest.substr(0, end), is_reserved) + "/";
      rest.erase(0, std::min(end + 2, rest.size()));
    }
  }
  return path;
}

std::string joined(const std::vector<std::string>& items) {
  std::string result;
  for (const std::string& item : items) result += (result.empty() ? "" : ", ") + item;
  return result;
}

std::vector<std::string> names(const std::vector<Parameter>& parameters, bool outputs) {
  std::vector<std::string> result;
  for (const Parameter& p : parameters)
    if (p.output == outputs) result.push_back(p.name);
  return result;
}

std::string signature(const Kernel& kernel, const std::string& name) {
  const std::vector<std::string> outputs = names(kernel.parameters, true);
  const std::string results = outputs.size() == 1 ? outputs.front() : "[" + joined(outputs) + "]";
  return "function " + results + " = " + name + "(" + joined(names(kernel.parameters, false)) + ")\n";
}

// `q (3 x 1): SLIDE, HFE, KFE`
std::string describe(const InputArray& array, const std::string& name) {
  const std::size_t n = array.elements.size();
  if (array.role == Role::parameters) return name + ": a struct, see parameters.m";
  if (array.role == Role::link_wrenches)
    return name + " (6 x " + std::to_string(n / 6) + "): one column a link, base first";
  std::string text = name + " (" + std::to_string(n) + " x 1)";
  constexpr std::size_t kMostListed = 40;
  if (n > 0 && n <= kMostListed) text += ": " + joined(array.elements);
  return text;
}

std::string counts(const Program& program) {
  const symbolic::OperationCount c = symbolic::count(program);
  return std::to_string(c.mul) + " multiplications, " + std::to_string(c.add) + " additions, " + std::to_string(c.div) +
         " divisions, " + std::to_string(c.sincos) + " pairs of sine and cosine.";
}

std::string upper_case(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

// The help text: what the function is, its arguments and results.
std::string help(const Library& library, const Callable& callable, const Kernel& longest) {
  const Function& function = *callable.overloads.back();
  std::string text;
  const std::vector<std::string>& summary = callable.overloads.front()->summary;
  for (std::size_t i = 0; i < summary.size(); ++i)
    text += comment(i == 0 ? upper_case(callable.name) + "  " + summary[i] : "  " + summary[i]);
  text += "%\n";
  for (std::size_t i = 0; i < function.program.inputs.size(); ++i)
    text += comment("  " + describe(function.program.inputs[i], longest.parameters[i].name));
  for (const OutputArray& output : function.program.outputs)
    text += comment(
        "  returns " + output.name + " (" + std::to_string(output.rows) + " x " + std::to_string(output.columns) + ")");
  if (!function.columns.empty()) {
    std::vector<std::string> joints;
    for (const int j : function.columns) joints.push_back(library.joints[static_cast<std::size_t>(j)].name);
    text += comment("  columns: " + joined(joints));
  }
  if (callable.overloads.size() > 1) {
    const std::size_t shortest = callable.overloads.front()->program.inputs.size();
    const std::vector<std::string> inputs = names(longest.parameters, false);
    text += comment("  " + function.summary.back());
    text += comment(
        "  May be left out, from the last: " +
        joined({inputs.begin() + static_cast<std::ptrdiff_t>(shortest), inputs.end()}) + ".");
    for (const Function* f : callable.overloads)
      text += comment("  With " + std::to_string(f->program.inputs.size()) + " arguments: " + counts(f->program));
  } else {
    text += comment("  " + counts(function.program));
  }
  text += "%\n";
  return text + comment(
                    "Generated by robcogen from " + library.model_file + " (model " + library.model_hash + "), robot " +
                    library.robot + ": edit the model, not this file.");
}

// The struct of parameters becomes the column that the lines read.
std::string unpack(const Program& program, const Kernel& kernel, const std::vector<std::string>& fields) {
  for (std::size_t i = 0; i < program.inputs.size(); ++i) {
    if (program.inputs[i].role != Role::parameters || !kernel.parameters[i].used) continue;
    const std::string& name = kernel.parameters[i].name;
    Rows rows;
    for (const std::string& field : fields) rows.push_back({name + "." + field});
    return assignment(name, rows, 2);
  }
  return "";
}

Rows rows_of(const OutputArray& output, const std::vector<std::string>& elements) {
  Rows rows(static_cast<std::size_t>(output.rows));
  for (std::size_t k = 0; k < elements.size(); ++k) rows[k % rows.size()].push_back(elements[k]);
  return rows;
}

std::string body(const Program& program, const Kernel& kernel, std::size_t indent) {
  const std::string margin(indent, ' ');
  std::string text;
  for (std::size_t i = 0; i < kernel.lines.size(); ++i) {
    const Line& line = kernel.lines[i];
    text += line.kind == Line::Kind::section ? (i > 0 ? "\n" : "") + comment(line.expression, indent)
                                             : margin + dialect().text(line) + "\n";
  }
  if (!kernel.lines.empty()) text += "\n";
  for (std::size_t p = 0; p < program.outputs.size(); ++p) {
    const OutputArray& output = program.outputs[p];
    const std::string& name = kernel.parameters[program.inputs.size() + p].name;
    if (output.values.empty()) {
      text +=
          margin + name + " = zeros(" + std::to_string(output.rows) + ", " + std::to_string(output.columns) + ");\n";
    } else {
      text += assignment(name, rows_of(output, kernel.results[p]), indent);
    }
  }
  return text;
}

// Gravity, where even the shortest overload takes it, may be left out all the same.
std::string default_gravity(const Program& shortest, const Kernel& kernel) {
  if (shortest.inputs.empty() || shortest.inputs.back().role != Role::gravity) return "";
  const std::size_t n = shortest.inputs.size();
  return "  if nargin < " + std::to_string(n) + "\n    " + kernel.parameters[n - 1].name + " = [0; 0; -9.81];\n  end\n";
}

std::string print_function(const Library& library, const Callable& callable, const std::vector<std::string>& fields) {
  std::vector<Kernel> kernels;
  for (const Function* f : callable.overloads) kernels.push_back(lower(f->program, callable.name, dialect()));
  const Kernel& longest = kernels.back();
  std::string text = signature(longest, callable.name) + help(library, callable, longest);
  text += default_gravity(callable.overloads.front()->program, longest);
  text += unpack(callable.overloads.back()->program, longest, fields);
  if (kernels.size() == 1) return text + body(callable.overloads.front()->program, longest, 2) + "end\n";
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    const bool is_last = k + 1 == kernels.size();
    const std::size_t more = is_last ? 0 : callable.overloads[k + 1]->program.inputs.size();
    const std::string condition = "nargin < " + std::to_string(more);
    text += is_last ? "  else\n" : (k == 0 ? "  if " : "  elseif ") + condition + "\n";
    text += body(callable.overloads[k]->program, kernels[k], 4);
  }
  return text + "  end\nend\n";
}

std::string number(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value < 0 ? "-Inf" : "Inf";
  return print_double(value);
}

template <class Items, class Text>
std::vector<std::string> texts(const Items& items, Text text) {
  std::vector<std::string> result;
  for (const auto& item : items) result.push_back(text(item));
  return result;
}

// `model.<field> = {…};`, a row of strings.
std::string strings(const std::string& field, const std::vector<std::string>& items) {
  std::string text = assignment("model." + field, {items.empty() ? std::vector<std::string>{""} : items}, 2);
  if (items.size() == 1) return "  model." + field + " = {" + items.front() + "};\n";
  std::replace(text.begin(), text.end(), '[', '{');
  std::replace(text.begin(), text.end(), ']', '}');
  return items.empty() ? "  model." + field + " = {};\n" : text;
}

// `model.<field> = […];`, a column for each item.
template <class Items, class Column>
std::string columns(const std::string& field, const Items& items, std::size_t rows, Column column) {
  if (items.empty()) return "  model." + field + " = zeros(" + std::to_string(rows) + ", 0);\n";
  Rows cells(rows);
  for (const auto& item : items) {
    const std::vector<double> values = column(item);
    for (std::size_t r = 0; r < rows; ++r) cells[r].push_back(number(values[r]));
  }
  return assignment("model." + field, cells, 2);
}

std::string print_model(const Library& library) {
  const auto one_based = [](int index) { return std::vector<double>{static_cast<double>(index + 1)}; };
  const auto list = [](const auto& array) { return std::vector<double>(array.begin(), array.end()); };
  const auto name = [](const auto& item) { return quoted(item.name); };
  std::string text = "function model = model()\n";
  text += comment("MODEL  Constants of robot " + library.robot + ", in SI units; indices count from 1.");
  text += comment("  Links come with the base first; parent_joint is 0 for the base.");
  text += comment("  com (m) and inertia (kg m^2: xx yy zz, then products xy xz yz of positive sign) are about the");
  text += comment("  origin and in the axes of the link frame. Placements: translation (m), then rotation about the");
  text += comment("  intrinsic axes x, y', z'' (rad). limits: lower, upper, velocity, effort.");
  text += "%\n" + comment("Generated by robcogen from " + library.model_file + " (model " + library.model_hash + ").");
  text += "  model.name = " + quoted(library.robot) + ";\n";
  text += "  model.dof = " + std::to_string(library.joints.size()) + ";\n";
  text += std::string("  model.floating_base = ") + (library.floating_base ? "true" : "false") + ";\n";
  text += strings("joints", texts(library.joints, name));
  text += strings("links", texts(library.links, name));
  text += strings("frames", texts(library.frames, name));
  text += columns(
      "is_revolute", library.joints, 1, [](const JointData& j) { return std::vector<double>{j.revolute ? 1.0 : 0.0}; });
  text += columns("parent_link", library.joints, 1, [&](const JointData& j) { return one_based(j.parent); });
  text += columns("child_link", library.joints, 1, [&](const JointData& j) { return one_based(j.child); });
  text += columns("joint_translation", library.joints, 3, [&](const JointData& j) { return list(j.translation); });
  text += columns("joint_rotation", library.joints, 3, [&](const JointData& j) { return list(j.rotation); });
  text += columns("limits", library.joints, 4, [](const JointData& j) {
    return std::vector<double>{j.limits.lower, j.limits.upper, j.limits.velocity, j.limits.effort};
  });
  text += columns("parent_joint", library.links, 1, [&](const LinkData& l) { return one_based(l.parent_joint); });
  text += columns("mass", library.links, 1, [](const LinkData& l) { return std::vector<double>{l.mass}; });
  text += columns("com", library.links, 3, [&](const LinkData& l) { return list(l.com); });
  text += columns("inertia", library.links, 6, [&](const LinkData& l) { return list(l.inertia); });
  text += columns("frame_link", library.frames, 1, [&](const FrameData& f) { return one_based(f.link); });
  text += columns("frame_translation", library.frames, 3, [&](const FrameData& f) { return list(f.translation); });
  text += columns("frame_rotation", library.frames, 3, [&](const FrameData& f) { return list(f.rotation); });
  return text + "end\n";
}

// +transforms/+product/<name>.m: the transform as the user's own primitives make it.
OutputFile print_product(const Library& library, const Callable& callable, const std::vector<std::string>& fields) {
  const Function& function = *callable.overloads.front();
  const Product product = product_of_primitives(function, " * ", dialect());
  const std::vector<std::string> inputs = names(product.kernel.parameters, false);
  std::string text = "function X = " + callable.name + "(" + joined(inputs) + ")\n";
  text += comment(upper_case(callable.name) + "  " + convention_of_primitives(library)) + "%\n";
  for (std::size_t i = 0; i < inputs.size(); ++i)
    text += comment("  " + describe(function.amounts.inputs[i], inputs[i]));
  text += unpack(function.amounts, product.kernel, fields);
  for (const Line& line : product.kernel.lines)
    if (line.kind != Line::Kind::section) text += "  " + dialect().text(line) + "\n";
  std::string line = "  X =";
  std::size_t begin = 0;
  while (begin < product.text.size()) {
    const std::size_t end = std::min(product.text.find(" * ", begin), product.text.size());
    const std::string factor = product.text.substr(begin, end - begin) + (end < product.text.size() ? " *" : ";");
    if (line.size() + factor.size() + 5 > kColumns) {
      text += line + " ...\n";
      line = "     ";
    }
    line += " " + factor;
    begin = end + 3;
  }
  return {package(library, "transforms::product") + callable.name + ".m", text + line + "\nend\n"};
}

// The fields of the struct of parameters, in the order of the programs' inputs.
std::vector<std::string> fields_of(const Library& library) {
  NameScope scope(is_reserved);
  std::vector<std::string> wanted;
  for (const ParameterData& p : library.parameters) wanted.push_back(p.name);
  return claim_all(scope, wanted);
}

std::string print_parameters(const Library& library, const std::vector<std::string>& fields) {
  std::string text = "function parameters = parameters()\n";
  text +=
      comment("PARAMETERS  Values of the parameters of robot " + library.robot + " as declared; NaN where none is.");
  for (std::size_t i = 0; i < fields.size(); ++i)
    text += "  parameters." + fields[i] + " = " + number(library.parameters[i].default_value) + ";\n";
  return text + "end\n";
}

}  // namespace

std::vector<OutputFile> print(const Library& library) {
  const std::vector<std::string> fields = fields_of(library);
  std::vector<OutputFile> files = {{package(library, "") + "model.m", print_model(library)}};
  if (!fields.empty()) files.push_back({package(library, "") + "parameters.m", print_parameters(library, fields)});
  for (const Callable& callable : callables(library))
    files.push_back(
        {package(library, callable.scope) + callable.name + ".m", print_function(library, callable, fields)});
  if (library.primitives == PrimitiveConvention::none) return files;
  for (const Callable& callable : callables(library))
    if (callable.scope == "transforms::homogeneous") files.push_back(print_product(library, callable, fields));
  return files;
}

}  // namespace robcogen::backend::matlab
