#include "algorithm/kinematics/actuators.h"

#include <set>

#include "algorithm/kinematics/chain_columns.h"
#include "algorithm/kinematics/path.h"
#include "algorithm/spatial/couplings.h"
#include "algorithm/spatial/named.h"
#include "algorithm/spatial/triangle.h"
#include "model/named_frame.h"

namespace robcogen::algorithm {
namespace {

using model::Frame;
using symbolic::Program;
using symbolic::Role;

model::FramePair frames_of(const model::KinematicTree& tree, const model::Actuator& actuator) {
  return model::frame_pair(tree, actuator.frames[0], actuator.frames[1]);
}

// By joint: the derivative of the length by its position.
using LeverArms = std::vector<Expression>;

// The actuators of a robot at the positions q, by joint.
class TracedActuators {
 public:
  TracedActuators(Trace& trace, const std::vector<Expression>& q) : trace_(trace), q_(q) {}

  // Appends one element per actuator to both lists. Lever arms are computed if `arms` is not nullptr.
  void add(const model::Actuator& actuator, std::vector<Expression>& lengths, std::vector<LeverArms>* arms) {
    trace_.section(actuator.name, "actuator " + actuator.name);
    const model::FramePair frames = frames_of(trace_.tree, actuator);
    std::vector<JointOnPath> joints;
    for (const PathSegment& segment : path_between(trace_.tree, frames))
      joints.insert(joints.end(), segment.joints.begin(), segment.joints.end());
    LeverArms made(trace_.tree.joints.size());
    const bool is_about_one_axis =
        joints.size() == 1 && trace_.tree.joints[at(joints.front().joint)].type == model::JointType::revolute;
    lengths.push_back(
        is_about_one_axis ? about_one_axis(frames, joints.front(), arms ? &made : nullptr)
                          : along_chain(frames, arms ? &made : nullptr));
    described("length", actuator.name, lengths.back());
    if (arms) arms->push_back(std::move(made));
  }

 private:
  Trace& trace_;
  const std::vector<Expression>& q_;

  // In the frame of the joint, one end is fixed and the other one turns: l^2 = A + B cos q + C sin q.
  Expression about_one_axis(const model::FramePair& frames, const JointOnPath& passed, LeverArms* arms) {
    const int joint = passed.joint, child = trace_.tree.joints[at(joint)].child;
    const model::FramePair ends = passed.backward ? model::FramePair{frames.right, frames.left} : frames;
    const Vector3 fixed = point_in(frame_of(Frame::Kind::joint, joint), ends.left);
    const Vector3 turning = point_in(frame_of(Frame::Kind::link, child), ends.right);
    const Expression along = fixed[2] - turning[2];
    const Vector2 a = {fixed[0], fixed[1]}, b = {turning[0], turning[1]};
    const Expression A = dot(a, a) + dot(b, b) + along * along;
    const Expression B = -2.0 * dot(b, a), C = -2.0 * cross(b, a);
    const Expression c = cos(q_[at(joint)]), s = sin(q_[at(joint)]);
    const Expression of_cosine = B * c, of_sine = C * s, square = A + of_cosine;
    const Expression length = sqrt(square + of_sine);
    if (arms) {
      const Expression across = C * c, aside = B * s, half = trace_.graph.constant(0.5);
      (*arms)[at(joint)] = (half / length) * (across - aside);
    }
    return length;
  }

  Expression along_chain(const model::FramePair& frames, LeverArms* arms) {
    const ChainColumns chain = chain_columns(trace_, q_, frames, JacobianReference::in_left);
    const Expression length = sqrt(dot(chain.point, chain.point));
    if (!arms) return length;
    const Expression reciprocal = trace_.graph.one() / length;
    const Vector3 direction = reciprocal * chain.point;
    for (std::size_t k = 0; k < chain.joints.size(); ++k)
      (*arms)[at(chain.joints[k])] = dot(direction, chain.columns[k].linear);
    return length;
  }

  Frame frame_of(Frame::Kind kind, int index) const {
    const std::string& name =
        kind == Frame::Kind::joint ? trace_.tree.joints[at(index)].name : trace_.tree.links[at(index)].name;
    return {kind, index, model::implicit_frame_name(name)};
  }

  // The origin of `other` in `frame`, in which it does not move.
  Vector3 point_in(const Frame& frame, const Frame& other) {
    const Path path = path_between(trace_.tree, {frame, other});
    return walk(trace_, path, q_, [](const PathSegment&, const PathPose&) {}).position;
  }
};

struct Lengths {
  std::vector<Expression> values;
  std::vector<LeverArms> arms;
};

Lengths with_lever_arms(Trace& trace, const std::vector<Expression>& q) {
  TracedActuators actuators(trace, q);
  Lengths result;
  for (const model::Actuator& actuator : trace.tree.actuators) actuators.add(actuator, result.values, &result.arms);
  return result;
}

Expression times(const LeverArms& arms, const std::vector<Expression>& rates) {
  Expression sum;
  for (std::size_t j = 0; j < arms.size(); ++j)
    if (!arms[j].is_zero()) sum += arms[j] * rates[j];
  return sum;
}

}  // namespace

Program actuator_lengths(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  const std::vector<Expression> q = trace.joint_input("q", Role::joint_position);
  TracedActuators actuators(trace, q);
  std::vector<Expression> lengths;
  for (const model::Actuator& actuator : tree.actuators) actuators.add(actuator, lengths, nullptr);
  trace.output("lengths", Role::value, lengths);
  return trace.program(name);
}

Program actuator_velocities(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  const std::vector<Expression> q = trace.joint_input("q", Role::joint_position);
  const std::vector<Expression> qd = trace.joint_input("qd", Role::joint_velocity);
  std::vector<Expression> velocities;
  for (const LeverArms& arms : with_lever_arms(trace, q).arms) velocities.push_back(times(arms, qd));
  trace.output("velocities", Role::value, velocities);
  return trace.program(name);
}

Program actuator_jacobian(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  const std::vector<Expression> q = trace.joint_input("q", Role::joint_position);
  Columns rows;
  for (const LeverArms& arms : with_lever_arms(trace, q).arms) rows.push_back(by_coordinate(trace, arms));
  Columns columns(at(tree.dof()));
  for (const std::vector<Expression>& row : rows)
    for (std::size_t k = 0; k < columns.size(); ++k) columns[k].push_back(row[k]);
  trace.output("J", Role::matrix, static_cast<int>(rows.size()), columns);
  return trace.program(name);
}

Program actuator_torques(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  const std::vector<Expression> q = trace.joint_input("q", Role::joint_position);
  const std::vector<Expression> forces = trace.input("forces", Role::value, model::names_of(tree.actuators));
  const std::vector<LeverArms> arms = with_lever_arms(trace, q).arms;
  std::vector<Expression> tau(tree.joints.size());
  for (std::size_t k = 0; k < arms.size(); ++k)
    for (std::size_t j = 0; j < tau.size(); ++j)
      if (!arms[k][j].is_zero()) tau[j] += arms[k][j] * forces[k];
  trace.output("tau", Role::joint_force, by_coordinate(trace, tau));
  return trace.program(name);
}

namespace {

// The coordinates that move each actuator.
std::vector<std::vector<int>> coordinates_of_actuators(const model::KinematicTree& tree) {
  std::vector<std::vector<int>> result;
  for (const model::Actuator& actuator : tree.actuators)
    result.push_back(chain_coordinates(tree, frames_of(tree, actuator)));
  return result;
}

}  // namespace

bool drives_separate_coordinates(const model::KinematicTree& tree) {
  Trace trace(tree);
  const std::vector<Expression> q = trace.joint_input("q", Role::joint_position);
  const std::vector<LeverArms> arms = with_lever_arms(trace, q).arms;
  const std::vector<std::vector<int>> coordinates = coordinates_of_actuators(tree);
  std::set<int> moved;
  for (std::size_t k = 0; k < arms.size(); ++k) {
    const std::vector<int>& own = coordinates[k];
    if (own.size() != 1 || !moved.insert(own.front()).second) return false;
    // An actuator with an end on the axis of its joint has no lever arm.
    if (by_coordinate(trace, arms[k])[at(own.front())].is_zero()) return false;
  }
  return true;
}

Program actuator_forces(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  const std::vector<Expression> q = trace.joint_input("q", Role::joint_position);
  const std::vector<Expression> tau = trace.coordinate_input("tau", Role::joint_force);
  const std::vector<std::vector<int>> coordinates = coordinates_of_actuators(tree);
  const std::vector<LeverArms> arms = with_lever_arms(trace, q).arms;
  std::vector<Expression> forces;
  for (std::size_t k = 0; k < arms.size(); ++k) {
    const auto coordinate = at(coordinates[k].front());
    forces.push_back(tau[coordinate] / by_coordinate(trace, arms[k])[coordinate]);
  }
  trace.output("forces", Role::value, forces);
  return trace.program(name);
}

}  // namespace robcogen::algorithm
