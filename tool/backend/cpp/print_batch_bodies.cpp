// Bodies of functions over many states, <name>/batch/<group>.h, which compute one block of states at a time. One source
// per processor instantiates them.
#include <optional>
#include <utility>

#include "backend/cpp/batch_kernels.h"
#include "backend/cpp/compiled_kernels.h"
#include "backend/cpp/layout.h"
#include "backend/cpp/printers.h"

namespace robcogen::backend::cpp {
namespace {

using symbolic::Program;

std::string lanes_of(const BatchArray& array) {
  return array.name + "_lanes";
}

// The kernel of a function over many states that writes its result in place. The result is a symmetric matrix: most of
// its elements are written twice or are zeros, and an intermediate copy would fill the cache. None if the kernel is cut
// into parts, or solves for the columns of its result, which it reads again.
std::optional<Kernel> kernel_in_place(const Callable& callable) {
  if (!is_symmetric(callable) || callable.function->solved) return std::nullopt;
  Kernel kernel = lower(callable.function->program, callable.kernel);
  return is_long(kernel, dialect()) ? std::nullopt : std::optional(std::move(kernel));
}

// A kernel that writes to columns. It is not inlined into the loop over blocks, because it would then keep the address
// of each column in memory.
std::string column_kernel(const Kernel& kernel) {
  std::vector<std::string> list;
  for (const KernelArray& p : kernel.parameters)
    list.push_back((p.output ? "const Columns " : "const Scalar* ") + (p.used ? p.name : "/*" + p.name + "*/"));
  return "template <class Scalar, class Columns>\n" +
         declaration("[[gnu::noinline]] void " + kernel.name, list, " noexcept {") + body(kernel) + "}\n";
}

// The member function of a block that stores a result; with `columns`, it stores what a kernel has not written in
// place.
std::string store_of(const BatchArray& array, bool is_lower, bool columns) {
  const std::string name = std::string("store") + (is_lower ? "_lower" : "") + (columns ? "_buffer" : "");
  return "block.template " + name + "<" + std::to_string(is_lower ? array.rows : array.size) + ">";
}

std::string definition(const Api& api, const BatchKernel& kernel, bool in_place) {
  const Program& program = kernel.callable->function->program;
  const std::string kernels = in_place ? "::batch::columns::" : "::kernel::";
  std::string values, once, load, store;
  std::vector<std::string> arguments;
  for (const BatchArray& a : batch_arrays(program)) {
    const std::string lanes = lanes_of(a), size = std::to_string(a.size);
    values += "  Value " + lanes + "[" + (a.size == 0 ? "1" : size) + "];\n";
    const bool is_column = in_place && a.is_output;
    const std::string columns =
        kernel.is_lower ? "template lower_columns<" + std::to_string(a.rows) + ">" : std::string("columns");
    arguments.push_back(is_column ? "block." + columns + "(" + a.name + ", " + lanes + ")" : lanes);
    if (a.is_parameters)
      once += call("robcogen::batch::spread", {a.name, size, lanes}, 2);
    else if (a.is_output)
      store += call(store_of(a, kernel.is_lower, is_column), {lanes, a.name}, 4);
    else
      load += call("block.template load<" + size + ">", {a.name, lanes}, 4);
  }
  return batch_body_declaration(kernel, " noexcept {") + "  using Value = robcogen::NativeLanes<Scalar>;\n" + values +
         once + "  for (robcogen::batch::Block<Scalar> block(n); block.is_left(); block.advance()) {\n" + load +
         call("::" + api.space + kernels + kernel.callable->kernel, arguments, 4) + store + "  }\n}\n";
}

// The kernels that take blocks of states.
std::vector<BatchKernel> in_blocks(const Api& api, const std::string& group) {
  std::vector<BatchKernel> kernels = batch_kernels(callables_of(api, group));
  std::erase_if(kernels, [](const BatchKernel& k) { return k.callable->function->form.takes_single_states; });
  return kernels;
}

}  // namespace

std::string print_batch_bodies(const Api& api, const std::string& group, const std::string& path) {
  std::vector<std::string> bodies, in_columns;
  for (const BatchKernel& k : in_blocks(api, group)) {
    const std::optional<Kernel> in_place = kernel_in_place(*k.callable);
    bodies.push_back(definition(api, k, in_place.has_value()));
    if (in_place && !k.is_lower) in_columns.push_back(column_kernel(*in_place));
  }
  const std::string remark = "// Kernels that write their results directly into the caller's memory.\n";
  return paragraphs(
      {banner(*api.library, path, "bodies of batch functions, compiled once for each processor level"),
       "#pragma once\n",
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
  for (const BatchKernel& k : in_blocks(api, group))
    kernels.push_back(batch_instantiations(api, k, "robcogen::batch::Level::" + level + ", "));
  const std::string text = paragraphs(
      {includes({"\"" + batch_path(folder(*api.library), group) + "\""}),
       in_namespace(api.space + "::batch::body", paragraphs(kernels))});
  const std::string head = banner(*api.library, path, "bodies of batch functions for one processor level");
  if (level == kLevels[0]) return paragraphs({head, text});
  return paragraphs(
      {head, includes({"\"robcogen/batch.h\""}), "#if ROBCOGEN_BATCH_LEVELS\n", text,
       "#endif  // ROBCOGEN_BATCH_LEVELS\n"});
}

}  // namespace robcogen::backend::cpp
