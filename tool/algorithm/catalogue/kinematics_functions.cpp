#include <functional>

#include "algorithm/catalogue/groups.h"
#include "algorithm/kinematics/kinematics.h"
#include "algorithm/kinematics/path.h"
#include "algorithm/kinematics/transform_kinds.h"
#include "support/parallel.h"

namespace robcogen::algorithm {

using model::KinematicTree;

namespace {

// One function for each desired Jacobian: `fr_base_<letter>_fr_foot`. Names of programs begin with `prefix`, because
// several scopes may have functions of the same name.
using BuildBetween = std::function<symbolic::Program(const model::FramePair& frames, const std::string& name)>;

void add_for_jacobians(
    std::vector<RobotFunction>& list,
    const KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group,
    const std::string& scope,
    const std::string& letter,
    const std::function<std::string(const std::string& left, const std::string& right)>& summary,
    const BuildBetween& build,
    const std::string& prefix = "") {
  for (const model::FramePair& pair : desired.jacobians) {
    const std::string name = pair.left.name + "_" + letter + "_" + pair.right.name;
    symbolic::Program program = build(pair, prefix + name);
    const bool has_columns = symbolic::is_jacobian(program.outputs.front().role);
    list.push_back(
        {group,
         scope,
         name,
         {summary(pair.left.name, pair.right.name)},
         has_columns ? chain_coordinates(tree, pair) : std::vector<int>{},
         pair,
         std::move(program)});
  }
}

// Positions of robots with spherical joints cannot simply be added. If q has followers, their loops would have to be
// closed as well.
void add_functions_of_quaternions(std::vector<RobotFunction>& list, const KinematicTree& tree) {
  if (tree.spherical_joints().empty() || !tree.followers_in_q().empty()) return;
  list.push_back(
      {"transforms",
       "",
       "integrate_positions",
       {"Joint positions after one second at constant velocities qd, or after another time if qd is multiplied by it.",
        "Spherical joints rotate about a fixed axis, exactly; the resulting quaternions have unit length."},
       {},
       {},
       integrate_positions(tree, "integrate_positions")});
  list.push_back(
      {"transforms",
       "",
       "position_difference",
       {"The constant velocities that lead from one position to another in one second: the inverse of "
        "integrate_positions.",
        "A spherical joint takes the shorter path, of at most half a turn."},
       {},
       {},
       position_difference(tree, "position_difference")});
}

}  // namespace

std::vector<RobotFunction> transforms_functions(const KinematicTree& tree, const model::DesiredTransforms& desired) {
  const model::RigidMotions motions = model::motions_of(tree);
  const model::MotionGraph graph(motions);
  std::vector<Path> paths;
  for (const model::FramePair& pair : desired.transforms) paths.push_back(path_between(tree, graph, pair));
  const std::vector<TransformKind> kinds = transform_kinds();
  std::vector<RobotFunction> list(kinds.size() * paths.size());
  for_each_index(list.size(), [&](std::size_t k) {
    const TransformKind& kind = kinds[k / paths.size()];
    const std::size_t i = k % paths.size();
    const model::FramePair& pair = desired.transforms[i];
    const std::string name = pair.left.name + "_X_" + pair.right.name;
    list[k] = {
        "transforms",
        "transforms::" + kind.scope,
        name,
        {kind.summary(pair.left.name, pair.right.name)},
        {},
        pair,
        transform_along(tree, paths[i], kind.form, kind.scope + "_" + name)};
  });
  add_joint_positions(list, tree);
  add_actuator_lengths(list, tree);
  add_loop_errors(list, tree);
  add_functions_of_quaternions(list, tree);
  return list;
}

std::vector<RobotFunction> jacobians_functions(const KinematicTree& tree, const model::DesiredTransforms& desired) {
  std::vector<RobotFunction> list;
  add_for_jacobians(
      list, tree, desired, "jacobians", "jacobians", "J",
      [](const std::string& left, const std::string& right) {
        return "Geometric Jacobian: angular velocity of " + right + " and velocity of its origin, with respect to " +
               left + " and in its axes; angular rows first (Siciliano et al. 2009, ch. 3).";
      },
      [&](const model::FramePair& pair, const std::string& name) { return geometric_jacobian(tree, pair, name); });
  add_lever_arms(list, tree);
  add_loop_jacobian(list, tree);
  return list;
}

std::vector<RobotFunction> jacobian_references_functions(
    const KinematicTree& tree,
    const model::DesiredTransforms& desired) {
  std::vector<RobotFunction> list;
  add_for_jacobians(
      list, tree, desired, "jacobian_references", "jacobians::in_target", "J",
      [](const std::string& left, const std::string& right) {
        return "Geometric Jacobian: angular velocity of " + right + " and velocity of its origin, with respect to " +
               left + ", in axes of " + right + "; angular rows first.";
      },
      [&](const model::FramePair& pair, const std::string& name) {
        return geometric_jacobian(tree, pair, name, JacobianReference::in_target);
      },
      "in_target_");
  add_for_jacobians(
      list, tree, desired, "jacobian_references", "jacobians::spatial", "J",
      [](const std::string& left, const std::string& right) {
        return "Spatial Jacobian: twist of " + right + " with respect to " + left + ", in coordinates of " + left +
               ": angular velocity, then velocity of the point of " + right + " that is at the origin of " + left +
               "; angular rows first (Featherstone 2008, ch. 2).";
      },
      [&](const model::FramePair& pair, const std::string& name) {
        return geometric_jacobian(tree, pair, name, JacobianReference::spatial);
      },
      "spatial_");
  return list;
}

// For pairs whose left frame is on the base: from others, the base is seen to move.
std::vector<RobotFunction> jacobians_with_base_functions(
    const KinematicTree& tree,
    const model::DesiredTransforms& desired) {
  const std::string columns = tree.floating_base
                                  ? "6 x (6 + n): for the velocity (base twist in base coordinates, angular first; qd)."
                                  : "6 x n, all joints in the order of the model.";
  model::DesiredTransforms of_base;
  for (const model::FramePair& pair : desired.jacobians)
    if (tree.link_of(pair.left) == 0) of_base.jacobians.push_back(pair);
  std::vector<RobotFunction> list;
  const std::string group = "jacobians_with_base", scope = "jacobians::with_base";
  add_for_jacobians(
      list, tree, of_base, group, scope, "J",
      [&](const std::string& left, const std::string& right) {
        return "Jacobian with base columns: angular velocity of " + right +
               " and velocity of its origin in an inertial frame, in axes of " + left + "; angular rows first. " +
               columns;
      },
      [&](const model::FramePair& pair, const std::string& name) { return jacobian_with_base(tree, pair, name); },
      "with_base_");
  add_for_jacobians(
      list, tree, of_base, group, scope, "bias",
      [](const std::string& left, const std::string& right) {
        return "Bias of " + right +
               ": its angular acceleration (rad/s^2) and the acceleration of its origin (m/s^2) in an inertial frame, "
               "minus its Jacobian with base columns times (spatial base acceleration, qdd), in axes of " +
               left + ".";
      },
      [&](const model::FramePair& pair, const std::string& name) { return jacobian_with_base_bias(tree, pair, name); },
      "with_base_");
  return list;
}

std::vector<RobotFunction> jacobian_derivatives_functions(
    const KinematicTree& tree,
    const model::DesiredTransforms& desired) {
  std::vector<RobotFunction> list;
  add_for_jacobians(
      list, tree, desired, "jacobian_derivatives", "jacobians", "Jd",
      [](const std::string& left, const std::string& right) {
        return "Time derivative of the geometric Jacobian " + left + "_J_" + right + ", angular rows first.";
      },
      [&](const model::FramePair& pair, const std::string& name) { return jacobian_derivative(tree, pair, name); });
  add_for_jacobians(
      list, tree, desired, "jacobian_derivatives", "jacobians", "Jd_qd",
      [](const std::string& left, const std::string& right) {
        return "Time derivative of " + left + "_J_" + right +
               " times the joint velocities: the angular acceleration (rad/s^2) of " + right +
               " and the acceleration (m/s^2) of its origin minus " + left + "_J_" + right + " qdd, with respect to " +
               left + " and in its axes.";
      },
      [&](const model::FramePair& pair, const std::string& name) {
        return jacobian_derivative_times_velocity(tree, pair, name);
      });
  return list;
}

std::vector<RobotFunction> velocities_functions(const KinematicTree& tree, const model::DesiredTransforms& desired) {
  std::vector<RobotFunction> list;
  add_for_jacobians(
      list, tree, desired, "velocities", "velocities", "V",
      [](const std::string& left, const std::string& right) {
        return "Twist of " + right + " with respect to " + left + ", in coordinates of " + left +
               ": angular velocity (rad/s), then velocity (m/s) of the point of " + right +
               " that is at the origin of " + left + ".";
      },
      [&](const model::FramePair& pair, const std::string& name) { return frame_velocity(tree, pair, name); });
  return list;
}

std::vector<RobotFunction> accelerations_functions(const KinematicTree& tree, const model::DesiredTransforms& desired) {
  std::vector<RobotFunction> list;
  add_for_jacobians(
      list, tree, desired, "accelerations", "accelerations", "A",
      [](const std::string& left, const std::string& right) {
        return "Spatial acceleration of " + right + " with respect to " + left +
               ": the time derivative (rad/s^2, m/s^2) of its twist in coordinates of " + left +
               ", angular first (Featherstone 2008, ch. 2).";
      },
      [&](const model::FramePair& pair, const std::string& name) { return frame_acceleration(tree, pair, name); });
  return list;
}

}  // namespace robcogen::algorithm
