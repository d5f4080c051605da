// Closures of any loops, at positions that are given.
#include <algorithm>
#include <map>

#include "algorithm/spatial/closures.h"
#include "algorithm/spatial/joint.h"
#include "algorithm/spatial/link_chain.h"

namespace robcogen::algorithm {
namespace {

using model::LoopType;
using Axes = std::array<Vector3, 3>;

// A joint of an end, in the frame of the last link that carries both ends.
struct Screw {
  int joint = -1;
  Vector3 turn, slide;  // by unit motion
  Vector3 origin;
};

// The frame of an end in that frame, and its motion.
struct End {
  std::vector<Screw> screws;
  Axes axes;
  Vector3 point;
  Vector3 w, wd;                   // angular velocity, and acceleration if joints do not accelerate
  Vector3 velocity, acceleration;  // of the point
};

Vector3 combined(const Axes& axes, const Vector3& v) {
  Vector3 sum;
  for (std::size_t k = 0; k < 3; ++k) sum += v[k] * axes[k];
  return sum;
}

// Half the sum of the cross products of the axes: the axis of the rotation between both frames times the sine of its
// angle.
Vector3 turn_between(const Axes& first, const Axes& second, Graph& graph) {
  Vector3 sum;
  for (std::size_t k = 0; k < 3; ++k) sum += cross(first[k], second[k]);
  return graph.constant(0.5) * sum;
}

void append(std::vector<Expression>& rows, const Vector3& v) {
  rows.insert(rows.end(), v.element.begin(), v.element.end());
}

// The rows of a loop: its second end as seen from the first one.
class LoopRows {
 public:
  LoopRows(Trace& trace, const model::LoopJoint& loop, const std::vector<Expression>& q, Positions positions)
      : trace_(trace), loop_(loop), positions_(positions) {
    const std::vector<Expression> still(trace.tree.joints.size());
    for (std::size_t e = 0; e < 2; ++e) {
      poses_[e] = poses_along(trace, loop.ends[e], q);
      ends_[e] = end(e, still);
    }
  }

  const std::vector<Screw>& screws(std::size_t e) const { return ends_[e].screws; }

  std::vector<Expression> error() const {
    const Vector3 apart = ends_[1].point - ends_[0].point;
    const Axes &first = ends_[0].axes, &second = ends_[1].axes;
    if (loop_.type == LoopType::distance) {
      const Expression length = trace_.lift(loop_.length), square = length * length;
      return {half() * (dot(apart, apart) - square)};
    }
    std::vector<Expression> rows = of_points(apart);
    if (loop_.type == LoopType::hinge) rows.insert(rows.end(), {dot(first[0], second[2]), dot(first[1], second[2])});
    if (fixes_axes()) append(rows, turn_between(first, second, trace_.graph));
    return rows;
  }

  // The same in metres and sines.
  std::vector<Expression> opening() const {
    std::vector<Expression> rows = error();
    if (loop_.type == LoopType::distance) rows[0] = rows[0] / trace_.lift(loop_.length);
    return rows;
  }

  std::vector<Expression> rate(std::size_t e, const Screw& screw) const {
    const Vector3& point = ends_[loop_.type == LoopType::slider ? 1 : e].point;
    Vector3 turn = screw.turn, motion = screw.slide;
    if (!is_zero(turn)) motion += cross(turn, point - screw.origin);
    if (e == 0) turn = -turn, motion = -motion;
    if (loop_.type == LoopType::distance) return {dot(ends_[1].point - ends_[0].point, motion)};
    std::vector<Expression> rows = of_points(motion);
    if (loop_.type == LoopType::hinge)
      for (const Vector3& direction : hinge_directions()) rows.push_back(dot(direction, turn));
    if (fixes_axes()) append(rows, turn);
    return rows;
  }

  std::vector<Expression> bias(const std::vector<Expression>& qd) const {
    const End first = end(0, qd), second = end(1, qd);
    const Vector3 apart = second.point - first.point, velocity = second.velocity - first.velocity;
    Vector3 acceleration = second.acceleration - first.acceleration;
    if (loop_.type == LoopType::distance) {
      const Expression of_velocity = dot(velocity, velocity);
      return {of_velocity + dot(apart, acceleration)};
    }
    if (loop_.type == LoopType::slider) {
      // The acceleration is seen from the first frame, which turns.
      const Vector3 seen = velocity - cross(first.w, apart);
      acceleration -= cross(first.wd, apart) + cross(first.w, cross(first.w, apart) + seen + seen);
    }
    std::vector<Expression> rows = of_points(acceleration);
    const Vector3 wd = second.wd - first.wd;
    if (loop_.type == LoopType::hinge) {
      const Vector3 w = second.w - first.w, axis = second.axes[2], turning = cross(second.w, axis);
      for (std::size_t k = 0; k < 2; ++k) {
        const Vector3& x = first.axes[k];
        const Vector3 change = cross(turning, x) + cross(axis, cross(first.w, x));
        rows.push_back(dot(change, w) + dot(cross(axis, x), wd));
      }
    }
    if (fixes_axes()) append(rows, wd);
    return rows;
  }

  // Force and moment of the second end on the first one; for a point the force alone, for a distance its compression.
  std::vector<Expression> force_of(const std::vector<Expression>& lambda) const {
    if (loop_.type == LoopType::distance) {
      const Vector3 apart = ends_[1].point - ends_[0].point;
      const bool is_closed = positions_ == Positions::solved;
      return {(is_closed ? trace_.lift(loop_.length) : sqrt(dot(apart, apart))) * lambda[0]};
    }
    Vector3 force, moment;
    std::size_t row = 0;
    if (loop_.type == LoopType::slider)
      for (; row < 2; ++row) force -= lambda[row] * ends_[0].axes[row];
    else
      for (; row < 3; ++row) force[row] = -lambda[row];
    std::vector<Expression> result;
    append(result, force);
    if (loop_.type == LoopType::point) return result;
    if (loop_.type == LoopType::hinge)
      for (const Vector3& direction : hinge_directions()) moment -= lambda[row++] * direction;
    else
      for (std::size_t k = 0; k < 3; ++k) moment[k] = -lambda[row++];
    append(result, moment);
    return result;
  }

 private:
  Trace& trace_;
  const model::LoopJoint& loop_;
  Positions positions_;
  std::array<std::vector<Pose>, 2> poses_;
  std::array<End, 2> ends_;

  bool fixes_axes() const { return loop_.type == LoopType::slider || loop_.type == LoopType::weld; }
  Expression half() const { return trace_.graph.constant(0.5); }

  // The rows of a vector between the points; a slider has none along its free axis.
  std::vector<Expression> of_points(const Vector3& v) const {
    if (loop_.type == LoopType::slider) return {dot(ends_[0].axes[0], v), dot(ends_[0].axes[1], v)};
    return {v[0], v[1], v[2]};
  }

  // The rates of the second z axis along the first x and y axes are the parts of the angular velocity along these
  // directions.
  std::array<Vector3, 2> hinge_directions() const {
    const Vector3& axis = ends_[1].axes[2];
    return {cross(axis, ends_[0].axes[0]), cross(axis, ends_[0].axes[1])};
  }

  End end(std::size_t e, const std::vector<Expression>& qd) const {
    End here;
    Graph& graph = trace_.graph;
    for (std::size_t k = 0; k < 3; ++k) here.axes[k] = unit_vector(graph, k);
    const std::vector<int>& joints = loop_.ends[e].joints;
    for (std::size_t k = 0; k < poses_[e].size(); ++k) {
      const Pose& pose = poses_[e][k];
      Axes axes;
      for (std::size_t axis = 0; axis < 3; ++axis)
        axes[axis] = combined(here.axes, to_parent(pose.rotation, unit_vector(graph, axis)));
      const Vector3 step = combined(here.axes, pose.offset) + pose.slide * axes[2];
      here.acceleration += cross(here.wd, step) + cross(here.w, cross(here.w, step));
      here.velocity += cross(here.w, step);
      here.point += step;
      if (k < joints.size()) add_joint(here, joints[k], axes[2], qd);
      here.axes = axes;
    }
    return here;
  }

  void add_joint(End& here, int index, const Vector3& axis, const std::vector<Expression>& qd) const {
    const Motion S = subspace(joint_of(trace_, index), trace_.graph);
    const Screw screw = {index, S.angular[2] * axis, S.linear[2] * axis, here.point};
    const Vector3 sliding = qd[at(index)] * screw.slide, turning = qd[at(index)] * screw.turn;
    const Vector3 coriolis = cross(here.w, sliding);
    here.acceleration += coriolis + coriolis;
    here.velocity += sliding;
    here.wd += cross(here.w, turning);
    here.w += turning;
    here.screws.push_back(screw);
  }
};

class SpatialClosure : public TracedClosure {
 public:
  SpatialClosure(
      Trace& trace,
      const model::Closure& closure,
      const std::vector<Expression>& q,
      Positions positions = Positions::solved)
      : TracedClosure(trace, closure) {
    for (const int loop : closure.loops) loops_.emplace_back(trace, trace.tree.loops[at(loop)], q, positions);
  }

  // The step of each dependent joint.
  std::vector<Expression> newton_step() {
    const std::vector<Expression> rows = error();
    return dependent_columns().solve(rows);
  }

  std::vector<Expression> open_rows() {
    std::vector<Expression> rows;
    for (const LoopRows& loop : loops_)
      for (const Expression& row : loop.opening()) rows.push_back(row);
    return rows;
  }

 private:
  std::vector<LoopRows> loops_;

  std::vector<Column> columns() override {
    std::map<int, std::vector<Expression>> by_joint;
    std::size_t first = 0;
    for (const LoopRows& loop : loops_) {
      std::size_t rows = 0;
      for (std::size_t e = 0; e < 2; ++e)
        for (const Screw& screw : loop.screws(e)) {
          const std::vector<Expression> rate = loop.rate(e, screw);
          std::vector<Expression>& column = by_joint[screw.joint];
          column.resize(first);
          column.insert(column.end(), rate.begin(), rate.end());
          rows = rate.size();
        }
      first += rows;
    }
    std::vector<Column> result;
    for (auto& [joint, column] : by_joint) {
      column.resize(first);
      result.push_back({joint, std::move(column)});
    }
    return result;
  }

  std::vector<Expression> error() override {
    std::vector<Expression> rows;
    for (const LoopRows& loop : loops_)
      for (const Expression& row : loop.error()) rows.push_back(row);
    return rows;
  }

  std::vector<Expression> bias(const std::vector<Expression>& qd) override {
    std::vector<Expression> rows;
    for (const LoopRows& loop : loops_)
      for (const Expression& row : loop.bias(qd)) rows.push_back(row);
    return rows;
  }

  std::vector<std::vector<Expression>> force_of(const std::vector<Expression>& lambda) override {
    std::vector<std::vector<Expression>> forces;
    auto next = lambda.begin();
    for (const LoopRows& loop : loops_) {
      const auto end = next + static_cast<std::ptrdiff_t>(loop.error().size());
      forces.push_back(loop.force_of({next, end}));
      next = end;
    }
    return forces;
  }
};

}  // namespace

std::unique_ptr<TracedClosure> traced_in_space(
    Trace& trace,
    const model::Closure& closure,
    const std::vector<Expression>& q,
    Positions positions) {
  return std::make_unique<SpatialClosure>(trace, closure, q, positions);
}

void newton_step(Trace& trace, const model::Closure& closure, std::vector<Expression>& q) {
  const std::vector<Expression> move = SpatialClosure(trace, closure, q).newton_step();
  for (std::size_t d = 0; d < move.size(); ++d) q[at(closure.dependents[d])] -= move[d];
}

std::vector<Expression> open_rows(Trace& trace, const model::Closure& closure, const std::vector<Expression>& q) {
  return SpatialClosure(trace, closure, q).open_rows();
}

}  // namespace robcogen::algorithm
