// The velocity of a point by the coordinates of a robot.
#include "algorithm/kinematics/chain_columns.h"
#include "algorithm/kinematics/path.h"
#include "algorithm/spatial/couplings.h"
#include "algorithm/spatial/named.h"
#include "symbolic/cost.h"

namespace robcogen::algorithm {
namespace {

std::vector<Vector3> from_base(Trace& trace, const std::vector<Expression>& q, const model::FramePair& frames) {
  std::vector<Vector3> columns;
  for (const Motion& column : columns_with_base(trace, q, frames)) columns.push_back(column.linear);
  return columns;
}

std::vector<Vector3> from_point(Trace& trace, const std::vector<Expression>& q, const model::FramePair& frames) {
  const model::KinematicTree& tree = trace.tree;
  const Path path = path_between(tree, frames);
  Vector3 point;  // from the origin of the frame reached, in its axes, as the columns of the joints behind it are
  std::vector<int> passed;
  std::vector<Vector3> by_joint(tree.joints.size());
  for (auto segment = path.rbegin(); segment != path.rend(); ++segment) {
    for (const JointOnPath& on_path : segment->joints) {
      const Motion S = subspace(joint_of(trace, on_path.joint), trace.graph);
      by_joint[at(on_path.joint)] = S.linear + cross(S.angular, point);
      passed.push_back(on_path.joint);
    }
    const Pose pose = pose_of(trace, *segment, q);
    point[2] += pose.slide;
    const std::string& name = segment->subject.empty() ? frames.right.name : segment->subject;
    point = described("p", name, pose.offset + to_parent(pose.rotation, point));
    for (const int joint : passed) {
      const Label column = at_link(tree.joints[at(joint)].name, name);
      by_joint[at(joint)] = described("J", column, to_parent(pose.rotation, by_joint[at(joint)]));
    }
  }
  std::vector<Vector3> columns;
  if (tree.floating_base) {
    for (std::size_t k = 0; k < 3; ++k) columns.push_back(cross(unit_vector(trace.graph, k), point));
    for (std::size_t k = 0; k < 3; ++k) columns.push_back(unit_vector(trace.graph, k));
  }
  for (const std::vector<MovedJoint>& moved : moved_joints(trace))
    columns.push_back(sum_of(moved, [&](int joint) { return by_joint[at(joint)]; }));
  return columns;
}

int work_of(
    std::vector<Vector3> (*make)(Trace&, const std::vector<Expression>&, const model::FramePair&),
    const model::KinematicTree& tree,
    const model::FramePair& frames) {
  Trace trace(tree);
  std::vector<Expression> values;
  for (const Vector3& column : make(trace, trace.joint_input("q", symbolic::Role::joint_position), frames))
    values.insert(values.end(), column.element.begin(), column.element.end());
  trace.output("columns", symbolic::Role::value, values);
  return symbolic::work(trace.program("columns"));
}

}  // namespace

std::vector<Vector3> point_columns(Trace& trace, const std::vector<Expression>& q, const model::FramePair& frames) {
  const bool is_back = work_of(from_point, trace.tree, frames) <= work_of(from_base, trace.tree, frames);
  return is_back ? from_point(trace, q, frames) : from_base(trace, q, frames);
}

}  // namespace robcogen::algorithm
