// Newton steps towards a target from joint positions near a solution: damped least squares with the pose and the
// Jacobian of the chain as it is, whatever its axes.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "algorithm/kinematics/inverse/target_loop.h"

namespace robcogen::algorithm::inversion {

// A further equation that the steps solve: what it misses at some positions, and its derivatives by the joints of the
// chain.
struct Condition {
  Expression missing;
  std::vector<Expression> derivatives;
};

class NewtonSteps {
 public:
  using ConditionAt = std::function<Condition(const JointValues&)>;

  NewtonSteps(Graph& graph, const SerialChain& chain, const Target& target, ConditionAt condition = {});

  // The values after one step. Joints whose positions are arguments stay where they are.
  JointValues step(const JointValues& values) const;

  // The root of the sum of squares of what the pose of these values misses: a distance (m) and a chord (rad).
  Expression misfit(const JointValues& values) const;

 private:
  // The frame of a joint has its z axis on that of the joint. With the joint it turns by a constant angle about z, so
  // that its x axis becomes perpendicular to the next axis too; then it is displaced, and turned about x onto that
  // axis.
  struct Link {
    double sine = 0.0, cosine = 1.0;            // of the angle about z
    Numbers3 displacement{};                    // in the frame that has turned by it
    double next_sine = 0.0, next_cosine = 1.0;  // of the angle about x
  };
  // In axes of the first frame.
  struct Posture {
    std::vector<Vector3> axes, origins;  // by joint
    std::array<Vector3, 3> columns;      // of the last frame
    Vector3 origin;
  };
  // The motion to the target: a rotation, and the displacement of a point.
  struct Missing {
    Vector3 rotation, displacement, point;
  };

  Graph& graph_;
  const SerialChain& chain_;
  ConditionAt condition_;
  std::vector<Link> links_;
  Numbers3 tool_point_{}, tool_axis_{};  // of the task, in the last frame
  // Where the target has the last frame, and point and axis of the task, in axes of the first frame.
  std::array<Vector3, 3> columns_;
  Vector3 origin_, point_, axis_;

  Vector3 constant(const Numbers3& v) const;
  // `v` in axes of a frame, as a combination of its columns.
  static Vector3 combined(const std::array<Vector3, 3>& columns, const Vector3& v);
  Posture posture(const JointValues& values) const;
  Missing missing(const Posture& posture) const;
  // Columns of the Jacobian of the unknown joints: rotation, displacement.
  struct Column {
    int joint;
    Vector3 rotation, displacement;
  };
  std::vector<Column> jacobian(const Posture& posture, const Missing& missing) const;
};

}  // namespace robcogen::algorithm::inversion
