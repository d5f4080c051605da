#include "algorithm/kinematics/inverse/newton.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace robcogen::algorithm::inversion {
namespace {

using Task = model::InverseTask::Kind;

// Coordinate axes of a frame, and its origin.
struct Frame {
  NumberMatrix axes{};
  Numbers3 origin{};

  Numbers3 seen(const Numbers3& v) const { return folded({dot(axes[0], v), dot(axes[1], v), dot(axes[2], v)}); }
};

// A unit vector across h.
Numbers3 across(const Numbers3& h) {
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::abs(h[k]) < std::abs(h[least])) least = k;
  Numbers3 e{};
  e[least] = 1.0;
  const Numbers3 v = e - h[least] * h;
  return (1.0 / norm(v)) * v;
}

// A unit vector across both, to the last digit across a also where they are almost parallel.
Numbers3 across(const Numbers3& a, const Numbers3& b) {
  constexpr double kParallel = 1e-14;
  Numbers3 n = cross(a, b);
  if (norm(n) < kParallel) return across(a);
  n = (1.0 / norm(n)) * n;
  n = n - dot(n, a) * a;
  return (1.0 / norm(n)) * n;
}

Numbers3 without_rounding(Numbers3 v) {
  for (double& x : v)
    if (std::abs(x) < 1e-15) x = 0.0;
  return v;
}

// a x + b y, and a x - b y.
Vector3 sum(const Expression& a, const Vector3& x, const Expression& b, const Vector3& y) {
  Vector3 v;
  for (std::size_t i = 0; i < 3; ++i) v[i] = sum_of_products(a, x[i], b, y[i]);
  return v;
}
Vector3 difference(const Expression& a, const Vector3& x, const Expression& b, const Vector3& y) {
  Vector3 v;
  for (std::size_t i = 0; i < 3; ++i) v[i] = difference_of_products(a, x[i], b, y[i]);
  return v;
}

// The solution of N x = b by Cholesky's factors without square roots. Pivots that rounding makes negative, or zero,
// which happens at singularities in single precision, count as positive.
std::vector<Expression> solved(Graph& graph, SquareMatrix N, std::vector<Expression> b, const Expression& least) {
  const int n = N.size();
  const Expression least_square = least * least;
  std::vector<Expression> inverse;  // of the pivots
  for (int k = 0; k < n; ++k) {
    const Expression pivot_square = N(k, k) * N(k, k);
    inverse.push_back(graph.one() / sqrt(pivot_square + least_square));
    for (int i = k + 1; i < n; ++i) {
      const Expression factor = N(i, k) * inverse[at(k)];
      for (int j = k + 1; j <= i; ++j) N(i, j) -= factor * N(j, k);
      b[at(i)] -= factor * b[at(k)];
    }
  }
  for (int k = n; k-- > 0;) {
    b[at(k)] = b[at(k)] * inverse[at(k)];
    for (int i = 0; i < k; ++i) {
      const Expression factor = N(k, i) * b[at(k)];
      b[at(i)] -= factor;
    }
  }
  return b;
}

}  // namespace

NewtonSteps::NewtonSteps(Graph& graph, const SerialChain& chain, const Target& target, ConditionAt condition)
    : graph_(graph), chain_(chain), condition_(std::move(condition)) {
  const Numbers3& first_axis = chain.axis(0).direction;
  const Numbers3 x = across(first_axis);
  const Frame first = {{x, cross(first_axis, x), first_axis}, chain.axis(0).point};
  Frame frame = first;
  for (int k = 0; k + 1 < chain.joints; ++k) {
    const ChainAxis& next = chain.axis(k + 1);
    const Numbers3 &h = chain.axis(k).direction, n = across(h, next.direction), y = cross(h, n);
    const Numbers3 angle = frame.seen(n), next_angle = folded({0.0, dot(y, next.direction), dot(h, next.direction)});
    Link& link = links_.emplace_back();
    link.sine = angle[1];
    link.cosine = angle[0];
    link.next_sine = -next_angle[1];
    link.next_cosine = next_angle[2];
    const Numbers3 last_origin = frame.origin;
    if (next.turns) {
      // The origin on the next axis from which the displacement has few elements.
      const Numbers3& level = std::abs(link.next_sine) > 0.5 ? y : h;
      const double along = dot(level, last_origin - next.point) / dot(level, next.direction);
      frame.origin = next.point + along * next.direction;
    }
    const Numbers3 between = frame.origin - last_origin;
    link.displacement = without_rounding(Numbers3{dot(n, between), dot(y, between), dot(h, between)});
    frame.axes = {n, cross(next.direction, n), next.direction};
  }
  links_.emplace_back();
  tool_point_ = without_rounding(frame.seen(chain.position - frame.origin));
  tool_axis_ = frame.seen(chain.rotation[2]);

  // Of the target, in axes of the first frame.
  const auto seen = [&](const Vector3& v) {
    return Vector3{
        {dot(constant(folded(first.axes[0])), v), dot(constant(folded(first.axes[1])), v),
         dot(constant(folded(first.axes[2])), v)}};
  };
  point_ = seen(target.position - constant(first.origin));
  if (chain.task.kind == Task::point) return;
  std::array<Vector3, 3> tool;
  for (std::size_t i = 0; i < 3; ++i)
    tool[i] = seen({{target.rotation[0][i], target.rotation[1][i], target.rotation[2][i]}});
  axis_ = tool[2];
  if (chain.task.kind == Task::axis) return;
  NumberMatrix turn{};  // from the last frame to the tool
  for (std::size_t i = 0; i < 3; ++i) turn[i] = frame.seen(chain.rotation[i]);
  for (std::size_t j = 0; j < 3; ++j) columns_[j] = combined(tool, constant({turn[0][j], turn[1][j], turn[2][j]}));
  origin_ = point_ - combined(columns_, constant(tool_point_));
}

Vector3 NewtonSteps::constant(const Numbers3& v) const {
  return {graph_.constant(v[0]), graph_.constant(v[1]), graph_.constant(v[2])};
}

Vector3 NewtonSteps::combined(const std::array<Vector3, 3>& columns, const Vector3& v) {
  Vector3 result = v[0] * columns[0];
  for (std::size_t i = 1; i < 3; ++i) result += v[i] * columns[i];
  return result;
}

NewtonSteps::Posture NewtonSteps::posture(const JointValues& values) const {
  Posture result;
  std::array<Vector3, 3>& R = result.columns;
  for (std::size_t i = 0; i < 3; ++i) R[i] = unit_vector(graph_, i);
  for (int k = 0; k < chain_.joints; ++k) {
    const Link& link = links_[at(k)];
    const JointValue& joint = *values[at(k)];
    result.axes.push_back(R[2]);
    result.origins.push_back(result.origin);
    Expression s = graph_.constant(link.sine), c = graph_.constant(link.cosine);
    if (chain_.axis(k).turns) {
      const Expression turned = sum_of_products(joint.sine, c, joint.cosine, s);
      c = difference_of_products(joint.cosine, c, joint.sine, s);
      s = turned;
    } else {
      result.origin += joint.sine * R[2];
    }
    const Vector3 x = sum(c, R[0], s, R[1]);
    R[1] = difference(c, R[1], s, R[0]);
    R[0] = x;
    if (k + 1 == chain_.joints) break;
    result.origin += combined(R, constant(link.displacement));
    const Expression next_s = graph_.constant(link.next_sine), next_c = graph_.constant(link.next_cosine);
    const Vector3 y = sum(next_c, R[1], next_s, R[2]);
    R[2] = difference(next_c, R[2], next_s, R[1]);
    R[1] = y;
  }
  return result;
}

NewtonSteps::Missing NewtonSteps::missing(const Posture& posture) const {
  Missing result;
  if (chain_.task.kind == Task::pose) {
    for (std::size_t i = 0; i < 3; ++i) result.rotation += cross(posture.columns[i], columns_[i]);
    result.rotation = graph_.constant(0.5) * result.rotation;
    result.point = posture.origin;
    result.displacement = origin_ - posture.origin;
    return result;
  }
  if (chain_.task.kind == Task::axis) result.rotation = cross(combined(posture.columns, constant(tool_axis_)), axis_);
  result.point = posture.origin + combined(posture.columns, constant(tool_point_));
  result.displacement = point_ - result.point;
  return result;
}

std::vector<NewtonSteps::Column> NewtonSteps::jacobian(const Posture& posture, const Missing& missing) const {
  std::vector<Column> columns;
  const bool leaves_axis = chain_.task.kind == Task::axis;
  const Vector3 free = leaves_axis ? combined(posture.columns, constant(tool_axis_)) : Vector3();
  for (int k = 0; k < chain_.joints; ++k) {
    if (chain_.is_known(k)) continue;
    Column& column = columns.emplace_back();
    column.joint = k;
    const Vector3& h = posture.axes[at(k)];
    if (!chain_.axis(k).turns) {
      column.displacement = h;
      continue;
    }
    column.displacement = cross(h, missing.point - posture.origins[at(k)]);
    if (chain_.task.kind == Task::point) continue;
    column.rotation = h;
    if (leaves_axis) column.rotation -= dot(free, h) * free;
  }
  return columns;
}

JointValues NewtonSteps::step(const JointValues& values) const {
  // The damping vanishes near the target, as the square of the error, but for what keeps pivots positive.
  constexpr double kLeastDamping = 0x1p-40, kDampingPerError = 1.0 / 64.0;
  // Steps are shorter than this (rad, m).
  constexpr double kLongest = 0.5;
  graph_.begin_section("Newton step: pose", "step");
  const Posture here = posture(values);
  const Missing missing_motion = missing(here);
  graph_.begin_section("Newton step: Jacobian", "step");
  const std::vector<Column> J = jacobian(here, missing_motion);
  Condition condition;
  if (condition_) condition = condition_(values);
  const Vector3 &r = missing_motion.rotation, &d = missing_motion.displacement;
  const Expression rotation_square = dot(r, r);
  Expression error_square = rotation_square + dot(d, d);
  if (condition_) error_square += condition.missing * condition.missing;
  const Expression damping = graph_.constant(kLeastDamping) + graph_.constant(kDampingPerError) * error_square;
  const auto n = static_cast<int>(J.size());
  SquareMatrix N(n);
  std::vector<Expression> b;
  for (int i = 0; i < n; ++i) {
    const Column& row = J[at(i)];
    for (int k = 0; k <= i; ++k) {
      const Expression of_rotations = dot(row.rotation, J[at(k)].rotation);
      N(i, k) = of_rotations + dot(row.displacement, J[at(k)].displacement);
      if (condition_) N(i, k) += condition.derivatives[at(row.joint)] * condition.derivatives[at(J[at(k)].joint)];
    }
    N(i, i) += damping;
    const Expression of_rotation = dot(row.rotation, r);
    b.push_back(of_rotation + dot(row.displacement, d));
    if (condition_) b.back() += condition.derivatives[at(row.joint)] * condition.missing;
  }
  graph_.begin_section("Newton step: joints", "step");
  const std::vector<Expression> full = solved(graph_, std::move(N), std::move(b), damping);
  Expression square;
  for (const Expression& x : full) square += x * x;
  const Expression ratio = graph_.one() / sqrt(graph_.one() + graph_.constant(1.0 / (kLongest * kLongest)) * square);
  JointValues result = values;
  for (int i = 0; i < n; ++i) {
    const int k = J[at(i)].joint;
    const Expression dq = ratio * full[at(i)];
    JointValue& joint = *result[at(k)];
    if (!chain_.axis(k).turns) {
      joint.sine += dq;
      continue;
    }
    // The turn with half this tangent of half the angle.
    const Expression t = graph_.constant(0.5) * dq, t_square = t * t;
    const Expression inverse = graph_.one() / (graph_.one() + t_square);
    const Expression c = (graph_.one() - t_square) * inverse, s = dq * inverse;
    const Expression sine = sum_of_products(joint.sine, c, joint.cosine, s);
    joint.cosine = difference_of_products(joint.cosine, c, joint.sine, s);
    joint.sine = sine;
  }
  return result;
}

Expression NewtonSteps::misfit(const JointValues& values) const {
  graph_.begin_section("pose of the branch", "end");
  const Posture here = posture(values);
  const Vector3 at_point = here.origin + combined(here.columns, constant(tool_point_)), missed = at_point - point_;
  Expression square = dot(missed, missed);
  if (chain_.task.kind == Task::pose)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 turned = here.columns[i] - columns_[i];
      square += graph_.constant(0.5) * dot(turned, turned);
    }
  if (chain_.task.kind == Task::axis) {
    const Vector3 turned = combined(here.columns, constant(tool_axis_)) - axis_;
    square += dot(turned, turned);
  }
  return sqrt(square);
}

}  // namespace robcogen::algorithm::inversion
