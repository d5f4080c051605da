// The functions of a group: declarations with their documentation, and bodies.
#include "backend/c/printers.h"
#include "backend/common/meaning.h"
#include "backend/common/parts.h"
#include "support/concat.h"

namespace robcogen::backend::c {
namespace {

using symbolic::InputArray;
using symbolic::OutputArray;
using symbolic::Role;

// Longer functions take compilers more time than their length, in parts of so many lines less.
constexpr std::size_t kLongest = 2000, kPart = 700;

// `void f(const double *hyl_restrict q, …)`, or a part of it.
std::string signature(
    const Names& names,
    const Callable& c,
    const std::string& head,
    const std::vector<Parameter>& list,
    const Precision& precision,
    const std::string& end) {
  const std::string structure = names.prefix + (c.reads_cache ? "_cache" : "_parameters") + precision.suffix + " *";
  const std::string array = precision.scalar + " *" + names.prefix + "_restrict ";
  std::vector<std::string> arguments;
  for (const Parameter& p : list)
    arguments.push_back((p.output ? "" : "const ") + (p.is_structure ? structure : array) + p.name);
  if (arguments.empty()) arguments = {"void"};
  return wrapped(head + "(", arguments, ")" + end);
}

std::string describe(const InputArray& input, const std::string& name, bool is_cache) {
  constexpr std::size_t kMaxListed = 40;
  const std::string size = name + "[" + std::to_string(input.elements.size()) + "]";
  if (input.role == Role::parameters)
    return name + (is_cache ? ": of the parameters, as computed before" : ": the parameters");
  if (input.role == Role::link_wrenches) return size + ": six elements a link, base first";
  if (input.role == Role::inertia_factor) return size + ": L, column by column";
  return input.elements.size() > kMaxListed || input.elements.empty() ? size : size + ": " + joined(input.elements);
}

std::string describe(const OutputArray& output, const std::string& name) {
  const std::string start = name + "[" + std::to_string(output.rows * output.columns) + "]: ";
  if (!is_matrix(output)) return start + "result";
  return start + "result, " + std::to_string(output.rows) + " x " + std::to_string(output.columns) +
         ", column by column";
}

std::string documentation(const Names& names, const Callable& c, const std::vector<Parameter>& list) {
  const Function& f = *c.function;
  const std::size_t count = f.program.inputs.size();
  std::string text;
  for (const std::string& line : f.summary) text += comment(line);
  if (!f.method.empty()) text += comment(f.method);
  for (std::size_t i = 0; i < list.size(); ++i)
    text += comment(
        i < count ? describe(f.program.inputs[i], list[i].name, c.reads_cache)
                  : describe(f.program.outputs[i - count], list[i].name));
  if (const std::string remark = remark_on_positions(f.program); !remark.empty()) text += comment(remark);
  const std::vector<std::string> columns = column_joints(names.library, f);
  if (!columns.empty()) text += comment("Columns: " + joined(columns) + ".");
  for (std::size_t k = 0; k < f.labels.size(); ++k)
    text += comment("Column " + std::to_string(k) + ": " + f.labels[k] + ".");
  return text;
}

std::string print_function(const Names& names, const Callable& c, const Precision& precision) {
  const Dialect& d = dialect(precision, c.reads_cache);
  const Kernel kernel = lower(c.function->program, c.function->kernel, d);
  std::string head = signature(names, c, "void " + c.name_in(precision), kernel.parameters, precision, " {");
  for (const Parameter& p : kernel.parameters)
    if (!p.used) head += "  (void)" + p.name + ";\n";
  if (kernel.lines.size() <= kLongest) return head + body(kernel, d) + "}\n";
  const Parts parts = in_parts(kernel, kPart, d);
  std::string text, calls;
  for (const Handed& h : parts.handed)
    calls += "  " + precision.scalar + " " + h.array.name + "[" + std::to_string(h.size) + "];\n";
  for (const Kernel& part : parts.kernels) {
    std::vector<std::string> arguments;
    for (const Parameter& p : part.parameters) arguments.push_back(p.name);
    // No other name has two underscores that follow each other.
    const std::string name = names.prefix + "__" + part.name + precision.suffix;
    text += signature(names, c, "static void " + name, part.parameters, precision, " {") + body(part, d) + "}\n\n";
    calls += wrapped("  " + name + "(", arguments, ");");
  }
  return text + head + calls + "}\n";
}

std::string update_signature(const Names& names, const Precision& precision) {
  const std::string& f = precision.suffix;
  return "void " + names.prefix + "_update" + f + "(const " + names.prefix + "_parameters" + f + " *parameters, " +
         names.prefix + "_cache" + f + " *cache)";
}

// Computes the parts of the cache one after the other.
std::string print_update(const Names& names, const Precision& precision) {
  std::string text = update_signature(names, precision) + " {\n";
  int begin = 0;
  for (const Callable& c : names.callables) {
    if (c.function->group != kParametersGroup) continue;
    const int size = c.function->program.outputs.front().rows;
    if (size > 0)
      text += "  " + c.name_in(precision) + "(parameters, cache->values + " + std::to_string(begin) + ");\n";
    begin += size;
  }
  return text + (begin == 0 ? "  (void)parameters;\n  (void)cache;\n" : "") + "}\n";
}

bool has_update(const Names& names, const std::string& group) {
  return group == kParametersGroup && !names.library.updates.empty();
}

}  // namespace

std::string print_header(const Names& names, const std::string& group) {
  std::string text = "#include \"" + names.folder + "/model.h\"\n";
  text += "\n#ifdef __cplusplus\nextern \"C\" {\n#endif\n";
  for (const Callable& c : names.callables) {
    if (c.function->group != group) continue;
    const std::vector<Parameter> list = parameters(c.function->program, dialect(kDouble, c.reads_cache));
    text += "\n" + documentation(names, c, list);
    for (const Precision& precision : kPrecisions)
      text += signature(names, c, "void " + c.name_in(precision), list, precision, ";");
  }
  if (has_update(names, group)) {
    text +=
        "\n" +
        comment(
            "The whole cache, of which functions read what they need of the parameters: once, and after every change.");
    for (const Precision& precision : kPrecisions) text += update_signature(names, precision) + ";\n";
  }
  text += "\n#ifdef __cplusplus\n}\n#endif\n";
  return header(names, group + ".h", group, text);
}

std::string print_functions(const Names& names, const std::string& group, const Precision& precision) {
  std::string text = opening(names, group + precision.file_end, group + " in " + precision.scalar);
  text += "#include \"" + names.folder + "/" + group + ".h\"\n\n#include <math.h>\n";
  for (const Callable& c : names.callables)
    if (c.function->group == group) text += "\n" + print_function(names, c, precision);
  return has_update(names, group) ? text + "\n" + print_update(names, precision) : text;
}

}  // namespace robcogen::backend::c
