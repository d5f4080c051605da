// The functions of a group: declarations with their documentation, and bodies.
#include <algorithm>
#include <set>

#include "backend/c/printers.h"
#include "backend/common/cache.h"
#include "backend/common/columns.h"
#include "backend/common/layout.h"
#include "backend/common/meaning.h"
#include "backend/common/split_kernel.h"
#include "support/index.h"

namespace robcogen::backend::c {
std::string documentation(const Names& names, const NamedFunction& c, const std::vector<KernelArray>& list) {
  const std::vector<std::string> arrays = describe_arrays(c.function->program, names_of(list), c.reads_cache);
  const ColumnWords words = {.all = "Columns: ", .one = "Column ", .end = ".", .first = 0};
  return comment(describe_function(names.library, *c.function, arrays, {}, words));
}

std::string macro_signature(const std::string& name, const std::vector<KernelArray>& list, const std::string& end) {
  int position = 0;
  std::vector<std::string> arguments;
  for (const KernelArray& p : list)
    arguments.push_back(
        is_kept(p.name) ? (p.output ? "REAL *" : "const REAL *") + p.name
                        : (p.output ? "RC_OUT(" : "RC_IN(") + std::to_string(++position) + ", " + p.name + ")");
  return wrapped("RC_FUNCTION(" + std::to_string(position) + ") " + name + "(", arguments, ")" + end);
}

namespace {

// `void f(const double *hyl_restrict q, …)`, or a part of it. `linkage`: `static ` or nothing.
std::string signature(
    const Names& names,
    const NamedFunction& c,
    const std::string& linkage,
    const std::string& name,
    const std::vector<KernelArray>& list,
    const Precision& precision,
    const std::string& end) {
  if (precision.is_macro) return macro_signature(name, list, end);
  const std::string structure = names.in(precision, c.reads_cache ? "@_cache$ *" : "@_parameters$ *");
  const std::string array = names.in(precision, "% *@_restrict ");
  std::vector<std::string> arguments;
  for (const KernelArray& p : list)
    arguments.push_back((p.output ? "" : "const ") + (p.is_structure ? structure : array) + p.name);
  if (arguments.empty()) arguments = {"void"};
  return wrapped(linkage + "void " + name + "(", arguments, ")" + end);
}

// `f(q, H);`, indented.
std::string call(const std::string& name, const std::vector<std::string>& arguments, const Precision& precision) {
  return wrapped("  " + (precision.is_macro ? "RC_CALL(" + name + ")" : name) + "(", arguments, ");");
}

// No other name has two consecutive underscores. A file in C has one group; texts for GPUs are included together.
std::string private_name(
    const Names& names,
    const std::string& group,
    const std::string& name,
    const Precision& precision) {
  return names.prefix + "__" + (precision.is_macro ? group + "_" : "") + name + precision.suffix;
}

std::string definition(
    const Names& names,
    const NamedFunction& c,
    const std::string& linkage,
    const std::string& name,
    const Precision& precision) {
  const Dialect d = dialect(precision, c.reads_cache);
  const Kernel kernel = lower(c.function->program, c.function->kernel, d);
  std::string head = signature(names, c, linkage, name, kernel.parameters, precision, " {");
  for (const KernelArray& p : kernel.parameters)
    if (!p.used)
      head += (precision.is_macro ? "  RC_UNUSED(" : "  (void)") + p.name + (precision.is_macro ? ");\n" : ";\n");
  if (!is_long(kernel, d)) return head + body(kernel, d) + "}\n";
  const SplitKernel split = split_kernel(kernel, d);
  std::string text, calls;
  for (const LiveValues& live : split.live)
    calls += "  " + precision.scalar + " " + subscripted(live.array.name, live.size) + ";\n";
  for (const Kernel& part : split.parts) {
    const std::string part_name = private_name(names, c.function->group, part.name, precision);
    text += signature(names, c, "static ", part_name, part.parameters, precision, " {") + body(part, d) + "}\n\n";
    calls += call(part_name, names_of(part.parameters), precision);
  }
  return text + head + calls + "}\n";
}

// In texts for GPUs, functions keep the factor and the right-hand side to themselves.
Function keeping(Function f, const Precision& precision) {
  if (!precision.is_macro) return f;
  for (symbolic::InputArray& input : f.program.inputs)
    if (input.name == "factor" || input.name == "b") input.name = "kept_" + input.name;
  for (symbolic::OutputArray& output : f.program.outputs)
    if (output.name == "factor") output.name = "kept_factor";
  return f;
}

// Prints `f_column`, which solves for one column, and `f_columns`, which replaces columns of a matrix by their
// solutions.
std::string print_column_solver(const Names& names, const std::string& group, const Function& f, const Precision& p) {
  const Function solution = keeping(f, p);
  const std::string rows = std::to_string(solution.program.outputs.front().rows), scalar = p.scalar;
  const std::string column = private_name(names, group, solution.kernel, p);
  const std::string columns = private_name(names, group, solution.kernel + "s", p);
  const std::string text = comment("Solves for one column.") +
                           definition(names, {&solution, {}, {}}, "static ", column, p) + "\n" +
                           comment("Replaces each column by its solution.");
  if (p.is_macro)
    return text + "RC_FUNCTION(1) " + columns + "(const REAL *kept_factor, int count, RC_OUT(1, columns)) {\n" +
           "  REAL kept_b[" + rows + "];\n  for (int k = 0; k < count; ++k) {\n    for (int row = 0; row < " + rows +
           "; ++row) kept_b[row] = RC_AT(columns, k * " + rows + " + row);\n    RC_CALL(" + column +
           ")(kept_factor, kept_b, RC_FROM(columns, k * " + rows + "));\n  }\n}\n";
  return text +
         wrapped(
             "static void " + columns + "(", {"const " + scalar + " *factor", "int count", scalar + " *columns"},
             ") {") +
         "  " + scalar + " b[" + rows + "];\n  for (; count > 0; --count) {\n    for (int row = 0; row < " + rows +
         "; ++row) b[row] = columns[row];\n    " + column + "(factor, b, columns);\n    columns += " + rows +
         ";\n  }\n}\n";
}

// Prints the function that computes right-hand sides, before the one that replaces them by the solutions.
std::string print_right_sides(const Names& names, const NamedFunction& c, const Precision& precision) {
  const Function sides = keeping(right_sides(names.library, *c.function), precision);
  const std::string name = private_name(names, c.function->group, sides.kernel, precision);
  return comment(sides.summary.front()) +
         definition(names, {&sides, {}, {}, c.reads_cache}, "static ", name, precision) + "\n";
}

std::string print_column_loop(const Names& names, const NamedFunction& c, const Precision& precision) {
  const Function sides = keeping(right_sides(names.library, *c.function), precision);
  const std::string& group = c.function->group;
  const std::vector<KernelArray> list = parameters(c.function->program, dialect(precision, c.reads_cache));
  const symbolic::OutputArray& factor = sides.program.outputs.back();
  std::vector<std::string> arguments;
  for (const KernelArray& p : list) arguments.push_back(passed(p, precision));
  arguments.push_back(factor.name);
  std::string text = signature(names, c, "", c.name_in(precision), list, precision, " {") + "  " + precision.scalar +
                     " " + factor.name + "[" + std::to_string(factor.rows) + "];\n" +
                     call(private_name(names, group, sides.kernel, precision), arguments, precision);
  for (const symbolic::SolvedColumns::Block& block : c.function->solved->blocks) {
    const KernelArray& array = list[c.function->program.inputs.size() + at(block.output)];
    text += call(
        private_name(names, group, c.function->solved->solution.name + "s", precision),
        {factor.name, std::to_string(block.columns), passed(array, precision)}, precision);
  }
  return text + "}\n";
}

// The function, whose parameters are elements of one array, in the order of the library.
Function with_all_parameters(Function f, const Library& library) {
  std::vector<int> moved;  // by flat index
  int begin = 0;           // flat index of an array's first element
  for (symbolic::InputArray& input : f.program.inputs) {
    std::vector<std::string> all = input.elements;
    if (input.role == symbolic::Role::parameters) all = model::names_of(library.parameters());
    for (const std::string& element : input.elements)
      moved.push_back(begin + static_cast<int>(std::find(all.begin(), all.end(), element) - all.begin()));
    begin += static_cast<int>(all.size());
    if (input.elements.size() != all.size()) input.quantities.clear();
    input.elements = all;
  }
  const auto move = [&](symbolic::Operand& o) {
    if (o.kind == symbolic::Operand::Kind::input) o.index = moved[at(o.index)];
  };
  for (symbolic::Statement& s : f.program.statements) for_each_operand(s, move);
  for (symbolic::OutputArray& output : f.program.outputs)
    for (symbolic::Operand& o : output.values) move(o);
  return f;
}

// Overloads share the functions that solve for their columns. These precede the first overload; `printed` collects
// their names.
std::string print_function(
    const Names& names,
    const NamedFunction& c,
    const Precision& precision,
    std::set<std::string>& printed) {
  const std::string description =
      precision.is_macro ? documentation(names, c, parameters(c.function->program, dialect(precision, c.reads_cache)))
                         : "";
  if (!c.function->solved) {
    if (!precision.is_macro || c.reads_cache || names.library.parameters().empty())
      return description + definition(names, c, "", c.name_in(precision), precision);
    const Function whole = with_all_parameters(*c.function, names.library);
    return description + definition(names, {&whole, {}, {}}, "", c.name_in(precision), precision);
  }
  const Function solution = column_solution(*c.function->solved);
  const bool is_new = printed.insert(solution.kernel).second;
  return (is_new ? print_column_solver(names, c.function->group, solution, precision) + "\n" : "") +
         print_right_sides(names, c, precision) + description + print_column_loop(names, c, precision);
}

bool has_update(const Names& names, const std::string& group) {
  return group == kParametersGroup && !names.library.updates.empty();
}

constexpr const char* kUpdate = "void @_update$(const @_parameters$ *parameters, @_cache$ *cache)";
constexpr const char* kUpdates =
    "// Computes the whole cache, which functions read in place of the parameters. Call it once, and after every "
    "change.\n";

// Prints the function that computes the parts of the cache one after the other.
std::string print_update(const Names& names, const Precision& precision) {
  std::string calls;
  if (precision.is_macro) {
    calls = "  RC_UNUSED(parameters);\n  RC_UNUSED(cache);\n";
    const NamedFunction* part = names.functions.data() + names.library.functions.size();
    for (const auto& [begin, size] : cache_parts(names.library))
      if (const std::string& name = part++->name; size > 0)
        calls += call(name, {"RC_PASS(parameters)", "RC_FROM(cache, " + std::to_string(begin) + ")"}, precision);
    const std::vector<KernelArray> list = {{"parameters"}, {"cache", true}};
    return kUpdates + macro_signature(names.prefix + "_update", list, " {") + calls + "}\n";
  }
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
      text += signature(names, c, "", c.name_in(precision), list, precision, ";");
  }
  if (has_update(names, group)) {
    text += std::string("\n") + kUpdates;
    for (const Precision& precision : kPrecisions) text += names.in(precision, kUpdate) + ";\n";
  }
  return header(names, group + ".h", group, text + "\n#ifdef __cplusplus\n}\n#endif\n");
}

std::string passed(const KernelArray& array, const Precision& precision) {
  return precision.is_macro && !is_kept(array.name) ? "RC_PASS(" + array.name + ")" : array.name;
}

std::string print_bodies(const Names& names, const std::string& group, const Precision& precision) {
  std::string text;
  std::set<std::string> printed;
  for (const NamedFunction& c : names.functions)
    if (c.function->group == group) text += "\n" + print_function(names, c, precision, printed);
  if (has_update(names, group)) text += "\n" + print_update(names, precision);
  return text;
}

std::string print_functions(const Names& names, const std::string& group, const Precision& precision) {
  const std::string path = names.folder + "/" + group;
  const std::string text = banner(names.library, path + precision.file_end, group + " in " + precision.scalar) +
                           "#include \"" + path + ".h\"\n\n#include <math.h>\n" + print_bodies(names, group, precision);
  return precision.is_float ? text : text + identity_definition(names, group);
}

}  // namespace robcogen::backend::c
