// Evaluates any function of a model without a compiler: one JSON object per state in, one out.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "command/functions.h"
#include "command/output.h"
#include "command/output_files.h"
#include "command/subcommands.h"
#include "symbolic/interpret.h"

namespace robcogen::command {
namespace {

// `qdd[2]`, `H[0][3]`
std::string element_name(const symbolic::OutputArray& array, std::size_t index) {
  const auto rows = static_cast<std::size_t>(array.rows);
  return symbolic::is_matrix(array.role) ? fmt::format("{}[{}][{}]", array.name, index % rows, index / rows)
                                         : fmt::format("{}[{}]", array.name, index);
}

// JSON has neither infinity nor NaN.
void require_finite(
    const symbolic::OutputArray& array,
    const std::vector<double>& values,
    const Signature& signature,
    std::size_t line) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) continue;
    refuse_input(
        line, fmt::format(
                  "result {} of {} is {}, which JSON cannot represent [result-not-finite]", element_name(array, i),
                  signature.function, values[i]));
  }
}

// A column as a flat array, a matrix as nested rows.
std::string array_text(const symbolic::OutputArray& array, const std::vector<double>& values) {
  const bool matrix = symbolic::is_matrix(array.role);
  std::vector<std::string> rows;
  for (int row = 0; row < array.rows; ++row) {
    std::vector<double> cells;
    for (int column = 0; column < array.columns; ++column)
      cells.push_back(values[static_cast<std::size_t>(row + column * array.rows)]);
    const std::string row_text = fmt::format("{}", fmt::join(cells, ", "));
    rows.push_back(matrix ? "[" + row_text + "]" : row_text);
  }
  return fmt::format("[{}]", fmt::join(rows, ", "));
}

// The line of results; `line` is the line number of the state.
std::string result_text(const EvaluableFunction& function, const symbolic::Arrays<double>& inputs, std::size_t line) {
  const symbolic::Arrays<double> results = symbolic::interpret<double>(function.program, inputs);
  std::vector<std::string> members;
  for (const symbolic::OutputArray& array : function.program.outputs) {
    require_finite(array, results.at(array.name), function.signature, line);
    members.push_back(fmt::format("\"{}\": {}", array.name, array_text(array, results.at(array.name))));
  }
  return fmt::format("{{{}}}\n", fmt::join(members, ", "));
}

// The results of each state are written before the next state is read.
Status evaluate_states(const EvaluableFunction& function) {
  JsonReader reader(stdin);
  while (const std::optional<JsonValue> state = reader.next()) {
    write_output(result_text(function, arguments_from(*state, function.signature), state->line));
    flush_output();
  }
  return ok;
}

}  // namespace

Status eval(const EvalOptions& options) {
  const ModelOptions& model = options.model;
  if (model.file == "-" || model.desired == "-")
    throw Failure{wrong_usage, "robcogen: error: eval reads states from standard input: the model must be a file"};
  require_apart_from_output({"-", model.file, model.desired});
  // A function with the name of its group counts as named: loading reports why the robot cannot have it.
  const std::vector<std::string>& groups = algorithm::groups();
  std::vector<std::string> named;
  if (std::find(groups.begin(), groups.end(), options.function) != groups.end()) named = {options.function};
  if (algorithm::mentions_collisions(options.function)) named = {algorithm::kCollisionGroup};
  const std::optional<driver::Model> loaded = model.load(named);
  if (!loaded) return wrong_input;
  require_apart_from_output(loaded->read);
  return evaluate_states(find_function(*loaded, options.function, model.steps));
}

}  // namespace robcogen::command
