#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

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
  std::vector<std::string> limbs_in_lanes;
  std::string without_lanes;
};

// The first overload of each function: default gravity, no external forces.
std::vector<Row> rows(const Programs& programs) {
  std::vector<Row> result;
  std::set<std::string> seen;
  for (const NamedProgram& f : programs.list)
    if (seen.insert(f.name).second)
      result.push_back({f.name, symbolic::cost(f.program), f.method, f.error, f.limbs_in_lanes, f.without_lanes});
  return result;
}

// What the functions have in lanes, in lines that name the functions, and why similar limbs are not congruent.
void print_limbs(const Programs& programs, const std::vector<Row>& table) {
  std::vector<std::pair<std::string, std::string>> lines;  // text, functions
  const auto note = [&](const std::string& text, const std::string& function) {
    const auto known = std::find_if(lines.begin(), lines.end(), [&](const auto& line) { return line.first == text; });
    if (known == lines.end())
      lines.emplace_back(text, function);
    else
      known->second += ", " + function;
  };
  for (const Row& row : table) {
    for (const std::string& limbs : row.limbs_in_lanes) note("limbs of " + limbs + " share lanes", row.name);
    if (!row.without_lanes.empty()) note("no limbs share lanes, because " + row.without_lanes, row.name);
  }
  if (!lines.empty() || !programs.unlike_limbs.empty()) print_output("\n");
  for (const auto& [text, functions] : lines) print_output("{}: {}\n", text, functions);
  for (const auto& [first, second, reason] : programs.unlike_limbs)
    print_output("limbs of {} and {} share no lanes: {}\n", first, second, reason);
}

void print_table(const Programs& programs, const std::vector<Row>& table, bool has_lanes) {
  std::size_t width = 8;
  for (const Row& row : table) width = std::max(width, row.name.size());
  print_output("{}: {}\n", programs.model, programs.about);
  print_output(
      "{:<{}} {:>6} {:>6} {:>4} {:>5} {:>7} {:>13} {:>14} {:>13} {:>13}\n", "function", width, "mul", "add", "div",
      "sqrt", "sincos", "instructions", "critical path", "double error", "float error");
  const auto text = [](const auto& error, double symbolic::RoundingError::*precision) {
    return error ? symbolic::print_error(*error.*precision) : std::string();
  };
  for (const auto& [name, c, method, error, limbs, without] : table)
    print_output(
        "{:<{}} {:>6} {:>6} {:>4} {:>5} {:>7} {:>13} {:>14} {:>13} {:>13}\n", name, width, c.mul, c.add, c.div, c.sqrt,
        c.sincos, c.instructions, c.critical_path, text(error, &symbolic::RoundingError::in_double),
        text(error, &symbolic::RoundingError::in_float));
  for (const auto& [name, c, method, error, limbs, without] : table)
    if (!method.empty()) print_output("\n{}: {}\n", name, method);
  if (has_lanes) print_limbs(programs, table);
}

void print_json(const Programs& programs, const std::vector<Row>& table, bool has_lanes) {
  nlohmann::ordered_json functions = nlohmann::ordered_json::array();
  for (const auto& [name, c, method, error, limbs, without] : table) {
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
    if (!limbs.empty()) functions.back()["limbs_in_lanes"] = limbs;
    if (!without.empty()) functions.back()["without_lanes"] = without;
  }
  nlohmann::ordered_json report = {{programs.kind, programs.model}, {"functions", functions}};
  if (has_lanes && !programs.unlike_limbs.empty()) {
    nlohmann::ordered_json& list = report["unlike_limbs"];
    for (const auto& [first, second, reason] : programs.unlike_limbs)
      list.push_back({{"joints", {first, second}}, {"reason", reason}});
  }
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
  options.json ? print_json(*programs, table, options.has_lanes) : print_table(*programs, table, options.has_lanes);
  return ok;
}

}  // namespace robcogen::command
