// Functions over many states: <name>/batch.h, with Eigen types over arrays, and what the library compiles beneath it:
// <name>/batch.cpp, which chooses the bodies for the processor that it runs on.
#include <algorithm>
#include <cctype>
#include <utility>

#include "backend/cpp/batch_kernels.h"
#include "backend/cpp/compiled_kernels.h"
#include "backend/cpp/layout.h"
#include "backend/cpp/printers.h"

namespace robcogen::backend::cpp {
namespace {

// The arguments of the kernel, parameters first.
std::vector<std::string> passed_on(const Callable& callable) {
  std::vector<std::string> list, others;
  for (const BatchArray& a : batch_arrays(callable.function->program))
    (a.is_parameters ? list : others).push_back(a.name);
  list.emplace_back("n");
  list.insert(list.end(), others.begin(), others.end());
  return list;
}

// The function that chooses the processor's body: declared in the interface, defined in <name>/batch.cpp.
std::string chooser_declaration(
    const BatchKernel& kernel,
    const std::string& tail,
    const std::string& level = "robcogen::batch::Level most") {
  std::vector<std::string> list = batch_parameters(kernel, "Scalar", true);
  list.push_back(level);
  return "template <class Scalar>\n" + declaration("void " + kernel.name(), list, tail);
}

// The constant that says whether bodies for a processor level are compiled: `kHasAvx2`.
std::string constant_of(std::string level) {
  std::transform(level.begin() + 1, level.end(), level.begin() + 1, [](unsigned char c) { return std::tolower(c); });
  return "kHasA" + level.substr(1);
}

// Statements that compute one state after the other by the compiled kernel, which writes to the caller's memory where
// it can.
std::string over_single_states(const Api& api, const BatchKernel& kernel, std::size_t indent) {
  const auto method = [](const std::string& name, int size) {
    return "states.template " + name + "<" + std::to_string(size) + ">";
  };
  const std::string blanks(indent, ' ');
  std::string buffers, store;
  std::vector<std::string> arguments;
  for (const BatchArray& a : batch_arrays(kernel.callable->function->program)) {
    if (a.is_parameters) {
      arguments.push_back(a.name);
      continue;
    }
    const bool is_lower = a.is_output && kernel.is_lower;
    const std::string buffer = a.name + "_buffer", arrays = "(" + a.name + ", " + buffer + ")";
    buffers += blanks + "Scalar " + buffer + "[" + std::to_string(std::max(a.size, 1)) + "];\n";
    arguments.push_back(is_lower ? buffer : (a.is_output ? "states.place" : method("load", a.size)) + arrays);
    if (a.is_output)
      store +=
          call(is_lower ? method("store_lower", a.rows) : method("store_buffer", a.size), {buffer, a.name}, indent + 2);
  }
  return buffers + blanks + "for (robcogen::batch::States<Scalar> states(n); states.is_left(); states.advance()) {\n" +
         call("::" + api.space + "::kernel::" + kernel.callable->kernel, arguments, indent + 2) + store + blanks +
         "}\n";
}

std::string chooser(const Api& api, const BatchKernel& kernel) {
  const std::vector<std::string> arguments = passed_on(*kernel.callable);
  const auto body = [&](const std::string& level) {
    return "body::" + kernel.name() + "<robcogen::batch::Level::" + level + ", Scalar>";
  };
  std::string text = chooser_declaration(kernel, " noexcept {");
  text += "  [[maybe_unused]] const robcogen::batch::Level level = robcogen::batch::available(most);\n";
  // A machine with AVX-512 also runs AVX2 code, if that is the best that is compiled.
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
  return text + "  if constexpr (kHasBaseline) {\n" + call(body("baseline"), arguments, 4) + "  } else {\n" +
         over_single_states(api, kernel, 4) + "  }\n}\n";
}

// The levels that the library is compiled for: BATCH_LEVELS of robcogen_add_robot.
std::string compiled_levels() {
  std::string text = "// Processor levels that the library is compiled for in addition to the baseline.\n";
  for (const std::string level : {"AVX512", "AVX2"})
    text += "#ifdef ROBCOGEN_WITHOUT_" + level + "\n[[maybe_unused]] constexpr bool " + constant_of(level) +
            " = false;\n#else\n[[maybe_unused]] constexpr bool " + constant_of(level) +
            " = robcogen::batch::kHasLevels;\n#endif\n";
  return text +
         "// Without bodies for the baseline, its machines compute one state after the other.\n"
         "#ifdef ROBCOGEN_WITHOUT_BASELINE\n[[maybe_unused]] constexpr bool kHasBaseline = false;\n#else\n"
         "[[maybe_unused]] constexpr bool kHasBaseline = true;\n#endif\n";
}

// A function of the interface. Without the gravity argument it takes standard gravity; the storage argument exists for
// symmetric matrices.
struct Signature {
  bool single_precision = false;
  bool has_gravity = true;
  bool has_storage = false;
};

std::string documentation(const Callable& callable, const Signature& signature, const std::string& sizes) {
  if (signature.single_precision) return "";
  if (signature.has_storage)
    return comment("The same; with robcogen::batch::Storage::lower, elements above the diagonal are not written.");
  std::string text;
  if (signature.has_gravity)
    text += comment(callable.function->summary);
  else
    text += comment("The same under standard gravity.");
  return text + comment("Elements per state: " + sizes + ".");
}

std::string function(const Api& api, const Callable& callable, const Signature& signature) {
  const std::string kernels = signature.single_precision ? "::" + api.space + "::batch::kernel::" : "kernel::";
  std::vector<std::string> list, inputs, arguments, passed;
  std::string sizes;
  for (const BatchArray& a : batch_arrays(callable.function->program)) {
    if (a.is_parameters) {
      list.push_back("const " + a.type + "& " + a.name);
      arguments.push_back(a.name + ".data()");
      continue;
    }
    const bool is_left_out = a.is_gravity && !signature.has_gravity;
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
  if (signature.has_storage) list.emplace_back("robcogen::batch::Storage storage");
  list.emplace_back("robcogen::batch::Level most = robcogen::batch::Level::avx512");
  arguments.emplace_back("most");
  std::string body;
  if (signature.has_storage)
    body = "  if (storage == robcogen::batch::Storage::lower)\n" +
           call("return " + kernels + callable.kernel + "_lower<Scalar>", arguments, 4);
  return documentation(callable, signature, sizes) + declaration("inline void " + callable.name, list, " noexcept {") +
         body + call(kernels + callable.kernel + "<Scalar>", arguments, 2) + "}\n";
}

// The scopes of free functions, then those of functions that are members of a result type, in order.
std::vector<std::string> all_scopes(const Api& api, const std::string& group) {
  std::vector<std::string> result = scopes(api, group);
  for (const Callable* c : callables_of(api, group))
    if (std::find(result.begin(), result.end(), c->function->scope) == result.end())
      result.push_back(c->function->scope);
  return result;
}

// All functions of one scope that take positions. Gravity may be left out where the functions of one state allow it.
std::string scope_text(const Api& api, const std::string& group, const std::string& scope, bool single_precision) {
  std::vector<std::string> parts;
  const auto add = [&](const Callable& c, bool with_gravity) {
    parts.push_back(function(api, c, {single_precision, with_gravity, false}));
    if (is_symmetric(c)) parts.push_back(function(api, c, {single_precision, with_gravity, true}));
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
  for (const BatchKernel& k : batch_kernels(api)) choosers.push_back(chooser_declaration(k, " noexcept;"));
  return in_namespace("batch::kernel", paragraphs(choosers));
}

std::string print_batch(const Api& api, const std::string& path) {
  const Library& library = *api.library;
  const bool single = library.has_single_precision;
  std::vector<std::string> headers = {"\"robcogen/batch.h\"", "\"" + header_path(folder(library), "types") + "\""};
  if (api.is_parametric()) headers.push_back("\"" + header_path(folder(library), kParameters) + "\"");
  return paragraphs(
      {banner(
           library, path,
           "functions over batches of n states, in double" + std::string(single ? " and (namespace f32) single" : "") +
               " precision") +
           "//\n"
           "// The arguments say how the states are stored: robcogen::batch::by_element(data, stride), by_state(data), "
           "or one\n"
           "// value for all states. Matrices are stored by columns. Units and frames are those of the functions of "
           "one state.\n"
           "// Results must not overlap arguments. n may be any number; only n states are read and written.\n"
           "//\n"
           "// Results agree with single calls up to rounding: processors fuse products into sums where they can. No "
           "state\n"
           "// affects another. To share the work between threads, give each thread a range of the states.\n"
           "//\n"
           "// `most` is the highest processor level to use; a level that the machine lacks is never used.\n",
       "#pragma once\n", includes({"<cstddef>"}), includes(headers), identity_reference(api, "batches"),
       in_namespace(
           api.space, paragraphs(
                          {batch_kernel_declarations(api), interface(api, false),
                           single ? interface(api, true) : std::string()}))});
}

std::string print_batch_choice(const Api& api, const std::string& path) {
  const std::vector<std::string> headers = {
      "\"" + kernels_path(folder(*api.library)) + "\"", "\"robcogen/batch_states.h\"", "\"robcogen/version.h\""};
  std::vector<std::string> bodies, choosers;
  for (const BatchKernel& k : batch_kernels(api)) {
    const bool is_in_blocks = !k.callable->function->form.takes_single_states;
    if (is_in_blocks) bodies.push_back(batch_body_declaration(k, " noexcept;"));
    const std::string by_state =
        chooser_declaration(k, " noexcept {", "robcogen::batch::Level") + over_single_states(api, k, 2) + "}\n";
    choosers.push_back(
        (is_in_blocks ? chooser(api, k) : by_state) + "\n" +
        batch_instantiations(api, k, "", {"robcogen::batch::Level"}));
  }
  return paragraphs(
      {banner(*api.library, path, "selection of the bodies for the processor"), includes({"\"robcogen/batch.h\""}),
       includes(headers), runtime_check(api),
       in_namespace(
           api.space + "::batch", paragraphs(
                                      {compiled_levels(), in_namespace("body", paragraphs(bodies)),
                                       in_namespace("kernel", paragraphs(choosers))}))});
}

}  // namespace robcogen::backend::cpp
