// Finds motions without inertia: the joint-space inertia matrix H is singular in every position.
//
// Eliminating the joints from the leaves to the base (the articulated-body recursion, Featherstone 2008, section 7.3)
// yields the pivots of a factorisation of H: pivot j is the inertia that joint j meets while the joints beyond it are
// free. H is singular where a pivot is zero; and as its determinant is analytic in q, it is singular everywhere if it
// is at a position without special angles.
//
// A computed zero is zero only up to rounding, and the scale of rounding depends on the units and sizes of the robot.
// Therefore a small inertia is added to every articulated inertia, in proportion to it: a pivot that doubles when this
// addition doubles consists of the addition only.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "model/plausibility.h"
#include "support/index.h"

namespace robcogen::model {

namespace {

// Large compared with the rounding of one recursion step, small compared with any real inertia of a robot.
constexpr double kAddition = 1e-12;

using Matrix6 = std::array<std::array<double, 6>, 6>;  // spatial, angular rows first

// Repeatable numbers between 0.5 and 1.5: no special angles, lengths or masses.
class OrdinaryNumbers {
 public:
  double next() { return 0.5 + static_cast<double>(engine_() >> 11) * 0x1p-53; }
  std::vector<double> next(std::size_t count) {
    std::vector<double> values(count);
    for (double& value : values) value = next();
    return values;
  }

 private:
  std::mt19937_64 engine_{5489};
};

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

// child_X_parent of spatial motion vectors.
Matrix6 motion_transform(const Joint& joint, double q, const std::vector<double>& parameters) {
  std::array<double, 3> p{}, sine{}, cosine{};
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = evaluate(joint.placement.translation[i], parameters);
    // Turning about z is the last rotation of the placement and the motion of a revolute joint.
    const double own = i == 2 && joint.type == JointType::revolute ? q : 0.0;
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
  if (joint.type == JointType::prismatic) {
    for (std::size_t i = 0; i < 3; ++i) p[i] += q * R[i][2];
  }
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

// Makes one direction free: leaves the inertia that the others meet. Without any inertia, leaves all as it is. `own` is
// inertia that motion in this direction alone meets. Returns the pivot.
double eliminate(Matrix6& a, std::size_t direction, double own = 0.0) {
  const std::array<double, 6> column = a[direction];
  const double pivot = column[direction] + own;
  if (pivot == 0.0) return pivot;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) a[i][j] -= column[i] * column[j] / pivot;
  }
  return pivot;
}

// That the joint alone meets. How a rotor couples with its carrier does not matter here: the carrier's own inertia
// about the rotor's axis, which includes the rotor, outweighs that.
double drive_inertia(const Drive& drive, const std::vector<double>& parameters) {
  const double armature = evaluate(drive.armature, parameters);
  return drive.rotor ? armature + evaluate(drive.rotor->inertia * drive.rotor->ratio * drive.rotor->ratio, parameters)
                     : armature;
}

struct Pivots {
  std::vector<double> joints;
  std::vector<double> base;  // of a floating base; empty for a fixed one
};

enum class Beyond { free, locked };  // the joints beyond the one under examination

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
    pivots.joints[at(*it)] = eliminate(projected, joint.type == JointType::revolute ? 2 : 5, own);
    add_transformed(
        articulated[at(joint.parent)], motion_transform(joint, q[at(*it)], parameters),
        beyond == Beyond::free ? projected : inertia);
  }
  if (tree.floating_base) {
    add_in_proportion(articulated[0], addition);
    for (std::size_t i = 6; i-- > 0;) pivots.base.push_back(eliminate(articulated[0], i));
  }
  return pivots;
}

// Of the pivots with the addition and with twice the addition.
std::vector<bool> zeros(const std::vector<double>& once, const std::vector<double>& twice) {
  std::vector<bool> result(once.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    // A half for a zero, close to 0 for an inertia; false after an overflow.
    result[i] = twice[i] - once[i] >= 0.4 * std::abs(twice[i]);
  }
  return result;
}

struct Zeros {
  std::vector<bool> joints;
  std::vector<bool> base;
};

Zeros zero_pivots(const KinematicTree& tree, Beyond beyond) {
  const Pivots once = pivots_of(tree, beyond, kAddition);
  const Pivots twice = pivots_of(tree, beyond, 2.0 * kAddition);
  return {zeros(once.joints, twice.joints), zeros(once.base, twice.base)};
}

bool any(const std::vector<bool>& flags) {
  return std::find(flags.begin(), flags.end(), true) != flags.end();
}

bool moves(const KinematicTree& tree, std::size_t link) {
  return link > 0 || tree.floating_base;
}

bool has_inertia(const Link& link) {
  if (!link.inertia) return false;
  const Inertia& i = *link.inertia;
  for (const Quantity* q : {&i.mass, &i.ixx, &i.iyy, &i.izz, &i.ixy, &i.ixz, &i.iyz})
    if (!q->is_constant() || q->number().value() != 0.0) return true;
  return false;
}

bool has_no_mass(const KinematicTree& tree) {
  const std::vector<double> parameters = OrdinaryNumbers().next(tree.parameters.size());
  double sum = 0.0, size = 0.0;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    if (!moves(tree, i) || !tree.links[i].inertia) continue;
    const double mass = evaluate(tree.links[i].inertia->mass, parameters);
    sum += mass;
    size += std::abs(mass);
  }
  return std::abs(sum) <= kAddition * size;
}

}  // namespace

InertiaDefects inertia_defects(const KinematicTree& tree) {
  InertiaDefects defects;
  bool some_move = false, some_have = false;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    some_move = some_move || moves(tree, i);
    some_have = some_have || (moves(tree, i) && has_inertia(tree.links[i]));
  }
  for (const Joint& joint : tree.joints) some_have = some_have || joint.drive.has_inertia();
  if (!some_move) return defects;
  const Zeros free = zero_pivots(tree, Beyond::free);
  const Zeros locked = zero_pivots(tree, Beyond::locked);
  defects.no_inertia = !some_have;
  defects.no_mass = has_no_mass(tree);
  for (std::size_t i = 0; i < tree.joints.size(); ++i) {
    if (!free.joints[i]) continue;
    defects.joints.push_back({static_cast<int>(i), locked.joints[i]});
  }
  defects.free_base = any(free.base);
  defects.locked_base = any(locked.base);
  return defects;
}

}  // namespace robcogen::model
