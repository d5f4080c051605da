#include "backend/maxima/maxima.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include "backend/common/columns.h"
#include "backend/common/layout.h"
#include "backend/common/meaning.h"
#include "backend/common/product.h"
#include "support/concat.h"
#include "support/index.h"
#include "support/number.h"

namespace robcogen::backend::maxima {
namespace {

using symbolic::InputArray;
using symbolic::OutputArray;
using symbolic::Role;

constexpr std::size_t kColumns = 100;
constexpr std::size_t kEnd = 4;  // of these columns, reserved for the end of a definition

// Words and values of the syntax, and system variables that control evaluation.
constexpr auto kReserved = std::to_array<std::string_view>(
    {"and", "do",       "else",      "elseif",    "false", "for",       "from",   "if",    "in",    "ind",
     "inf", "infinity", "minf",      "next",      "not",   "or",        "step",   "then",  "thru",  "true",
     "und", "unless",   "while",     "zeroa",     "zerob", "algebraic", "domain", "error", "float", "fpprec",
     "gcd", "linel",    "listarith", "logexpand", "numer", "radexpand", "ratfac", "simp",  "values"});

bool is_reserved(const std::string& name) {
  return std::find(kReserved.begin(), kReserved.end(), name) != kReserved.end();
}

std::string fraction(const Rational& ratio, bool is_pi_multiple) {
  std::string number = std::to_string(ratio.num);
  if (is_pi_multiple) number = ratio.num == 1 ? "%pi" : number + "*%pi";
  return ratio.den == 1 ? number : number + "/" + std::to_string(ratio.den);
}

Spelling literal(const Number& value, Texts& texts) {
  const std::string number =
      value.ratio() ? fraction(*value.ratio(), value.is_pi_multiple()) : print_double(value.value());
  Spelling result = backend::literal(number, texts);
  if (value.ratio() && (value.ratio()->den != 1 || value.is_pi_multiple())) result.precedence = Precedence::product;
  return result;
}

// A separate variable, whose name no other name can have. In a function, `q[1]` would be an element of a user's array
// `q`.
std::string element(const std::string& array, std::size_t k) {
  return array + "__" + std::to_string(k + 1);
}

const Dialect& dialect() {
  static const Dialect maxima = [] {
    Dialect d = returning_dialect(kColumns);
    d.is_reserved = is_reserved;
    d.name_limit = 28;  // two of them and a fraction fit in one line
    d.literal = literal;
    d.element = element;
    d.assignment = ": ";
    d.end = ",";
    return d;
  }();
  return maxima;
}

// Lines of at most kColumns where blanks allow it, each after the margin.
std::string wrapped(const std::string& text, const std::string& margin) {
  return wrapped_text(text, kColumns - kEnd, margin, margin);
}

// A comment that no user text can end early. Maxima's comments nest.
std::string comment(const std::vector<std::string>& lines, const std::string& margin = "") {
  std::string result;
  for (std::string line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const bool delimits = i > 0 && (line.substr(i - 1, 2) == "/*" || line.substr(i - 1, 2) == "*/");
      if (delimits || static_cast<unsigned char>(line[i]) < ' ') line[i] = ' ';
    }
    result += wrapped(line, margin + "   ");
  }
  result.replace(margin.size(), 2, "/*");
  result.insert(result.size() - 1, " */");
  return result;
}

std::string describe(const InputArray& array, const std::string& name) {
  if (array.role == Role::homogeneous) return name + ": column by column, apply(append, args(transpose(X)))";
  if (array.role == Role::inertia_factor) return name + ": column by column, apply(append, args(transpose(L)))";
  const std::string elements = describe_elements(array);
  if (array.role == Role::link_wrenches) return name + ": " + elements;
  if (elements.empty() && !array.elements.empty())
    return name + ": " + std::to_string(array.elements.size()) + " elements";
  return name + ": [" + elements + "]";
}

std::string describe(const OutputArray& output) {
  const std::string rows = std::to_string(output.rows);
  return output.name +
         (is_matrix(output) ? ", " + rows + " x " + std::to_string(output.columns) : ", a list of " + rows);
}

std::string result(const OutputArray& output, const std::vector<std::string>& elements) {
  if (!is_matrix(output)) return wrapped("[" + joined(elements) + "]", "  ");
  std::string text;
  for (const std::vector<std::string>& row : rows_of(output, elements)) {
    text += (text.empty() ? "" : ",\n") + wrapped("[" + joined(row) + "]", "    ");
    text.pop_back();
  }
  return "  matrix(\n" + text + ")\n";
}

// `name(arguments) := block([locals], [elements]: argument, lines, value)$`
std::string definition(
    const std::string& name,
    const symbolic::Program& program,
    const Kernel& kernel,
    const std::string& value) {
  std::vector<std::string> arguments, locals;
  std::string lines;
  for (std::size_t i = 0; i < program.inputs.size(); ++i) {
    arguments.push_back(kernel.parameters[i].name);
    if (!kernel.parameters[i].used) continue;
    std::vector<std::string> elements;
    for (std::size_t k = 0; k < program.inputs[i].elements.size(); ++k)
      elements.push_back(element(arguments.back(), k));
    locals.insert(locals.end(), elements.begin(), elements.end());
    lines += wrapped("[" + joined(elements) + "]: " + arguments.back() + ",", "  ");
  }
  for (const Line& line : kernel.lines) {
    const bool is_section = line.kind == Line::Kind::section;
    if (!is_section) locals.push_back(line.targets.front());
    lines += is_section ? comment({line.expression}, "  ") : "  " + text(line, dialect()) + "\n";
  }
  const std::string signature = wrapped(name + "(" + joined(arguments) + ") := block(", "");
  return signature + wrapped("[" + joined(locals) + "],", "  ") + lines + value + ")$\n";
}

std::vector<std::string> documentation(const Library& library, const Function& f, const Kernel& kernel) {
  std::vector<std::string> arguments, results;
  for (std::size_t i = 0; i < f.program.inputs.size(); ++i)
    arguments.push_back(describe(f.program.inputs[i], kernel.parameters[i].name));
  for (const OutputArray& output : f.program.outputs) results.push_back(describe(output));
  return describe_function(library, f, arguments, {"returns " + joined(results)});
}

std::string results(const symbolic::Program& program, const Kernel& kernel) {
  std::string value;
  for (std::size_t p = 0; p < program.outputs.size(); ++p) {
    if (p > 0) value += ",\n";
    value += result(program.outputs[p], kernel.results[p]);
    value.pop_back();
  }
  return program.outputs.size() == 1 ? value : "  [\n" + value + "]";
}

std::string definition(const std::string& name, const Function& f) {
  const Kernel kernel = lower(f.program, f.kernel, dialect());
  return definition(name, f.program, kernel, results(f.program, kernel));
}

// Prints `f_column`, which solves for one column, and `f_columns`, which replaces the first columns of a matrix by
// their solutions.
std::string print_column_solver(const Function& solution, const std::string& prefix) {
  const std::string name = prefix + solution.kernel;
  return "\n" +
         comment({"Solves for one column; " + name + "s replaces the first columns of a matrix by their solutions."}) +
         definition(name, solution) + name + "s(factor, count, given) := block(\n  [columns],\n" +
         "  columns: args(transpose(given)),\n  transpose(apply('matrix, append(\n" +
         wrapped("makelist(" + name + "(factor, columns[k]), k, 1, count),", "    ") +
         "    rest(columns, count)))))$\n";
}

// Prints a function that computes right-hand sides and replaces them by the solutions.
std::string print_column_loop(const Library& library, const Function& f, const std::string& prefix) {
  const Function& sides = right_sides(library, f);
  const Kernel kernel = without_lines(f, dialect());
  std::vector<std::string> arguments;
  for (std::size_t i = 0; i < f.program.inputs.size(); ++i) arguments.push_back(kernel.parameters[i].name);
  const std::string list = "(" + joined(arguments) + ")";
  std::string text = "\n" + comment(sides.summary) + definition(prefix + sides.kernel, sides) + "\n" +
                     comment(documentation(library, f, kernel)) + wrapped(prefix + f.kernel + list + " := block(", "") +
                     "  [results, factor],\n" + wrapped("results: " + prefix + sides.kernel + list + ",", "  ") +
                     "  factor: last(results),\n";
  for (const symbolic::SolvedColumns::Block& block : f.solved->blocks) {
    const std::string place = "results[" + std::to_string(block.output + 1) + "]";
    text += "  " + place + ": " + prefix + f.solved->solution.name + "s(factor, " + std::to_string(block.columns) +
            ", " + place + "),\n";
  }
  return text + "  rest(results, -1))$\n";
}

std::string print_function(const Library& library, const Function& f, const std::string& prefix) {
  if (f.solved) return print_column_loop(library, f, prefix);
  const Kernel kernel = lower(f.program, f.kernel, dialect());
  return "\n" + comment(documentation(library, f, kernel)) +
         definition(prefix + f.kernel, f.program, kernel, results(f.program, kernel));
}

std::string print_product(const Library& library, const Function& f, const std::string& name) {
  const ProductData& data = f.product.value();
  const Product product = product_of_primitives(data, f.kernel, dialect());
  std::string value = wrapped(joined(product.factors, " . "), "  ");
  value.pop_back();
  return "\n" + comment({convention_of_primitives(library)}) + definition(name, data.amounts, product.kernel, value);
}

// Parameters without default remain symbols.
std::string print_parameters(const Library& library, const std::string& prefix) {
  std::vector<std::string> values;
  for (const model::Parameter& p : library.parameters())
    values.push_back(p.default_value ? print_double(*p.default_value) : "'" + identifier(p.name, is_reserved));
  std::string list = wrapped("[" + joined(values) + "]", "  ");
  list.pop_back();
  return "\n" + comment({"The declared values of the parameters; a parameter without default is a symbol."}) + prefix +
         "parameters() :=\n" + list + "$\n";
}

}  // namespace

std::vector<OutputFile> print(const Library& library) {
  const std::string robot = identifier(flat(library.enclosing, library.name), is_reserved), prefix = robot + "_";
  std::string text = comment(
      {library.title() + ": generated by robcogen from " + library.model_file + " (model " + library.model_hash +
           "). Edit the model, not this file.",
       "Arguments are lists of numbers or symbols: [q1, q2]. Fractions and multiples of %pi are exact."});
  if (!library.parameters().empty()) text += print_parameters(library, prefix);
  NameScope scope(is_reserved);
  std::set<std::string> solvers;  // solvers that overloads share
  for (const Function& f : library.functions) {
    if (f.solved && solvers.insert(f.solved->solution.name).second)
      text += print_column_solver(column_solution(*f.solved), prefix);
    text += print_function(library, f, prefix);
    scope.take(f.kernel);
  }
  if (library.primitives != PrimitiveConvention::none)
    for (const Function& f : library.functions)
      if (f.product) text += print_product(library, f, prefix + scope.claim("product_" + f.name));
  return {{robot + ".mac", text}};
}

}  // namespace robcogen::backend::maxima
