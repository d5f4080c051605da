// <name>/reflection.h: the tables that the self-check and the benchmark of a robot read.
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "backend/cpp/layout.h"
#include "backend/cpp/printers.h"
#include "support/number.h"
#include "symbolic/count.h"

namespace robcogen::backend::cpp {
namespace {

using symbolic::Role;

// A number of the model; none where it depends on a parameter without default.
std::string number(double value) {
  return std::isnan(value) ? "std::numeric_limits<double>::quiet_NaN()" : print_double(value);
}

template <std::size_t n>
Field numbers(const std::array<double, n>& values) {
  std::vector<std::string> texts;
  for (double v : values) texts.push_back(number(v));
  return texts;
}

// The definition of a table, and how the robot's own table refers to it.
struct Table {
  std::string definition;
  std::string reference;
};

Table table(const std::string& type, const std::string& name, const std::vector<std::vector<Field>>& rows) {
  if (rows.empty()) return {"", "{nullptr, 0}"};
  return {
      cpp::table("inline constexpr robcogen::reflection::" + type + " " + name + "[]", rows),
      "{" + name + ", " + std::to_string(rows.size()) + "}"};
}

Table links(const Library& library) {
  std::vector<std::vector<Field>> rows;
  for (const LinkData& l : library.links)
    rows.push_back({quoted(l.name), l.parent_joint, number(l.mass), numbers(l.com), numbers(l.inertia)});
  return table("Link", "kLinks", rows);
}

Table joints(const Library& library) {
  std::vector<std::vector<Field>> rows;
  for (const JointData& j : library.joints)
    rows.push_back(
        {quoted(j.name), j.revolute ? "true" : "false", j.parent, j.child, numbers(j.translation),
         numbers(j.rotation)});
  return table("Joint", "kJoints", rows);
}

Table frames(const Library& library) {
  std::vector<std::vector<Field>> rows;
  for (const FrameData& f : library.frames)
    rows.push_back({quoted(f.name), f.link, numbers(f.translation), numbers(f.rotation)});
  return table("Frame", "kFrames", rows);
}

bool is_form(const Callable& c, Role role) {
  return c.function->left_frame >= 0 && !c.function->program.outputs.empty() &&
         c.function->program.outputs.front().role == role;
}

std::string address(const Callable& c) {
  return "&kernel::" + c.kernel + "<double>";
}

// One row a pair of frames that has all three forms.
Table transforms(const Api& api) {
  using Pair = std::pair<int, int>;
  std::map<Pair, std::string> motion, force;
  for (const Callable& c : api.callables) {
    if (is_form(c, Role::spatial_motion)) motion[{c.function->left_frame, c.function->right_frame}] = address(c);
    if (is_form(c, Role::spatial_force)) force[{c.function->left_frame, c.function->right_frame}] = address(c);
  }
  std::vector<std::vector<Field>> rows;
  for (const Callable& c : api.callables) {
    const Pair pair(c.function->left_frame, c.function->right_frame);
    if (!is_form(c, Role::homogeneous) || !motion.contains(pair) || !force.contains(pair)) continue;
    rows.push_back({quoted(c.function->name), pair.first, pair.second, address(c), motion[pair], force[pair]});
  }
  return table("Transform", "kTransforms", rows);
}

// The list of the joints of a Jacobian's columns.
Table columns_of(const Callable& c) {
  if (c.function->columns.empty()) return {"", "nullptr"};
  std::vector<std::string> indices;
  for (int j : c.function->columns) indices.push_back(std::to_string(j));
  const std::string name = c.kernel + "_columns";
  return {numbered_list("inline constexpr int " + name + "[]", indices), name};
}

Table jacobians(const Api& api) {
  std::vector<std::vector<Field>> rows;
  std::string lists;
  for (const Callable& c : api.callables) {
    if (!is_form(c, Role::jacobian)) continue;
    const Table columns = columns_of(c);
    lists += columns.definition;
    rows.push_back(
        {quoted(c.function->name), c.function->left_frame, c.function->right_frame, columns.reference,
         c.function->program.outputs.front().columns, address(c)});
  }
  Table result = table("Jacobian", "kJacobians", rows);
  result.definition = paragraphs({lists, result.definition});
  return result;
}

// Functions that the table of FrameFunction is about.
std::optional<std::string> frame_quantity(const Callable& c) {
  constexpr std::array kQuantities = {
      std::pair{Role::jacobian_in_target, "jacobian_in_target"},
      std::pair{Role::spatial_jacobian, "spatial_jacobian"},
      std::pair{Role::jacobian_derivative, "jacobian_derivative"},
      std::pair{Role::frame_bias_acceleration, "frame_bias_acceleration"},
      std::pair{Role::frame_velocity, "frame_velocity"},
      std::pair{Role::frame_acceleration, "frame_acceleration"}};
  for (const auto& [role, name] : kQuantities)
    if (is_form(c, role)) return std::string("robcogen::reflection::FrameQuantity::") + name;
  return std::nullopt;
}

Table frame_functions(const Api& api) {
  std::vector<std::vector<Field>> rows;
  std::string lists;
  for (const Callable& c : api.callables) {
    const std::optional<std::string> quantity = frame_quantity(c);
    if (!quantity) continue;
    const Table columns = columns_of(c);
    lists += columns.definition;
    rows.push_back(
        {quoted(c.kernel), *quantity, c.function->left_frame, c.function->right_frame, columns.reference,
         c.function->program.outputs.front().columns, "&flat::" + c.kernel});
  }
  Table result = table("FrameFunction", "kFrameFunctions", rows);
  result.definition = paragraphs({lists, result.definition});
  return result;
}

// All kernels of robots with parameters, those that fill their cache too.
std::vector<Callable> all_callables(const Api& api) {
  std::vector<Callable> result = api.callables;
  result.insert(result.end(), api.updates.begin(), api.updates.end());
  return result;
}

int input_count(const symbolic::Program& program) {
  std::size_t count = 0;
  for (const symbolic::InputArray& input : program.inputs) count += input.elements.size();
  return static_cast<int>(count);
}

int output_count(const symbolic::Program& program) {
  int count = 0;
  for (const symbolic::OutputArray& output : program.outputs) count += output.rows * output.columns;
  return count;
}

// A kernel under one signature for all: its arrays stand one after another.
std::string flat_function(const Callable& c) {
  const symbolic::Program& program = c.function->program;
  std::vector<std::string> arguments;
  const auto append = [&](const std::string& array, std::size_t offset) {
    arguments.push_back(offset == 0 ? array : array + " + " + std::to_string(offset));
  };
  std::size_t offset = 0;
  for (const symbolic::InputArray& input : program.inputs) {
    append("in", offset);
    offset += input.elements.size();
  }
  offset = 0;
  for (const symbolic::OutputArray& output : program.outputs) {
    append("out", offset);
    offset += static_cast<std::size_t>(output.rows) * static_cast<std::size_t>(output.columns);
  }
  const std::string in = program.inputs.empty() ? "const double*" : "const double* in";
  const std::string out = program.outputs.empty() ? "double*" : "double* out";
  return declaration("inline void " + c.kernel, {in, out}, " noexcept {") +
         call("kernel::" + c.kernel + "<double>", arguments, 2) + "}\n";
}

std::string flat_functions(const Api& api) {
  std::vector<std::string> functions;
  for (const Callable& c : all_callables(api)) functions.push_back(flat_function(c));
  return in_namespace("flat", paragraphs(functions));
}

Table functions(const Api& api) {
  std::vector<std::vector<Field>> rows;
  for (const Callable& c : all_callables(api)) {
    const symbolic::OperationCount n = symbolic::count(c.function->program);
    std::vector<std::string> counts;
    for (int k : {n.mul, n.add, n.div, n.sqrt, n.sincos, n.instructions, n.critical_path})
      counts.push_back(std::to_string(k));
    rows.push_back(
        {quoted(c.kernel), counts, input_count(c.function->program), output_count(c.function->program),
         "&flat::" + c.kernel});
  }
  return table("Function", "kFunctions", rows);
}

Table parameters(const Library& library) {
  std::vector<std::vector<Field>> rows;
  for (const ParameterData& p : library.parameters)
    rows.push_back({quoted(p.name), p.is_dynamics ? "true" : "false", number(p.default_value)});
  return table("Parameter", "kParameters", rows);
}

}  // namespace

std::string print_reflection(const Api& api, const std::string& path) {
  const Library& library = *api.library;
  std::vector<std::string> kernels;
  for (const Callable& c : all_callables(api)) kernels.push_back(kernel_declaration(c));
  std::vector<Table> tables = {links(library), joints(library),      frames(library), transforms(api),
                               jacobians(api), frame_functions(api), functions(api)};
  std::vector<std::string> remarks = {"name",       "floating base", "links",           "joints",   "frames",
                                      "transforms", "Jacobians",     "frame functions", "functions"};
  if (api.is_parametric()) {
    tables.push_back(parameters(library));
    remarks.insert(remarks.end(), {"parameters", "numbers for their values"});
    for (const Callable& c : api.numbers) kernels.push_back(kernel_declaration(c));
  }
  std::vector<std::string> parts = {flat_functions(api)};
  std::vector<std::string> fields = {quoted(library.robot), library.floating_base ? "true" : "false"};
  for (const Table& t : tables) {
    parts.push_back(t.definition);
    fields.push_back(t.reference);
  }
  for (const Callable& c : api.numbers) fields.push_back(address(c));
  parts.push_back(remarked_list("inline constexpr robcogen::reflection::Robot robot", fields, remarks));
  return paragraphs(
      {banner(library, path, "its constants and functions as tables, without Eigen"), "#pragma once\n",
       api.is_parametric() ? includes({"<limits>"}) : "",
       includes({"\"robcogen/reflection.h\"", "\"robcogen/version.h\""}), runtime_check(api),
       in_namespace(api.space + "::kernel", paragraphs(kernels)),
       in_namespace(api.space + "::reflection", paragraphs(parts))});
}

}  // namespace robcogen::backend::cpp
