// What a function says of itself: the help text.
#include <algorithm>
#include <cmath>

#include "backend/common/meaning.h"
#include "backend/matlab/dialect.h"
#include "backend/matlab/printers.h"

namespace robcogen::backend::matlab {
namespace {

using symbolic::InputArray;
using symbolic::OutputArray;
using symbolic::Role;

// What an array is, its unit and its frame; empty where the summary of the function says it.
std::string meaning_of(Role role) {
  switch (role) {
    case Role::link_wrenches:
      return "wrench on each link (N m, N), a column a link, base first: about the link's origin in link coordinates, "
             "moment first";
    case Role::inertia_factor:
      return "factor of the inertia matrix H = L' * L";
    case Role::parameters:
      return "struct of the parameters, as parameters() returns it";
    default:
      return meaning(role);
  }
}

std::string line(const std::string& name, int rows, int columns, const std::string& what) {
  const std::string shape = " (" + std::to_string(rows) + " x " + std::to_string(columns) + ")";
  return comment("  " + name + shape + (what.empty() ? "" : "  " + what), 0, 6);
}

std::string default_of(const InputArray& input) {
  return input.role == Role::gravity ? "; optional, default [0; 0; -9.81]" : "; optional, default zero";
}

std::string results(const Library& library, const Function& function) {
  std::string text = comment("Results:");
  for (const OutputArray& output : function.program.outputs)
    text += line(output.name, output.rows, output.columns, meaning_of(output.role));
  std::vector<std::string> joints;
  for (const int j : function.columns) joints.push_back(library.joints[static_cast<std::size_t>(j)].name);
  if (!joints.empty()) text += comment("    columns: " + joined(joints), 0, 6);
  for (std::size_t k = 0; k < function.labels.size(); ++k)
    text += comment("    column " + std::to_string(k + 1) + ": " + function.labels[k], 0, 6);
  return text;
}

// The lines with a first one that stands alone, as searches of help texts show it.
std::vector<std::string> titled(const std::string& name, std::vector<std::string> lines) {
  if (lines.empty()) return {""};
  const std::size_t room = kColumns - 4 - name.size();
  const std::size_t colon = lines.front().find(": ");
  if (lines.front().size() <= room || colon == std::string::npos) return lines;
  std::string rest = upper_case(lines.front().substr(colon + 2, 1)) + lines.front().substr(colon + 3);
  lines.front().erase(colon);
  lines.front() += ".";
  lines.insert(lines.begin() + 1, std::move(rest));
  return lines;
}

}  // namespace

std::string first_line(const Callable& callable) {
  return titled(callable.name, summary(callable)).front();
}

std::string heading(const std::string& name, const std::vector<std::string>& summary) {
  const std::vector<std::string> lines = titled(name, summary);
  std::string text = comment(upper_case(name) + "  " + lines.front());
  for (std::size_t i = 1; i < lines.size(); ++i) text += comment("  " + lines[i]);
  return text + "%\n";
}

std::string describe_arguments(const std::vector<InputArray>& inputs, const Kernel& kernel, std::size_t required) {
  std::string text;
  std::vector<std::string> named;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const InputArray& input = inputs[i];
    const std::string& name = kernel.parameters[i].name;
    const int size = static_cast<int>(input.elements.size());
    if (input.role == Role::variables) {
      for (const std::string& e : kernel.parameters[i].elements) text += line(e, 1, 1, "rad or m");
      continue;
    }
    std::string what = meaning_of(input.role);
    if (is_of_joints(input.role) && input.elements != named && size > 0) {
      what += ": " + joined(input.elements);
      named = input.elements;
    }
    if (i >= required) what += default_of(input);
    if (input.role == Role::link_wrenches) {
      text += line(name, 6, size / 6, what);
    } else if (input.role == Role::inertia_factor) {
      const int rows = static_cast<int>(std::lround(std::sqrt(size)));
      text += line(name, rows, rows, what);
    } else if (input.role == Role::parameters) {
      text += comment("  " + name + "  " + what, 0, 6);
    } else {
      text += line(name, size, 1, what);
    }
  }
  return text.empty() ? "" : comment("Arguments:") + text;
}

std::string help(const Library& library, const Callable& callable, const Kernel& kernel) {
  const Function& function = callable.longest();
  const std::string remark = remark_on_quaternions(function.program);
  return heading(callable.name, summary(callable)) +
         describe_arguments(function.program.inputs, kernel, required_inputs(library, callable)) +
         (remark.empty() ? "" : comment(remark)) + results(library, function) +
         comment(describe_operations(function.program));
}

std::string origin(const Library& library) {
  const std::string what = library.has_robot() ? "robot " : "model ";
  return comment(
      "Generated by robcogen from " + library.model_file + " (model " + library.model_hash + "), " + what +
          library.robot + ": edit the model, not this file.",
      0, 0);
}

}  // namespace robcogen::backend::matlab
