#include "algorithm/identification/identifiable.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algorithm/spatial/trace.h"

namespace robcogen::algorithm {
namespace {

// Directions that differ by less are the same; vectors have unit size, with lengths in units of the robot's size.
constexpr double kSame = 1e-9;

// An orthonormal basis of the space that vectors span.
template <std::size_t n>
class Span {
 public:
  using Vector = std::array<double, n>;

  const std::vector<Vector>& basis() const { return basis_; }

  // False if the span contains the vector already.
  bool add(Vector v) {
    if (!normalise(v, kSame)) return false;
    for (int pass = 0; pass < 2; ++pass)
      for (const Vector& b : basis_) {
        const double along = std::inner_product(v.begin(), v.end(), b.begin(), 0.0);
        for (std::size_t i = 0; i < n; ++i) v[i] -= along * b[i];
      }
    if (!normalise(v, kSame)) return false;
    basis_.push_back(v);
    return true;
  }

  void add(const Span& other) {
    for (const Vector& v : other.basis_) add(v);
  }

  // Extends the span until these maps do not lead out of it.
  template <class Map>
  void close(const std::vector<Map>& maps) {
    for (std::size_t i = 0; i < basis_.size(); ++i)
      for (const Map& map : maps) add(map(Vector(basis_[i])));
  }

 private:
  std::vector<Vector> basis_;

  static bool normalise(Vector& v, double least) {
    const double length = std::sqrt(std::inner_product(v.begin(), v.end(), v.begin(), 0.0));
    if (!(length > least)) return false;
    for (double& x : v) x /= length;
    return true;
  }
};

using Parameters = std::array<double, kParametersOfLink>;  // or a linear function of them
using Functions = Span<kParametersOfLink>;
using Twist = std::array<double, 6>;
using Twists = Span<6>;
using Matrix4 = std::array<std::array<double, 4>, 4>;

Matrix4 operator*(const Matrix4& a, const Matrix4& b) {
  Matrix4 c{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 4; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}

Matrix4 transposed(const Matrix4& a) {
  Matrix4 b{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) b[j][i] = a[i][j];
  return b;
}

// A twist as the matrix that gives the velocity of points, and back.
Matrix4 hat(const Twist& t) {
  return {{{0, -t[2], t[1], t[3]}, {t[2], 0, -t[0], t[4]}, {-t[1], t[0], 0, t[5]}, {0, 0, 0, 0}}};
}
Twist vee(const Matrix4& m) {
  return {m[2][1], m[0][2], m[1][0], m[0][3], m[1][3], m[2][3]};
}

// The integral of (p, 1) (p, 1)' dm (Wensing, Kim and Slotine 2018), and back; with moments of mass.
Matrix4 pseudo_inertia(const Parameters& p) {
  return {{{p[4], p[7], p[8], p[1]}, {p[7], p[5], p[9], p[2]}, {p[8], p[9], p[6], p[3]}, {p[1], p[2], p[3], p[0]}}};
}
Parameters parameters_of(const Matrix4& J) {
  return {J[3][3], J[0][3], J[1][3], J[2][3], J[0][0], J[1][1], J[2][2], J[0][1], J[0][2], J[1][2]};
}

// A linear function of parameters that go through this map first.
template <class Map>
Parameters through(const Parameters& function, const Map& map) {
  Parameters result{};
  for (std::size_t k = 0; k < result.size(); ++k) {
    Parameters unit{};
    unit[k] = 1;
    const Parameters moved = parameters_of(map(pseudo_inertia(unit)));
    result[k] = std::inner_product(function.begin(), function.end(), moved.begin(), 0.0);
  }
  return result;
}

// The power of one motion against the other, as a function of the parameters: trace of a J b'.
Parameters felt(const Twist& a, const Twist& b) {
  const Matrix4 left = hat(a), right = transposed(hat(b));
  Parameters result{};
  for (std::size_t k = 0; k < result.size(); ++k) {
    Parameters unit{};
    unit[k] = 1;
    const Matrix4 product = left * pseudo_inertia(unit) * right;
    for (std::size_t i = 0; i < 3; ++i) result[k] += product[i][i];
  }
  return result;
}

// The joint's placement with lengths in this unit.
Matrix4 pose_of(const model::Placement& placement, const std::vector<double>& values, double unit) {
  const auto rotation = model::rotation_matrix(placement);
  Matrix4 pose{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) pose[i][j] = evaluate(rotation[i][j], values);
    pose[i][3] = evaluate(placement.translation[i], values) / unit;
  }
  pose[3][3] = 1;
  return pose;
}

Matrix4 inverse(const Matrix4& pose) {
  Matrix4 result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      result[i][j] = pose[j][i];
      result[i][3] -= pose[j][i] * pose[j][3];
    }
  }
  result[3][3] = 1;
  return result;
}

double unit_of_length(const model::KinematicTree& tree, const std::vector<double>& values) {
  double largest = 0;
  for (const model::Joint& joint : tree.joints)
    for (const model::Quantity& q : joint.placement.translation)
      largest = std::max(largest, std::abs(evaluate(q, values)));
  return largest > 0 ? largest : 1;
}

// The motion subspace of a joint as numbers; three twists for a spherical joint, given any of its components.
std::vector<Twist> twists_of(
    const model::KinematicTree& tree,
    int joint,
    const std::vector<double>& values,
    double unit) {
  const model::Joint& of_model = tree.joints[at(joint)];
  switch (of_model.type) {
    case model::JointType::revolute:
      break;
    case model::JointType::prismatic:
      return {{0, 0, 0, 0, 0, 1}};
    case model::JointType::helical:
      return {{0, 0, 1, 0, 0, evaluate(of_model.pitch, values) / unit}};
    case model::JointType::spherical:
      return {{1, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0}};
  }
  return {{0, 0, 1, 0, 0, 0}};
}

// What a link passes on to its children: the motions that it may have, the functions that are felt, and those that must
// not change.
struct FeltLink {
  Twists motions;
  Functions felt, unchanged;
};

// A base that is fixed, or that can move in all ways.
FeltLink felt_by_base(bool floating, Loads loads) {
  FeltLink base;
  for (std::size_t k = 0; k < 6; ++k)
    if (Twist unit{}; floating) unit[k] = 1, base.motions.add(unit);
  // Gravity acts like an acceleration of the base.
  for (std::size_t axis = loads == Loads::standard_gravity ? 5 : 3; !floating && axis < 6; ++axis) {
    Twist unit{};
    unit[axis] = 1;
    base.motions.add(unit);
  }
  for (std::size_t k = 0; floating && k < kParametersOfLink; ++k) {
    Parameters unit{};
    unit[k] = 1;
    base.felt.add(unit);
  }
  base.unchanged = base.felt;
  return base;
}

// How a motion changes when a joint moves.
struct ChangeOfTwist {
  Matrix4 rate;

  Twist operator()(const Twist& t) const {
    const Matrix4 m = hat(t), left = rate * m, right = m * rate;
    Matrix4 change{};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) change[i][j] = left[i][j] - right[i][j];
    return vee(change);
  }
};

// How a function of the parameters of the moving links changes.
struct ChangeOfFunction {
  Matrix4 rate;

  Parameters operator()(const Parameters& f) const {
    return through(f, [&](const Matrix4& J) {
      Matrix4 change = rate * J;
      const Matrix4 other = transposed(change);
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) change[i][j] += other[i][j];
      return change;
    });
  }
};

FeltLink felt_by_child(const FeltLink& parent, const Matrix4& pose, const std::vector<Twist>& subspace) {
  const Matrix4 back = inverse(pose);
  std::vector<ChangeOfTwist> of_motions;
  std::vector<ChangeOfFunction> of_functions;
  for (const Twist& S : subspace) {
    of_motions.push_back({hat(S)});
    of_functions.push_back({hat(S)});
  }
  FeltLink child;
  for (const Twist& motion : parent.motions.basis()) child.motions.add(vee(back * hat(motion) * pose));
  child.motions.close(of_motions);
  for (const Twist& S : subspace) child.motions.add(S);
  for (const Twist& S : subspace)
    for (const Twist& motion : child.motions.basis()) child.felt.add(felt(S, motion));
  // The parent's functions as functions of the child's parameters, and their changes when the joint moves.
  const auto at_rest = [&](const Matrix4& J) { return pose * J * transposed(pose); };
  Functions carried, changes;
  for (const Parameters& f : parent.unchanged.basis()) carried.add(through(f, at_rest));
  for (const Parameters& f : carried.basis())
    for (const ChangeOfFunction& change : of_functions) changes.add(change(f));
  changes.close(of_functions);
  child.felt.add(changes);
  child.unchanged = child.felt;
  child.unchanged.add(carried);
  return child;
}

// The functions as combinations, each with one parameter that no other has: for the link of a revolute joint h_x, h_y,
// S_xx, S_yy, S_xy, S_xz and S_yz, for that of a prismatic joint the mass and the first moment, as far as there are
// that many.
std::vector<Combination> reduced(const Functions& felt, double unit) {
  constexpr std::array<std::size_t, kParametersOfLink> kPreferred = {1, 2, 4, 5, 7, 8, 9, 3, 0, 6};
  constexpr std::array<int, kParametersOfLink> kLengths = {0, 1, 1, 1, 2, 2, 2, 2, 2, 2};
  std::vector<Parameters> rows = felt.basis();
  std::vector<Combination> result;
  for (const std::size_t p : kPreferred) {
    const std::size_t done = result.size();
    std::size_t pivot = done;
    for (std::size_t r = done; r < rows.size(); ++r)
      if (std::abs(rows[r][p]) > std::abs(rows[pivot][p])) pivot = r;
    if (done == rows.size() || std::abs(rows[pivot][p]) < kSame) continue;
    std::swap(rows[done], rows[pivot]);
    const double scale = rows[done][p];
    for (double& x : rows[done]) x /= scale;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (r == done) continue;
      const double factor = rows[r][p];
      for (std::size_t k = 0; k < rows[r].size(); ++k) rows[r][k] -= factor * rows[done][k];
    }
    result.push_back({static_cast<int>(p), {}});
  }
  for (std::size_t r = 0; r < result.size(); ++r) {
    const auto p = static_cast<std::size_t>(result[r].parameter);
    for (std::size_t k = 0; k < rows[r].size(); ++k) {
      const double nearest = std::round(2 * rows[r][k]) / 2;
      const double number = std::abs(rows[r][k] - nearest) < kSame ? nearest : rows[r][k];
      result[r].coefficients[k] = number * std::pow(unit, kLengths[p] - kLengths[k]);
    }
  }
  std::sort(result.begin(), result.end(), [](const Combination& a, const Combination& b) {
    return a.parameter < b.parameter;
  });
  return result;
}

using CombinationsOfLinks = std::vector<std::vector<Combination>>;

CombinationsOfLinks combinations_for(const model::KinematicTree& tree, Loads loads, const std::vector<double>& values) {
  const double unit = unit_of_length(tree, values);
  std::vector<FeltLink> links(tree.links.size());
  links[0] = felt_by_base(tree.floating_base, loads);
  for (const int j : tree.topological()) {
    const model::Joint& joint = tree.joints[at(j)];
    if (!joint.is_first()) continue;
    const int child = joint.spherical.empty() ? joint.child : tree.joints[at(j + 2)].child;
    links[at(child)] = felt_by_child(
        links[at(joint.parent)], pose_of(joint.placement, values, unit), twists_of(tree, j, values, unit));
  }
  CombinationsOfLinks result;
  for (const FeltLink& link : links) result.push_back(reduced(link.felt, unit));
  return result;
}

bool are_equal(const std::vector<Combination>& a, const std::vector<Combination>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Combination& x, const Combination& y) {
    bool same = x.parameter == y.parameter;
    for (std::size_t k = 0; k < x.coefficients.size(); ++k)
      same = same && std::abs(x.coefficients[k] - y.coefficients[k]) <= kSame;
    return same;
  });
}

// All that may be felt of a link, as if all motions were possible below it.
std::vector<Combination> most_of(const model::KinematicTree& tree, int link) {
  const int joint = tree.links[at(link)].parent_joint;
  const FeltLink any = felt_by_base(true, Loads::gravity);
  if (joint < 0) return reduced(any.felt, 1);
  Matrix4 identity{};
  for (std::size_t i = 0; i < 4; ++i) identity[i][i] = 1;
  return reduced(felt_by_child(any, identity, twists_of(tree, joint, parameter_values(tree), 1)).felt, 1);
}

}  // namespace

CombinationsOfLinks identifiable_combinations(const model::KinematicTree& tree, Loads loads) {
  std::vector<double> values = parameter_values(tree);
  CombinationsOfLinks result = combinations_for(tree, loads, values);
  if (tree.parameters.empty()) return result;
  for (int trial = 1; trial <= 2; ++trial) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += 0.1 * trial + 0.05 / static_cast<double>(2 + i);
    const CombinationsOfLinks other = combinations_for(tree, loads, values);
    for (std::size_t link = 0; link < result.size(); ++link)
      if (!are_equal(result[link], other[link])) result[link] = most_of(tree, static_cast<int>(link));
  }
  return result;
}

}  // namespace robcogen::algorithm
