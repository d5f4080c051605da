#include "algorithm/kinematics/path_pose.h"

#include <algorithm>
#include <utility>

#include "algorithm/spatial/named.h"
#include "symbolic/cost.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

void turn(Matrix3& m, const PlaneRotation& plane) {
  if (plane.matrix) {
    m = m * *plane.matrix;
    return;
  }
  const auto i = static_cast<std::size_t>((plane.axis + 1) % 3), j = static_cast<std::size_t>((plane.axis + 2) % 3);
  for (std::size_t r = 0; r < 3; ++r) {
    const Expression a = m[r][i], b = m[r][j];
    m[r][i] = sum_of_products(plane.c, a, plane.s, b);
    m[r][j] = difference_of_products(plane.c, b, plane.s, a);
  }
}

void turn(Matrix3& m, const QuarterTurns& quarter) {
  const Matrix3 before = m;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t k = 0; k < 3; ++k) {
      const Expression& e = before[r][k];
      m[r][static_cast<std::size_t>(quarter.image[k])] = quarter.sign[k] < 0 ? -e : e;
    }
}

// m * plane, taken apart: fixed + c * with_c + s * with_s.
struct Parts {
  Matrix3 fixed, with_c, with_s;
};

Parts take_apart(const Matrix3& m, int axis) {
  const auto k = static_cast<std::size_t>(axis), i = (k + 1) % 3, j = (k + 2) % 3;
  Parts parts;
  for (std::size_t r = 0; r < 3; ++r) {
    parts.fixed[r][k] = m[r][k];
    parts.with_c[r][i] = m[r][i];
    parts.with_c[r][j] = m[r][j];
    parts.with_s[r][i] = m[r][j];
    parts.with_s[r][j] = -m[r][i];
  }
  return parts;
}

Matrix3 put_together(const Parts& parts, const PlaneRotation& plane) {
  Matrix3 m;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t k = 0; k < 3; ++k)
      m[r][k] = parts.fixed[r][k] + sum_of_products(plane.c, parts.with_c[r][k], plane.s, parts.with_s[r][k]);
  return m;
}

Matrix3 from_left_to_right(const PathPose& here) {
  Matrix3 m = here.before.back();
  turn(m, here.planes.back());
  return m;
}

// The product of three plane rotations, the middle one of which is taken apart: the parts are products of the outer
// sines and cosines, each needed once.
Matrix3 from_outside(const PathPose& here) {
  Parts parts = take_apart(here.before[1], here.planes[1].axis);
  for (Matrix3* m : {&parts.fixed, &parts.with_c, &parts.with_s}) turn(*m, here.planes[2]);
  return put_together(parts, here.planes[1]);
}

// The rotation, once its last plane rotation is known. Euler angles take 12 products from outside and 14 from left to
// right, two of which the position may share; constant angles can make the latter cheaper.
Matrix3 product(const PathPose& here) {
  if (here.planes.size() != 3) return from_left_to_right(here);
  const std::size_t mark = here.graph->mark();
  const auto cost_of = [&](Matrix3 (*make)(const PathPose&)) {
    make(here);
    const int cost = symbolic::work_since(*here.graph, mark);
    here.graph->rollback(mark);
    return cost;
  };
  return cost_of(from_outside) <= cost_of(from_left_to_right) ? from_outside(here) : from_left_to_right(here);
}

// P r1 r2 … Q = (P Q) (Q' r1 Q) … : each rotation keeps its angle and turns its axis by Q'.
void turn(PathPose& here, const QuarterTurns& quarter) {
  turn(here.rotation, quarter);
  for (Matrix3& m : here.before) turn(m, quarter);
  for (PlaneRotation& plane : here.planes) {
    const auto axis = static_cast<std::size_t>(plane.axis);
    plane.axis = quarter.image[axis];
    if (quarter.sign[axis] > 0) continue;
    plane.s = -plane.s;
    plane.angle = -plane.angle;
  }
}

bool is_at_hand(const PathPose& here, const Expression& angle) {
  return angle.is_constant() || std::any_of(here.angles.begin(), here.angles.end(), [&](const Expression& known) {
           return known == angle || -known == angle;
         });
}

// Both turns as one. Its sine and cosine come from those of the two, unless they are known for the sum.
PlaneRotation sum(const PathPose& here, const PlaneRotation& a, const PlaneRotation& b) {
  const Expression angle = a.angle + b.angle;
  if (angle.is_zero()) return {a.axis, Expression(), Expression(), angle};
  if (is_at_hand(here, angle)) return {a.axis, cos(angle), sin(angle), angle};
  return {a.axis, difference_of_products(a.c, b.c, a.s, b.s), sum_of_products(a.s, b.c, a.c, b.s), angle};
}

void turn(PathPose& here, const PlaneRotation& plane) {
  if (plane.matrix) {
    // The rotation before it stays a product of its own.
    turn(here.rotation, plane);
    here.before.clear();
    here.planes.clear();
    return;
  }
  here.angles.push_back(plane.angle);
  if (here.planes.empty() || here.planes.back().axis != plane.axis) {
    here.before.push_back(here.rotation);
    here.planes.push_back(plane);
    here.rotation = product(here);
    return;
  }
  here.planes.back() = sum(here, here.planes.back(), plane);
  if (!here.planes.back().angle.is_zero()) {
    here.rotation = product(here);
    return;
  }
  here.rotation = here.before.back();
  here.before.pop_back();
  here.planes.pop_back();
}

std::vector<Expression> by_columns(const std::vector<std::vector<Expression>>& rows) {
  std::vector<Expression> values;
  for (std::size_t c = 0; c < rows.front().size(); ++c)
    for (const std::vector<Expression>& row : rows) values.push_back(row[c]);
  return values;
}

// [p]x R.
Matrix3 moment_of(const PathPose& here) {
  Matrix3 m;
  for (std::size_t c = 0; c < 3; ++c) {
    const Vector3 moment = cross(here.position, column(here.rotation, c));
    for (std::size_t k = 0; k < 3; ++k) m[k][c] = moment[k];
  }
  return m;
}

// Adds R [offset]x, for an offset in the present frame.
void add_moment(PathPose& here, const Vector3& offset) {
  for (std::size_t k = 0; k < 3; ++k) here.moment[k] += cross(here.rotation[k], offset);
}

std::vector<Expression> homogeneous(Graph& graph, const PathPose& x) {
  std::vector<std::vector<Expression>> rows(4, std::vector<Expression>(4));
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) rows[r][c] = x.rotation[r][c];
    rows[r][3] = x.position[r];
  }
  rows[3][3] = graph.one();
  return by_columns(rows);
}

// [p]x R stands below the diagonal of the motion form, above that of the force form.
std::vector<Expression> spatial(const PathPose& x, bool motion) {
  const Matrix3 moment = x.segment > x.moment_from ? x.moment : moment_of(x);
  std::vector<std::vector<Expression>> rows(6, std::vector<Expression>(6));
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t k = 0; k < 3; ++k) {
      rows[k][c] = rows[3 + k][3 + c] = x.rotation[k][c];
      (motion ? rows[3 + k][c] : rows[k][3 + c]) = moment[k][c];
    }
  }
  return by_columns(rows);
}

}  // namespace

PathPose start(Graph& graph, int moment_from) {
  PathPose here = {&graph};
  for (std::size_t i = 0; i < 3; ++i) here.rotation[i][i] = graph.one();
  here.moment_from = moment_from;
  return here;
}

void advance(PathPose& here, const Pose& pose) {
  if (here.segment == here.moment_from) here.moment = moment_of(here);
  const bool along = here.segment >= here.moment_from;
  here.position += multiply(here.rotation, pose.offset);
  if (along) add_moment(here, pose.offset);
  turn(here, pose.rotation.quarter);
  if (along) turn(here.moment, pose.rotation.quarter);
  for (const PlaneRotation& plane : pose.rotation.planes) {
    turn(here, plane);
    if (along) turn(here.moment, plane);
  }
  here.position += pose.slide * column(here.rotation, 2);
  if (along) add_moment(here, {Expression(), Expression(), pose.slide});
  ++here.segment;
}

Program cheapest_transform(TransformForm form, int tail, const std::function<Program(int moment_from)>& make) {
  Program best = make(PathPose::kNoSegment);
  if (form == TransformForm::homogeneous) return best;
  const auto cost_of = [](const Program& program) {
    return weighted(symbolic::cost(program), symbolic::kOfTransforms);
  };
  int least = cost_of(best);
  for (const int moment_from : tail == 0 ? std::vector{0} : std::vector{0, tail}) {
    Program other = make(moment_from);
    const int cost = cost_of(other);
    if (cost >= least) continue;
    least = cost;
    best = std::move(other);
  }
  return best;
}

void name_path_pose(const PathPose& here, const std::string& subject) {
  named("R", subject, here.rotation);
  named("p", subject, here.position);
}

Vector3 column(const Matrix3& m, std::size_t k) {
  return {m[0][k], m[1][k], m[2][k]};
}

Motion in_axes(const Matrix3& rotation, const Motion& motion, bool negated) {
  const Motion turned{multiply(rotation, motion.angular), multiply(rotation, motion.linear)};
  return negated ? Motion{-turned.angular, -turned.linear} : turned;
}

void output_transform(ProgramTrace& trace, const PathPose& x, TransformForm form) {
  switch (form) {
    case TransformForm::homogeneous:
      return trace.output("X", Role::homogeneous, 4, 4, homogeneous(trace.graph, x));
    case TransformForm::spatial_motion:
      return trace.output("X", Role::spatial_motion, 6, 6, spatial(x, true));
    case TransformForm::spatial_force:
      return trace.output("X", Role::spatial_force, 6, 6, spatial(x, false));
  }
}

}  // namespace robcogen::algorithm
