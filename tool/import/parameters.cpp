#include "import/parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>

#include "import/magnitudes.h"

namespace robcogen::import {

using language::Expression;
using model::Parameter;
using model::ParameterKind;
using model::Quantity;

namespace {

const char* kind_name(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::length:
      return "a length";
    case ParameterKind::angle:
      return "an angle";
    case ParameterKind::ratio:
      return "a ratio";
    case ParameterKind::inertial:
      break;
  }
  return "a mass or drive property";
}

// Trial values of a parameter: many magnitudes of either sign.
constexpr std::array<double, 10> kTrialScales = {1.4, -1.4, 0.01, -0.01, 1e2, -1e2, 1e4, -1e4, 1e6, -1e6};

// Two parameters never have equal trial values.
double trial_value(double scale, std::size_t parameter) {
  return scale * (1.0 + 0.37 * static_cast<double>(parameter));
}

// Whether a default value of a parameter is part of the expression.
bool gives_default(const Expression& expression) {
  const auto operand_does = [](const language::ExpressionPtr& operand) { return operand && gives_default(*operand); };
  return expression.default_value || operand_does(expression.left) || operand_does(expression.right);
}

}  // namespace

void QuantityReader::declare_group(const language::ParameterGroup& group) {
  const Place group_place = {source_, group.name.span};
  const auto [entry, is_new] = groups_.insert({group.name.text, {group_place, {}}});
  if (!is_new) {
    diagnostics_.error("duplicate-group", group_place, fmt::format("group '{}' is declared twice", group.name.text))
        .notes.push_back({entry->second.place, "first declared here"});
  }
  for (const language::Name& name : group.parameters) {
    const Place place = {source_, name.span};
    entry->second.parameters.push_back(name.text);
    if (!grouped_.insert(name.text).second) {
      const Parameter& earlier = parameters_[static_cast<std::size_t>(parameter_indices_.at(name.text))];
      diagnostics_.error("duplicate-parameter", place, fmt::format("parameter '{}' is declared twice", name.text))
          .notes.push_back({earlier.place, "first declared here"});
      continue;
    }
    unused_.insert(name.text);
    uses_.declare(name.text, place);
    add_parameter(name.text, ParameterKind::length, place);
  }
}

void QuantityReader::declare_names_in(const Expression& expression) {
  if (expression.kind == Expression::Kind::constant) {
    if (expression.left) declare_constant(expression);
    return;
  }
  if (expression.default_value) with_default_.insert(expression.name);
  if (expression.is_parameter || (expression.default_value && plain_name_ == PlainName::variable))
    parameters_by_spelling_.insert({expression.name, place(expression)});
  if (expression.left) declare_names_in(*expression.left);
  if (expression.right) declare_names_in(*expression.right);
}

void QuantityReader::declare_constant(const Expression& expression) {
  const Quantity value = read(*expression.left, ParameterKind::length);
  const auto [earlier, is_new] = constants_.insert({expression.name, {value, place(expression)}});
  if (is_new || earlier->second.value.number() == value.number()) return;
  diagnostics_
      .error(
          "conflicting-constant", place(expression), fmt::format("constant '{}' has a second value", expression.name))
      .notes.push_back({earlier->second.place, "the first value is here"});
}

Quantity QuantityReader::read(const Expression& expression, ParameterKind kind) {
  const int faults_before = faults_;
  const Quantity result = finite(expression, kind);
  if (faults_ > faults_before) return result;
  if (kind == ParameterKind::angle) check_angle(expression, result);
  const double least = least_magnitude(result);
  if (least < kZero && result.is_constant()) return Quantity();
  if (least < kTooLarge) return result;
  if (std::isinf(least))
    return fault(diagnostics_.error(
        "not-finite", place(expression), "this expression has no finite value for any values of its parameters"));
  const std::string what = result.is_constant() ? print_double(result.number().value())
                                                : "for all values of its parameters, this expression";
  return fault(diagnostics_.error("too-large", place(expression), too_large(what)));
}

void QuantityReader::check_angle(const Expression& expression, const Quantity& angle, double turns) {
  // Several expressions may use a default value: one of them gives it.
  if (!angle.is_constant() && !gives_default(expression)) return;
  if (angle.is_constant() && angle.number().is_pi_multiple()) return;  // intentional
  const std::optional<double> value = value_at_defaults(angle, parameters_, variables_.size());
  const std::string message = value ? large_angle(*value, turns) : "";
  if (message.empty()) return;
  diagnostics_.warning("large-angle", place(expression), message).hint = "angles are in rad; one degree is 'PI/180.0'";
}

double QuantityReader::least_magnitude(const Quantity& q) const {
  if (q.is_constant()) return std::abs(q.number().value());
  double least = std::numeric_limits<double>::infinity();
  // Without parameters or variables, the sets of values are empty.
  for (std::size_t i = 0; i < kTrialScales.size(); ++i) {
    const auto values = [&](const std::vector<std::vector<double>>& sets) {
      return sets.empty() ? std::span<const double>() : std::span<const double>(sets[i]);
    };
    const double magnitude = std::abs(evaluate(q, values(trials_), values(variable_trials_)));
    if (magnitude < least) least = magnitude;  // false for NaN
  }
  return least;
}

Quantity QuantityReader::finite(const Expression& expression, ParameterKind kind) {
  const int faults_before = faults_;
  const Quantity result = operate(expression, kind);
  const bool is_finite = !result.is_constant() || std::isfinite(result.number().value());
  // Only the innermost expression is reported.
  if (is_finite || faults_ > faults_before) return result;
  return fault(diagnostics_.error("not-finite", place(expression), "this expression has no finite value"));
}

Quantity QuantityReader::fault(const Diagnostic&) {
  ++faults_;
  // NaN propagates through operations, and the checks of the model accept it.
  return Quantity(std::numeric_limits<double>::quiet_NaN());
}

Quantity QuantityReader::operate(const Expression& expression, ParameterKind kind) {
  const auto left = [&] { return finite(*expression.left, kind); };
  const auto right = [&] { return finite(*expression.right, kind); };
  const auto angle = [&] {
    const Quantity result = left();
    check_angle(*expression.left, result);
    return result;
  };
  switch (expression.kind) {
    case Expression::Kind::number:
      return Quantity(expression.number);
    case Expression::Kind::pi:
      if (grouped_.contains(expression.name) || with_default_.contains(expression.name))
        return parameter(expression, kind);
      return Quantity(Number::pi_multiple(1));
    case Expression::Kind::name:
      return name(expression, kind);
    case Expression::Kind::constant:
      return constant(expression);
    case Expression::Kind::negate:
      return -left();
    // Evaluation order of the operands matters: it determines the order of the parameters.
    case Expression::Kind::add: {
      const Quantity a = left(), b = right();
      return a + b;
    }
    case Expression::Kind::subtract: {
      const Quantity a = left(), b = right();
      return a - b;
    }
    case Expression::Kind::multiply: {
      const Quantity a = left(), b = right();
      const bool is_name = expression.right->kind == Expression::Kind::name;
      if (expression.juxtaposed && is_name) uses_.multiply_by_number(expression, place(expression));
      return a * b;
    }
    case Expression::Kind::divide: {
      const Quantity a = left(), b = right();
      if (!b.is_zero()) return a / b;
      return fault(diagnostics_.error("not-finite", place(expression), "division by zero"));
    }
    case Expression::Kind::sine:
      return sin(angle());
    case Expression::Kind::cosine:
      return cos(angle());
    case Expression::Kind::tangent:
      return tan(angle());
    case Expression::Kind::square_root:
      return sqrt(left());
  }
  assert(false && "unknown expression");
  return Quantity();
}

Quantity QuantityReader::name(const Expression& expression, ParameterKind kind) {
  if (!expression.group.empty()) return member(expression, kind);
  const bool is_parameter = plain_name_ == PlainName::parameter || expression.is_parameter ||
                            expression.default_value || grouped_.contains(expression.name);
  return is_parameter ? parameter(expression, kind) : variable(expression);
}

Quantity QuantityReader::member(const Expression& expression, ParameterKind kind) {
  const auto group = groups_.find(expression.group);
  if (group == groups_.end()) {
    std::vector<std::string> names;
    for (const auto& [name, other] : groups_) names.push_back(name);
    Diagnostic& error = diagnostics_.error(
        "unknown-group", place(expression), fmt::format("unknown parameter group '{}'", expression.group));
    error.hint = did_you_mean(expression.group, names);
    return fault(error);
  }
  const std::vector<std::string>& names = group->second.parameters;
  if (std::find(names.begin(), names.end(), expression.name) == names.end()) {
    Diagnostic& error = diagnostics_.error(
        "unknown-parameter", place(expression),
        fmt::format("group '{}' has no parameter '{}'", expression.group, expression.name));
    error.hint = did_you_mean(expression.name, names);
    error.notes.push_back({group->second.place, "the group is declared here"});
    return fault(error);
  }
  return parameter(expression, kind);
}

Quantity QuantityReader::variable(const Expression& expression) {
  const auto parameter = parameters_by_spelling_.find(expression.name);
  if (parameter != parameters_by_spelling_.end() && ambiguous_.insert(expression.name).second) {
    diagnostics_
        .error(
            "variable-and-parameter", place(expression),
            fmt::format("'{0}' is a variable here, but 'p:{0}' or '{0}[…]' is a parameter elsewhere", expression.name))
        .notes.push_back({parameter->second, "the parameter is here"});
  }
  uses_.use(expression, "variable", place(expression));
  const auto [entry, is_new] = variable_indices_.insert({expression.name, static_cast<int>(variables_.size())});
  if (is_new) {
    variable_trials_.resize(kTrialScales.size());
    for (std::size_t i = 0; i < variable_trials_.size(); ++i)
      variable_trials_[i].push_back(trial_value(0.7 * kTrialScales[i], variables_.size()));
    variables_.push_back(expression.name);
  }
  return Quantity::variable(entry->second);
}

void QuantityReader::add_parameter(const std::string& name, ParameterKind kind, const Place& place) {
  parameter_indices_.insert({name, static_cast<int>(parameters_.size())});
  trials_.resize(kTrialScales.size());
  for (std::size_t i = 0; i < trials_.size(); ++i)
    trials_[i].push_back(trial_value(kTrialScales[i], parameters_.size()));
  parameters_.push_back({name, kind, std::nullopt, place});
}

Quantity QuantityReader::parameter(const Expression& expression, ParameterKind kind) {
  const std::string& name = expression.name;
  uses_.use(expression, "parameter", place(expression));
  if (!parameter_indices_.contains(name)) add_parameter(name, kind, place(expression));
  const int index = parameter_indices_.at(name);
  Parameter& parameter = parameters_[static_cast<std::size_t>(index)];
  if (unused_.erase(name) > 0) parameter.kind = kind;
  join_kind(index, kind, place(expression));
  if (expression.default_value) set_default(parameter, expression.default_value->value(), place(expression));
  return Quantity::parameter(index);
}

// A length or an angle that mass properties depend on keeps its kind.
void QuantityReader::join_kind(int index, ParameterKind kind, const Place& place) {
  Parameter& parameter = parameters_[static_cast<std::size_t>(index)];
  if (parameter.kind == kind) return;
  if (parameter.kind == ParameterKind::inertial || kind == ParameterKind::inertial) {
    if (parameter.kind == ParameterKind::inertial) parameter.kind = kind;
    parameter.is_in_masses_too = true;
    return;
  }
  if (!two_units_.insert(index).second) return;
  diagnostics_
      .warning(
          "parameter-of-two-units", place,
          fmt::format(
              "parameter '{}' is {} here and {} elsewhere", parameter.name, kind_name(kind), kind_name(parameter.kind)))
      .notes.push_back({parameter.place, "first used here"});
}

void QuantityReader::set_default(Parameter& parameter, double value, const Place& place) {
  if (std::abs(value) >= kTooLarge) fault(diagnostics_.error("too-large", place, too_large(print_double(value))));
  if (parameter.default_value.value_or(value) != value) {
    diagnostics_
        .error(
            "conflicting-default", place,
            fmt::format(
                "parameter '{}' has default {} here and {} elsewhere", parameter.name, print_double(value),
                print_double(*parameter.default_value)))
        .notes.push_back({parameter.place, "first used here"});
  }
  parameter.default_value = parameter.default_value.value_or(value);
}

Quantity QuantityReader::constant(const Expression& expression) {
  const auto found = constants_.find(expression.name);
  if (found != constants_.end()) {
    if (!std::isfinite(found->second.value.number().value())) ++faults_;  // reported at its declaration
    return found->second.value;
  }
  std::vector<std::string> names;
  for (const auto& [name, value] : constants_) names.push_back(name);
  Diagnostic& error = diagnostics_.error(
      "unknown-constant", place(expression), fmt::format("constant '{}' is not declared", expression.name));
  error.hint = did_you_mean(expression.name, names);
  return fault(error);
}

}  // namespace robcogen::import
