#include "backend/common/meaning.h"

#include <cmath>

#include "backend/common/layout.h"
#include "support/concat.h"
#include "support/index.h"

namespace robcogen::backend {

using symbolic::Role;

std::string meaning(Role role) {
  switch (role) {
    case Role::joint_reference:
      return "joint positions (rad, m) where any would do";
    case Role::joint_position:
      return "joint positions (rad, m)";
    case Role::joint_velocity:
      return "joint velocities (rad/s, m/s)";
    case Role::joint_acceleration:
      return "joint accelerations (rad/s^2, m/s^2)";
    case Role::joint_force:
      return "joint forces (N m, N)";
    case Role::gravity:
      return "gravity (m/s^2) in base coordinates";
    case Role::base_pose:
      return "pose of the base in the world: unit quaternion w, x, y, z from base axes to world axes, then the base "
             "origin (m)";
    case Role::base_velocity:
      return "velocity of the base (rad/s, m/s) in base coordinates, angular first";
    case Role::base_acceleration:
      return "spatial acceleration of the base (rad/s^2, m/s^2) in base coordinates, angular first, without gravity";
    case Role::base_wrench:
      return "wrench on the base (N m, N) about its origin in base coordinates, moment first";
    case Role::inverse_diagonal:
      return "reciprocals of the diagonal of L";
    case Role::contact_activity:
      return "1 for an active contact, 0 for an open one";
    default:
      return "";
  }
}

namespace {

// `q1_w q1_x q1_y q1_z, and …`.
std::string names_of_quaternions(const symbolic::InputArray& q) {
  std::string list;
  for (const int first : q.quaternions) {
    std::vector<std::string> names;
    for (int k = first; k < first + 4; ++k) names.push_back(q.elements[at(k)]);
    list += (list.empty() ? "" : ", and ") + joined(names, " ");
  }
  return list;
}

std::string names_of_followers(const symbolic::InputArray& q) {
  return joined({q.elements.end() - q.followers, q.elements.end()});
}

}  // namespace

std::string remark_on_positions(const symbolic::Program& program) {
  std::string remark;
  for (const symbolic::InputArray& input : program.inputs) {
    if (input.role != Role::joint_position) continue;
    if (const std::string list = names_of_quaternions(input); !list.empty())
      remark =
          "Unit quaternions, scalar part first, that rotate coordinates of the child to coordinates of the joint "
          "frame: " +
          list + ". Velocities are those of the child with respect to the parent, in axes of the child.";
    if (input.followers > 0)
      remark += (remark.empty() ? "" : " ") +
                std::string("Joints that follow through loops, computed by close_loops: ") + names_of_followers(input) +
                ".";
  }
  return remark;
}

std::string meaning_of_positions(const Library& library) {
  std::string text;
  if (!library.tree.spherical_joints().empty()) text = "spherical joints have unit quaternions, scalar part first";
  if (!library.tree.followers_in_q().empty())
    text += (text.empty() ? "" : "; ") + std::string("joints that follow through loops come last");
  return text;
}

bool is_of_joints(Role role) {
  return role == Role::joint_position || role == Role::joint_reference || role == Role::joint_velocity ||
         role == Role::joint_acceleration || role == Role::joint_force;
}

bool is_matrix(const symbolic::OutputArray& output) {
  return symbolic::is_matrix(output.role) || output.columns > 1;
}

int side(const symbolic::InputArray& square) {
  return static_cast<int>(std::lround(std::sqrt(static_cast<double>(square.elements.size()))));
}

std::vector<std::vector<std::string>> rows_of(
    const symbolic::OutputArray& output,
    const std::vector<std::string>& elements) {
  std::vector<std::vector<std::string>> rows(at(output.rows));
  for (std::size_t k = 0; k < elements.size(); ++k) rows[k % rows.size()].push_back(elements[k]);
  return rows;
}

std::vector<std::string> column_joints(const Library& library, const Function& function) {
  std::vector<std::string> names;
  const std::vector<int> coordinates = library.tree.coordinates();
  for (const int j : function.columns) names.push_back(library.tree.joints[at(coordinates[at(j)])].name);
  return names;
}

std::vector<std::string> describe_columns(const Library& library, const Function& function, const ColumnWords& words) {
  std::vector<std::string> lines;
  if (!function.columns.empty()) lines.push_back(words.all + joined(column_joints(library, function)) + words.end);
  for (std::size_t k = 0; k < function.labels.size(); ++k)
    lines.push_back(words.one + std::to_string(k + words.first) + ": " + function.labels[k] + words.end);
  return lines;
}

std::string describe_elements(const symbolic::InputArray& input) {
  constexpr std::size_t kMaxListed = 40;
  if (input.role == Role::link_wrenches) return "six elements per link, base first";
  return input.elements.size() > kMaxListed ? "" : joined(input.elements);
}

std::vector<std::string> describe_arrays(
    const symbolic::Program& program,
    const std::vector<std::string>& names,
    bool has_cache) {
  std::vector<std::string> lines;
  for (const symbolic::InputArray& input : program.inputs) {
    const std::string& name = names[lines.size()];
    const std::string elements = input.role == Role::inertia_factor ? "L, column by column"
                                 : input.role == Role::homogeneous  ? "4 x 4, column by column"
                                                                    : describe_elements(input);
    if (input.role == Role::parameters)
      lines.push_back(
          name + (has_cache ? ": values that depend on the parameters, computed before" : ": the parameters"));
    else
      lines.push_back(subscripted(name, input.elements.size()) + (elements.empty() ? "" : ": " + elements));
  }
  for (const symbolic::OutputArray& output : program.outputs) {
    const std::string shape = std::to_string(output.rows) + " x " + std::to_string(output.columns);
    lines.push_back(
        subscripted(names[lines.size()], output.values.size()) + ": result" +
        (is_matrix(output) ? ", " + shape + ", column by column" : ""));
  }
  return lines;
}

std::vector<std::string> describe_function(
    const Library& library,
    const Function& function,
    const std::vector<std::string>& arguments,
    const std::vector<std::string>& results,
    const ColumnWords& words) {
  std::vector<std::string> lines = function.summary;
  if (!function.method.empty()) lines.push_back(function.method);
  lines.insert(lines.end(), arguments.begin(), arguments.end());
  if (const std::string remark = remark_on_positions(function.program); !remark.empty()) lines.push_back(remark);
  lines.insert(lines.end(), results.begin(), results.end());
  const std::vector<std::string> columns = describe_columns(library, function, words);
  lines.insert(lines.end(), columns.begin(), columns.end());
  return lines;
}

}  // namespace robcogen::backend
