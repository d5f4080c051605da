#include "backend/selfcheck/selfcheck.h"

#include <algorithm>

#include "backend/c/printers.h"
#include "backend/common/planned_file.h"
#include "backend/cpp/compiled_kernels.h"
#include "backend/cpp/cpp.h"
#include "backend/cpp/layout.h"
#include "backend/cpp/printers.h"

namespace robcogen::backend::selfcheck {
namespace {

using cpp::Api;
using cpp::Callable;

constexpr const char* kFolder = "selfcheck/";

// A structure of the library in C holds the numbers of an array and nothing else.
std::string as_structure(const std::string& type, const std::string& array) {
  return "reinterpret_cast<const " + type + "*>(" + array + ")";
}

// The specialisation of a kernel for one precision: it calls the function in C.
std::string definition(
    const Callable& kernel,
    const c::NamedFunction& function,
    const std::string& prefix,
    bool is_update,
    const c::Precision& precision) {
  const std::string structure = "::" + prefix + (is_update ? "_parameters" : "_cache") + precision.suffix;
  const std::vector<KernelArray> in_c =
      parameters(kernel.function->program, c::dialect(precision, function.reads_cache));
  std::vector<std::string> list, arguments;
  for (std::size_t i = 0; i < kernel.parameters.size(); ++i) {
    const KernelArray& p = kernel.parameters[i];
    list.push_back((p.output ? "" : "const ") + precision.scalar + "* " + p.name);
    arguments.push_back(in_c[i].is_structure ? as_structure(structure, p.name) : p.name);
  }
  return "template <>\n" +
         cpp::declaration("void " + kernel.kernel + "<" + precision.scalar + ">", list, " noexcept {") +
         cpp::call("::" + function.name_in(precision), arguments, 2) + "}\n";
}

// `numbers` are left out: only the tables of a robot with parameters read them, and the library in C lacks them.
std::string print_kernels(const Api& api, const std::string& path) {
  const c::Names names = c::names(*api.library);
  const std::string folder = cpp::folder(*api.library);
  std::vector<std::string> definitions;
  for (std::size_t i = 0; i < names.functions.size(); ++i) {
    const bool is_update = i >= api.callables.size();
    const Callable& kernel = is_update ? api.updates[i - api.callables.size()] : api.callables[i];
    for (const c::Precision& precision : c::kPrecisions)
      if (!precision.is_float || api.library->has_single_precision)
        definitions.push_back(definition(kernel, names.functions[i], names.prefix, is_update, precision));
  }
  std::string instantiations;
  for (const Callable& n : api.numbers) instantiations += cpp::explicit_instantiations(api, n.kernel);
  definitions.push_back(instantiations);
  return cpp::paragraphs(
      {cpp::banner(*api.library, path, "kernels for the self-check of the library in C"),
       cpp::includes(
           {cpp::quoted(names.folder + "/" + names.folder + ".h"), cpp::quoted(cpp::kernels_path(folder)),
            cpp::quoted(cpp::kernel_path(folder, cpp::kParameters))}),
       cpp::in_namespace(api.space + "::kernel", cpp::paragraphs(definitions))});
}

std::vector<PlannedFile<Api>> files(const std::string& folder) {
  std::vector<PlannedFile<Api>> list;
  const auto add = [&](const std::string& path, const auto& printer, const auto&... arguments) {
    list.push_back({kFolder + path, [=](const Api& api) { return printer(api, arguments..., path); }});
  };
  add(cpp::header_path(folder, "model"), cpp::print_model);
  add(cpp::header_path(folder, "types"), cpp::print_types);
  add(cpp::header_path(folder, cpp::kParameters), cpp::print_parameters);
  add(cpp::header_path(folder, "reflection"), cpp::print_reflection);
  add(cpp::umbrella_path(folder), cpp::print_umbrella);
  add(cpp::kernels_path(folder), cpp::print_kernel_declarations);
  add(cpp::functions_path(folder), cpp::print_definitions);
  add(cpp::kernel_path(folder, cpp::kParameters), cpp::print_kernels, std::string(cpp::kParameters));
  add(folder + "/kernels.cpp", print_kernels);
  return list;
}

}  // namespace

std::vector<std::string> outputs(const std::string& name, const std::string& enclosing) {
  return paths(files(cpp::folder(name, enclosing)));
}

std::vector<OutputFile> print(const Library& library) {
  Library as_cpp = library;
  as_cpp.has_batches = false;
  as_cpp.levels.clear();
  return backend::print(files(cpp::folder(as_cpp)), cpp::api(as_cpp));
}

}  // namespace robcogen::backend::selfcheck
