#include "backend/casadi/casadi.h"

#include <algorithm>

#include "backend/c/printers.h"

namespace robcogen::backend::casadi {
namespace {

using c::comment;
using c::NamedFunction;
using c::Names;
using c::quoted;
using c::wrapped;
using symbolic::InputArray;
using symbolic::Operand;
using symbolic::OutputArray;
using symbolic::Program;
using symbolic::Role;

// An argument or a result of CasADi: dense, or compressed by columns where elements are always zero.
struct Matrix {
  std::string name;
  std::size_t rows = 0, columns = 1;
  std::vector<std::vector<std::size_t>> nonzeros = {};  // rows of each column; empty: dense
  bool is_parameters = false;

  std::size_t size() const { return rows * columns; }
};

Matrix argument(const Library& library, const InputArray& input, const std::string& name) {
  const std::size_t size = input.elements.size();
  if (input.role == Role::parameters) return {name, library.tree.parameters.size(), 1, {}, true};
  if (input.role == Role::link_wrenches) return {name, 6, size / 6};
  return {name, size, 1};
}

// The program of a function that solves for columns in a loop does not tell which results are zero.
Matrix result(const Function& function, const OutputArray& output, const std::string& name) {
  const Program& program = function.program;
  Matrix m{name, static_cast<std::size_t>(output.rows), static_cast<std::size_t>(output.columns)};
  if (function.solved) return m;
  std::size_t count = 0;
  std::vector<std::vector<std::size_t>> nonzeros(m.columns);
  for (std::size_t k = 0; k < m.size(); ++k) {
    const Operand& value = output.values[k];
    const bool is_zero =
        symbolic::is_constant(value) && program.constants[static_cast<std::size_t>(value.index)].value() == 0;
    if (is_zero) continue;
    nonzeros[k / m.rows].push_back(k % m.rows);
    ++count;
  }
  if (count < m.size()) m.nonzeros = std::move(nonzeros);
  return m;
}

// {rows, columns, 1} for a dense matrix. Otherwise rows and columns, then where each column begins, then the row of
// each element.
std::string sparsity(const Matrix& m, const std::string& name) {
  std::vector<std::string> numbers = {std::to_string(m.rows), std::to_string(m.columns)};
  if (m.nonzeros.empty()) {
    numbers.emplace_back("1");
  } else {
    std::size_t count = 0;
    numbers.emplace_back("0");
    for (const auto& column : m.nonzeros) numbers.push_back(std::to_string(count += column.size()));
    for (const auto& column : m.nonzeros)
      for (const std::size_t row : column) numbers.push_back(std::to_string(row));
  }
  return wrapped("static const casadi_int " + name + "[" + std::to_string(numbers.size()) + "] = {", numbers, "};");
}

// F_name_in and F_sparsity_in, or the same for results.
std::string tables(const std::string& function, const std::vector<Matrix>& list, const std::string& end) {
  const std::string count = std::to_string(list.size());
  std::string text, patterns;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string pattern = function + "__" + end + std::to_string(i);
    text += sparsity(list[i], pattern);
    patterns += "    case " + std::to_string(i) + ": return " + pattern + ";\n";
    names.push_back("    case " + std::to_string(i) + ": return " + quoted(list[i].name) + ";\n");
  }
  const auto choice = [&](const std::string& head, const std::string& cases) {
    return "CASADI_EXPORT " + head + "(casadi_int i);\nCASADI_EXPORT " + head + "(casadi_int i) {\n  switch (i) {\n" +
           cases + "    default: return 0;\n  }\n}\n";
  };
  std::string cases;
  for (const std::string& name : names) cases += name;
  const std::string counter = "casadi_int " + function + "_n_" + end + "(void)";
  return text + "CASADI_EXPORT " + counter + ";\nCASADI_EXPORT " + counter + " { return " + count + "; }\n" +
         choice("const char *" + function + "_name_" + end, cases) +
         choice("const casadi_int *" + function + "_sparsity_" + end, patterns);
}

std::string print_function(const Names& names, const NamedFunction& c) {
  const std::string function = names.prefix + "_casadi" + c.name.substr(names.prefix.size());
  const Program& program = c.function->program;
  const std::vector<KernelArray> list = parameters(program, c::dialect(c::kDouble, false));
  std::vector<Matrix> in, out;
  for (std::size_t i = 0; i < program.inputs.size(); ++i)
    in.push_back(argument(names.library, program.inputs[i], list[i].name));
  for (std::size_t i = 0; i < program.outputs.size(); ++i)
    out.push_back(result(*c.function, program.outputs[i], list[in.size() + i].name));

  std::string before, after;
  std::vector<std::string> arguments;
  std::size_t offset = 0;
  const auto place = [&](const Matrix& m) {
    const std::string text = "w + " + std::to_string(offset);
    offset += m.size();
    return text;
  };
  for (std::size_t i = 0; i < in.size(); ++i) {
    const std::string given = names.prefix + "__given(arg[" + std::to_string(i) + "], " + place(in[i]) + ", " +
                              std::to_string(in[i].size()) + ")";
    if (in[i].is_parameters) {
      const bool has_cache = !names.library.updates.empty();
      before += "  " + names.prefix + "_parameters parameters;\n";
      if (has_cache) before += "  " + names.prefix + "_cache cache;\n";
      after += "  memcpy(&parameters, " + given + ", sizeof parameters);\n";
      if (has_cache) after += "  " + names.prefix + "_update(&parameters, &cache);\n";
      arguments.emplace_back(has_cache ? "&cache" : "&parameters");
    } else {
      arguments.push_back(given);
    }
  }
  std::string results;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::string at = place(out[i]);
    arguments.push_back(at);
    results += "  " + names.prefix + "__take(" + at + ", " + function + "__out" + std::to_string(i) + ", res[" +
               std::to_string(i) + "]);\n";
  }
  const std::string head =
      "int " + function + "(const casadi_real **arg, casadi_real **res, casadi_int *iw, casadi_real *w, int mem)";
  const std::string work =
      "int " + function + "_work(casadi_int *sz_arg, casadi_int *sz_res, casadi_int *sz_iw, casadi_int *sz_w)";
  const auto size = [](const char* pointer, std::size_t value) {
    return "  if (" + std::string(pointer) + ") *" + pointer + " = " + std::to_string(value) + ";\n";
  };
  std::string unused = "  (void)iw;\n  (void)mem;\n";
  if (in.empty()) unused += "  (void)arg;\n";
  return "\n" + comment(function + ": " + c.name + ".") + tables(function, in, "in") + tables(function, out, "out") +
         "CASADI_EXPORT " + work + ";\nCASADI_EXPORT " + work + " {\n" + size("sz_arg", in.size()) +
         size("sz_res", out.size()) + size("sz_iw", 0) + size("sz_w", offset) + "  return 0;\n}\n" + "CASADI_EXPORT " +
         head + ";\nCASADI_EXPORT " + head + " {\n" + before + unused + after +
         wrapped("  " + c.name + "(", arguments, ");") + results + "  return 0;\n}\n";
}

bool takes_inputs(const NamedFunction& c) {
  return c.function->group != c::kParametersGroup && !c.function->program.inputs.empty();
}

}  // namespace

std::string output(const std::string& prefix) {
  return prefix + "_c/casadi.c";
}

OutputFile print(const Library& library) {
  const Names names = c::names(library);
  const std::string given = names.prefix + "__given", take = names.prefix + "__take";
  std::string text = c_family::banner(library, output(names.prefix), "external functions for CasADi");
  text += comment(
      "In CasADi: external(\"" + names.prefix +
      "_casadi_...\", \"./lib.so\"), from a library compiled from this file and the functions.");
  text += "#include \"" + names.folder + "/" + names.folder +
          ".h\"\n\n#include <string.h>\n\n"
          "#ifndef casadi_real\n#define casadi_real double\n#endif\n"
          "#ifndef casadi_int\n#define casadi_int long long int\n#endif\n"
          "#ifndef CASADI_EXPORT\n#if defined(_WIN32)\n#define CASADI_EXPORT __declspec(dllexport)\n"
          "#elif defined(__GNUC__)\n#define CASADI_EXPORT __attribute__((visibility(\"default\")))\n"
          "#else\n#define CASADI_EXPORT\n#endif\n#endif\n\n";
  const std::string path = output(names.prefix);
  if (names.functions.empty()) return {path, text};
  // A function that nothing calls is a warning.
  if (std::any_of(names.functions.begin(), names.functions.end(), takes_inputs))
    text += comment("A null pointer as argument means zero.") + "static const casadi_real *" + given +
            "(const casadi_real *argument, casadi_real *memory, size_t size) {\n"
            "  if (argument) return argument;\n"
            "  memset(memory, 0, size * sizeof *memory);\n"
            "  return memory;\n}\n\n";
  text += comment(
              "A null pointer as result means that the result is not needed. A sparse result consists of the elements "
              "of its pattern.") +
          "static void " + take +
          "(const casadi_real *from, const casadi_int *pattern, casadi_real *result) {\n"
          "  casadi_int column, k;\n"
          "  if (!result) return;\n"
          "  if (pattern[2]) {\n"
          "    memcpy(result, from, (size_t)(pattern[0] * pattern[1]) * sizeof *result);\n"
          "    return;\n  }\n"
          "  for (column = 0; column < pattern[1]; ++column)\n"
          "    for (k = pattern[2 + column]; k < pattern[3 + column]; ++k)\n"
          "      result[k] = from[column * pattern[0] + pattern[3 + pattern[1] + k]];\n}\n";
  for (const NamedFunction& c : names.functions)
    if (c.function->group != c::kParametersGroup) text += print_function(names, c);
  return {path, text};
}

}  // namespace robcogen::backend::casadi
