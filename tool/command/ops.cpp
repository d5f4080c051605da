#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "command/output.h"
#include "command/output_files.h"
#include "command/subcommands.h"
#include "symbolic/cost.h"

namespace robcogen::command {
namespace {

struct Row {
  std::string name;
  symbolic::Cost count;
  std::string method;
  std::optional<symbolic::RoundingError> error;
};

// The first overload of each function: default gravity, no external forces.
std::vector<Row> rows(const Programs& programs) {
  std::vector<Row> result;
  std::set<std::string> seen;
  for (const NamedProgram& f : programs.list)
    if (seen.insert(f.name).second) result.push_back({f.name, symbolic::cost(f.program), f.method, f.error});
  return result;
}

void print_table(const Programs& programs, const std::vector<Row>& table) {
  std::size_t width = 8;
  for (const Row& row : table) width = std::max(width, row.name.size());
  print_output("{}: {}\n", programs.model, programs.about);
  print_output(
      "{:<{}} {:>6} {:>6} {:>4} {:>5} {:>7} {:>13} {:>14} {:>13} {:>13}\n", "function", width, "mul", "add", "div",
      "sqrt", "sincos", "instructions", "critical path", "double error", "float error");
  const auto text = [](const auto& error, double symbolic::RoundingError::*precision) {
    return error ? symbolic::print_error(*error.*precision) : std::string();
  };
  for (const auto& [name, c, method, error] : table)
    print_output(
        "{:<{}} {:>6} {:>6} {:>4} {:>5} {:>7} {:>13} {:>14} {:>13} {:>13}\n", name, width, c.mul, c.add, c.div, c.sqrt,
        c.sincos, c.instructions, c.critical_path, text(error, &symbolic::RoundingError::in_double),
        text(error, &symbolic::RoundingError::in_float));
  for (const auto& [name, c, method, error] : table)
    if (!method.empty()) print_output("\n{}: {}\n", name, method);
}

void print_json(const Programs& programs, const std::vector<Row>& table) {
  nlohmann::ordered_json functions = nlohmann::ordered_json::array();
  for (const auto& [name, c, method, error] : table) {
    functions.push_back(
        {{"name", name},
         {"mul", c.mul},
         {"add", c.add},
         {"div", c.div},
         {"sqrt", c.sqrt},
         {"sincos", c.sincos},
         {"instructions", c.instructions},
         {"critical_path", c.critical_path}});
    if (error) functions.back()["rounding"] = {{"double", error->in_double}, {"float", error->in_float}};
    if (!method.empty()) functions.back()["method"] = method;
  }
  const nlohmann::ordered_json report = {{programs.kind, programs.model}, {"functions", functions}};
  print_output("{}\n", report.dump(2));
}

}  // namespace

Status ops(const OpsOptions& options) {
  require_apart_from_output({options.model.file, options.model.desired});
  const std::optional<Programs> programs =
      options.model.load_programs(options.groups, {.caches_parameters = true, .has_lanes = options.has_lanes});
  if (!programs) return wrong_input;
  require_apart_from_output(programs->read);
  const std::vector<Row> table = rows(*programs);
  options.json ? print_json(*programs, table) : print_table(*programs, table);
  return ok;
}

}  // namespace robcogen::command
