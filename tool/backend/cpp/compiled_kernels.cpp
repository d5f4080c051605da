#include "backend/cpp/compiled_kernels.h"

#include "backend/cpp/layout.h"
#include "backend/cpp/printers.h"

namespace robcogen::backend::cpp {

std::string qualified(const CompiledKernel& kernel) {
  return kernel.is_core ? "core::" + kernel.name : kernel.name;
}

std::vector<const Callable*> kernels_of(const Api& api, const std::string& group) {
  std::vector<const Callable*> result;
  for (const Callable& c : api.right_sides)
    if (c.function->group == group) result.push_back(&c);
  const std::vector<const Callable*> others = callables_of(api, group);
  result.insert(result.end(), others.begin(), others.end());
  return result;
}

std::vector<const Callable*> callables_of(const Api& api, const std::string& group) {
  std::vector<const Callable*> result;
  for (const std::vector<Callable>* list : {&api.callables, &api.updates, &api.numbers, &api.trigonometry})
    for (const Callable& c : *list)
      if (c.function->group == group) result.push_back(&c);
  return result;
}

std::vector<KernelArray> trigonometry_parameters(const Library& library) {
  std::vector<KernelArray> list = parameters(library.trigonometry->angles);
  list.back() = {"sin_q", true};
  list.push_back({"cos_q", true});
  return list;
}

std::vector<CompiledKernel> compiled_kernels(const Api& api, const std::string& group) {
  std::vector<CompiledKernel> result;
  for (const Callable* c : kernels_of(api, group)) {
    if (c->function->core) result.push_back({c->kernel, true, c->core_parameters, c});
    result.push_back({c->kernel, false, c->parameters, c});
  }
  if (group == kTrigonometry && api.takes_sines())
    result.push_back({"joint_trigonometry", false, trigonometry_parameters(*api.library)});
  return result;
}

std::string lanes(int width) {
  return "robcogen::Lanes<Scalar, " + std::to_string(width) + ">";
}

std::string type_of(const KernelArray& parameter) {
  return parameter.width > 1 ? lanes(parameter.width) : "Scalar";
}

std::string signature(const std::string& head, const std::vector<KernelArray>& parameters, const char* tail) {
  std::vector<std::string> list;
  for (const KernelArray& p : parameters) {
    list.push_back((p.output ? type_of(p) : "const " + type_of(p)) + "* " + (p.used ? p.name : "/*" + p.name + "*/"));
  }
  return "template <class Scalar>\n" + declaration(head, list, tail);
}

}  // namespace robcogen::backend::cpp
