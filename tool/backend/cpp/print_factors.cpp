// <name>/reflection.h of a library without a robot: its transforms as products of primitives, for the self-check.
#include "backend/cpp/compiled_kernels.h"
#include "backend/cpp/flat_tables.h"
#include "backend/cpp/layout.h"
#include "backend/cpp/lower.h"
#include "backend/cpp/printers.h"
#include "support/number.h"
#include "symbolic/cost.h"

namespace robcogen::backend::cpp {
namespace {

using symbolic::Role;

// A range of a table that another table refers to.
std::string span(const std::string& table, std::size_t first, std::size_t size) {
  if (size == 0) return "{nullptr, 0}";
  return braced({table + (first ? " + " + std::to_string(first) : ""), std::to_string(size)});
}

// A wrapper of an interface function, whose arguments are the arrays of all parameters and of all variables.
std::string caller(const Api& api, const Callable& callable) {
  std::string name = "call_" + callable.kernel;
  std::vector<std::string> arguments;
  bool parameters = false, variables = false;
  for (const symbolic::InputArray& input : callable.function->program.inputs) {
    if (input.role == Role::parameters) {
      std::vector<std::string> values;
      for (std::size_t i = 0; i < api.parameters.size(); ++i) values.push_back("parameters[" + std::to_string(i) + "]");
      arguments.push_back("Parameters" + braced(values));
      parameters = true;
    } else {
      for (const std::string& label : input.elements)
        for (std::size_t i = 0; i < api.library->document.variables.size(); ++i)
          if (api.library->document.variables[i] == label) arguments.push_back("variables[" + std::to_string(i) + "]");
      variables = true;
    }
  }
  return declaration(
             "inline " + callable.result + " " + name,
             {std::string("const double* ") + (parameters ? "parameters" : "/*parameters*/"),
              std::string("const double* ") + (variables ? "variables" : "/*variables*/")},
             " noexcept {") +
         call("return " + callable.function->scope + "::" + callable.name, arguments, 2) + "}\n";
}

// The function that computes the amounts of a transform's factors from all parameters and all variables.
std::string amounts_of(const Callable& homogeneous) {
  const symbolic::Program& program = homogeneous.function->factors->amounts;
  const Kernel kernel = lower(program, "amounts_" + homogeneous.kernel);
  std::vector<KernelArray> list;
  for (const Role role : {Role::parameters, Role::variables}) {
    KernelArray parameter{role == Role::parameters ? "parameters" : "variables", false, false};
    for (std::size_t p = 0; p < program.inputs.size(); ++p)
      if (program.inputs[p].role == role && kernel.parameters[p].used) parameter = kernel.parameters[p];
    list.push_back(std::move(parameter));
  }
  list.push_back(kernel.parameters.back());
  return signature("void " + kernel.name, list, " noexcept {") + body(kernel) + "}\n";
}

// Tables of factors and of transforms. A row of the latter refers to a range of the former.
class Tables {
 public:
  explicit Tables(const Api& api) : api_(api) {
    for (const Callable& c : api.callables) {
      if (!c.function->derivatives.empty()) {
        differentiated_.push_back(&c);
        continue;
      }
      functions_.push_back(caller(api, c));
      if (c.function->factors) add(c);
    }
  }

  std::string text() const {
    const Library& library = *api_.library;
    const std::string space = "robcogen::reflection::";
    std::vector<std::string> parts = functions_;
    const auto add = [&](const std::string& type, const std::string& name,
                         const std::vector<std::vector<Field>>& rows) {
      if (!rows.empty()) parts.push_back(table("inline constexpr " + space + type + " " + name + "[]", rows));
    };
    add("Factor", "kFactors", factors_);
    add("ProductOfFactors", "kTransforms", transforms_);
    std::vector<std::string> fields = {
        quoted(library.title()), std::to_string(library.parameters().size()),
        std::to_string(library.document.variables.size()), std::to_string(library.frames().size()),
        span("kTransforms", 0, transforms_.size())};
    std::vector<std::string> remarks = {"name", "parameters", "variables", "frames", "transforms"};
    if (!differentiated_.empty()) {
      std::vector<std::vector<Field>> rows;
      for (const Callable* c : differentiated_) rows.push_back(function_row(*c));
      const Table functions = table("Function", "kFunctions", rows), blocks = derivatives(differentiated_, false);
      parts.insert(
          parts.end(), {"using robcogen::reflection::At;\nusing robcogen::reflection::kFlat;\n", functions.definition,
                        blocks.definition});
      fields.insert(fields.end(), {functions.reference, blocks.reference});
      remarks.insert(remarks.end(), {"functions with derivatives", "derivatives"});
    }
    parts.push_back(remarked_list("inline constexpr " + space + "Transforms model", fields, remarks));
    return paragraphs(parts);
  }

 private:
  void add(const Callable& homogeneous) {
    const std::size_t first = factors_.size();
    const ProductData& product = homogeneous.function->factors.value();
    for (const PrimitiveData& p : product.primitives) factors_.push_back({p.rotation ? "true" : "false", p.axis});
    functions_.push_back(amounts_of(homogeneous));
    std::vector<Field> row = {
        quoted(homogeneous.function->name), homogeneous.function->left_frame, homogeneous.function->right_frame,
        span("kFactors", first, factors_.size() - first), "&amounts_" + homogeneous.kernel};
    for (const Role form : {Role::homogeneous, Role::spatial_motion, Role::spatial_force})
      row.emplace_back("&" + caller_of(homogeneous, form));
    transforms_.push_back(std::move(row));
  }

  // The wrapper of the function that has the same name in another form.
  std::string caller_of(const Callable& homogeneous, Role form) const {
    for (const Callable& c : api_.callables)
      if (c.function->name == homogeneous.function->name && c.function->program.outputs.front().role == form)
        return "call_" + c.kernel;
    return "";
  }

  const Api& api_;
  std::vector<std::string> functions_;
  std::vector<std::vector<Field>> factors_, transforms_;
  std::vector<const Callable*> differentiated_;
};

}  // namespace

std::string print_factors(const Api& api, const std::string& path) {
  const Library& library = *api.library;
  return paragraphs(
      {banner(library, path, "its transforms as tables"), "#pragma once\n",
       includes({cpp::quoted(umbrella_path(folder(library))), "\"robcogen/transform_tables.h\""}),
       in_namespace(api.space + "::reflection", Tables(api).text())});
}

}  // namespace robcogen::backend::cpp
