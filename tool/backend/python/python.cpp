#include "backend/python/python.h"

#include <algorithm>
#include <cmath>

#include "backend/common/layout.h"
#include "backend/cpp/api.h"
#include "backend/cpp/cpp.h"
#include "backend/cpp/layout.h"
#include "backend/cpp/printers.h"
#include "backend/python/functions.h"
#include "support/concat.h"
#include "support/number.h"

namespace robcogen::backend::python {
namespace {

using cpp::braced;
using cpp::quoted;
using symbolic::Role;

std::string number(double value) {
  return backend::number(value, "NAN", "INFINITY");
}

std::string flag(bool value) {
  return value ? "true" : "false";
}

// `{"q", 1, 3, 1, false, false}`
std::string table(const Array& a) {
  return braced(
      {quoted(a.name), std::to_string(a.rank), std::to_string(a.rows), std::to_string(a.columns), flag(a.is_by_rows),
       flag(a.is_parameters)});
}

std::string list(const std::vector<Array>& arrays) {
  std::vector<std::string> items;
  for (const Array& a : arrays) items.push_back(table(a));
  return braced(items);
}

// Whether the first argument is what the library computes from the parameters.
bool takes_parameters(const cpp::Callable& c) {
  const std::vector<symbolic::InputArray>& inputs = c.function->program.inputs;
  return std::any_of(inputs.begin(), inputs.end(), [](const auto& input) { return input.role == Role::parameters; });
}

// The declaration of the kernel over many states, which otherwise only headers with Eigen have.
std::string print_declaration(const cpp::Callable& c) {
  std::vector<std::string> types;
  if (takes_parameters(c)) types.emplace_back("const S*");
  types.emplace_back("std::ptrdiff_t");
  for (const symbolic::InputArray& input : c.function->program.inputs)
    if (input.role != Role::parameters) types.emplace_back("const Strided<const S>&");
  types.insert(types.end(), c.function->program.outputs.size(), "const Strided<S>&");
  types.emplace_back("robcogen::batch::Level");
  return "template <class S>\n" + cpp::declaration("void " + c.kernel, types, " noexcept;");
}

// The calls of a kernel, for one state and for many.
std::string print_calls(const cpp::Api& api, const cpp::Callable& c) {
  const symbolic::Program& program = c.function->program;
  std::vector<std::string> one, many;
  if (takes_parameters(c)) many.emplace_back("parameters");
  many.emplace_back("n");
  for (std::size_t i = 0; i < program.inputs.size(); ++i) {
    one.push_back("in[" + std::to_string(i) + "]");
    if (program.inputs[i].role != Role::parameters) many.push_back(one.back());
  }
  for (std::size_t i = 0; i < program.outputs.size(); ++i) {
    one.push_back("out[" + std::to_string(i) + "]");
    many.push_back(one.back());
  }
  many.emplace_back("robcogen::batch::Level::avx512");
  std::string text = "template <class S>\nvoid one_" + c.kernel +
                     "([[maybe_unused]] const S* const* in, [[maybe_unused]] S* const* out) {\n" +
                     cpp::call(api.space + "::kernel::" + c.kernel + "<S>", one, 2) + "}\n";
  if (!api.library->has_batches) return text;
  const std::vector<std::string> parameters = {
      "std::ptrdiff_t n", "[[maybe_unused]] const S* parameters", "[[maybe_unused]] const Strided<const S>* in",
      "[[maybe_unused]] const Strided<S>* out"};
  return text + "template <class S>\n" + cpp::declaration("void many_" + c.kernel, parameters, " {") +
         cpp::call(api.space + "::batch::kernel::" + c.kernel + "<S>", many, 2) + "}\n";
}

std::string print_table(const Library& library, const Function& f) {
  std::string documentation = "    ";
  for (const std::string& line : documentation_of(f)) documentation += quoted(line) + "\n    ";
  for (std::size_t at = documentation.find("\"\n"); at != std::string::npos; at = documentation.find("\"\n", at + 3))
    documentation.insert(at, "\\n");
  documentation.erase(documentation.find_last_not_of(" \n") + 1);
  std::vector<std::string> variants;
  for (const cpp::Callable* c : f.overloads) {
    const auto name = [&](const char* start, const char* type) { return "&" + (start + c->kernel) + "<" + type + ">"; };
    const bool many = library.has_batches;
    variants.push_back(braced(
        {std::to_string(c->function->program.inputs.size()), name("one_", "double"), name("one_", "float"),
         many ? name("many_", "double") : "nullptr", many ? name("many_", "float") : "nullptr"}));
  }
  return "    {" + quoted(f.scope) + ",\n     " + quoted(f.name) + ",\n" + documentation + ",\n     " +
         list(f.arguments) + ",\n     " + std::to_string(f.required) + ",\n     " + list(f.results) + ",\n     " +
         braced(variants) + "},\n";
}

std::string print_parameters(const cpp::Api& api) {
  if (!api.is_parametric()) return "{}";
  std::vector<std::string> names, defaults;
  for (const ParameterData& p : api.library->parameters) {
    names.push_back(quoted(p.name));
    defaults.push_back(number(p.default_value));
  }
  return "{" + braced(names) + ", " + braced(defaults) + ", &make, &destroy, &in_double, &in_float}";
}

std::string print_caches(const cpp::Api& api) {
  if (!api.is_parametric()) return "";
  const std::string type = api.space + "::Parameters", array = api.space + "::ParameterArray";
  return "struct Caches {\n  " + type + "<double> in_double;\n  " + type + "<float> in_float;\n};\n\n" +
         "void* make(const double* values) {\n  " + array + " array;\n" +
         "  for (std::size_t i = 0; i < array.size(); ++i) array[i] = values[i];\n" + "  return new Caches{" + type +
         "<double>(array), " + type + "<float>(array)};\n}\n" +
         "void destroy(void* caches) {\n  delete static_cast<Caches*>(caches);\n}\n" +
         "const double* in_double(const void* caches) {\n  return static_cast<const "
         "Caches*>(caches)->in_double.data();\n}\n" +
         "const float* in_float(const void* caches) {\n  return static_cast<const "
         "Caches*>(caches)->in_float.data();\n}\n";
}

template <class List, class F>
std::string column(const List& list, F text) {
  std::vector<std::string> items;
  for (const auto& item : list) items.push_back(text(item));
  return "    " + braced(items);
}

std::string print_source(const cpp::Api& api, const std::vector<Function>& functions) {
  const Library& library = *api.library;
  const std::string folder = cpp::folder(library);
  std::string declarations, calls, rows;
  for (const Function& f : functions) {
    for (const cpp::Callable* c : f.overloads) {
      if (library.has_batches) declarations += print_declaration(*c);
      calls += print_calls(api, *c) + "\n";
    }
    rows += print_table(library, f);
  }
  const auto name = [](const auto& item) { return quoted(item.name); };
  const auto limit = [](double JointLimits::*member) {
    return [member](const JointData& joint) { return number(joint.limits.*member); };
  };
  const auto limb = [](const LimbData& l) {
    const auto elements = [](const std::vector<LimbData::Element>& list) {
      std::vector<std::string> items;
      for (const LimbData::Element& e : list) items.push_back(braced({quoted(e.own), std::to_string(e.index)}));
      return braced(items);
    };
    return braced(
        {quoted(l.name), quoted(l.part), std::to_string(l.first_link), elements(l.links), elements(l.joints),
         elements(l.frames)});
  };
  const auto parent = [&](const LinkData& link) {
    if (link.parent_joint < 0) return std::string("-1");
    return std::to_string(library.all_joints()[static_cast<std::size_t>(link.parent_joint)].parent);
  };
  const std::vector<std::string> fields = {
      "    " + quoted(library.name),
      "    " + quoted(
                   library.has_robot() ? "Kinematics and dynamics of the robot " + library.robot + "."
                                       : "Coordinate transforms of the model " + library.robot + "."),
      "    {\n" + rows + "    }",
      "    " + print_parameters(api),
      column(library.joints, name),
      column(library.position_names(), cpp::quoted),
      column(library.links, name),
      column(library.frames, name),
      column(library.links, parent),
      column(library.joints, limit(&JointLimits::lower)),
      column(library.joints, limit(&JointLimits::upper)),
      column(library.joints, limit(&JointLimits::velocity)),
      column(library.joints, limit(&JointLimits::effort)),
      column(library.limbs, limb)};
  return cpp::banner(library, library.name + ".cpp", "its Python module") + "// clang-format off\n#include " +
         quoted("robcogen/python/make_module.h") + "\n\n#include " + quoted(cpp::kernels_path(folder)) + "\n" +
         (library.has_robot() ? "#include " + quoted(cpp::header_path(folder, cpp::kParameters)) + "\n" : "") +
         "\nusing robcogen::batch::Strided;\n\n" + cpp::in_namespace(api.space + "::batch::kernel", declarations) +
         "\nnamespace {\n\n" + calls + print_caches(api) + "\nconst robcogen::python::Module kModule = {\n" +
         joined(fields, ",\n") + "};\n\n}  // namespace\n\nPyMODINIT_FUNC PyInit_" + library.name +
         "() {\n  return robcogen::python::make_module(kModule);\n}\n";
}

}  // namespace

std::vector<OutputFile> print(const Library& library) {
  const cpp::Api api = cpp::api(library);
  const std::vector<Function> all = functions(api);
  return {{library.name + ".cpp", print_source(api, all)}, {library.name + ".pyi", print_stub(library, all)}};
}

}  // namespace robcogen::backend::python
