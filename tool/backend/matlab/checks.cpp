// The first lines of a function: they refuse missing arguments and arguments of another shape, and give the others
// their defaults.
#include <cmath>

#include "backend/matlab/dialect.h"
#include "backend/matlab/printers.h"

namespace robcogen::backend::matlab {
namespace {

using symbolic::InputArray;
using symbolic::Role;

// An argument of the function, as the caller passes it.
struct Argument {
  std::string name;
  int rows = 1;
  int columns = 1;
  Role role = Role::variables;
  std::vector<int> quaternions = {};  // the elements that begin unit quaternions
};

// The variables of a document are separate arguments.
std::vector<Argument> arguments(const std::vector<InputArray>& inputs, const Kernel& kernel, std::size_t count) {
  std::vector<Argument> result;
  for (std::size_t i = 0; i < count; ++i) {
    const KernelArray& parameter = kernel.parameters[i];
    Argument a{parameter.name, static_cast<int>(inputs[i].elements.size()), 1, inputs[i].role, inputs[i].quaternions};
    if (a.role == Role::variables) {
      for (const std::string& element : parameter.elements) result.push_back({element});
      continue;
    }
    if (a.role == Role::link_wrenches) {
      a.columns = a.rows / 6;
      a.rows = 6;
    } else if (symbolic::is_square_input(a.role)) {
      a.rows = a.columns = static_cast<int>(std::lround(std::sqrt(a.rows)));
    }
    result.push_back(std::move(a));
  }
  return result;
}

std::string shape(const Argument& a) {
  return std::to_string(a.rows) + " x " + std::to_string(a.columns);
}

std::string note(const Argument& a) {
  return a.role == Role::gravity ? " (m/s^2, in base coordinates)" : "";
}

// `    error('function: message', values);`. The function's name is a separate argument if the line has no room for
// both.
std::string error(const std::string& function, const std::string& message, std::vector<std::string> values) {
  std::string text = quoted(function + ": " + message);
  if (text.size() + 16 > kColumns) {
    text = quoted("%s: " + message);
    values.insert(values.begin(), quoted(function));
  }
  values.insert(values.begin(), text);
  return wrapped("    error(", values, ");");
}

std::string missing(const std::string& function, const std::vector<Argument>& required) {
  if (required.empty()) return "";
  std::vector<std::string> names;
  for (const Argument& a : required) names.push_back(quoted(a.name + note(a)));
  const std::string count = std::to_string(required.size());
  return "  if nargin < " + count + "\n" + wrapped("    names = {", names, "};") +
         error(function, "missing %s", {"strjoin(names(nargin + 1:end), ', ')"}) + "  end\n";
}

// The test that fails. It is empty if any shape will do, because nothing is read from an array without elements.
std::string condition(const Argument& a) {
  if (a.role == Role::parameters) return "~isstruct(" + a.name + ")";
  if (a.rows * a.columns == 0) return "";
  if (a.rows * a.columns == 1) return "numel(" + a.name + ") ~= 1";
  return "numel(" + a.name + ") ~= " + std::to_string(a.rows * a.columns) + " || size(" + a.name +
         ", 2) ~= " + std::to_string(a.columns);
}

std::string wrong_shape(const std::string& function, const Argument& a) {
  if (a.role == Role::parameters) {
    return error(function, a.name + " must be a struct, as parameters() returns it", {});
  }
  return error(
      function, a.name + " must be " + shape(a) + note(a) + ", is %d x %d",
      {"size(" + a.name + ", 1)", "size(" + a.name + ", 2)"});
}

// Refuses quaternions of another length, which would make results wrong. The tolerance admits numbers that were printed
// with four digits.
std::string wrong_length(const std::string& function, const Argument& a) {
  std::string text;
  for (const int first : a.quaternions) {
    const std::string q = a.name + "(" + std::to_string(first + 1) + ":" + std::to_string(first + 4) + ")";
    text += "  if abs(norm(" + q + ") - 1) > 1e-4\n" +
            error(function, q + " must be a unit quaternion w, x, y, z, has norm %g", {"norm(" + q + ")"}) + "  end\n";
  }
  return text;
}

std::string default_value(const Argument& a) {
  if (a.role == Role::gravity) return "[0; 0; -9.81]";
  return "zeros(" + std::to_string(a.rows) + ", " + std::to_string(a.columns) + ")";
}

}  // namespace

std::string print_checks(
    const std::string& name,
    const std::vector<InputArray>& inputs,
    const Kernel& kernel,
    std::size_t required) {
  const std::vector<Argument> first = arguments(inputs, kernel, required);
  std::string text = missing(name, first);
  std::size_t position = 0;
  for (const Argument& a : arguments(inputs, kernel, inputs.size())) {
    const std::string refused = condition(a);
    if (++position > first.size()) {
      text += "  if nargin < " + std::to_string(position) + " || isempty(" + a.name + ")\n    " + a.name + " = " +
              default_value(a) + ";\n";
      text += (refused.empty() ? "" : "  elseif " + refused + "\n" + wrong_shape(name, a)) + "  end\n";
    } else if (!refused.empty()) {
      text += "  if " + refused + "\n" + wrong_shape(name, a) + "  end\n";
    }
    text += wrong_length(name, a);
  }
  return text;
}

}  // namespace robcogen::backend::matlab
