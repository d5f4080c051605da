// One JSON object in, one out: any function of a robot without a compiler.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "algorithm/dynamics.h"
#include "algorithm/kinematics.h"
#include "command/command.h"
#include "pass/passes.h"
#include "symbolic/interpret.h"

namespace robcogen::command {
namespace {

using nlohmann::json;
using symbolic::Role;

struct Options {
  ModelOptions model;
  std::string function;
};

[[noreturn]] void refuse(const std::string& message) {
  throw Failure{wrong_input, fmt::format("<standard input>: error: {}", message)};
}

// Splits `A_X_B` at every place where it can be split, and takes the split whose halves are frames of the robot.
std::optional<model::FramePair> frames_of(
    const model::KinematicTree& tree,
    const std::string& name,
    const std::string& separator) {
  for (std::size_t at = name.find(separator); at != std::string::npos; at = name.find(separator, at + 1)) {
    const auto left = tree.find_frame(name.substr(0, at));
    const auto right = tree.find_frame(name.substr(at + separator.size()));
    if (left && right) return model::FramePair{*left, *right};
  }
  return std::nullopt;
}

std::optional<symbolic::Program> kinematics_program(const Robot& robot, const std::string& function) {
  using algorithm::TransformForm;
  struct Kind {
    std::string prefix;
    std::string separator;
    std::optional<TransformForm> form;
  };
  const std::vector<Kind> kinds = {
      {"transforms.homogeneous.", "_X_", TransformForm::homogeneous},
      {"transforms.motion.", "_X_", TransformForm::spatial_motion},
      {"transforms.force.", "_X_", TransformForm::spatial_force},
      {"jacobians.", "_J_", std::nullopt}};
  for (const Kind& kind : kinds) {
    if (!function.starts_with(kind.prefix)) continue;
    const auto pair = frames_of(robot.tree, function.substr(kind.prefix.size()), kind.separator);
    if (!pair)
      throw Failure{
          wrong_usage, fmt::format(
                           "robcogen: error: '{}' names no two frames of robot '{}'; expected {}A{}B", function,
                           robot.tree.name, kind.prefix, kind.separator)};
    return kind.form ? algorithm::coordinate_transform(robot.tree, *pair, *kind.form, "transform")
                     : algorithm::geometric_jacobian(robot.tree, *pair, "jacobian");
  }
  return std::nullopt;
}

// The overload with all loads serves them all.
symbolic::Program program_of(const Robot& robot, const Options& options) {
  if (auto program = kinematics_program(robot, options.function)) return *program;
  std::vector<std::string> names;
  std::optional<symbolic::Program> found;
  const auto [formulation, passes] = split(options.model.steps);
  algorithm::Formulations formulations(robot.tree, formulation);
  for (const std::string& group : algorithm::groups()) {
    for (algorithm::RobotFunction& f : algorithm::functions(robot.tree, {}, group, formulations)) {
      names.push_back(f.scope.empty() ? f.name : f.scope + "." + f.name);
      if (names.back() == options.function) found = std::move(f.program);
    }
    if (found) return pass::run(std::move(*found), passes);
  }
  throw Failure{
      wrong_usage,
      fmt::format(
          "robcogen: error: robot '{}' has no function '{}'{}{}", robot.tree.name, options.function, "\nhint: ",
          did_you_mean(options.function, names).empty() ? "transforms.homogeneous.A_X_B, jacobians.A_J_B, or a name "
                                                          "that 'robcogen ops' lists"
                                                        : did_you_mean(options.function, names))};
}

std::vector<double> numbers(const json& value, const std::string& name, std::size_t length) {
  if (!value.is_array() || value.size() != length)
    refuse(fmt::format("'{}' must be an array of {} numbers", name, length));
  std::vector<double> result;
  for (const json& element : value) {
    if (!element.is_number()) refuse(fmt::format("'{}' must be an array of {} numbers", name, length));
    result.push_back(element.get<double>());
  }
  return result;
}

// A square matrix as nested rows.
std::vector<double> square_matrix(const json& value, const std::string& name, std::size_t length) {
  const auto size = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(length))));
  if (!value.is_array() || value.size() != size)
    refuse(fmt::format("'{}' must be an array of {} rows of {} numbers", name, size, size));
  std::vector<double> columns(length);
  for (std::size_t r = 0; r < size; ++r) {
    const std::vector<double> row = numbers(value[r], fmt::format("{}[{}]", name, r), size);
    for (std::size_t c = 0; c < size; ++c) columns[r + c * size] = row[c];
  }
  return columns;
}

std::vector<double> parameter_values(const json& given, const std::vector<model::Parameter>& parameters) {
  if (!given.is_object()) refuse("'parameters' must be an object of name: number");
  std::vector<std::string> names;
  for (const model::Parameter& p : parameters) names.push_back(p.name);
  for (const auto& [name, value] : given.items()) {
    if (std::find(names.begin(), names.end(), name) == names.end())
      refuse(fmt::format("the model has no parameter '{}'", name));
    if (!value.is_number()) refuse(fmt::format("parameter '{}' must be a number", name));
  }
  std::vector<double> values;
  for (const model::Parameter& p : parameters) {
    if (given.contains(p.name))
      values.push_back(given[p.name].get<double>());
    else if (p.default_value)
      values.push_back(*p.default_value);
    else
      refuse(fmt::format("parameter '{}' has no default: give it in 'parameters'", p.name));
  }
  return values;
}

std::vector<double> link_wrenches(const json& given, const model::KinematicTree& tree) {
  if (!given.is_object()) refuse("'external' must be an object of link name: array of 6 numbers");
  std::vector<double> values(6 * tree.links.size(), 0.0);
  for (const auto& [name, wrench] : given.items()) {
    const std::optional<int> link = tree.find_link(name);
    if (!link) refuse(fmt::format("the robot has no link '{}'", name));
    const std::vector<double> six = numbers(wrench, "external." + name, 6);
    std::copy(six.begin(), six.end(), values.begin() + 6 * *link);
  }
  return values;
}

symbolic::Arrays<double> arguments(const json& given, const Robot& robot, const symbolic::Program& program) {
  // A name that no function knows is a slip; one that this function has no use for is welcome.
  static const std::vector<std::string> known = {
      "q",
      "qd",
      "qdd",
      "tau",
      "gravity",
      "base_velocity",
      "base_acceleration",
      "external",
      "parameters",
      "L",
      "inverse_diagonal",
      "x"};
  for (const auto& [name, value] : given.items())
    if (std::find(known.begin(), known.end(), name) == known.end())
      refuse(fmt::format("'{}' is no argument; arguments are {}", name, fmt::join(known, ", ")));

  const std::vector<double> parameters =
      parameter_values(given.value("parameters", json::object()), robot.tree.parameters);

  symbolic::Arrays<double> inputs;
  for (const symbolic::InputArray& array : program.inputs) {
    const std::string& name = array.name;
    if (array.role == Role::parameters)
      inputs[name] = parameters;
    else if (array.role == Role::link_wrenches)
      inputs[name] = link_wrenches(given.value("external", json::object()), robot.tree);
    else if (array.role == Role::inertia_factor && given.contains(name))
      inputs[name] = square_matrix(given[name], name, array.elements.size());
    else if (given.contains(name))
      inputs[name] = numbers(given[name], name, array.elements.size());
    else if (array.role == Role::gravity)
      inputs[name] = {0.0, 0.0, -algorithm::kStandardGravity};
  }
  return inputs;
}

std::string number_text(double value) {
  return std::isfinite(value) ? fmt::format("{:.17g}", value) : "null";
}

// A column as a flat array, a matrix as nested rows.
std::string array_text(const symbolic::OutputArray& array, const std::vector<double>& values) {
  const bool matrix = symbolic::is_matrix(array.role);
  const auto row_text = [&](int row) {
    std::vector<std::string> cells;
    for (int column = 0; column < array.columns; ++column)
      cells.push_back(number_text(values[static_cast<std::size_t>(row + column * array.rows)]));
    return fmt::format("[{}]", fmt::join(cells, ", "));
  };
  std::vector<std::string> rows;
  for (int row = 0; row < array.rows; ++row)
    rows.push_back(matrix ? row_text(row) : number_text(values[static_cast<std::size_t>(row)]));
  return fmt::format("[{}]", fmt::join(rows, ", "));
}

// Those that are not given are zero.
std::vector<double> variable_values(const json& given, const std::vector<std::string>& variables) {
  if (!given.is_object()) refuse("'variables' must be an object of name: number");
  for (const auto& [name, value] : given.items()) {
    if (std::find(variables.begin(), variables.end(), name) == variables.end())
      refuse(fmt::format("the model has no variable '{}'", name));
    if (!value.is_number()) refuse(fmt::format("variable '{}' must be a number", name));
  }
  std::vector<double> values;
  for (const std::string& name : variables) values.push_back(given.value(name, 0.0));
  return values;
}

symbolic::Arrays<double> arguments(
    const json& given,
    const model::CoordinateTransforms& document,
    const symbolic::Program& program) {
  for (const auto& [name, value] : given.items())
    if (name != "variables" && name != "parameters")
      refuse(fmt::format("'{}' is no argument; arguments are variables, parameters", name));
  const std::vector<double> values = variable_values(given.value("variables", json::object()), document.variables);
  symbolic::Arrays<double> inputs;
  for (const symbolic::InputArray& array : program.inputs) {
    if (array.role == Role::parameters) {
      inputs[array.name] = parameter_values(given.value("parameters", json::object()), document.parameters);
      continue;
    }
    for (const std::string& element : array.elements) {
      const auto place = std::find(document.variables.begin(), document.variables.end(), element);
      inputs[array.name].push_back(values[static_cast<std::size_t>(place - document.variables.begin())]);
    }
  }
  return inputs;
}

symbolic::Program program_of(const Transforms& transforms, const Options& options) {
  std::vector<std::string> names;
  for (const algorithm::TransformFunction& f : trace(transforms, options.model.steps)) {
    names.push_back(dotted(f.scope, f.name));
    if (names.back() == options.function) return f.program;
  }
  const std::string guess = did_you_mean(options.function, names);
  throw Failure{
      wrong_usage, fmt::format(
                       "robcogen: error: model '{}' has no function '{}'\nhint: {}", transforms.document.name,
                       options.function, guess.empty() ? "'robcogen ops' lists them" : guess)};
}

json read_arguments() {
  json given;
  try {
    given = json::parse(std::string(std::istreambuf_iterator<char>(std::cin), {}));
  } catch (const json::exception& fault) {
    refuse(fault.what());
  }
  if (!given.is_object()) refuse("expected one JSON object");
  return given;
}

void print_results(const symbolic::Program& program, const symbolic::Arrays<double>& inputs) {
  const symbolic::Arrays<double> results = symbolic::interpret<double>(program, inputs);
  std::vector<std::string> members;
  for (const symbolic::OutputArray& array : program.outputs)
    members.push_back(fmt::format("\"{}\": {}", array.name, array_text(array, results.at(array.name))));
  fmt::print("{{{}}}\n", fmt::join(members, ", "));
}

Status eval_robot(const Options& options) {
  const std::optional<Robot> robot = options.model.load();
  if (!robot) return wrong_input;
  require_traceable(*robot);
  const symbolic::Program program = program_of(*robot, options);
  print_results(program, arguments(read_arguments(), *robot, program));
  return ok;
}

Status eval_transforms(const Options& options) {
  const std::optional<Transforms> transforms = options.model.load_transforms();
  if (!transforms) return wrong_input;
  const symbolic::Program program = program_of(*transforms, options);
  print_results(program, arguments(read_arguments(), transforms->document, program));
  return ok;
}

}  // namespace

Action declare_eval(CLI::App& application) {
  CLI::App* subcommand = application.add_subcommand(
      "eval", "Evaluates a function of a model: arguments as one JSON object on standard input, results on output");
  auto options = std::make_shared<Options>();
  options->model.declare(*subcommand);
  subcommand->add_option("function", options->function, "inverse_dynamics, transforms.homogeneous.A_X_B, …")
      ->required();
  return [options] { return is_transforms(options->model.model) ? eval_transforms(*options) : eval_robot(*options); };
}

}  // namespace robcogen::command
