#include "algorithm/spatial/pose.h"

#include <stdexcept>
#include <utility>

namespace robcogen::algorithm {
namespace {

using model::PrimitiveTransform;
using model::Quantity;

// An angle as quarter turns plus a rest, which is zero or not a multiple of 90 degrees.
struct Angle {
  int quarters = 0;
  Expression rest;
};

// The constant part of a sum, and the rest.
std::pair<Number, Expression> split_constant(
    ProgramTrace& trace,
    const Quantity& q,
    const std::vector<Expression>& positions) {
  switch (q.op()) {
    case Quantity::Op::constant:
      return {q.number(), Expression()};
    case Quantity::Op::negate: {
      const auto [constant, rest] = split_constant(trace, q.left(), positions);
      return {-constant, -rest};
    }
    case Quantity::Op::add:
    case Quantity::Op::subtract: {
      const auto [c1, r1] = split_constant(trace, q.left(), positions);
      const auto [c2, r2] = split_constant(trace, q.right(), positions);
      const bool sum = q.op() == Quantity::Op::add;
      return {sum ? c1 + c2 : c1 - c2, sum ? r1 + r2 : r1 - r2};
    }
    default:
      return {Number(), trace.lift(q, positions)};
  }
}

Angle angle_of(ProgramTrace& trace, const Quantity& q, const std::vector<Expression>& positions) {
  const auto [constant, rest] = split_constant(trace, q, positions);
  if (constant.is_zero()) return {0, rest};
  if (constant.is_pi_multiple() && 2 % constant.ratio()->den == 0)
    return {static_cast<int>(constant.ratio()->num % 4 * (2 / constant.ratio()->den) % 4), rest};
  return {0, rest + trace.graph.constant(constant)};
}

// A rotation under construction: planes hold angles until no more can merge.
class RotationBuilder {
 public:
  void append(int axis, const Angle& angle) {
    if (angle.quarters != 0) append_quarter(quarter_turn(axis, angle.quarters));
    if (angle.rest.is_zero()) return;
    if (!planes_.empty() && planes_.back().axis == axis) {
      planes_.back().angle += angle.rest;
      if (planes_.back().angle.is_zero()) planes_.pop_back();
    } else {
      planes_.push_back({axis, angle.rest});
    }
  }

  void append(Graph& graph, const std::array<Expression, 4>& quaternion) {
    planes_.push_back({PlaneRotation::kAnyAxis, {}, rotation_by_quaternion(graph, quaternion).matrix});
  }

  // The z axis of the rotated frame as ± an axis of the parent frame: {axis, sign}; {-1, 0} if it is not along one.
  std::pair<int, int> aligned_z() const {
    for (const Plane& plane : planes_)
      if (plane.axis != 2) return {-1, 0};
    for (int i = 0; i < 3; ++i)
      if (quarter_.image[static_cast<std::size_t>(i)] == 2) return {i, quarter_.sign[static_cast<std::size_t>(i)]};
    throw std::logic_error("not a rotation");
  }

  Rotation finish() const {
    Rotation r{quarter_, {}};
    for (const Plane& plane : planes_) {
      if (plane.matrix)
        r.planes.push_back({plane.axis, {}, {}, {}, plane.matrix});
      else
        r.planes.push_back({plane.axis, cos(plane.angle), sin(plane.angle), plane.angle});
    }
    return r;
  }

 private:
  struct Plane {
    int axis;
    Expression angle;
    std::shared_ptr<const Matrix3> matrix = {};
  };

  // P r1 … rk Q = (P Q) (Q' r1 Q) … : each rotation keeps its angle and turns its axis by Q'.
  void append_quarter(const QuarterTurns& turn) {
    quarter_ = quarter_ * turn;
    const QuarterTurns back = inverse(turn);
    for (Plane& plane : planes_) {
      if (plane.matrix) plane.matrix = std::make_shared<const Matrix3>(conjugate(back, *plane.matrix));
      for (int i = 0; i < 3; ++i) {
        if (back.image[static_cast<std::size_t>(i)] != plane.axis) continue;
        if (back.sign[static_cast<std::size_t>(i)] < 0) plane.angle = -plane.angle;
        plane.axis = i;
        break;
      }
    }
  }

  QuarterTurns quarter_;
  std::vector<Plane> planes_;
};

std::array<Expression, 4> lifted(
    ProgramTrace& trace,
    const std::vector<Quantity>& quaternion,
    const std::vector<Expression>& positions) {
  std::array<Expression, 4> result;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = trace.lift(quaternion.at(i), positions);
  return result;
}

}  // namespace

Pose pose_of(
    ProgramTrace& trace,
    const std::vector<PrimitiveTransform>& primitives,
    const std::vector<Expression>& positions) {
  RotationBuilder rotation;
  bool rotated = false;
  Pose pose;
  for (const PrimitiveTransform& primitive : primitives) {
    const int axis = static_cast<int>(primitive.axis);
    if (primitive.rotation) {
      // A slide before another rotation is an ordinary offset.
      if (!pose.slide.is_zero()) {
        pose.offset += to_parent(rotation.finish(), {Expression(), Expression(), pose.slide});
        pose.slide = Expression();
      }
      if (primitive.quaternion.empty())
        rotation.append(axis, angle_of(trace, primitive.amount, positions));
      else
        rotation.append(trace.graph, lifted(trace, primitive.quaternion, positions));
      rotated = true;
      continue;
    }
    const Expression amount = trace.lift(primitive.amount, positions);
    if (axis == 2 && (rotated || !amount.is_constant())) {
      pose.slide += amount;
    } else {
      Vector3 step;
      step[static_cast<std::size_t>(axis)] = amount;
      pose.offset += rotated ? to_parent(rotation.finish(), step) : step;
    }
  }
  pose.rotation = rotation.finish();
  if (!rotated) return pose;

  const auto [axis, sign] = rotation.aligned_z();
  if (axis >= 0 && axis != 2) {
    Expression& along = pose.offset[static_cast<std::size_t>(axis)];
    pose.slide += sign < 0 ? -along : along;
    along = Expression();
  }
  return pose;
}

Force to_parent(const Pose& X_PC, const Force& F_C) {
  Vector3 n = F_C.moment;
  if (!X_PC.slide.is_zero()) {
    n[0] -= X_PC.slide * F_C.linear[1];
    n[1] += X_PC.slide * F_C.linear[0];
  }
  const Vector3 force = to_parent(X_PC.rotation, F_C.linear);
  const Vector3 moment = to_parent(X_PC.rotation, n);
  return {moment + cross(X_PC.offset, force), force};
}

Motion to_parent(const Pose& X_PC, const Motion& V_C) {
  // By duality, linear parts of motions transform as moments do.
  const Force moved = to_parent(X_PC, Force{V_C.linear, V_C.angular});
  return {moved.linear, moved.moment};
}

Motion to_child(const Pose& X_PC, const Motion& V_P) {
  Motion result;
  result.angular = to_child(X_PC.rotation, V_P.angular);
  result.linear = to_child(X_PC.rotation, V_P.linear + cross(V_P.angular, X_PC.offset));
  if (!X_PC.slide.is_zero()) {
    result.linear[0] += X_PC.slide * result.angular[1];
    result.linear[1] -= X_PC.slide * result.angular[0];
  }
  return result;
}

}  // namespace robcogen::algorithm
