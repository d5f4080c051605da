#include "command/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithm/dynamics/dynamics.h"
#include "backend/common/meaning.h"
#include "model/closed_positions.h"
#include "support/diagnostics.h"

namespace robcogen::command {
namespace {

using Shape = Argument::Shape;
using symbolic::InputArray;
using symbolic::Role;

std::string meaning_of(Role role) {
  switch (role) {
    case Role::link_wrenches:
      return "wrench on each link, angular first, in axes of the frame fr_<link> about its origin";
    case Role::inertia_factor:
      return "factor L of the joint-space inertia matrix";
    case Role::homogeneous:
      return "homogeneous transform, row by row";
    case Role::parameters:
      return "parameters of the model";
    case Role::variables:
      return "variables of the transform";
    default:
      return backend::meaning(role);
  }
}

std::string counted(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

// `array of 3 numbers`
std::string shape_text(const Argument& a) {
  switch (a.shape) {
    case Shape::vector:
      return "array of " + counted(a.length, "number");
    case Shape::square:
      return fmt::format("array of {} of {}", counted(a.length, "row"), counted(a.length, "number"));
    case Shape::numbers_by_name:
      return "object of name: number";
    case Shape::vectors_by_name:
      break;
  }
  return "object of name: array of " + counted(a.length, "number");
}

// `HFE, KFE`: all names, or the first and last ones of a long list.
std::string elements_text(const std::vector<std::string>& elements) {
  constexpr std::size_t kMaxShown = 12;
  if (elements.size() <= kMaxShown) return fmt::format("{}", fmt::join(elements, ", "));
  return fmt::format("{}, {}, …, {}", elements[0], elements[1], elements.back());
}

// `; optional, (0, 0, -9.81)`
std::string default_text(const Argument& a) {
  if (a.is_required()) return "";
  if (a.shape == Shape::numbers_by_name) return "; optional: all have defaults";
  std::vector<double> values;
  for (const std::optional<double>& value : a.defaults) values.push_back(*value);
  const bool is_zero = std::all_of(values.begin(), values.end(), [](double value) { return value == 0; });
  return is_zero ? "; optional, zero" : fmt::format("; optional, ({})", fmt::join(values, ", "));
}

// A line for each argument.
std::string list_of(const Signature& signature) {
  if (signature.arguments.empty()) return fmt::format("\nnote: {} takes no arguments: {{}}", signature.function);
  std::string text = fmt::format("\nnote: arguments of {}:", signature.function);
  for (const Argument& a : signature.arguments) {
    text += fmt::format("\n  {}: {}", a.name, shape_text(a));
    if (!a.elements.empty()) text += fmt::format(" ({})", elements_text(a.elements));
    if (!a.meaning.empty()) text += ": " + a.meaning;
    text += default_text(a);
  }
  return text;
}

std::string hint_line(const std::string& word, const std::vector<std::string>& candidates) {
  const std::string hint = did_you_mean(word, candidates);
  return hint.empty() ? "" : "\nhint: " + hint;
}

// ---- From values to numbers.

[[noreturn]] void refuse_shape(const JsonValue& value, const std::string& name, const std::string& expected) {
  refuse_input(value.line, fmt::format("'{}' must be an {}, not {} [wrong-shape]", name, expected, describe(value)));
}

void append_numbers(
    const JsonValue& value,
    const std::string& name,
    std::size_t length,
    const std::string& expected,
    std::vector<double>& numbers) {
  if (!value.is_array() || value.values().size() != length) refuse_shape(value, name, expected);
  for (std::size_t i = 0; i < length; ++i) {
    const JsonValue& element = value.values()[i];
    if (!element.is_number())
      refuse_input(
          element.line,
          fmt::format("'{}' must be an {}, but [{}] is {} [wrong-shape]", name, expected, i, describe(element)));
    numbers.push_back(element.number);
  }
}

// Normalises quaternions that are nearly of unit length, and refuses others.
void normalise(const JsonValue& value, const Argument& a, std::vector<double>& numbers) {
  constexpr double kNearly = 1e-6;
  for (const int first : a.quaternions) {
    double* q = &numbers[static_cast<std::size_t>(first)];
    const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (!(std::abs(norm - 1.0) <= kNearly))
      refuse_input(
          value.values()[static_cast<std::size_t>(first)].line,
          fmt::format(
              "'{}': elements {} to {} ({}, …) are not a unit quaternion: their norm is {} [quaternion-norm]\nhint: "
              "the "
              "order is w, x, y, z",
              a.name, first, first + 3, a.elements[static_cast<std::size_t>(first)], norm));
    for (int i = 0; i < 4; ++i) q[i] /= norm;
  }
}

std::vector<double> vector_from(const JsonValue& value, const Argument& a) {
  std::vector<double> numbers;
  const std::size_t least = a.length - static_cast<std::size_t>(a.followers);
  const bool has_followers = !value.is_array() || value.values().size() != least;
  append_numbers(value, a.name, has_followers ? a.length : least, shape_text(a), numbers);
  normalise(value, a, numbers);
  return numbers;
}

// Converts rows of numbers to an array column by column.
std::vector<double> square_from(const JsonValue& value, const Argument& a) {
  const std::size_t n = a.length;
  if (!value.is_array() || value.values().size() != n) refuse_shape(value, a.name, shape_text(a));
  std::vector<double> columns(n * n);
  for (std::size_t r = 0; r < n; ++r) {
    std::vector<double> row;
    append_numbers(value.values()[r], fmt::format("{}[{}]", a.name, r), n, "array of " + counted(n, "number"), row);
    for (std::size_t c = 0; c < n; ++c) columns[r + c * n] = row[c];
  }
  return columns;
}

// `values` is nullptr if the state does not have the argument.
std::vector<double> by_name(const JsonValue* values, const Argument& a, const JsonValue& state) {
  std::vector<std::optional<double>> numbers = a.defaults;
  if (values && !values->is_object()) refuse_shape(*values, a.name, shape_text(a));
  for (std::size_t k = 0; values && k < values->names().size(); ++k) {
    const std::string& name = values->names()[k];
    const JsonValue& value = values->values()[k];
    const auto place = std::find(a.elements.begin(), a.elements.end(), name);
    if (place == a.elements.end())
      refuse_input(
          value.line, fmt::format(
                          "'{}' has no element '{}'; its elements are {} [unknown-element]{}", a.name, name,
                          elements_text(a.elements), hint_line(name, a.elements)));
    std::vector<double> found;
    const std::string path = a.name + "." + name;
    if (a.shape == Shape::vectors_by_name)
      append_numbers(value, path, a.length, "array of " + counted(a.length, "number"), found);
    else if (value.is_number())
      found.push_back(value.number);
    else
      refuse_input(value.line, fmt::format("'{}' must be a number, not {} [wrong-shape]", path, describe(value)));
    std::copy(
        found.begin(), found.end(),
        numbers.begin() + (place - a.elements.begin()) * static_cast<std::ptrdiff_t>(a.length));
  }
  std::vector<double> result;
  std::vector<std::string> missing;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    result.push_back(numbers[i].value_or(0));
    if (!numbers[i]) missing.push_back(a.elements[i / a.length]);
  }
  if (!missing.empty())
    refuse_input(
        (values ? *values : state).line,
        fmt::format("'{}' must give {}: no default [missing-element]", a.name, elements_text(missing)));
  return result;
}

// ---- From programs to arguments.

std::vector<std::optional<double>> zeros(std::size_t count) {
  return std::vector<std::optional<double>>(count, 0.0);
}

Argument parameters_argument(const std::vector<model::Parameter>& parameters) {
  Argument a{"parameters", Shape::numbers_by_name, meaning_of(Role::parameters), {}, 1, {}};
  for (const model::Parameter& p : parameters) {
    a.elements.push_back(p.name);
    a.defaults.push_back(p.default_value);
  }
  return a;
}

Argument external_argument(const InputArray& array, const model::KinematicTree& tree) {
  Argument a{array.name, Shape::vectors_by_name, meaning_of(array.role), {}, 6, zeros(array.elements.size())};
  for (const model::Link& link : tree.links)
    if (!link.is_repeated) a.elements.push_back(link.name);
  return a;
}

Argument array_argument(const InputArray& array) {
  const std::size_t size = array.elements.size();
  if (symbolic::is_square_input(array.role)) {
    const auto n = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(size))));
    return {array.name, Shape::square, meaning_of(array.role), {}, n, {}};
  }
  std::string meaning = meaning_of(array.role);
  if (!array.quaternions.empty() && (array.role == Role::joint_position || array.role == Role::joint_reference))
    meaning += "; of spherical joints unit quaternions, scalar part first";
  if (array.followers > 0)
    meaning += fmt::format("; the last {}, which follow through loops, may be left out", array.followers);
  return {array.name, Shape::vector, std::move(meaning), array.elements, size, {}, array.quaternions, array.followers};
}

bool takes(const symbolic::Program& program, const std::string& name) {
  return std::any_of(
      program.inputs.begin(), program.inputs.end(), [&](const InputArray& array) { return array.name == name; });
}

// The default of an argument that only some overloads take.
std::vector<std::optional<double>> default_of(const InputArray& array) {
  if (array.role == Role::gravity) return {0.0, 0.0, -algorithm::kStandardGravity};
  return zeros(array.elements.size());
}

void require_known_names(const JsonValue& object, const Signature& signature) {
  std::vector<std::string> known;
  for (const Argument& a : signature.arguments) known.push_back(a.name);
  for (std::size_t k = 0; k < object.names().size(); ++k) {
    const std::string& name = object.names()[k];
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    refuse_input(
        object.values()[k].line, fmt::format(
                                     "'{}' is not an argument of {} [unknown-argument]{}{}", name, signature.function,
                                     hint_line(name, known), list_of(signature)));
  }
}

}  // namespace

bool Argument::is_required() const {
  const bool is_by_name = shape == Shape::numbers_by_name || shape == Shape::vectors_by_name;
  return is_by_name ? std::count(defaults.begin(), defaults.end(), std::nullopt) > 0 : defaults.empty();
}

Signature signature_of(
    const std::string& function,
    const std::vector<symbolic::Program>& overloads,
    const model::KinematicTree& tree) {
  Signature signature = {function, {}, &tree};
  // The last overload takes all arguments.
  for (const InputArray& array : overloads.back().inputs) {
    if (array.role == Role::parameters) {
      signature.arguments.push_back(parameters_argument(tree.parameters));
      continue;
    }
    if (array.role == Role::link_wrenches) {
      signature.arguments.push_back(external_argument(array, tree));
      continue;
    }
    Argument a = array_argument(array);
    const bool some_do_without = std::any_of(
        overloads.begin(), overloads.end(), [&](const symbolic::Program& p) { return !takes(p, array.name); });
    if (some_do_without || (array.role == Role::gravity && !tree.floating_base))
      a.defaults = default_of(array);
    else if (array.role == Role::gravity)
      a.meaning += ", required because it depends on the orientation of the floating base";
    signature.arguments.push_back(std::move(a));
  }
  return signature;
}

Signature signature_of(
    const std::string& function,
    const symbolic::Program& program,
    const model::CoordinateTransforms& document) {
  Signature signature = {function, {}, nullptr};
  for (const InputArray& array : program.inputs) {
    if (array.role == Role::parameters) {
      signature.arguments.push_back(parameters_argument(document.parameters));
      continue;
    }
    const std::vector<std::optional<double>> none(array.elements.size());
    signature.arguments.push_back(
        {array.name, Shape::numbers_by_name, meaning_of(array.role), array.elements, 1, none});
  }
  return signature;
}

symbolic::Arrays<double> arguments_from(const JsonValue& object, const Signature& signature) {
  require_known_names(object, signature);
  symbolic::Arrays<double> inputs;
  for (const Argument& a : signature.arguments) {
    const JsonValue* given = object.find(a.name);
    if (!given && a.is_required())
      refuse_input(
          object.line, fmt::format(
                           "argument '{}' of {} is missing{} [missing-argument]{}", a.name, signature.function,
                           a.meaning.empty() ? "" : ": " + a.meaning, list_of(signature)));
    if (a.shape == Shape::numbers_by_name || a.shape == Shape::vectors_by_name) {
      inputs[a.name] = by_name(given, a, object);
    } else if (given) {
      inputs[a.name] = a.shape == Shape::square ? square_from(*given, a) : vector_from(*given, a);
    } else {
      for (const std::optional<double>& value : a.defaults) inputs[a.name].push_back(*value);
    }
  }
  for (const Argument& a : signature.arguments) {
    if (a.followers == 0) continue;
    std::vector<double>& q = inputs.at(a.name);
    if (q.size() == a.length) continue;
    const auto parameters = inputs.find("parameters");
    const std::vector<double> followers = model::closed_followers(
        *signature.tree, q, parameters == inputs.end() ? std::vector<double>() : parameters->second);
    q.insert(q.end(), followers.begin(), followers.end());
  }
  return inputs;
}

}  // namespace robcogen::command
