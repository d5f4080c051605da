#include "algorithm/kinematics/joint_poses.h"

#include <stdexcept>

#include "algorithm/kinematics/kinematics.h"
#include "model/rigid_motions.h"

namespace robcogen::algorithm {

std::vector<Pose> joint_poses(Trace& trace, const std::vector<Expression>& q) {
  const model::KinematicTree& tree = trace.tree;
  const model::RigidMotions motions = model::motions_of(tree);
  const model::MotionGraph graph(motions);
  std::vector<Pose> poses;
  for (const model::Joint& joint : tree.joints) {
    const std::string parent = tree.links[static_cast<std::size_t>(joint.parent)].name;
    const std::string child = tree.links[static_cast<std::size_t>(joint.child)].name;
    const auto transform = graph.transform_between("fr_" + parent, "fr_" + child);
    if (!transform) throw std::logic_error("the motions of a robot do not connect its links");
    trace.section(joint.name, "joint ", ": placement");
    poses.push_back(pose_of(trace, transform->primitives, q));
  }
  return poses;
}

std::vector<Pose> poses_at_rest(Trace& trace) {
  std::vector<Expression> q(trace.tree.joints.size());
  q.resize(q.size() + trace.tree.spherical_joints().size(), trace.graph.one());  // the scalar parts of quaternions
  return joint_poses(trace, q);
}

symbolic::Program joint_positions(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  const std::vector<Expression> q = trace.joint_input("q", symbolic::Role::joint_position);
  std::vector<Expression> positions;
  for (const int joint : model::independent_joints_first(tree)) positions.push_back(q[at(joint)]);
  trace.output("positions", symbolic::Role::value, positions);
  return trace.program(name);
}

}  // namespace robcogen::algorithm
