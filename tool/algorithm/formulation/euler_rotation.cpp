#include "algorithm/formulation/euler_rotation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "support/index.h"

namespace robcogen::algorithm {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

constexpr double kRightAngle = std::numbers::pi / 2;

bool is_constant(const PlaneRotation& plane) {
  return !plane.matrix && plane.c.is_constant() && plane.s.is_constant();
}

// m Rot(axis).
void rotate(Matrix& m, int axis, double c, double s) {
  const std::size_t a = at((axis + 1) % 3), b = at((axis + 2) % 3);
  for (std::array<double, 3>& row : m) {
    const double first = row[a], second = row[b];
    row[a] = c * first + s * second;
    row[b] = c * second - s * first;
  }
}

Matrix matrix_of(const QuarterTurns& q) {
  Matrix m{};
  for (std::size_t i = 0; i < 3; ++i) m[i][at(q.image[i])] = q.sign[i];
  return m;
}

std::int64_t quarters_of(double angle) {
  return static_cast<std::int64_t>(std::round(angle / kRightAngle));
}

// Moves quarter turns on the right of a rotation to its left.
void append(Rotation& rotation, const QuarterTurns& turn) {
  rotation.quarter = rotation.quarter * turn;
  const QuarterTurns back = inverse(turn);
  for (PlaneRotation& plane : rotation.planes) {
    const auto image = std::find(back.image.begin(), back.image.end(), plane.axis) - back.image.begin();
    plane.axis = static_cast<int>(image);
    if (back.sign[static_cast<std::size_t>(image)] > 0) continue;
    plane.s = -plane.s;
    plane.angle = -plane.angle;
  }
}

PlaneRotation constant_plane(Trace& trace, const EulerTurn& turn) {
  double c = std::cos(turn.angle), s = std::sin(turn.angle);
  if (is_multiple_of_quarter(turn.angle)) c = std::round(c), s = std::round(s);
  const auto constant = [&](double value, double representative) {
    return trace.graph.constant(symbolic::Constant(Number(value)).folded_as(representative));
  };
  return {turn.axis, constant(c, turn.c), constant(s, turn.s), trace.graph.constant(turn.angle)};
}

}  // namespace

AngleParts parts_of_angle(const Expression& angle) {
  if (angle.is_constant()) return {angle.number().value(), Expression()};
  Graph& graph = *angle.graph();
  const symbolic::Node node = graph.nodes()[at(angle.node())];
  if (node.kind != symbolic::Node::Kind::operation || !symbolic::is_sum(node.op)) return {0.0, angle};
  Expression rest = graph.expression(node.a, false),
             constant = graph.expression(node.b, node.op == symbolic::Op::subtract);
  if (rest.is_constant()) std::swap(rest, constant);
  if (!constant.is_constant()) return {0.0, angle};
  const double value = constant.number().value();
  return angle.negative() ? AngleParts{-value, -rest} : AngleParts{value, rest};
}

bool is_multiple_of_quarter(double angle) {
  constexpr double kRounding = 1e-15;
  return std::abs(angle - static_cast<double>(quarters_of(angle)) * kRightAngle) < kRounding;
}

std::optional<std::array<double, 3>> euler_angles(const Rotation& rotation) {
  Matrix m = matrix_of(rotation.quarter);
  double with_joint = 0.0;
  for (const PlaneRotation& plane : rotation.planes) {
    if (is_constant(plane)) {
      rotate(m, plane.axis, plane.c.number().value(), plane.s.number().value());
      continue;
    }
    if (plane.matrix || plane.axis != 2 || &plane != &rotation.planes.back()) return std::nullopt;
    with_joint = parts_of_angle(plane.angle).constant;
  }
  // The axis of the joint is (sin a sin b, -cos a sin b, cos b).
  constexpr double kLeastSine = 1e-12;
  const double sine = std::hypot(m[0][2], m[1][2]);
  const bool is_parallel = sine < kLeastSine;
  const double a = is_parallel ? 0.0 : std::atan2(m[0][2], -m[1][2]);
  const double b = is_parallel ? (m[2][2] < 0 ? std::numbers::pi : 0.0) : std::atan2(sine, m[2][2]);
  // The last angle is computed from the other two, so that nearly parallel axes lose no digits.
  const double ca = std::cos(a), sa = std::sin(a);
  const double x = ca * m[0][0] + sa * m[1][0];
  const double y = std::cos(b) * (ca * m[1][0] - sa * m[0][0]) + std::sin(b) * m[2][0];
  return std::array{a, b, std::remainder(std::atan2(y, x) + with_joint, 4 * kRightAngle)};
}

Rotation as_euler_rotation(Trace& trace, const EulerRotation& turns, const Rotation& rotation) {
  Expression joint;
  if (!rotation.planes.empty()) joint = parts_of_angle(rotation.planes.back().angle).rest;
  Rotation result;
  for (const EulerTurn& turn : turns) {
    const bool is_last = &turn == &turns.back();
    if (turn.is_quarters)
      append(result, quarter_turn(turn.axis, static_cast<int>((quarters_of(turn.angle) % 4 + 4) % 4)));
    if (is_last && !joint.is_zero()) {
      Expression angle = joint;
      if (!turn.is_quarters)
        angle += trace.graph.constant(symbolic::Constant(Number(turn.angle)).folded_as(turn.angle_with_joint));
      result.planes.push_back({turn.axis, cos(angle), sin(angle), angle});
    } else if (!turn.is_quarters) {
      result.planes.push_back(constant_plane(trace, turn));
    }
  }
  return result;
}

}  // namespace robcogen::algorithm
