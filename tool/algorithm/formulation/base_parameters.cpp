#include "algorithm/formulation/base_parameters.h"

#include <algorithm>

namespace robcogen::algorithm {
namespace {

// The mass properties of a rod on the joint's axis z, in the parent: mass m at the point p of the axis, moment b and
// pseudo-inertia s along the axis:
//     m += m,   h += m p + b z,   S += m p p' + b (p z' + z p') + s z z'.
MassProperties rod(const Vector3& p, const Vector3& z, const MassProperties& child) {
  const Expression& b = child.first_moment[2];
  const Expression& s = child.pseudo_inertia[2][2];
  MassProperties result;
  result.mass = child.mass;
  Vector3 half;  // with S = half p' + p half' + s z z'
  for (std::size_t i = 0; i < 3; ++i) {
    result.first_moment[i] = sum_of_products(child.mass, p[i], b, z[i]);
    half[i] = sum_of_products(0.5 * child.mass, p[i], b, z[i]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      Expression& e = result.pseudo_inertia[i][j];
      e = sum_of_products(half[i], p[j], p[i], half[j]);
      e += (s * z[i]) * z[j];
      result.pseudo_inertia[j][i] = e;
    }
  }
  return result;
}

// Removes from the child the mass properties that a revolute joint does not feel, and returns the parent's share.
MassProperties take_revolute(Trace& trace, const Pose& pose, MassProperties& child) {
  const Expression zero;
  const Vector3 z = to_parent(pose.rotation, {zero, zero, trace.graph.one()});
  const MassProperties share = rod(pose.offset + pose.slide * z, z, child);
  child.mass = child.first_moment[2] = child.pseudo_inertia[2][2] = zero;
  return share;
}

// A spherical joint does not feel a mass at its centre: the mass of the child goes to the parent there, and the child
// keeps its moments about the centre.
MassProperties take_spherical(const Pose& pose, MassProperties& child) {
  const Vector3& p = pose.offset;
  MassProperties share;
  share.mass = child.mass;
  share.first_moment = child.mass * p;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j)
      share.pseudo_inertia[i][j] = share.pseudo_inertia[j][i] = share.first_moment[i] * p[j];
  child.mass = Expression();
  return share;
}

// A helical joint also moves the mass along its axis, so only the second moment along the axis goes to the parent.
MassProperties take_helical(Trace& trace, const Pose& pose, MassProperties& child) {
  const Expression zero;
  MassProperties on_axis;
  on_axis.pseudo_inertia[2][2] = child.pseudo_inertia[2][2];
  child.pseudo_inertia[2][2] = zero;
  return rod({}, to_parent(pose.rotation, {zero, zero, trace.graph.one()}), on_axis);
}

MassProperties take_prismatic(const Pose& pose, MassProperties& child) {
  MassProperties share;
  share.pseudo_inertia = symmetric_to_parent(pose.rotation, child.pseudo_inertia);
  child.pseudo_inertia = {};
  return share;
}

MassProperties take(Trace& trace, model::JointType type, const Pose& pose, MassProperties& child) {
  switch (type) {
    case model::JointType::revolute:
      break;
    case model::JointType::prismatic:
      return take_prismatic(pose, child);
    case model::JointType::helical:
      return take_helical(trace, pose, child);
    case model::JointType::spherical:
      return take_spherical(pose, child);
  }
  return take_revolute(trace, pose, child);
}

}  // namespace

std::vector<MassProperties> with_base_parameters(
    Trace& trace,
    const std::vector<Pose>& poses,
    std::vector<MassProperties> masses) {
  const model::KinematicTree& tree = trace.tree;
  std::vector<int> from_leaves = tree.topological();
  std::reverse(from_leaves.begin(), from_leaves.end());
  for (int j : from_leaves) {
    const model::Joint& joint = tree.joints[static_cast<std::size_t>(j)];
    if (!joint.is_first()) continue;
    const Pose& pose = poses[static_cast<std::size_t>(j)];
    const std::string& name = tree.links[static_cast<std::size_t>(joint.child)].name;
    trace.section(name, "link ", ": base inertial parameters");
    // The child of a spherical joint is behind its last component.
    const int link = joint.spherical.empty() ? joint.child : tree.joints[static_cast<std::size_t>(j) + 2].child;
    MassProperties& child = masses[static_cast<std::size_t>(link)];
    const MassProperties share = take(trace, joint.type, pose, child);
    if (joint.parent == 0 && !tree.floating_base) continue;
    MassProperties& parent = masses[static_cast<std::size_t>(joint.parent)];
    parent = parent + share;
  }
  return masses;
}

}  // namespace robcogen::algorithm
