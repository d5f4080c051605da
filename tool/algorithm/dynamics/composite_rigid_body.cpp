#include "algorithm/dynamics/composite_rigid_body.h"

#include <functional>

#include "algorithm/dynamics/drives.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/ldl.h"
#include "algorithm/spatial/couplings.h"
#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// The mass properties of all links that a joint moves, about the origin of the joint's parent and in its axes.
MassProperties in_parent_of(const TracedRobot& robot, const Joint& joint, const MassProperties& composite) {
  return described(in_parent(robot.link_name(joint.child)), to_parent(robot.pose(joint.index), composite));
}

void collect(const TracedRobot& robot, int link, std::vector<MassProperties>& composite) {
  const auto l = at(link);
  composite[l] = robot.mass(link);
  for (const Joint& joint : robot.children(link)) {
    collect(robot, joint.child, composite);
    if (!robot.parent_matters(joint.child)) continue;
    const std::string& name = robot.link_name(link);
    robot.trace.section(name, "link ", ": composite inertia");
    composite[l] = composite[l] + in_parent_of(robot, joint, composite[at(joint.child)]);
  }
  named(robot.link_name(link), composite[l]);
}

}  // namespace

std::vector<MassProperties> composite_bodies(const TracedRobot& robot) {
  std::vector<MassProperties> composite(robot.tree().links.size());
  collect(robot, 0, composite);
  return composite;
}

MassProperties moving_body(const TracedRobot& robot, const std::vector<MassProperties>& composite) {
  if (robot.floating()) return composite[0];
  MassProperties total;
  for (const Joint& joint : robot.children(0)) total = total + in_parent_of(robot, joint, composite[at(joint.child)]);
  return described("robot", total);
}

Motion free_acceleration(const SpatialInertia& body, const Force& missing) {
  std::vector<Expression> right;
  for (const Expression& e : missing.moment.element) right.push_back(-e);
  for (const Expression& e : missing.linear.element) right.push_back(-e);
  const std::vector<Expression> a = solve(matrix(body), std::move(right), {"wx", "wy", "wz", "vx", "vy", "vz"});
  return {{a[0], a[1], a[2]}, {a[3], a[4], a[5]}};
}

void add_composite_forces(
    const TracedRobot& robot,
    const std::vector<MassProperties>& composite,
    const Motion& base_acceleration,
    std::vector<Expression>& tau) {
  const std::function<void(int, const Motion&)> descend = [&](int link, const Motion& parent) {
    for (const TracedRotor& rotor : rotors_on(robot, link)) tau[at(rotor.joint)] += dot(rotor.momentum, parent.angular);
    for (const Joint& joint : robot.children(link)) {
      const std::string& name = robot.link_name(joint.child);
      robot.trace.section(name, "link ", ": share of the base acceleration");
      const Motion a = described_acceleration(name, to_child(robot.pose(joint.index), parent));
      tau[at(joint.index)] += dot(times_subspace(composite[at(joint.child)], joint), a);
      descend(joint.child, a);
    }
  };
  descend(0, base_acceleration);
}

namespace {

std::vector<int> joints_of(const model::KinematicTree& tree) {
  std::vector<int> all;
  for (int j = 0; j < static_cast<int>(tree.joints.size()); ++j) all.push_back(j);
  return all;
}

// Names of the rows of a floating base, then of the rows of these joints.
std::vector<std::string> names_of_rows(const model::KinematicTree& tree, const std::vector<int>& joints) {
  std::vector<std::string> names;
  if (tree.floating_base) names = {"wx", "wy", "wz", "vx", "vy", "vz"};
  for (const int joint : joints) names.push_back(tree.joints[at(joint)].name);
  return names;
}

// Reduces the matrix from joints to coordinates.
SquareMatrix reduced(const TracedRobot& robot, const SquareMatrix& by_joint) {
  if (robot.tree().couplings.empty()) return by_joint;
  robot.trace.section("coupled", "inertia of coupled joints");
  const SquareMatrix H = by_coordinate(robot.trace, by_joint, robot.floating() ? 6 : 0, Symmetry::symmetric);
  const std::vector<std::string> names = coordinate_names(robot.tree());
  for (int r = 0; r < H.size(); ++r)
    for (int c = 0; c <= r; ++c) described(coordinates("H", names[at(r)], names[at(c)]), H(r, c));
  return H;
}

}  // namespace

SquareMatrix inertia_by_joint(const TracedRobot& robot) {
  const model::KinematicTree& tree = robot.tree();
  const std::vector<MassProperties> composite = composite_bodies(robot);
  const int base = tree.floating_base ? 6 : 0;
  const int joints = static_cast<int>(tree.joints.size());
  SquareMatrix H(base + joints);
  const std::vector<std::string> names = joint_names(tree);
  const auto set = [&](int row, int column, const Expression& value) {
    H(row, column) = H(column, row) = described(coordinates("H", names[at(row)], names[at(column)]), value);
  };
  for (int j = 0; j < joints; ++j) {
    Joint joint = robot.joint(j);
    const std::string& link = robot.link_name(joint.child);
    robot.trace.section(link, {"link ", link, ": column of joint ", tree.joints[at(j)].name});
    Force wrench = times_subspace(composite[at(joint.child)], joint);
    while (true) {
      const Expression own = joint.index == j ? drive_inertia(robot.trace, j) : Expression();
      set(base + joint.index, base + j, project(joint, wrench) + own);
      described(at_link(tree.joints[at(j)].name, robot.link_name(joint.child)), wrench);
      if (!robot.parent_matters(joint.child)) break;
      wrench = to_parent(robot.pose(joint.index), wrench);
      wrench.moment += rotor_momentum(robot, j, tree.joints[at(joint.index)].parent);
      const int parent = tree.parent_joint_of(joint.index);
      if (parent < 0) break;
      joint = robot.joint(parent);
    }
    if (!tree.floating_base) continue;
    for (int k = 0; k < 3; ++k) {
      set(k, base + j, wrench.moment[at(k)]);
      set(3 + k, base + j, wrench.linear[at(k)]);
    }
  }
  for (int j = 0; j < joints; ++j) {
    Vector3 momentum = rotor_momentum(robot, j);
    for (const int passed : rotor_path(tree, j).joints) {
      const Expression share = project(robot.joint(passed), Force{momentum, {}});
      set(base + passed, base + j, H(base + passed, base + j) + (passed == j ? share + share : share));
      momentum = to_parent(robot.pose(passed).rotation, momentum);
    }
  }
  if (tree.floating_base) {
    const SquareMatrix body = matrix(rigid_body_inertia(composite[0]));
    for (int r = 0; r < 6; ++r)
      for (int c = 0; c < 6; ++c) H(r, c) = body(r, c);
  }
  return H;
}

SquareMatrix joint_space_inertia(const TracedRobot& robot) {
  return reduced(robot, inertia_by_joint(robot));
}

std::vector<std::string> joint_names(const model::KinematicTree& tree) {
  return names_of_rows(tree, joints_of(tree));
}

std::vector<std::string> coordinate_names(const model::KinematicTree& tree) {
  return names_of_rows(tree, tree.coordinates());
}

void trace_joint_space_inertia(Trace& trace, const Formulation& formulation) {
  const StateInputs in(trace, {State::position});
  const SquareMatrix H = joint_space_inertia(TracedRobot(trace, in.q, formulation));
  trace.output("H", Role::inertia_matrix, H.size(), H.size(), H.columns());
}

Program joint_space_inertia(const model::KinematicTree& tree, const std::string& name, const Formulation& formulation) {
  Trace trace(tree);
  trace_joint_space_inertia(trace, formulation);
  return trace.program(name);
}

}  // namespace robcogen::algorithm
