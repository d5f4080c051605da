// Closures of distances between two points.
#include <algorithm>
#include <array>

#include "algorithm/spatial/closures.h"
#include "algorithm/spatial/joint.h"
#include "algorithm/spatial/link_chain.h"
#include "algorithm/spatial/triangle.h"

namespace robcogen::algorithm {
namespace {

// A point that moves in a frame; the acceleration is the part that velocities cause.
struct MovingPoint {
  Vector3 position, velocity, acceleration;
};

class DistanceClosure : public TracedClosure {
 public:
  DistanceClosure(Trace& trace, const model::Closure& closure, std::vector<Expression>& q, Positions positions)
      : TracedClosure(trace, closure), loop_(trace.tree.loops[at(closure.loop())]), positions_(positions) {
    for (std::size_t e = 0; e < 2; ++e)
      for (std::size_t k = 0; k < loop_.ends[e].joints.size(); ++k)
        if (loop_.ends[e].joints[k] == closure.dependents[0]) end_ = e, place_ = k;
    if (positions == Positions::solved) solve(q);
    for (std::size_t e = 0; e < 2; ++e) {
      poses_[e] = poses_along(trace, loop_.ends[e], q);
      points_[e] = points(e, 0);
    }
  }

 private:
  const model::LoopJoint& loop_;
  Positions positions_;
  std::size_t end_ = 0, place_ = 0;             // of the dependent joint
  std::array<std::vector<Pose>, 2> poses_;      // by joint of an end, then of its frame
  std::array<std::vector<Vector3>, 2> points_;  // the end's point in each frame before a pose

  // The point of the end in the frame before each pose, from the last pose back to pose `first`.
  std::vector<Vector3> points(std::size_t e, std::size_t first) const {
    const std::vector<Pose>& poses = poses_[e];
    std::vector<Vector3> result(poses.size());
    Vector3 point;
    for (std::size_t k = poses.size(); k-- > first;) result[k] = point = point_to_parent(poses[k], point);
    return result;
  }

  // Solves in the frame of the joint, which turns the point of its own end about its axis: |other - R own| is the
  // length.
  void solve(std::vector<Expression>& q) {
    for (std::size_t e = 0; e < 2; ++e) poses_[e] = poses_along(trace_, loop_.ends[e], q);
    Vector3 other = points(1 - end_, 0).front();
    for (std::size_t k = 0; k < place_; ++k) other = point_to_child(poses_[end_][k], other);
    const int joint = closure_.dependents[0];
    other = point_to_child(placement_of_joint(trace_, joint), other);
    const Vector3 own = points(end_, place_ + 1)[place_ + 1];
    const Expression length = trace_.lift(loop_.length), along = other[2] - own[2];
    const Vector2 base = {other[0], other[1]}, side = {own[0], own[1]};
    const Expression squared_length = length * length;
    if (trace_.tree.joints[at(joint)].type == model::JointType::prismatic) {
      const Vector2 across = base - side;
      const Expression square = dot(across, across);
      const Expression root = sqrt(squared_length - square);
      q[at(joint)] = closure_.branch < 0.0 ? along - root : along + root;
      return;
    }
    const Expression aside = along * along;
    const Vector2 turn = turn_to_distance(side, base, squared_length - aside, closure_.branch);
    q[at(joint)] = atan2(turn.y, turn.x);
  }

  std::vector<Column> columns() override {
    std::vector<Column> result;
    for (std::size_t e = 0; e < 2; ++e) {
      Vector3 other = points_[1 - e].front();
      for (std::size_t k = 0; k < loop_.ends[e].joints.size(); ++k) {
        other = point_to_child(poses_[e][k], other);
        const Vector3& own = points_[e][k + 1];
        const Joint joint = joint_of(trace_, loop_.ends[e].joints[k]);
        // (own - other) times the velocity of the own point at unit rate, about or along z.
        const Motion S = subspace(joint, trace_.graph);
        Expression rate;
        if (!is_zero(S.angular)) rate += difference_of_products(other[0], own[1], other[1], own[0]);
        if (!is_zero(S.linear)) rate += S.linear[2] * (own[2] - other[2]);
        result.push_back({joint.index, {rate}});
      }
    }
    return result;
  }

  MovingPoint moving(std::size_t e, const std::vector<Expression>& qd) const {
    MovingPoint point;
    for (std::size_t k = poses_[e].size(); k-- > 0;) {
      if (k < loop_.ends[e].joints.size()) {
        const int j = loop_.ends[e].joints[k];
        const Expression& rate = qd[at(j)];
        const auto [axis, slide] = subspace(joint_of(trace_, j), trace_.graph);
        if (!is_zero(axis)) {
          const Expression twice = rate + rate, square = rate * rate;
          point.acceleration += twice * cross(axis, point.velocity);
          point.acceleration += square * cross(axis, cross(axis, point.position));
          point.velocity += rate * cross(axis, point.position);
        }
        point.velocity += rate * slide;
      }
      point.position = point_to_parent(poses_[e][k], point.position);
      point.velocity = to_parent(poses_[e][k].rotation, point.velocity);
      point.acceleration = to_parent(poses_[e][k].rotation, point.acceleration);
    }
    return point;
  }

  std::vector<Expression> bias(const std::vector<Expression>& qd) override {
    const MovingPoint first = moving(0, qd), second = moving(1, qd);
    const Vector3 velocity = first.velocity - second.velocity;
    const Expression of_velocity = dot(velocity, velocity);
    const Vector3 apart = first.position - second.position;
    return {of_velocity + dot(apart, first.acceleration - second.acceleration)};
  }

  // The row is half the square of the distance, minus that of the length.
  std::vector<Expression> error() override {
    const Expression length = trace_.lift(loop_.length), square = length * length;
    return {0.5 * (square_of_distance() - square)};
  }

  std::vector<std::vector<Expression>> force_of(const std::vector<Expression>& lambda) override {
    const bool is_closed = positions_ == Positions::solved;
    return {{(is_closed ? trace_.lift(loop_.length) : sqrt(square_of_distance())) * lambda[0]}};
  }

  Expression square_of_distance() const {
    const Vector3 apart = points_[0].front() - points_[1].front();
    return dot(apart, apart);
  }
};

}  // namespace

std::unique_ptr<TracedClosure> traced_distance(
    Trace& trace,
    const model::Closure& closure,
    std::vector<Expression>& q,
    Positions positions) {
  return std::make_unique<DistanceClosure>(trace, closure, q, positions);
}

}  // namespace robcogen::algorithm
