// <name>/detail/kernels.h, the declarations of all kernels, and <name>/<group>.cpp, which compiles them.
#include "backend/cpp/compiled_kernels.h"
#include "backend/cpp/layout.h"
#include "backend/cpp/printers.h"

namespace robcogen::backend::cpp {

std::string explicit_instantiations(const Api& api, const std::string& kernel) {
  std::string result;
  for (const std::string& scalar : api.scalars()) {
    const std::string name = kernel + "<" + scalar + ">";
    const std::string type = "template decltype(" + name + ")";
    const bool fits = type.size() + name.size() + 2 <= kColumns;
    result += type + (fits ? " " : "\n    ") + name + ";\n";
  }
  return result;
}

std::string instantiations(const Api& api, const std::string& group) {
  std::string kernels;
  for (const CompiledKernel& kernel : compiled_kernels(api, group))
    kernels += explicit_instantiations(api, qualified(kernel));
  return in_namespace(api.space + "::kernel", kernels);
}

std::string print_kernel_declarations(const Api& api, const std::string& path) {
  std::string kernels, cores;
  for (const std::vector<Callable>* list :
       {&api.right_sides, &api.callables, &api.updates, &api.numbers, &api.trigonometry}) {
    for (const Callable& c : *list) {
      kernels += signature("void " + c.kernel, c.parameters, " noexcept;");
      if (c.function->core) cores += signature("void " + c.kernel, c.core_parameters, " noexcept;");
    }
  }
  if (api.takes_sines())
    kernels += signature("void joint_trigonometry", trigonometry_parameters(*api.library), " noexcept;");
  return paragraphs(
      {banner(
           *api.library, path, "declarations of its kernels, which the library compiles for " + api.scalars_in_words()),
       "#pragma once\n", in_namespace(api.space + "::kernel", kernels),
       in_namespace(api.space + "::kernel::core", cores)});
}

std::string print_instantiations(const Api& api, const std::string& group, const std::string& path) {
  if (chooses_level(api, group)) return paragraphs({print_choice(api, group, path), identity_definition(api, group)});
  return paragraphs(
      {banner(*api.library, path, "kernels compiled for " + api.scalars_in_words()),
       includes({"\"" + kernel_path(folder(*api.library), group) + "\""}), instantiations(api, group),
       identity_definition(api, group)});
}

}  // namespace robcogen::backend::cpp
