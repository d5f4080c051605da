// The text of functions.
#include "backend/common/columns.h"
#include "backend/common/meaning.h"
#include "backend/common/product.h"
#include "backend/matlab/dialect.h"
#include "backend/matlab/printers.h"
#include "support/index.h"

namespace robcogen::backend::matlab {
namespace {

using symbolic::InputArray;
using symbolic::Program;
using symbolic::Role;

// `function [a, b] = name(arguments)`. The variables of a document are separate arguments.
std::string signature(const Program& program, const Kernel& kernel, const std::string& name) {
  std::vector<std::string> arguments, results;
  for (std::size_t i = 0; i < kernel.parameters.size(); ++i) {
    const KernelArray& p = kernel.parameters[i];
    if (p.output) {
      results.push_back(p.name);
    } else if (program.inputs[i].role == Role::variables) {
      arguments.insert(arguments.end(), p.elements.begin(), p.elements.end());
    } else {
      arguments.push_back(p.name);
    }
  }
  const std::string result = results.size() == 1 ? results.front() : "[" + joined(results) + "]";
  const std::string head = "function " + result + " = " + name + "(";
  if (head.size() <= kColumns) return wrapped(head, arguments, ")");
  std::string text = wrapped("function [", results, "] = " + name + "(");
  text.pop_back();
  const std::size_t last_line = text.rfind('\n') + 1;
  return text.substr(0, last_line) + wrapped(text.substr(last_line), arguments, ")");
}

// Blocks with a blank line between them.
std::string blocks(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts)
    if (!part.empty()) text += (text.empty() ? "" : "\n") + part;
  return text;
}

std::string whole_name(const Library& library, const std::string& scope, const OverloadedFunction& overloaded) {
  return joined(packages(library, scope), ".") + "." + overloaded.name;
}

std::string results(const Program& program, const Kernel& kernel, const std::vector<std::string>& joints = {}) {
  std::string text;
  for (std::size_t p = 0; p < program.outputs.size(); ++p)
    text += assemble(program.outputs[p], kernel.parameters[program.inputs.size() + p].name, kernel.results[p], joints);
  return text;
}

// A function that is local to the file.
std::string print_local(const Function& function, const std::string& name) {
  const Kernel kernel = lower(function.program, name, dialect());
  return "\n" + signature(function.program, kernel, name) +
         blocks({body(kernel, dialect()), results(function.program, kernel)}) + "end\n";
}

// Prints a function that computes right-hand sides and replaces them by the solutions.
std::string print_column_loop(const Library& library, const OverloadedFunction& overloaded) {
  const Function &function = overloaded.longest(), &sides = right_sides(library, function);
  const Program& program = function.program;
  const Kernel kernel = without_lines(function, dialect());
  const std::string factor = parameters(sides.program, dialect()).back().name;
  std::vector<std::string> arguments, values;
  for (const KernelArray& p : kernel.parameters) (p.output ? values : arguments).push_back(p.name);
  values.push_back(factor);
  std::string loops = wrapped("  [", values, "] = ...");
  loops += wrapped("    right_sides(", arguments, ");");
  for (const symbolic::SolvedColumns::Block& block : function.solved->blocks) {
    const std::string column = values[at(block.output)] + "(:, column)";
    loops += "  for column = 1:" + std::to_string(block.columns) + "\n    " + column + " = solution(" + factor + ", " +
             column + ");\n  end\n";
  }
  const std::string checks = print_checks(
      whole_name(library, overloaded.scope, overloaded), program.inputs, kernel, required_inputs(library, overloaded));
  return signature(program, kernel, overloaded.name) + help(library, overloaded, kernel) + "\n" +
         blocks({origin(library), checks, loops}) + "end\n" + print_local(sides, "right_sides") +
         print_local(column_solution(*function.solved), "solution");
}

}  // namespace

std::string print_function(const Library& library, const OverloadedFunction& overloaded) {
  const Function& function = overloaded.longest();
  if (function.solved) return print_column_loop(library, overloaded);
  const Program& program = function.program;
  const Kernel kernel = lower(program, overloaded.name, dialect());
  const std::vector<std::string> joints = column_joints(library, function);
  const std::string checks = print_checks(
      whole_name(library, overloaded.scope, overloaded), program.inputs, kernel, required_inputs(library, overloaded));
  return signature(program, kernel, overloaded.name) + help(library, overloaded, kernel) + "\n" +
         blocks({origin(library), checks, body(kernel, dialect()), results(program, kernel, joints)}) + "end\n";
}

std::string print_product(const Library& library, const OverloadedFunction& overloaded) {
  ProductData data = overloaded.longest().product.value();
  data.amounts.outputs.front().name = "X";
  const Product product = product_of_primitives(data, overloaded.longest().kernel, dialect());
  const std::vector<InputArray>& inputs = data.amounts.inputs;
  const std::string result = "  " + product.kernel.parameters.back().name + " =";
  const std::string checks =
      print_checks(whole_name(library, "transforms::product", overloaded), inputs, product.kernel, inputs.size());
  return signature(data.amounts, product.kernel, overloaded.name) +
         heading(overloaded.name, {convention_of_primitives(library)}) +
         describe_arguments(inputs, product.kernel, inputs.size()) + "\n" +
         blocks(
             {origin(library), checks, body(product.kernel, dialect()), wrapped(result, product.factors, ";", " *")}) +
         "end\n";
}

}  // namespace robcogen::backend::matlab
