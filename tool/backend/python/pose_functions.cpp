#include <algorithm>

#include "backend/common/meaning.h"
#include "backend/python/functions.h"
#include "support/concat.h"

namespace robcogen::backend::python {
namespace {

using symbolic::Role;

constexpr const char* kHeader = "robcogen::python::";

Array vector(const std::string& name, int rows, const std::string& text) {
  Array a{name, 1, rows};
  a.meaning = text;
  return a;
}

Array pose(const std::string& name) {
  Array a = vector(name, 7, meaning(Role::base_pose));
  a.quaternions = {0};
  return a;
}

bool reads_pose(const cpp::Callable& c) {
  const std::vector<symbolic::InputArray>& inputs = c.function->program.inputs;
  return std::any_of(inputs.begin(), inputs.end(), [](const auto& i) { return i.role == Role::base_pose; });
}

std::vector<Function> conversions() {
  Array qpos = vector("qpos", 7, "position (m), then the unit quaternion w, x, y, z: qpos[:7] of MuJoCo");
  qpos.quaternions = {3};
  const Array position = vector("position", 3, "base origin in the world (m)");
  Array orientation = vector("orientation", 4, "unit quaternion x, y, z, w from base axes to world axes");
  orientation.quaternions = {0};
  return {
      {"",
       "base_pose_from_mujoco",
       {},
       {qpos},
       {pose("base_pose")},
       1,
       {"The pose of the base from the first seven positions of MuJoCo's free joint."},
       "",
       "from_mujoco"},
      {"",
       "base_pose_to_mujoco",
       {},
       {pose("base_pose")},
       {qpos},
       1,
       {"The first seven positions of MuJoCo's free joint from the pose of the base."},
       "",
       "to_mujoco"},
      {"",
       "base_pose_from_ros",
       {},
       {position, orientation},
       {pose("base_pose")},
       2,
       {"The pose of the base from the elements of a geometry_msgs/Pose of ROS. Pinocchio has the same order in "
        "q[:7]."},
       "",
       "from_ros"},
      {"",
       "base_pose_to_ros",
       {},
       {pose("base_pose")},
       {position, orientation},
       1,
       {"The elements of a geometry_msgs/Pose of ROS from the pose of the base."},
       "",
       "to_ros"}};
}

Function gravity() {
  return {
      "",
      "gravity_in_base",
      {},
      {pose("base_pose"), vector("gravity", 3, "gravity (m/s^2) in world axes")},
      {vector("gravity_in_base", 3, "gravity (m/s^2) in base coordinates")},
      1,
      {"Gravity as the functions of a robot with a floating base take it."},
      "",
      "gravity_in_base"};
}

// The positions and the velocity of all joints, under these names.
Array positions(const Library& library, const std::string& name) {
  Array q = vector(name, library.tree.position_count(), meaning(Role::joint_position));
  q.quaternions = model::quaternions(library.tree);
  return q;
}
Array velocities(const Library& library, const std::string& name) {
  return vector(name, library.tree.dof(), meaning(Role::joint_velocity));
}

std::vector<Function> integration(const Library& library) {
  std::vector<std::string> numbers = {std::to_string(library.tree.dof())};
  for (const int first : model::quaternions(library.tree)) numbers.push_back(std::to_string(first));
  const std::string joints = "robcogen::python::Joints<" + joined(numbers) + ">";
  const Array twist = vector("base_velocity", 6, meaning(Role::base_velocity));
  const Array step = {"dt", 0, 1, 1, 1, false, false, {}, "time (s)"};
  return {
      {"",
       "integrate",
       {},
       {positions(library, "q"), velocities(library, "qd"), pose("base_pose"), twist, step},
       {positions(library, "q"), pose("base_pose")},
       5,
       {"The positions and the pose after a motion with constant velocities for dt: the base follows an exact screw "
        "motion."},
       "",
       joints + "::integrate"},
      {"",
       "difference",
       {},
       {positions(library, "q_from"), positions(library, "q_to"), pose("pose_from"), pose("pose_to")},
       {velocities(library, "qd"), twist},
       4,
       {"The constant velocities that lead from one position and pose to the other in one second, with rotations of at "
        "most",
        "half a turn: the inverse of integrate."},
       "",
       joints + "::difference"}};
}

}  // namespace

std::vector<Function> pose_functions(const cpp::Api& api) {
  const Library& library = *api.library;
  std::vector<Function> result;
  if (library.tree.floating_base || std::any_of(api.callables.begin(), api.callables.end(), reads_pose)) {
    result = conversions();
    result.push_back(gravity());
  }
  // Joints that follow others through loops move by close_loops.
  if (library.tree.floating_base && library.tree.followers_in_q().empty())
    for (Function& f : integration(library)) result.push_back(std::move(f));
  for (Function& f : result)
    if (f.call.rfind(kHeader, 0) != 0) f.call = kHeader + f.call;
  return result;
}

}  // namespace robcogen::backend::python
