#include "backend/javascript/javascript.h"

#include <algorithm>

#include "backend/common/columns.h"
#include "backend/common/meaning.h"
#include "backend/common/overloads.h"
#include "backend/common/product.h"
#include "backend/javascript/text.h"
#include "support/index.h"

namespace robcogen::backend::javascript {
namespace {

using symbolic::InputArray;
using symbolic::OutputArray;
using symbolic::Role;

// Callables with dotted scopes, `transforms.homogeneous`, and legal names. A member may have any name.
std::vector<OverloadedFunction> named_functions(const Library& library) {
  std::vector<OverloadedFunction> result = overloaded_functions(library);
  NameScope names(dialect().is_reserved);
  for (OverloadedFunction& overloaded : result) {
    if (overloaded.scope.empty()) overloaded.name = names.claim(overloaded.name);
    overloaded.scope = dotted(overloaded.scope);
  }
  return result;
}

std::string whole_name(const OverloadedFunction& overloaded) {
  return overloaded.scope.empty() ? overloaded.name : overloaded.scope + "." + overloaded.name;
}

// The functions that check arguments. Their names begin with a character that no function of a robot has.
constexpr const char* kChecks =
#include "backend/javascript/checks.inc"
    ;

// Printed where a function has quaternions. The tolerance admits numbers that were printed with four digits.
constexpr const char* kQuaternionCheck = R"js(
// The unit quaternion that begins at element k.
function $quaternion(name, value, k) {
  const norm = Math.hypot(value[k], value[k + 1], value[k + 2], value[k + 3]);
  if (Math.abs(norm - 1) > 1e-4)
    throw new RangeError(
        `${name}: elements ${k} to ${k + 3} must be a unit quaternion w, x, y, z, have norm ${norm}`);
}
)js";

constexpr const char* kParameterChecks =
#include "backend/javascript/parameter_checks.inc"
    ;

// The code that checks an argument and converts it into the form that the lines read.
std::string check(const std::string& function, const InputArray& input, const KernelArray& parameter) {
  const std::string& name = parameter.name;
  if (input.role == Role::parameters) return "  $parameters(\"" + function + ": " + name + "\", " + name + ");\n";
  if (input.role == Role::variables) {
    std::string text;
    for (const std::string& e : parameter.elements) text += "  $number(\"" + function + ": " + e + "\", " + e + ");\n";
    return text;
  }
  std::string label = "\"" + function + ": " + name;
  if (input.role == Role::gravity) label += " (m/s^2, in base coordinates)";
  const std::string head = label + "\", " + name + ", ";
  if (input.role == Role::link_wrenches)
    return "  " + name + " = $vectors(" + head + std::to_string(input.elements.size() / 6) + ", 6);\n";
  if (symbolic::is_square_input(input.role))
    return "  " + name + " = $columns(" + head + std::to_string(side(input)) + ");\n";
  std::string text = "  $vector(" + head + std::to_string(input.elements.size()) + ");\n";
  for (const int first : input.quaternions) text += "  $quaternion(" + head + std::to_string(first) + ");\n";
  return text;
}

std::string parameter_line(const Library& library, const InputArray& input, const KernelArray& p, bool is_required) {
  const std::string size = std::to_string(input.elements.size());
  std::string type = "ArrayLike<number>", what = meaning(input.role);
  if (input.role == Role::parameters) {
    return "@param {ReturnType<typeof parameters>} " + p.name +
           " values of the parameters, as parameters() returns them";
  } else if (input.role == Role::link_wrenches) {
    type = "ArrayLike<number>[]";
    what = "wrench on each link (N m, N), " + std::to_string(library.tree.link_count()) +
           " arrays of 6, base first: about the link's origin in link coordinates, moment first";
  } else if (symbolic::is_square_input(input.role)) {
    type = "number[][]";
    what = std::to_string(side(input)) + " rows: " +
           (input.role == Role::homogeneous ? "homogeneous transform" : "factor of the inertia matrix H = L^T L");
  } else {
    what = size + (input.elements.size() == 1 ? " number" : " numbers") + (what.empty() ? "" : ": " + what);
    const bool differs = model::has_own_positions(library.tree) && is_of_joints(input.role);
    if ((input.role == Role::joint_position || differs) && !input.elements.empty())
      what += ": " + joined(input.elements);
  }
  if (is_required) return "@param {" + type + "} " + p.name + " " + what;
  return "@param {" + type + "} [" + p.name + "] " + what + "; default " +
         (input.role == Role::gravity ? "[0, 0, -9.81]" : "zero");
}

bool is_number(const OutputArray& output) {
  return symbolic::is_number(output.role);
}

std::string type_of(const OutputArray& output) {
  return is_number(output) ? "number" : is_matrix(output) ? "number[][]" : "number[]";
}

std::string shape_of(const OutputArray& output) {
  if (is_number(output)) return output.name;
  const std::string rows = std::to_string(output.rows);
  const std::string what = meaning(output.role);
  return output.name + ", " + (is_matrix(output) ? rows + " x " + std::to_string(output.columns) : rows + " numbers") +
         (what.empty() ? "" : ": " + what);
}

std::string returns_line(const std::vector<OutputArray>& outputs) {
  if (outputs.size() == 1) return "@returns {" + type_of(outputs.front()) + "} " + shape_of(outputs.front());
  std::vector<std::string> types, shapes;
  for (const OutputArray& output : outputs) {
    types.push_back(output.name + ": " + type_of(output));
    shapes.push_back(shape_of(output));
  }
  return "@returns {{ " + joined(types) + " }} " + joined(shapes, "; ");
}

std::string documentation(const Library& library, const OverloadedFunction& overloaded, const Kernel& kernel) {
  const Function& f = overloaded.longest();
  std::vector<std::string> lines = summary(overloaded);
  lines.push_back(describe_operations(library, f));
  const std::size_t required = required_inputs(library, overloaded);
  for (std::size_t i = 0; i < f.program.inputs.size(); ++i) {
    const KernelArray& p = kernel.parameters[i];
    if (f.program.inputs[i].role == Role::variables)
      for (const std::string& e : p.elements) lines.push_back("@param {number} " + e + " rad or m");
    else
      lines.push_back(parameter_line(library, f.program.inputs[i], p, i < required));
  }
  if (const std::string remark = remark_on_positions(f.program); !remark.empty()) lines.push_back(remark);
  const std::vector<std::string> columns = column_joints(library, f);
  lines.push_back(returns_line(f.program.outputs) + (columns.empty() ? "" : "; columns: " + joined(columns)));
  for (std::size_t k = 0; k < f.labels.size(); ++k)
    lines.push_back("  column " + std::to_string(k) + ": " + f.labels[k]);
  return "\n/**\n" + comment_lines(lines, " * ") + " */\n";
}

// `export function name(` or `scope.name = function (`, and the arguments.
std::string signature(
    const OverloadedFunction& overloaded,
    const symbolic::Program& program,
    const Kernel& kernel,
    std::size_t required,
    const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments;
  for (std::size_t i = 0; i < program.inputs.size(); ++i) {
    const KernelArray& p = kernel.parameters[i];
    if (program.inputs[i].role == Role::variables)
      arguments.insert(arguments.end(), p.elements.begin(), p.elements.end());
    else if (i < required)
      arguments.push_back(p.name);
    else
      arguments.push_back(p.name + (program.inputs[i].role == Role::gravity ? " = $gravity" : " = $noWrenches"));
  }
  arguments.insert(arguments.end(), more.begin(), more.end());
  const bool is_member = !overloaded.scope.empty();
  return wrapped(
      is_member ? whole_name(overloaded) + " = function (" : "export function " + overloaded.name + "(", arguments,
      ") {");
}

std::string checks(
    const std::string& name,
    const symbolic::Program& program,
    const std::vector<KernelArray>& parameters) {
  std::string text;
  for (std::size_t i = 0; i < program.inputs.size(); ++i) text += check(name, program.inputs[i], parameters[i]);
  return text;
}

std::string body(const std::string& name, const symbolic::Program& program, const Kernel& kernel) {
  return backend::body(kernel, dialect(), checks(name, program, kernel.parameters));
}

// `head value tail`: a number, an array or the rows of a matrix.
std::string result(
    const std::string& head,
    const OutputArray& output,
    const std::vector<std::string>& elements,
    const std::string& tail) {
  if (is_number(output)) return head + elements.front() + tail + "\n";
  if (!is_matrix(output)) return wrapped(head + "[", elements, "]" + tail);
  const std::string margin(head.find_first_not_of(' ') + 2, ' ');
  std::string text = head + "[\n";
  for (const std::vector<std::string>& row : rows_of(output, elements)) text += wrapped(margin + "[", row, "],");
  return text + margin.substr(2) + "]" + tail + "\n";
}

std::string results(const symbolic::Program& program, const Kernel& kernel) {
  if (program.outputs.size() == 1) return result("  return ", program.outputs.front(), kernel.results.front(), ";");
  std::string text = "  return {\n";
  for (std::size_t p = 0; p < program.outputs.size(); ++p)
    text += result("    " + program.outputs[p].name + ": ", program.outputs[p], kernel.results[p], ",");
  return text + "  };\n";
}

std::vector<std::string> input_names(const symbolic::Program& program, const Kernel& kernel) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < program.inputs.size(); ++i) names.push_back(kernel.parameters[i].name);
  return names;
}

// Prints a function that is private to the module, without checks, and returns its name.
std::string print_private(const Function& function, std::string& text) {
  const Kernel kernel = lower(function.program, function.kernel, dialect());
  const std::string name = "$" + function.kernel;
  text += "\n" + wrapped("function " + name + "(", input_names(function.program, kernel), ") {") +
          backend::body(kernel, dialect()) + results(function.program, kernel) + "}\n";
  return name;
}

// Prints a function that computes right-hand sides and replaces them by the solutions.
std::string print_column_loop(const Library& library, const OverloadedFunction& overloaded) {
  const Function& function = overloaded.longest();
  const Kernel kernel = without_lines(function, dialect());
  std::string text;
  const Function& sides = right_sides(library, function);
  const std::string right = print_private(sides, text);
  const std::string solution = print_private(column_solution(*function.solved), text);
  text += documentation(library, overloaded, kernel) +
          signature(overloaded, function.program, kernel, required_inputs(library, overloaded)) +
          checks(whole_name(overloaded), function.program, kernel.parameters) +
          wrapped(
              "  const { " + sides.program.outputs.back().name + ": $factor, ...$results } = " + right + "(",
              input_names(function.program, kernel), ");");
  for (const symbolic::SolvedColumns::Block& block : function.solved->blocks)
    text += "  $solve($results." + function.program.outputs[at(block.output)].name + ", " +
            std::to_string(block.columns) + ", (b) => " + solution + "($factor, b));\n";
  return text + "  return $results;\n}\n";
}

constexpr const char* kSolve = R"(
// Replaces the first columns of a matrix by what the function makes of them.
function $solve(rows, count, solution) {
  for (let column = 0; column < count; ++column)
    solution(rows.map((row) => row[column])).forEach((x, row) => { rows[row][column] = x; });
}
)";

std::string print_function(const Library& library, const OverloadedFunction& overloaded) {
  if (overloaded.longest().solved) return print_column_loop(library, overloaded);
  const symbolic::Program& program = overloaded.longest().program;
  const Kernel kernel = lower(program, overloaded.name, dialect());
  const bool is_member = !overloaded.scope.empty();
  return documentation(library, overloaded, kernel) +
         signature(overloaded, program, kernel, required_inputs(library, overloaded)) +
         body(whole_name(overloaded), program, kernel) + results(program, kernel) + (is_member ? "};\n" : "}\n");
}

std::string print_product(const Library& library, const Function& function, const OverloadedFunction& overloaded) {
  const ProductData& data = function.product.value();
  const Product product = product_of_primitives(data, function.kernel, dialect());
  std::vector<std::string> lines = {
      convention_of_primitives(library),
      "@param {object} primitives your functions Rx, Ry, Rz, Tx, Ty, Tz of one number, and multiply(A, B)"};
  return "\n/**\n" + comment_lines(lines, " * ") + " */\n" +
         signature(overloaded, data.amounts, product.kernel, data.amounts.inputs.size(), {"primitives"}) +
         body(whole_name(overloaded), data.amounts, product.kernel) +
         "  const { Rx, Ry, Rz, Tx, Ty, Tz, multiply } = primitives;\n" +
         wrapped("  return [", product.factors, "].reduce((A, B) => multiply(A, B));") + "};\n";
}

// The objects of scopes, each before its members.
std::string print_scopes(const std::vector<OverloadedFunction>& all) {
  std::string text;
  for (const std::string& scope : scopes(all))
    text += (scope.find('.') == std::string::npos ? "export const " : "") + scope + " = {};\n";
  return text.empty() ? "" : "\n" + text;
}

std::string print_parameters(const Library& library) {
  const std::vector<std::string> names = members(model::names_of(library.parameters()));
  std::vector<std::string> initial;
  for (std::size_t i = 0; i < names.size(); ++i)
    initial.push_back(names[i] + ": " + number(model::default_of(library.parameters()[i])));
  return "\n/** Values of the parameters as the document declares them; NaN for a parameter without a value. */\n"
         "export function parameters() {\n" +
         wrapped("  return {", initial, " };") + "}\n" + kParameterChecks;
}

bool has_quaternions(const Function& f) {
  const std::vector<InputArray>& inputs = f.program.inputs;
  return std::any_of(inputs.begin(), inputs.end(), [](const InputArray& input) { return !input.quaternions.empty(); });
}

}  // namespace

std::vector<OutputFile> print(const Library& library) {
  const std::string file = identifier(flat(library.enclosing, library.name), is_free) + ".mjs";
  std::vector<OverloadedFunction> all = named_functions(library);
  std::vector<std::pair<const Function*, OverloadedFunction>> products;
  if (library.primitives != PrimitiveConvention::none)
    for (const OverloadedFunction& overloaded : all)
      if (overloaded.longest().product)
        products.push_back({&overloaded.longest(), {"transforms.product", overloaded.name, {}}});
  std::vector<OverloadedFunction> scopes = all;
  for (const auto& [function, overloaded] : products) scopes.push_back(overloaded);

  std::string text = comment_lines(
      {library.title() + ": generated by robcogen from " + library.model_file + " (model " + library.model_hash +
       "). Edit the model, not this file."},
      "// ");
  text += kChecks;
  if (std::any_of(library.functions.begin(), library.functions.end(), has_quaternions)) text += kQuaternionCheck;
  if (library.has_robot())
    text += "\nconst $gravity = [0, 0, -9.81];\nconst $noWrenches = Array(" +
            std::to_string(library.tree.link_count()) + ").fill([0, 0, 0, 0, 0, 0]);\n" + print_model(library);
  if (!library.parameters().empty()) text += print_parameters(library);
  if (std::any_of(library.functions.begin(), library.functions.end(), [](const Function& f) { return f.solved; }))
    text += kSolve;
  text += print_scopes(scopes);
  for (const OverloadedFunction& overloaded : all) text += print_function(library, overloaded);
  for (const auto& [function, overloaded] : products) text += print_product(library, *function, overloaded);
  return {{file, text}};
}

}  // namespace robcogen::backend::javascript
