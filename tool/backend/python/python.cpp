#include "backend/python/python.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "backend/common/layout.h"
#include "backend/cpp/api.h"
#include "backend/cpp/cpp.h"
#include "backend/cpp/layout.h"
#include "backend/cpp/printers.h"
#include "backend/python/functions.h"
#include "support/concat.h"
#include "support/index.h"
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

// The constant arrays of the tables, each printed once.
class Constants {
 public:
  // Returns the name of an array with these items, `{}` if there are none.
  std::string array(const std::string& type, const std::string& what, const std::vector<std::string>& items) {
    if (items.empty()) return "{}";
    const std::string text = "[] = " + braced(items) + ";\n";
    const auto [place, is_new] = names_.insert({type + text, ""});
    if (is_new) {
      place->second = "k" + what + std::to_string(++counts_[what]);
      text_ += "const " + type + " " + place->second + text;
    }
    return place->second;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::map<std::string, std::string> names_;
  std::map<std::string, int> counts_;
};

// The type of the runtime with this name.
std::string type(const std::string& name) {
  return "robcogen::python::" + name;
}

// `{"q", 1, 3, 1, false, false, 1, {}}`
std::string table(const Array& a, Constants& constants) {
  std::vector<std::string> quaternions;
  for (const int first : a.quaternions) quaternions.push_back(std::to_string(first));
  return braced(
      {quoted(a.name), std::to_string(a.rank), std::to_string(a.rows), std::to_string(a.columns), flag(a.is_by_rows),
       flag(a.is_parameters), std::to_string(a.pages), constants.array("int", "Quaternions", quaternions)});
}

std::string list(const std::vector<Array>& arrays, Constants& constants) {
  std::vector<std::string> items;
  for (const Array& a : arrays) items.push_back(table(a, constants));
  return constants.array(type("Argument"), "Arrays", items);
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

std::string print_table(const Library& library, const Function& f, Constants& constants) {
  std::string documentation = "    ";
  for (const std::string& line : documentation_of(f)) documentation += quoted(line) + "\n    ";
  for (std::size_t at = documentation.find("\"\n"); at != std::string::npos; at = documentation.find("\"\n", at + 3))
    documentation.insert(at, "\\n");
  documentation.erase(documentation.find_last_not_of(" \n") + 1);
  std::vector<std::string> variants;
  for (const cpp::Callable* c : f.overloads) {
    const auto name = [&](bool is_there, const char* start, const char* type) {
      return is_there ? "&" + (start + c->kernel) + "<" + type + ">" : "nullptr";
    };
    const bool single = library.has_single_precision, many = library.has_batches;
    variants.push_back(braced(
        {std::to_string(c->function->program.inputs.size()), name(true, "one_", "double"),
         name(single, "one_", "float"), name(many, "many_", "double"), name(many && single, "many_", "float")}));
  }
  if (variants.empty())
    variants.push_back(braced(
        {std::to_string(f.arguments.size()), "&" + f.call + "<double>", "&" + f.call + "<float>", "nullptr",
         "nullptr"}));
  return "    {" + quoted(f.scope) + ",\n     " + quoted(f.name) + ",\n" + documentation + ",\n     " +
         list(f.arguments, constants) + ",\n     " + std::to_string(f.required) + ",\n     " +
         list(f.results, constants) + ",\n     " + constants.array(type("Variant"), "Variants", variants) + "},\n";
}

std::string print_parameters(const cpp::Api& api, Constants& constants) {
  if (!api.is_parametric()) return "{}";
  std::vector<std::string> names, defaults;
  for (const model::Parameter& p : api.library->parameters()) {
    names.push_back(quoted(p.name));
    defaults.push_back(number(model::default_of(p)));
  }
  return braced(
      {constants.array("char* const", "Names", names), constants.array("double", "Numbers", defaults), "&make",
       "&destroy", "&in_double", api.library->has_single_precision ? "&in_float" : "nullptr"});
}

// The values that depend on the parameters, in each precision that the library has.
std::string print_caches(const cpp::Api& api) {
  if (!api.is_parametric()) return "";
  const std::string type = api.space + "::Parameters", array = api.space + "::ParameterArray";
  std::string members, values, readers;
  for (const std::string& scalar : api.scalars()) {
    members += "  " + type + "<" + scalar + "> in_" + scalar + ";\n";
    values += (values.empty() ? "" : ", ") + type + "<" + scalar + ">(array)";
    readers += "const " + scalar + "* in_" + scalar +
               "(const void* caches) {\n  return static_cast<const Caches*>(caches)->in_" + scalar + ".data();\n}\n";
  }
  return "struct Caches {\n" + members + "};\n\n" + "void* make(const double* values) {\n  " + array + " array;\n" +
         "  for (std::size_t i = 0; i < array.size(); ++i) array[i] = values[i];\n" + "  return new Caches{" + values +
         "};\n}\n" + "void destroy(void* caches) {\n  delete static_cast<Caches*>(caches);\n}\n" + readers;
}

template <class List, class F>
std::vector<std::string> each(const List& list, F text) {
  std::vector<std::string> items;
  for (const auto& item : list) items.push_back(text(item));
  return items;
}

std::string print_limb(const model::Limb& l, Constants& constants) {
  const auto elements = [&](const std::vector<model::Limb::Element>& list) {
    const auto text = [](const model::Limb::Element& e) { return braced({quoted(e.own), std::to_string(e.index)}); };
    return constants.array(type("LimbElement"), "Elements", each(list, text));
  };
  return braced(
      {quoted(l.name), quoted(l.part), std::to_string(l.first_link), elements(l.links), elements(l.joints),
       elements(l.frames)});
}

// The table of the whole module, after the arrays that it refers to.
std::string print_module(const cpp::Api& api, const std::vector<Function>& functions) {
  const Library& library = *api.library;
  const model::KinematicTree& tree = library.tree;
  Constants constants;
  std::string rows;
  for (const Function& f : functions) rows += print_table(library, f, constants);
  const auto names = [&](const std::vector<std::string>& list) {
    return constants.array("char* const", "Names", each(list, cpp::quoted));
  };
  const std::vector<int> coordinates = tree.coordinates(), joints = model::independent_joints_first(tree);
  const auto limits = [&](double model::JointLimits::*member) {
    const auto text = [&](int j) { return number(tree.joints[at(j)].limits.*member); };
    return constants.array("double", "Numbers", each(coordinates, text));
  };
  const auto parent = [&](int carrier) {
    return carrier < 0 ? std::string("-1") : std::to_string(model::parent_link(tree, joints[at(carrier)]));
  };
  const auto limb = [&](const model::Limb& l) { return print_limb(l, constants); };
  const std::vector<std::string> fields = {
      "    " + quoted(library.name),
      "    " + quoted(
                   library.has_robot() ? "Kinematics and dynamics of the robot " + library.title() + "."
                                       : "Coordinate transforms of the model " + library.title() + "."),
      rows.empty() ? "    {}" : "    kFunctions",
      "    " + print_parameters(api, constants),
      "    " + names(model::names_of(tree, coordinates)),
      "    " + names(model::position_names(tree)),
      "    " + names(model::link_names(tree)),
      "    " + names(library.frames()),
      "    " + constants.array("int", "Indices", each(model::carrying_joints(tree), parent)),
      "    " + limits(&model::JointLimits::lower),
      "    " + limits(&model::JointLimits::upper),
      "    " + limits(&model::JointLimits::velocity),
      "    " + limits(&model::JointLimits::effort),
      "    " + constants.array(type("Limb"), "Limbs", each(model::listed_limbs(tree), limb))};
  const std::string table = rows.empty() ? "" : "\nconst " + type("Function") + " kFunctions[] = {\n" + rows + "};\n";
  return constants.text() + table + "\nconst " + type("Module") + " kModule = {\n" + joined(fields, ",\n") + "};\n";
}

// The two phases in which Python makes the module.
std::string print_initialisation(const std::string& name) {
  return "int execute(PyObject* module) {\n  return robcogen::python::execute(module, kModule);\n}\n\n}  // "
         "namespace\n\nPyMODINIT_FUNC PyInit_" +
         name +
         "() {\n  static robcogen::python::Definition definition(kModule, &execute);\n  return "
         "definition.initialise();\n}\n";
}

std::string print_source(const cpp::Api& api, const std::vector<Function>& functions) {
  const Library& library = *api.library;
  const std::string folder = cpp::folder(library);
  std::string declarations, calls;
  bool has_poses = false;
  for (const Function& f : functions) {
    for (const cpp::Callable* c : f.overloads) {
      if (library.has_batches) declarations += print_declaration(*c);
      calls += print_calls(api, *c) + "\n";
    }
    has_poses = has_poses || f.overloads.empty();
  }
  return cpp::banner(library, library.name + ".cpp", "its Python module") + "// clang-format off\n#include " +
         quoted("robcogen/python/make_module.h") + "\n" +
         (has_poses ? "#include " + quoted("robcogen/python/poses.h") + "\n" : "") + "\n#include " +
         quoted(cpp::kernels_path(folder)) + "\n" +
         (library.has_robot() ? "#include " + quoted(cpp::header_path(folder, cpp::kParameters)) + "\n" : "") +
         "\nusing robcogen::batch::Strided;\n\n" + cpp::in_namespace(api.space + "::batch::kernel", declarations) +
         "\nnamespace {\n\n" + calls + print_caches(api) + "\n" + print_module(api, functions) + "\n" +
         print_initialisation(library.name);
}

}  // namespace

std::vector<OutputFile> print(const Library& library) {
  const cpp::Api api = cpp::api(library);
  const std::vector<Function> all = functions(api);
  return {{library.name + ".cpp", print_source(api, all)}, {library.name + ".pyi", print_stub(library, all)}};
}

}  // namespace robcogen::backend::python
