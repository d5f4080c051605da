#include "model/inertia_pivots.h"

#include <array>
#include <cmath>
#include <utility>

#include "model/loop_cluster.h"
#include "support/index.h"

namespace robcogen::model {

namespace {

using Vector6 = std::array<double, 6>;
using Matrix6 = std::array<Vector6, 6>;  // spatial, angular rows first

Matrix6 spatial_inertia(const Inertia& inertia, const std::vector<double>& parameters) {
  const RigidBodyInertia body = in_link_frame(inertia);
  const auto value = [&](const Quantity& q) { return evaluate(q, parameters); };
  const double m = value(body.mass);
  const double hx = value(body.first_moment[0]), hy = value(body.first_moment[1]), hz = value(body.first_moment[2]);
  const double ixy = value(body.ixy), ixz = value(body.ixz), iyz = value(body.iyz);
  return {{
      {value(body.ixx), -ixy, -ixz, 0.0, -hz, hy},
      {-ixy, value(body.iyy), -iyz, hz, 0.0, -hx},
      {-ixz, -iyz, value(body.izz), -hy, hx, 0.0},
      {0.0, hz, -hy, m, 0.0, 0.0},
      {-hz, 0.0, hx, 0.0, m, 0.0},
      {hy, -hx, 0.0, 0.0, 0.0, m},
  }};
}

// child_X_parent for spatial motion vectors.
Matrix6 motion_transform(const Joint& joint, double q, const std::vector<double>& parameters) {
  std::array<double, 3> p{}, sine{}, cosine{};
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = evaluate(joint.placement.translation[i], parameters);
    // The last rotation of the placement and the rotation of a joint are both about z, so their angles add up. A
    // spherical joint turns with its first component, about any axis that is not special.
    const bool is_turn = joint.spherical.empty() ? i == 2 && turns(joint.type) : joint.is_first();
    const double own = is_turn ? q : 0.0;
    const double angle = evaluate(joint.placement.rotation[i], parameters) + own;
    sine[i] = std::sin(angle), cosine[i] = std::cos(angle);
  }
  const auto [sx, sy, sz] = sine;
  const auto [cx, cy, cz] = cosine;
  const std::array<std::array<double, 3>, 3> R = {{
      // parent_R_child
      {cy * cz, -cy * sz, sy},
      {cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -sx * cy},
      {sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy},
  }};
  const double slide = q * evaluate(slide_of(joint), parameters);
  for (std::size_t i = 0; i < 3; ++i) p[i] += slide * R[i][2];
  Matrix6 X{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t k = (j + 1) % 3, l = (j + 2) % 3;
      X[i][j] = X[i + 3][j + 3] = R[j][i];
      X[i + 3][j] = R[l][i] * p[k] - R[k][i] * p[l];  // -R' [p]x
    }
  }
  return X;
}

// a += X' b X
void add_transformed(Matrix6& a, const Matrix6& X, const Matrix6& b) {
  Matrix6 bX{};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = 0; k < 6; ++k) {
      for (std::size_t j = 0; j < 6; ++j) bX[i][j] += b[i][k] * X[k][j];
    }
  }
  for (std::size_t k = 0; k < 6; ++k) {
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) a[i][j] += X[k][i] * bX[k][j];
    }
  }
}

void add_in_proportion(Matrix6& a, double part) {
  const double rotation = std::abs(a[0][0] + a[1][1] + a[2][2]) / 3.0;
  const double translation = std::abs(a[3][3] + a[4][4] + a[5][5]) / 3.0;
  for (std::size_t i = 0; i < 3; ++i) a[i][i] += part * rotation, a[i + 3][i + 3] += part * translation;
}

Vector6 operator*(const Matrix6& a, const Vector6& v) {
  Vector6 result{};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) result[i] += a[i][j] * v[j];
  return result;
}

double dot(const Vector6& a, const Vector6& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 6; ++i) sum += a[i] * b[i];
  return sum;
}

Vector6 unit(std::size_t direction) {
  Vector6 v{};
  v[direction] = 1.0;
  return v;
}

// Makes one direction free: `a` becomes the inertia that the other directions meet, and is unchanged if the pivot is
// zero. `own` is inertia that only motion in this direction meets. Returns the pivot.
double eliminate(Matrix6& a, const Vector6& direction, double own = 0.0) {
  const Vector6 column = a * direction;
  const double pivot = dot(column, direction) + own;
  if (pivot == 0.0) return pivot;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) a[i][j] -= column[i] * column[j] / pivot;
  }
  return pivot;
}

// The drive's inertia about the joint axis. The coupling between a rotor and its carrier does not matter here: the
// carrier's own inertia about the rotor's axis, which includes the rotor, outweighs it.
double drive_inertia(const Drive& drive, const std::vector<double>& parameters) {
  const double armature = evaluate(drive.armature, parameters);
  return drive.rotor ? armature + evaluate(drive.rotor->inertia * drive.rotor->ratio * drive.rotor->ratio, parameters)
                     : armature;
}

// The motion subspace, in child coordinates.
Vector6 direction_of(const Joint& joint, const std::vector<double>& parameters) {
  Vector6 S = {0.0, 0.0, 0.0, 0.0, 0.0, evaluate(slide_of(joint), parameters)};
  if (turns(joint.type)) S[at(joint.axis)] = 1.0;
  return S;
}

// H of all joints, followed by the base, from composite bodies with the addition (Featherstone 2008, section 6.2).
std::vector<std::vector<double>> inertia_of_joints(const KinematicTree& tree, double addition) {
  OrdinaryNumbers numbers;
  const std::vector<double> parameters = numbers.next(tree.parameters.size());
  const std::vector<double> q = numbers.next(tree.joints.size());
  std::vector<Matrix6> composite(tree.links.size(), Matrix6{});
  for (std::size_t i = 0; i < tree.links.size(); ++i)
    if (tree.links[i].inertia) composite[i] = spatial_inertia(*tree.links[i].inertia, parameters);
  std::vector<Matrix6> X(tree.joints.size());
  const std::vector<int> order = tree.topological();
  for (auto it = order.rbegin(); it != order.rend(); ++it) {
    const Joint& joint = tree.joints[at(*it)];
    X[at(*it)] = motion_transform(joint, q[at(*it)], parameters);
    add_in_proportion(composite[at(joint.child)], addition);
    add_transformed(composite[at(joint.parent)], X[at(*it)], composite[at(joint.child)]);
  }
  add_in_proportion(composite[0], addition);
  const std::size_t joints = tree.joints.size(), size = joints + (tree.floating_base ? 6 : 0);
  std::vector<std::vector<double>> H(size, std::vector<double>(size));
  for (std::size_t j = 0; j < joints; ++j) {
    Vector6 wrench = composite[at(tree.joints[j].child)] * direction_of(tree.joints[j], parameters);
    for (int i = static_cast<int>(j); i >= 0; i = tree.parent_joint_of(i)) {
      H[at(i)][j] = H[j][at(i)] = dot(wrench, direction_of(tree.joints[at(i)], parameters));
      Vector6 seen{};
      for (std::size_t r = 0; r < 6; ++r)
        for (std::size_t c = 0; c < 6; ++c) seen[c] += X[at(i)][r][c] * wrench[r];
      wrench = seen;
    }
    H[j][j] += drive_inertia(tree.joints[j].drive, parameters);
    for (std::size_t k = joints; k < size; ++k) H[k][j] = H[j][k] = wrench[k - joints];
  }
  for (std::size_t r = joints; r < size; ++r)
    for (std::size_t c = joints; c < size; ++c) H[r][c] = composite[0][r - joints][c - joints];
  return H;
}

// Adds the rows of G of joints that follow through loops. Any position serves, closed or not: at none of them do the
// rates have special values.
void add_rates_of_loops(
    const KinematicTree& tree,
    const std::vector<double>& parameters,
    std::vector<std::vector<std::pair<std::size_t, double>>>& G) {
  OrdinaryNumbers numbers;
  const std::vector<double> q = numbers.next(tree.joints.size());
  const auto add = [&](int follower, int joint, double rate) {
    if (rate == 0.0) return;
    for (const auto& [coordinate, factor] : G[at(joint)]) G[at(follower)].emplace_back(coordinate, rate * factor);
  };
  for (const Closure& closure : tree.closures) {
    if (closure.method == Closure::Method::iterative) {
      const LoopCluster cluster(tree, closure.loops, parameters);
      const auto rates = cluster.rates(q, closure.dependents);
      for (std::size_t d = 0; d < rates.size(); ++d)
        for (std::size_t k = 0; k < rates[d].size(); ++k) add(closure.dependents[d], cluster.joints()[k], rates[d][k]);
      continue;
    }
    const LoopJoint& loop = tree.loops[at(closure.loop())];
    const LoopPosture now = posture(tree, loop, q, parameters);
    const auto rates = rate_factors(closure, now, error_of(closure, now, evaluate(loop.length, parameters)));
    for (std::size_t d = 0; d < rates.size(); ++d)
      for (std::size_t k = 0; k < now.screws.size(); ++k) add(closure.dependents[d], now.screws[k].joint, rates[d][k]);
  }
}

// The inertia matrix of the independent coordinates, G' H G, followed by the base.
std::vector<std::vector<double>> inertia_of_coordinates(const KinematicTree& tree, double addition) {
  const std::vector<std::vector<double>> H = inertia_of_joints(tree, addition);
  const std::vector<double> parameters = OrdinaryNumbers().next(tree.parameters.size());
  const std::vector<int> independent = tree.coordinates();
  // By row of H: pairs of coordinate and factor.
  std::vector<std::vector<std::pair<std::size_t, double>>> G(H.size());
  for (std::size_t k = 0; k < independent.size(); ++k) G[at(independent[k])] = {{k, 1.0}};
  for (const Coupling& coupling : tree.couplings) {
    if (!coupling.is_linear()) continue;
    for (const Coupling::Term& term : coupling.terms)
      G[at(coupling.joint)].emplace_back(at(tree.coordinate_of(term.joint)), evaluate(term.factor, parameters));
  }
  add_rates_of_loops(tree, parameters, G);
  const std::size_t gone = tree.couplings.size();
  for (std::size_t row = tree.joints.size(); row < H.size(); ++row) G[row] = {{row - gone, 1.0}};
  std::vector<std::vector<double>> result(H.size() - gone, std::vector<double>(H.size() - gone));
  for (std::size_t i = 0; i < H.size(); ++i) {
    for (std::size_t j = 0; j < H.size(); ++j) {
      if (H[i][j] == 0.0) continue;
      for (const auto& [row, left] : G[i])
        for (const auto& [column, right] : G[j]) result[row][column] += left * H[i][j] * right;
    }
  }
  return result;
}

}  // namespace

Pivots pivots_of(const KinematicTree& tree, Beyond beyond, double addition) {
  OrdinaryNumbers numbers;
  const std::vector<double> parameters = numbers.next(tree.parameters.size());
  const std::vector<double> q = numbers.next(tree.joints.size());
  std::vector<Matrix6> articulated(tree.links.size(), Matrix6{});
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    if (tree.links[i].inertia) articulated[i] = spatial_inertia(*tree.links[i].inertia, parameters);
  }
  Pivots pivots;
  pivots.joints.resize(tree.joints.size());
  const std::vector<int> order = tree.topological();
  for (auto it = order.rbegin(); it != order.rend(); ++it) {
    const Joint& joint = tree.joints[at(*it)];
    Matrix6& inertia = articulated[at(joint.child)];
    add_in_proportion(inertia, addition);
    Matrix6 projected = inertia;
    const double own = drive_inertia(joint.drive, parameters);
    pivots.joints[at(*it)] = eliminate(projected, direction_of(joint, parameters), own);
    add_transformed(
        articulated[at(joint.parent)], motion_transform(joint, q[at(*it)], parameters),
        beyond == Beyond::free ? projected : inertia);
  }
  if (tree.floating_base) {
    add_in_proportion(articulated[0], addition);
    for (std::size_t i = 6; i-- > 0;) pivots.base.push_back(eliminate(articulated[0], unit(i)));
  }
  return pivots;
}

Pivots pivots_of_coordinates(const KinematicTree& tree, Beyond beyond, double addition) {
  std::vector<std::vector<double>> H = inertia_of_coordinates(tree, addition);
  Pivots pivots;
  for (std::size_t i = 0; i < H.size(); ++i) {
    const std::vector<double> row = H[i];
    (i < at(tree.dof()) ? pivots.joints : pivots.base).push_back(row[i]);
    if (beyond == Beyond::locked || row[i] == 0.0) continue;
    for (std::size_t r = i + 1; r < H.size(); ++r) {
      if (row[r] == 0.0) continue;
      for (std::size_t c = i + 1; c < H.size(); ++c) H[r][c] -= row[r] * row[c] / row[i];
    }
  }
  return pivots;
}

}  // namespace robcogen::model
