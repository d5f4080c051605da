#include "algorithm/reached.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Role;

void turn(Matrix3& m, const PlaneRotation& plane) {
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

std::vector<Expression> by_columns(const std::vector<std::vector<Expression>>& rows) {
  std::vector<Expression> values;
  for (std::size_t c = 0; c < rows.front().size(); ++c)
    for (const std::vector<Expression>& row : rows) values.push_back(row[c]);
  return values;
}

std::vector<Expression> homogeneous(Graph& graph, const Reached& x) {
  std::vector<std::vector<Expression>> rows(4, std::vector<Expression>(4));
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) rows[r][c] = x.rotation[r][c];
    rows[r][3] = x.position[r];
  }
  rows[3][3] = graph.one();
  return by_columns(rows);
}

// [p]x R stands below the diagonal of the motion form, above that of the force form.
std::vector<Expression> spatial(const Reached& x, bool motion) {
  std::vector<std::vector<Expression>> rows(6, std::vector<Expression>(6));
  for (std::size_t c = 0; c < 3; ++c) {
    const Vector3 r = column(x.rotation, c), moment = cross(x.position, r);
    for (std::size_t k = 0; k < 3; ++k) {
      rows[k][c] = rows[3 + k][3 + c] = r[k];
      (motion ? rows[3 + k][c] : rows[k][3 + c]) = moment[k];
    }
  }
  return by_columns(rows);
}

}  // namespace

Reached start(Graph& graph) {
  Reached here;
  for (std::size_t i = 0; i < 3; ++i) here.rotation[i][i] = graph.one();
  return here;
}

void advance(Reached& here, const Pose& pose) {
  here.position += multiply(here.rotation, pose.offset);
  turn(here.rotation, pose.rotation.quarter);
  for (const PlaneRotation& plane : pose.rotation.planes) turn(here.rotation, plane);
  here.position += pose.slide * column(here.rotation, 2);
}

void name_reached(Graph& graph, const Reached& here, const std::string& subject) {
  const char* axes = "xyz";
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) graph.name(here.rotation[r][c], subject + "_R" + axes[r] + axes[c]);
  name(graph, here.position, subject + "_p");
}

Vector3 column(const Matrix3& m, std::size_t k) {
  return {m[0][k], m[1][k], m[2][k]};
}

void output_transform(ProgramTrace& trace, const Reached& x, TransformForm form) {
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
