#include "algorithm/kinematics/loop_functions.h"

#include "algorithm/kinematics/all_joints.h"
#include "algorithm/kinematics/chain_columns.h"
#include "algorithm/kinematics/path.h"
#include "algorithm/spatial/closures.h"
#include "model/named_frame.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

model::FramePair frames_of(const model::KinematicTree& tree, const model::LoopJoint& loop) {
  return model::frame_pair(tree, loop.ends[0].frame, loop.ends[1].frame);
}

// The second frame of a loop in its first one.
PathPose second_in_first(Trace& trace, const model::LoopJoint& loop, const std::vector<Expression>& q) {
  const Path path = path_between(trace.tree, frames_of(trace.tree, loop));
  return walk(trace, path, q, [](const PathSegment&, const PathPose&) {});
}

bool fixes_axes(model::LoopType type) {
  return type == model::LoopType::slider || type == model::LoopType::weld;
}

// The axis of the rotation of the second frame in the first one, times the sine of its angle.
Vector3 turn_of(const Matrix3& R) {
  Vector3 turn;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    turn[i] = 0.5 * (R[k][j] - R[j][k]);
  }
  return turn;
}

// The rows of a position; for a slider only those across its axis.
std::vector<Expression> of_point(model::LoopType type, const Vector3& p) {
  if (type == model::LoopType::slider) return {p[0], p[1]};
  return {p[0], p[1], p[2]};
}

std::vector<Expression> error_of(Trace& trace, const model::LoopJoint& loop, const std::vector<Expression>& q) {
  const PathPose second = second_in_first(trace, loop, q);
  const Vector3& p = second.position;
  if (loop.type == model::LoopType::distance) return {sqrt(dot(p, p)) - trace.lift(loop.length)};
  std::vector<Expression> rows = of_point(loop.type, p);
  if (loop.type == model::LoopType::hinge) {
    const Vector3 axis = column(second.rotation, 2);
    rows.insert(rows.end(), {axis[0], axis[1]});
  }
  if (fixes_axes(loop.type)) {
    const Vector3 turn = turn_of(second.rotation);
    rows.insert(rows.end(), turn.element.begin(), turn.element.end());
  }
  return rows;
}

// The columns of the rows of a loop, by joint of the chain.
std::vector<std::vector<Expression>> columns_of(
    Trace& trace,
    const model::LoopJoint& loop,
    const std::vector<Expression>& q,
    std::vector<int>& joints) {
  const ChainColumns chain = chain_columns(trace, q, frames_of(trace.tree, loop), JacobianReference::in_left);
  joints = chain.joints;
  std::vector<std::vector<Expression>> result;
  if (loop.type == model::LoopType::distance) {
    const Vector3& p = chain.point;
    const Vector3 direction = (trace.graph.one() / sqrt(dot(p, p))) * p;
    for (const Motion& column : chain.columns) result.push_back({dot(direction, column.linear)});
    return result;
  }
  const bool has_axes = loop.type != model::LoopType::point;
  const Matrix3 R = has_axes ? second_in_first(trace, loop, q).rotation : Matrix3();
  const Expression sum = has_axes ? R[0][0] + R[1][1] + R[2][2] : Expression();
  for (const Motion& motion : chain.columns) {
    const Vector3& w = motion.angular;
    std::vector<Expression>& rows = result.emplace_back(of_point(loop.type, motion.linear));
    if (loop.type == model::LoopType::hinge) {
      const Vector3 turned = cross(w, column(R, 2));
      rows.insert(rows.end(), {turned[0], turned[1]});
    }
    if (fixes_axes(loop.type)) {
      // The rate of R is w x R.
      const Vector3 rate = trace.graph.constant(0.5) * (sum * w - multiply(R, w));
      rows.insert(rows.end(), rate.element.begin(), rate.element.end());
    }
  }
  return result;
}

}  // namespace

int rows_of(model::LoopType type) {
  switch (type) {
    case model::LoopType::point:
      return 3;
    case model::LoopType::hinge:
    case model::LoopType::slider:
      return 5;
    case model::LoopType::weld:
      return 6;
    case model::LoopType::distance:
      break;
  }
  return 1;
}

Program loop_error(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  const std::vector<Expression> q = input_of_all_joints(trace, tree, "positions");
  std::vector<Expression> errors;
  for (const model::LoopJoint& loop : tree.loops)
    for (const Expression& row : error_of(trace, loop, q)) errors.push_back(row);
  trace.output("error", Role::value, errors);
  return trace.program(name);
}

Program loop_jacobian(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  const std::vector<Expression> q = input_of_all_joints(trace, tree, "positions");
  Columns by_joint(tree.joints.size());
  std::size_t first = 0;
  for (const model::LoopJoint& loop : tree.loops) {
    std::vector<int> joints;
    const auto columns = columns_of(trace, loop, q, joints);
    first += at(rows_of(loop.type));
    for (std::size_t k = 0; k < joints.size(); ++k)
      by_joint[at(joints[k])].insert(by_joint[at(joints[k])].end(), columns[k].begin(), columns[k].end());
    for (std::vector<Expression>& column : by_joint) column.resize(first);
  }
  Columns columns;
  for (const int joint : model::independent_joints_first(tree)) columns.push_back(by_joint[at(joint)]);
  trace.output("K", Role::matrix, static_cast<int>(first), columns);
  return trace.program(name);
}

// From within about 0.05 rad, four steps leave only rounding errors. If they do not close the loop, which may be
// impossible, the last root is that of a negative number: NaN.
Program close_loops(const model::KinematicTree& tree, const std::string& name) {
  constexpr int kSteps = 4;
  constexpr double kOpen = 1e-5;  // m, rad
  Trace trace(tree);
  std::vector<Expression> q = trace.joint_input("q", Role::joint_position);
  for (const model::Closure& closure : tree.closures) {
    if (closure.method != model::Closure::Method::iterative) continue;
    const std::string& loop = tree.loops[at(closure.loop())].name;
    for (int step = 0; step < kSteps; ++step) {
      trace.section(loop, "loop " + loop + ": step " + std::to_string(step + 1));
      newton_step(trace, closure, q);
    }
    trace.section(loop, "loop ", ": check of closure");
    Expression left = trace.graph.constant(kOpen * kOpen);
    for (const Expression& row : open_rows(trace, closure, q)) left -= row * row;
    const Expression root = sqrt(left), is_closed = root / root;
    for (const int joint : closure.dependents) q[at(joint)] = is_closed * q[at(joint)];
  }
  trace.output("q", Role::value, trace.positions(q));
  return trace.program(name);
}

symbolic::FollowerRates follower_rates(const model::KinematicTree& tree) {
  const std::vector<int> dependents = tree.followers_in_q();
  if (dependents.empty()) return std::nullopt;
  Trace trace(tree);
  trace.joint_input("q", Role::joint_position);
  Columns columns(at(tree.dof()), std::vector<Expression>(dependents.size()));
  for (std::size_t row = 0; row < dependents.size(); ++row)
    for (const RateTerm& share : trace.rates_of(*tree.coupling_of(dependents[row])))
      columns[at(tree.coordinate_of(share.joint))][row] = share.factor;
  trace.output("rates", Role::matrix, static_cast<int>(dependents.size()), columns);
  return trace.program("follower_rates");
}

Program joint_velocities(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  trace.joint_input("q", Role::joint_position);
  output_of_all_joints(trace, tree, "velocities", trace.joint_input("qd", Role::joint_velocity));
  return trace.program(name);
}

Program joint_accelerations(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  trace.joint_input("q", Role::joint_position);
  trace.joint_input("qd", Role::joint_velocity);
  output_of_all_joints(trace, tree, "accelerations", trace.joint_input("qdd", Role::joint_acceleration));
  return trace.program(name);
}

}  // namespace robcogen::algorithm
