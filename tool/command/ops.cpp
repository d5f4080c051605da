#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>

#include "command/command.h"
#include "symbolic/count.h"

namespace robcogen::command {
namespace {

struct Options {
  ModelOptions model;
  bool json = false;
};

struct Row {
  std::string name;
  symbolic::OperationCount count;
};

// Of the overloads of a function the first: default gravity, no external forces.
std::vector<Row> rows(const Robot& robot, const std::vector<std::string>& passes) {
  std::vector<Row> result;
  std::set<std::string> seen;
  for (const algorithm::RobotFunction& f : trace(robot, algorithm::groups(), passes)) {
    std::string name = f.scope.empty() ? f.name : f.scope + "::" + f.name;
    for (std::size_t at; (at = name.find("::")) != std::string::npos;) name.replace(at, 2, ".");
    if (seen.insert(name).second) result.push_back({name, symbolic::count(f.program)});
  }
  return result;
}

void print_table(const Robot& robot, const std::vector<Row>& table) {
  std::size_t width = 8;
  for (const Row& row : table) width = std::max(width, row.name.size());
  fmt::print(
      "{}: {} joints, {} base; default gravity, no external forces\n", robot.tree.name, robot.tree.dof(),
      robot.tree.floating_base ? "floating" : "fixed");
  fmt::print(
      "{:<{}} {:>6} {:>6} {:>4} {:>5} {:>7} {:>13} {:>14}\n", "function", width, "mul", "add", "div", "sqrt", "sincos",
      "instructions", "critical path");
  for (const auto& [name, c] : table)
    fmt::print(
        "{:<{}} {:>6} {:>6} {:>4} {:>5} {:>7} {:>13} {:>14}\n", name, width, c.mul, c.add, c.div, c.sqrt, c.sincos,
        c.instructions, c.critical_path);
}

void print_json(const Robot& robot, const std::vector<Row>& table) {
  nlohmann::ordered_json functions = nlohmann::ordered_json::array();
  for (const auto& [name, c] : table)
    functions.push_back(
        {{"name", name},
         {"mul", c.mul},
         {"add", c.add},
         {"div", c.div},
         {"sqrt", c.sqrt},
         {"sincos", c.sincos},
         {"instructions", c.instructions},
         {"critical_path", c.critical_path}});
  const nlohmann::ordered_json report = {{"robot", robot.tree.name}, {"functions", functions}};
  fmt::print("{}\n", report.dump(2));
}

}  // namespace

Action declare_ops(CLI::App& application) {
  CLI::App* subcommand = application.add_subcommand("ops", "Counts the operations of a robot's functions");
  auto options = std::make_shared<Options>();
  options->model.declare(*subcommand);
  subcommand->add_flag("--json", options->json, "Machine-readable");
  return [options] {
    const std::optional<Robot> robot = options->model.load();
    if (!robot) return wrong_input;
    const std::vector<Row> table = rows(*robot, options->model.passes);
    options->json ? print_json(*robot, table) : print_table(*robot, table);
    return ok;
  };
}

}  // namespace robcogen::command
