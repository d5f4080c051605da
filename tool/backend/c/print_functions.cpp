// The functions of a group: declarations with their documentation, and bodies.
#include <set>

#include "backend/c/printers.h"
#include "backend/common/cache.h"
#include "backend/common/columns.h"
#include "backend/common/layout.h"
#include "backend/common/meaning.h"
#include "backend/common/split_kernel.h"
#include "support/index.h"

namespace robcogen::backend::c {
namespace {

// `void f(const double *hyl_restrict q, …)`, or a part of it.
std::string signature(
    const Names& names,
    const NamedFunction& c,
    const std::string& head,
    const std::vector<KernelArray>& list,
    const Precision& precision,
    const std::string& end) {
  const std::string structure = names.in(precision, c.reads_cache ? "@_cache$ *" : "@_parameters$ *");
  const std::string array = names.in(precision, "% *@_restrict ");
  std::vector<std::string> arguments;
  for (const KernelArray& p : list)
    arguments.push_back((p.output ? "" : "const ") + (p.is_structure ? structure : array) + p.name);
  if (arguments.empty()) arguments = {"void"};
  return wrapped(head + "(", arguments, ")" + end);
}

std::string documentation(const Names& names, const NamedFunction& c, const std::vector<KernelArray>& list) {
  const std::vector<std::string> arrays = describe_arrays(c.function->program, names_of(list), c.reads_cache);
  const ColumnWords words = {.all = "Columns: ", .one = "Column ", .end = ".", .first = 0};
  return comment(describe_function(names.library, *c.function, arrays, {}, words));
}

// No other name has two consecutive underscores.
std::string private_name(const Names& names, const std::string& name, const Precision& precision) {
  return names.prefix + "__" + name + precision.suffix;
}

// `start` is the return type and the name, `void name`.
std::string definition(
    const Names& names,
    const NamedFunction& c,
    const std::string& start,
    const Precision& precision) {
  const Dialect d = dialect(precision, c.reads_cache);
  const Kernel kernel = lower(c.function->program, c.function->kernel, d);
  std::string head = signature(names, c, start, kernel.parameters, precision, " {");
  for (const KernelArray& p : kernel.parameters)
    if (!p.used) head += "  (void)" + p.name + ";\n";
  if (!is_long(kernel, d)) return head + body(kernel, d) + "}\n";
  const SplitKernel split = split_kernel(kernel, d);
  std::string text, calls;
  for (const LiveValues& live : split.live)
    calls += "  " + precision.scalar + " " + subscripted(live.array.name, live.size) + ";\n";
  for (const Kernel& part : split.parts) {
    const std::string name = private_name(names, part.name, precision);
    text += signature(names, c, "static void " + name, part.parameters, precision, " {") + body(part, d) + "}\n\n";
    calls += wrapped("  " + name + "(", names_of(part.parameters), ");");
  }
  return text + head + calls + "}\n";
}

// Prints `f_column`, which solves for one column, and `f_columns`, which replaces columns of a matrix by their
// solutions.
std::string print_column_solver(const Names& names, const Function& solution, const Precision& precision) {
  const std::string rows = std::to_string(solution.program.outputs.front().rows), scalar = precision.scalar;
  const std::string column = private_name(names, solution.kernel, precision);
  return comment("Solves for one column.") +
         definition(names, {&solution, {}, {}}, "static void " + column, precision) + "\n" +
         comment("Replaces each column by its solution.") +
         wrapped(
             "static void " + private_name(names, solution.kernel + "s", precision) + "(",
             {"const " + scalar + " *factor", "int count", scalar + " *columns"}, ") {") +
         "  " + scalar + " b[" + rows + "];\n  for (; count > 0; --count) {\n    for (int row = 0; row < " + rows +
         "; ++row) b[row] = columns[row];\n    " + column + "(factor, b, columns);\n    columns += " + rows +
         ";\n  }\n}\n";
}

// Prints a function that computes right-hand sides and replaces them by the solutions.
std::string print_column_loop(const Names& names, const NamedFunction& c, const Precision& precision) {
  const Function& sides = right_sides(names.library, *c.function);
  const std::vector<KernelArray> list = parameters(c.function->program, dialect(precision, c.reads_cache));
  const std::string right = private_name(names, sides.kernel, precision), factor = sides.program.outputs.back().name;
  std::vector<std::string> arguments = names_of(list);
  arguments.push_back(factor);
  std::string text = comment(sides.summary.front()) +
                     definition(names, {&sides, {}, {}, c.reads_cache}, "static void " + right, precision) + "\n" +
                     signature(names, c, "void " + c.name_in(precision), list, precision, " {") + "  " +
                     precision.scalar + " " + factor + "[" + std::to_string(sides.program.outputs.back().rows) +
                     "];\n" + wrapped("  " + right + "(", arguments, ");");
  for (const symbolic::SolvedColumns::Block& block : c.function->solved->blocks) {
    const std::string& array = list[c.function->program.inputs.size() + at(block.output)].name;
    text += wrapped(
        "  " + private_name(names, c.function->solved->solution.name + "s", precision) + "(",
        {factor, std::to_string(block.columns), array}, ");");
  }
  return text + "}\n";
}

// Overloads share the functions that solve for their columns. These precede the first overload; `printed` collects
// their names.
std::string print_function(
    const Names& names,
    const NamedFunction& c,
    const Precision& precision,
    std::set<std::string>& printed) {
  if (!c.function->solved) return definition(names, c, "void " + c.name_in(precision), precision);
  const Function solution = column_solution(*c.function->solved);
  return (printed.insert(solution.kernel).second ? print_column_solver(names, solution, precision) + "\n" : "") +
         print_column_loop(names, c, precision);
}

bool has_update(const Names& names, const std::string& group) {
  return group == kParametersGroup && !names.library.updates.empty();
}

constexpr const char* kUpdate = "void @_update$(const @_parameters$ *parameters, @_cache$ *cache)";

// Prints the function that computes the parts of the cache one after the other.
std::string print_update(const Names& names, const Precision& precision) {
  std::string calls;
  const NamedFunction* update = names.functions.data() + names.library.functions.size();
  for (const auto& [begin, size] : cache_parts(names.library)) {
    const std::string& name = update++->name_in(precision);
    if (size > 0) calls += "  " + name + "(parameters, cache->values + " + std::to_string(begin) + ");\n";
  }
  if (calls.empty()) calls = "  (void)parameters;\n  (void)cache;\n";
  return names.in(precision, kUpdate) + " {\n" + calls + "}\n";
}

}  // namespace

std::string print_header(const Names& names, const std::string& group) {
  std::string text = "#include \"" + names.folder + "/model.h\"\n\n#ifdef __cplusplus\nextern \"C\" {\n#endif\n";
  for (const NamedFunction& c : names.functions) {
    if (c.function->group != group) continue;
    const std::vector<KernelArray> list = parameters(c.function->program, dialect(kDouble, c.reads_cache));
    text += "\n" + documentation(names, c, list);
    for (const Precision& precision : kPrecisions)
      text += signature(names, c, "void " + c.name_in(precision), list, precision, ";");
  }
  if (has_update(names, group)) {
    text +=
        "\n"
        "// Computes the whole cache, which functions read in place of the parameters. Call it once, and after every "
        "change.\n";
    for (const Precision& precision : kPrecisions) text += names.in(precision, kUpdate) + ";\n";
  }
  return header(names, group + ".h", group, text + "\n#ifdef __cplusplus\n}\n#endif\n");
}

std::string print_functions(const Names& names, const std::string& group, const Precision& precision) {
  const std::string path = names.folder + "/" + group;
  std::string text = banner(names.library, path + precision.file_end, group + " in " + precision.scalar) +
                     "#include \"" + path + ".h\"\n\n#include <math.h>\n";
  std::set<std::string> printed;
  for (const NamedFunction& c : names.functions)
    if (c.function->group == group) text += "\n" + print_function(names, c, precision, printed);
  if (has_update(names, group)) text += "\n" + print_update(names, precision);
  return precision.is_float ? text : text + identity_definition(names, group);
}

}  // namespace robcogen::backend::c
