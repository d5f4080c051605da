#include "backend/cpp/inverse_table.h"

#include <algorithm>

#include "backend/cpp/layout.h"
#include "support/number.h"

namespace robcogen::backend::cpp {
namespace {

std::string task_of(const model::InverseTask& task) {
  const std::string type = "robcogen::reflection::InverseTask::";
  if (task.kind == model::InverseTask::Kind::point) return type + "position";
  return type + (task.kind == model::InverseTask::Kind::axis ? "position_and_axis" : "pose");
}

// The element of qd of a joint.
int element_of(const model::KinematicTree& tree, int joint) {
  const std::vector<int> joints = tree.coordinates();
  return joint < 0 ? -1 : static_cast<int>(std::find(joints.begin(), joints.end(), joint) - joints.begin());
}

}  // namespace

Table inverse_kinematics(const Api& api) {
  std::vector<std::vector<Field>> rows;
  std::string lists;
  for (const model::InverseTarget& target : api.library->inverses) {
    const auto place_of = [&](const std::string& scope) {
      const auto found = std::find_if(api.callables.begin(), api.callables.end(), [&](const Callable& c) {
        return c.function->scope == "inverse_kinematics" + scope && c.function->left == target.frames.left.name &&
               c.function->right == target.frames.right.name && c.function->derivatives.empty();
      });
      return found == api.callables.end() ? -1 : static_cast<int>(found - api.callables.begin());
    };
    const int all = place_of("");
    if (all < 0) continue;
    const Callable& c = api.callables[static_cast<std::size_t>(all)];
    std::vector<std::string> joints;
    for (const int j : c.function->row_joints) joints.push_back(std::to_string(j));
    lists += numbered_list("inline constexpr int " + c.kernel + "_joints[]", joints);
    rows.push_back(
        {quoted(c.function->name), task_of(target.task), c.function->left_frame, c.function->right_frame,
         c.kernel + "_joints", static_cast<int>(joints.size()), c.function->program.outputs.front().columns,
         element_of(api.library->tree, target.task.given), all, place_of("::branch"), place_of("::configuration"),
         place_of("::redundancy")});
    if (target.task.tolerance > 0.0) rows.back().push_back(print_double(target.task.tolerance));
  }
  Table result = table("InverseKinematics", "kInverseKinematics", rows);
  result.definition = paragraphs({lists, result.definition});
  return result;
}

}  // namespace robcogen::backend::cpp
