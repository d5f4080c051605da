// Functions over many states: <name>/batch.h, Eigen types over arrays, and what the library compiles beneath it,
// <name>/batch.cpp, which chooses the bodies for the processor that it runs on, and the bodies, <name>/batch/<group>.h,
// instantiated in a source for each processor. And what the tables of <name>/reflection.h say of them.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <utility>

#include "backend/cpp/compiled_kernels.h"
#include "backend/cpp/layout.h"
#include "backend/cpp/lower.h"
#include "backend/cpp/printers.h"

namespace robcogen::backend::cpp {
namespace {

using symbolic::InputArray;
using symbolic::OutputArray;
using symbolic::Program;
using symbolic::Role;

// An array of a function, of one state. Parameters are the same for all states.
struct Array {
  std::string name;
  std::string type;  // of one state
  int size = 0;
  bool is_output = false;
  bool is_parameters = false;
  bool is_gravity = false;
};

std::string input_type(const InputArray& input) {
  const auto size = static_cast<int>(input.elements.size());
  if (input.role != Role::inertia_factor) return type_of(input);
  const auto rows = static_cast<int>(std::lround(std::sqrt(size)));
  return matrix_type(rows, rows);
}

// Inputs, then outputs, as the kernel has them.
std::vector<Array> arrays(const Program& program) {
  std::vector<Array> result;
  const std::vector<Parameter> names = parameters(program);
  for (std::size_t i = 0; i < program.inputs.size(); ++i) {
    const InputArray& input = program.inputs[i];
    const auto size = static_cast<int>(input.elements.size());
    result.push_back(
        {names[i].name, input_type(input), size, false, input.role == Role::parameters, input.role == Role::gravity});
  }
  for (std::size_t i = 0; i < program.outputs.size(); ++i) {
    const OutputArray& output = program.outputs[i];
    const std::string& name = names[program.inputs.size() + i].name;
    result.push_back({name, type_of(output), output.rows * output.columns, true, false, false});
  }
  return result;
}

// The type in which compiled functions take an array.
std::string strided(const Array& array, const std::string& scalar) {
  if (array.is_parameters) return "const " + scalar + "*";
  return "const robcogen::batch::Strided<" + std::string(array.is_output ? "" : "const ") + scalar + ">&";
}

// Parameters, the number of states, then the others; `with_names` or types alone.
std::vector<std::string> compiled_parameters(const Program& program, const std::string& scalar, bool with_names) {
  const auto name = [&](const std::string& n) { return with_names ? " " + n : ""; };
  std::vector<std::string> list, others;
  for (const Array& a : arrays(program)) (a.is_parameters ? list : others).push_back(strided(a, scalar) + name(a.name));
  list.push_back("std::ptrdiff_t" + name("n"));
  list.insert(list.end(), others.begin(), others.end());
  return list;
}

// The same as arguments.
std::vector<std::string> passed_on(const Program& program) {
  std::vector<std::string> list, others;
  for (const Array& a : arrays(program)) (a.is_parameters ? list : others).push_back(a.name);
  list.emplace_back("n");
  list.insert(list.end(), others.begin(), others.end());
  return list;
}

// `template <Level, class Scalar> void f(…) noexcept`, without its end.
std::string body_declaration(const Callable& callable, const std::string& tail) {
  return "template <robcogen::batch::Level kLevel, class Scalar>\n" +
         declaration("void " + callable.kernel, compiled_parameters(callable.function->program, "Scalar", true), tail);
}

// Declared in the interface, and defined where the processor is chosen.
std::string chooser_declaration(const Callable& callable, const std::string& tail) {
  std::vector<std::string> list = compiled_parameters(callable.function->program, "Scalar", true);
  list.emplace_back("robcogen::batch::Level most");
  return "template <class Scalar>\n" + declaration("void " + callable.kernel, list, tail);
}

// Whether bodies for a processor are compiled: `kHasAvx2`.
std::string constant_of(std::string level) {
  std::transform(level.begin() + 1, level.end(), level.begin() + 1, [](unsigned char c) { return std::tolower(c); });
  return "kHasA" + level.substr(1);
}

std::string chooser(const Callable& callable) {
  const std::vector<std::string> arguments = passed_on(callable.function->program);
  const auto body = [&](const std::string& level) {
    return "body::" + callable.kernel + "<robcogen::batch::Level::" + level + ", Scalar>";
  };
  std::string text = chooser_declaration(callable, " noexcept {");
  text += "  [[maybe_unused]] const robcogen::batch::Level level = robcogen::batch::available(most);\n";
  // A machine with AVX-512 runs AVX2, too, where that is the best that is compiled.
  const std::pair<std::string, std::string> levels[] = {
      {"avx512", "== robcogen::batch::Level::avx512"}, {"avx2", "!= robcogen::batch::Level::baseline"}};
  for (const auto& [level, test] : levels) {
    text += "  if constexpr (" + constant_of(level) + ") {\n";
    const std::string condition = "    if (level " + test + ")";
    const std::string line = call(condition + " return " + body(level), arguments, 0);
    const bool fits = line.find('\n') == line.size() - 1;
    text += fits ? line : condition + "\n" + call("return " + body(level), arguments, 6);
    text += "  }\n";
  }
  return text + call(body("baseline"), arguments, 2) + "}\n";
}

// What the library is compiled for: BATCH_LEVELS of robcogen_add_robot.
std::string compiled_levels() {
  std::string text = "// Processor levels that the library is compiled for in addition to the baseline.\n";
  for (const std::string level : {"AVX512", "AVX2"})
    text += "#ifdef ROBCOGEN_WITHOUT_" + level + "\n[[maybe_unused]] constexpr bool " + constant_of(level) +
            " = false;\n#else\n[[maybe_unused]] constexpr bool " + constant_of(level) +
            " = robcogen::batch::kHasLevels;\n#endif\n";
  return text;
}

// Explicit instantiations for both precisions; `extra` ends the list of types.
std::string instantiations(
    const Callable& callable,
    const std::string& arguments,
    const std::vector<std::string>& extra = {}) {
  std::string text;
  for (const std::string scalar : {"double", "float"}) {
    std::vector<std::string> list = compiled_parameters(callable.function->program, scalar, false);
    list.insert(list.end(), extra.begin(), extra.end());
    text += declaration("template void " + callable.kernel + "<" + arguments + scalar + ">", list, " noexcept;");
  }
  return text;
}

std::string lanes_of(const Array& array) {
  return array.name + "_lanes";
}

// The kernel of a function over many states that writes its result in place: a symmetric matrix, most of whose elements
// are written twice or are zeros, and which fills the cache when it is stored on the way. None where the kernel is cut
// into parts.
std::optional<Kernel> kernel_in_place(const Callable& callable) {
  const std::vector<OutputArray>& outputs = callable.function->program.outputs;
  if (outputs.size() != 1 || outputs.front().role != Role::inertia_matrix) return std::nullopt;
  Kernel kernel = lower(callable.function->program, callable.kernel);
  return kernel.lines.size() <= kLongest ? std::optional(std::move(kernel)) : std::nullopt;
}

// A kernel that writes to columns. Inlined into the loop over blocks, it would keep the address of each column in
// memory.
std::string column_kernel(const Kernel& kernel) {
  std::vector<std::string> list;
  for (const Parameter& p : kernel.parameters)
    list.push_back((p.output ? "const Columns " : "const Scalar* ") + (p.used ? p.name : "/*" + p.name + "*/"));
  return "template <class Scalar, class Columns>\n" +
         declaration("[[gnu::noinline]] void " + kernel.name, list, " noexcept {") + body(kernel) + "}\n";
}

std::string definition(const Api& api, const Callable& callable, bool in_place) {
  const Program& program = callable.function->program;
  const std::string kernels = in_place ? "::batch::columns::" : "::kernel::";
  std::string values, once, load, store;
  std::vector<std::string> arguments;
  for (const Array& a : arrays(program)) {
    const std::string lanes = lanes_of(a), size = std::to_string(a.size);
    values += "  Value " + lanes + "[" + (a.size == 0 ? "1" : size) + "];\n";
    const bool is_column = in_place && a.is_output;
    arguments.push_back(is_column ? "block.columns(" + a.name + ", " + lanes + ")" : lanes);
    if (a.is_parameters)
      once += call("robcogen::batch::spread", {a.name, size, lanes}, 2);
    else if (a.is_output)
      store +=
          call((is_column ? "block.template store_buffer<" : "block.template store<") + size + ">", {lanes, a.name}, 4);
    else
      load += call("block.template load<" + size + ">", {a.name, lanes}, 4);
  }
  return body_declaration(callable, " noexcept {") + "  using Value = robcogen::NativeLanes<Scalar>;\n" + values +
         once + "  for (robcogen::batch::Block<Scalar> block(n); block.is_left(); block.advance()) {\n" + load +
         call("::" + api.space + kernels + callable.kernel, arguments, 4) + store + "  }\n}\n";
}

// A function of the interface, without gravity where standard gravity takes its place.
std::string function(const Api& api, const Callable& callable, bool single_precision, bool with_gravity) {
  const std::string kernels = single_precision ? "::" + api.space + "::batch::kernel::" : "kernel::";
  const std::vector<Array> all = arrays(callable.function->program);
  std::vector<std::string> list, inputs, arguments, passed;
  std::string sizes;
  for (const Array& a : all) {
    if (a.is_parameters) {
      list.push_back("const " + a.type + "& " + a.name);
      arguments.push_back(a.name + ".data()");
      continue;
    }
    const bool is_left_out = a.is_gravity && !with_gravity;
    const std::string type = std::string("robcogen::batch::") + (a.is_output ? "Output" : "Input") + "<" + a.type + ">";
    passed.push_back((is_left_out ? type + "(Gravity::standard())" : a.name) + ".array()");
    if (is_left_out) continue;
    inputs.push_back("const " + type + "& " + a.name);
    sizes += (sizes.empty() ? "" : ", ") + a.name + " " + std::to_string(a.size);
  }
  list.emplace_back("std::ptrdiff_t n");
  arguments.emplace_back("n");
  list.insert(list.end(), inputs.begin(), inputs.end());
  arguments.insert(arguments.end(), passed.begin(), passed.end());
  list.emplace_back("robcogen::batch::Level most = robcogen::batch::Level::avx512");
  arguments.emplace_back("most");
  std::string text;
  if (!single_precision) {
    if (with_gravity)
      for (const std::string& line : callable.function->summary) text += comment(line);
    else
      text += comment("The same under standard gravity.");
    text += comment("Elements of a state: " + sizes + ".");
  }
  return text + declaration("inline void " + callable.name, list, " noexcept {") +
         call(kernels + callable.kernel + "<Scalar>", arguments, 2) + "}\n";
}

// Scopes of free functions and of those that are members of what one returns, in order.
std::vector<std::string> all_scopes(const Api& api, const std::string& group) {
  std::vector<std::string> result = scopes(api, group);
  for (const Callable* c : callables_of(api, group))
    if (std::find(result.begin(), result.end(), c->function->scope) == result.end())
      result.push_back(c->function->scope);
  return result;
}

// All functions of one scope, of positions. They may leave out gravity where those of one state may.
std::string scope_text(const Api& api, const std::string& group, const std::string& scope, bool single_precision) {
  std::vector<std::string> parts;
  const auto add = [&](const Callable& c, bool with_gravity) {
    parts.push_back(function(api, c, single_precision, with_gravity));
  };
  for (const Overload& o : overloads(api, group, scope)) {
    if (o.takes_sines) continue;
    add(*o.callable, !o.adds_standard_gravity);
  }
  for (const Callable* c : callables_of(api, group))
    if (!c->owner.empty() && c->function->scope == scope) add(*c, true);
  return paragraphs(parts);
}

std::string interface(const Api& api, bool single_precision) {
  std::vector<std::string> parts;
  for (const std::string& group : api.library->groups) {
    for (const std::string& scope : all_scopes(api, group)) {
      const std::string text = scope_text(api, group, scope, single_precision);
      parts.push_back(scope.empty() ? text : in_namespace(scope, text));
    }
  }
  return in_namespace(single_precision ? "f32::batch" : "batch", paragraphs(parts));
}

}  // namespace

std::string batch_kernel_declarations(const Api& api) {
  std::vector<std::string> choosers;
  for (const Callable& c : api.callables) choosers.push_back(chooser_declaration(c, " noexcept;"));
  return in_namespace("batch::kernel", paragraphs(choosers));
}

std::string print_batch(const Api& api, const std::string& path) {
  const Library& library = *api.library;
  std::vector<std::string> headers = {"\"robcogen/batch.h\"", "\"" + header_path(folder(library), "types") + "\""};
  if (api.is_parametric()) headers.push_back("\"" + header_path(folder(library), kParameters) + "\"");
  return paragraphs(
      {banner(library, path, "functions over n states at once, in double and (namespace f32) single precision") +
           "//\n"
           "// The arguments say how the states are stored: robcogen::batch::by_element(data, stride), by_state(data), "
           "or one\n"
           "// value for all states. Matrices are stored by columns. Units and frames are those of the functions of "
           "one state.\n"
           "// Results must not overlap arguments. n may be any number; nothing beyond n states is read or written.\n"
           "//\n"
           "// Results agree with single calls up to rounding: processors fuse products into sums where they can. No "
           "state\n"
           "// affects another. To share the work between threads, give each thread a range of the states.\n"
           "//\n"
           "// `most` is the highest processor level to use; a level that the machine lacks is never used.\n",
       "#pragma once\n", includes({"<cstddef>"}), includes(headers),
       in_namespace(
           api.space, paragraphs({batch_kernel_declarations(api), interface(api, false), interface(api, true)}))});
}

std::string print_batch_choice(const Api& api, const std::string& path) {
  std::vector<std::string> bodies, choosers;
  for (const Callable& c : api.callables) {
    bodies.push_back(body_declaration(c, " noexcept;"));
    choosers.push_back(chooser(c) + "\n" + instantiations(c, "", {"robcogen::batch::Level"}));
  }
  return paragraphs(
      {banner(*api.library, path, "the choice of a processor's bodies"),
       includes({"\"robcogen/batch.h\"", "\"robcogen/version.h\""}), runtime_check(api),
       in_namespace(
           api.space + "::batch", paragraphs(
                                      {compiled_levels(), in_namespace("body", paragraphs(bodies)),
                                       in_namespace("kernel", paragraphs(choosers))}))});
}

std::string print_batch_bodies(const Api& api, const std::string& group, const std::string& path) {
  std::vector<std::string> bodies, in_columns;
  for (const Callable* c : callables_of(api, group)) {
    const std::optional<Kernel> in_place = kernel_in_place(*c);
    bodies.push_back(definition(api, *c, in_place.has_value()));
    if (in_place) in_columns.push_back(column_kernel(*in_place));
  }
  const std::string remark = "// Kernels that write to the place of the result in the memory of the caller.\n";
  return paragraphs(
      {banner(*api.library, path, "bodies over many states, compiled once for each processor"), "#pragma once\n",
       includes({"\"robcogen/batch_body.h\"", "\"" + kernel_path(folder(*api.library), group) + "\""}),
       in_columns.empty() ? "" : remark + in_namespace(api.space + "::batch::columns", paragraphs(in_columns)),
       in_namespace(api.space + "::batch::body", paragraphs(bodies))});
}

std::string print_batch_level(
    const Api& api,
    const std::string& group,
    const std::string& level,
    const std::string& path) {
  std::vector<std::string> kernels;
  for (const Callable* c : callables_of(api, group))
    kernels.push_back(instantiations(*c, "robcogen::batch::Level::" + level + ", "));
  const std::string text = paragraphs(
      {includes({"\"" + batch_path(folder(*api.library), group) + "\""}),
       in_namespace(api.space + "::batch::body", paragraphs(kernels))});
  const std::string head = banner(*api.library, path, "bodies over many states, for one processor");
  if (level == kLevels[0]) return paragraphs({head, text});
  return paragraphs(
      {head, includes({"\"robcogen/batch.h\""}), "#if ROBCOGEN_BATCH_LEVELS\n", text,
       "#endif  // ROBCOGEN_BATCH_LEVELS\n"});
}

}  // namespace robcogen::backend::cpp
