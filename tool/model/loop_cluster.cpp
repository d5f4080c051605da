#include "model/loop_cluster.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "model/loop_plane.h"
#include "support/index.h"

namespace robcogen::model {
namespace {

using Column = std::vector<double>;

double inner_product(const Column& a, const Column& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

double length_of(const Column& a) {
  return std::sqrt(inner_product(a, a));
}

// An orthonormal basis of columns, built by modified Gram-Schmidt (Golub and Van Loan 2013, sec. 5.2.8).
class Basis {
 public:
  // Adds the part of the column that is orthogonal to the basis, unless it is smaller than this fraction of the column.
  // Returns whether it was added.
  bool add(const Column& column, double least_part) {
    const double before = length_of(column);
    Column left = column;
    Column factors;
    for (const Column& unit : units_) {
      factors.push_back(inner_product(unit, left));
      for (std::size_t i = 0; i < left.size(); ++i) left[i] -= factors.back() * unit[i];
    }
    const double after = length_of(left);
    if (!(before > 0.0) || !(after > least_part * before)) return false;
    for (double& x : left) x /= after;
    factors.push_back(after);
    units_.push_back(std::move(left));
    factors_.push_back(std::move(factors));
    return true;
  }

  // Returns the least-squares solution x of columns * x = b.
  Column solve(Column b) const {
    Column x(units_.size());
    for (std::size_t k = 0; k < units_.size(); ++k) {
      x[k] = inner_product(units_[k], b);
      for (std::size_t i = 0; i < b.size(); ++i) b[i] -= x[k] * units_[k][i];
    }
    for (std::size_t k = x.size(); k-- > 0;) {
      x[k] /= factors_[k][k];
      for (std::size_t i = 0; i < k; ++i) x[i] -= factors_[k][i] * x[k];
    }
    return x;
  }

 private:
  std::vector<Column> units_;
  std::vector<Column> factors_;  // the columns of R
};

// Joint motions that differ by less than this fraction are the same.
constexpr double kSameMotion = 1e-6;
// Of the size of the loops: motions below this are rounding, as where a rod spins about the line between its ends.
constexpr double kNoMotion = 1e-13;

void append(Column& rows, const Numbers3& v, double factor = 1.0) {
  for (const double x : v) rows.push_back(factor * x);
}

// Half the sum of the cross products of the axes: the sine of the angle between the two frames, times the rotation
// axis.
Numbers3 turn_between(const std::array<Numbers3, 3>& first, const std::array<Numbers3, 3>& second) {
  Numbers3 sum{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Numbers3 part = cross(first[k], second[k]);
    for (std::size_t i = 0; i < 3; ++i) sum[i] += 0.5 * part[i];
  }
  return sum;
}

// Whether frames that are to be parallel differ by half a turn: the sine between them is zero as well.
bool is_opposite(const LoopJoint& loop, const LoopPosture& at) {
  if (loop.type != LoopType::slider && loop.type != LoopType::weld) return false;
  double cosines = 0.0;
  for (std::size_t k = 0; k < 3; ++k) cosines += dot(at.axes[0][k], at.axes[1][k]);
  return cosines < 0.0;
}

// The constraint rows of a loop, for the motion of its second frame relative to the first: as an error, or as a rate.
struct LoopRows {
  const LoopJoint& loop;
  const LoopPosture& at;
  double size, distance;

  Column error() const {
    const auto& [first, second] = at.axes;
    const Numbers3 apart = at.points[1] - at.points[0];
    const Numbers3 turn = turn_between(first, second);
    switch (loop.type) {
      case LoopType::distance:
        return {0.5 * (dot(apart, apart) - distance * distance) / (distance > 0.0 ? distance : 1.0)};
      case LoopType::hinge:
        return rows(apart, {}, {dot(first[0], second[2]), dot(first[1], second[2])});
      default:
        return rows(apart, turn, {});
    }
  }

  Column rate(const LoopScrew& screw) const {
    const double sign = screw.end == 0 ? -1.0 : 1.0;
    const Numbers3 point = loop.type == LoopType::slider ? at.points[1] : at.points[at_end(screw)];
    Numbers3 turn{}, motion{};
    if (screw.turns) {
      motion = cross(screw.axis, point - screw.origin);
      turn = screw.axis;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      turn[i] *= sign;
      motion[i] = sign * (motion[i] + screw.slide * screw.axis[i]);
    }
    const auto& [first, second] = at.axes;
    switch (loop.type) {
      case LoopType::distance:
        return {dot(at.points[1] - at.points[0], motion) / (distance > 0.0 ? distance : 1.0)};
      case LoopType::hinge:
        return rows(motion, {}, {dot(cross(second[2], first[0]), turn), dot(cross(second[2], first[1]), turn)});
      default:
        return rows(motion, turn, {});
    }
  }

 private:
  static std::size_t at_end(const LoopScrew& screw) { return static_cast<std::size_t>(screw.end); }

  Column rows(const Numbers3& motion, const Numbers3& turn, const Column& of_axis) const {
    Column result;
    const auto& first = at.axes[0];
    if (loop.type == LoopType::slider)
      result = {dot(first[0], motion), dot(first[1], motion)};
    else
      append(result, motion);
    if (loop.type == LoopType::slider || loop.type == LoopType::weld) append(result, turn, size);
    for (const double x : of_axis) result.push_back(size * x);
    return result;
  }
};

}  // namespace

LoopCluster::LoopCluster(const KinematicTree& tree, std::vector<int> loops, std::vector<double> parameters)
    : tree_(tree), loops_(std::move(loops)), parameters_(std::move(parameters)) {
  std::set<int> joints;
  for (const int loop : loops_)
    for (const LoopEnd& end : tree_.loops[at(loop)].ends)
      for (const int joint : end.joints) {
        const Coupling* coupling = tree_.coupling_of(joint);
        if (coupling == nullptr || !coupling->is_linear())
          joints.insert(joint);
        else
          for (const Coupling::Term& term : coupling->terms) joints.insert(term.joint);
      }
  joints_.assign(joints.begin(), joints.end());
}

std::size_t LoopCluster::column_of(int joint) const {
  return static_cast<std::size_t>(std::lower_bound(joints_.begin(), joints_.end(), joint) - joints_.begin());
}

void LoopCluster::follow_couplings(std::vector<double>& q) const {
  for (const Coupling& coupling : tree_.couplings) {
    if (!coupling.is_linear()) continue;
    double& position = q[at(coupling.joint)];
    position = evaluate(coupling.offset, parameters_);
    for (const Coupling::Term& term : coupling.terms)
      position += evaluate(term.factor, parameters_) * q[at(term.joint)];
  }
}

double LoopCluster::size(const std::vector<double>& q) const {
  double largest = 0.0;
  for (const int loop : loops_)
    largest = std::max(largest, size_of(posture(tree_, tree_.loops[at(loop)], q, parameters_)));
  return largest > 0.0 ? largest : 1.0;
}

LoopCluster::Rows LoopCluster::rows(std::vector<double>& q) const {
  follow_couplings(q);
  const double lever = size(q);
  Rows all{{}, std::vector<Column>(joints_.size())};
  for (const int index : loops_) {
    const LoopJoint& loop = tree_.loops[at(index)];
    const LoopPosture now = posture(tree_, loop, q, parameters_);
    const LoopRows of_loop{loop, now, lever, evaluate(loop.length, parameters_)};
    const Column error = of_loop.error();
    const std::size_t first = all.error.size();
    all.error.insert(all.error.end(), error.begin(), error.end());
    for (Column& column : all.columns) column.resize(all.error.size());
    const auto add = [&](int joint, double factor, const Column& rate) {
      Column& column = all.columns[column_of(joint)];
      for (std::size_t i = 0; i < rate.size(); ++i) column[first + i] += factor * rate[i];
    };
    for (const LoopScrew& screw : now.screws) {
      const Column rate = of_loop.rate(screw);
      const Coupling* coupling = tree_.coupling_of(screw.joint);
      if (coupling == nullptr || !coupling->is_linear())
        add(screw.joint, 1.0, rate);
      else
        for (const Coupling::Term& term : coupling->terms) add(term.joint, evaluate(term.factor, parameters_), rate);
    }
  }
  for (Column& column : all.columns)
    if (length_of(column) < kNoMotion * lever) std::fill(column.begin(), column.end(), 0.0);
  return all;
}

int LoopCluster::rank(std::vector<double> q) const {
  const Rows now = rows(q);
  Basis basis;
  // Columns that differ clearly from the others are taken first, and columns that nearly depend on others last.
  int rank = 0;
  std::vector<bool> is_taken(now.columns.size());
  for (const double least : {0.1, 1e-3, kSameMotion})
    for (std::size_t k = 0; k < now.columns.size(); ++k)
      if (!is_taken[k] && basis.add(now.columns[k], least)) is_taken[k] = true, ++rank;
  return rank;
}

std::vector<int> LoopCluster::following(std::vector<double> q, const std::vector<int>& candidates) const {
  constexpr double kFirst = 0.1, kDetermined = 1e-4;
  const Rows now = rows(q);
  Basis basis;
  std::set<int> chosen;
  for (const double least : {kFirst, kDetermined})
    for (const int joint : candidates)
      if (!chosen.contains(joint) && basis.add(now.columns[column_of(joint)], least)) chosen.insert(joint);
  return {chosen.begin(), chosen.end()};
}

bool LoopCluster::has_opposite_frames(const std::vector<double>& q) const {
  return std::any_of(loops_.begin(), loops_.end(), [&](int loop) {
    return is_opposite(tree_.loops[at(loop)], posture(tree_, tree_.loops[at(loop)], q, parameters_));
  });
}

double LoopCluster::close(std::vector<double>& q, const std::vector<int>& following) const {
  constexpr int kSteps = 60;
  constexpr double kLargestStep = 0.5;  // rad, m: so that iteration reaches the nearest solution
  double gap = 0.0;
  for (int step = 0; step < kSteps; ++step) {
    const Rows now = rows(q);
    gap = length_of(now.error);
    Basis basis;
    for (const int joint : following)
      if (!basis.add(now.columns[column_of(joint)], 1e-12)) return gap;
    const Column move = basis.solve(now.error);
    double largest = 0.0;
    for (const double x : move) largest = std::max(largest, std::abs(x));
    if (!(largest < 1e6)) return gap;
    const double share = largest > kLargestStep ? kLargestStep / largest : 1.0;
    for (std::size_t k = 0; k < move.size(); ++k) q[at(following[k])] -= share * move[k];
  }
  return has_opposite_frames(q) ? std::numeric_limits<double>::infinity() : gap;
}

std::vector<std::vector<double>> LoopCluster::rates(std::vector<double> q, const std::vector<int>& following) const {
  const Rows now = rows(q);
  Basis basis;
  for (const int joint : following) basis.add(now.columns[column_of(joint)], 0.0);
  std::vector<std::vector<double>> factors(following.size(), std::vector<double>(joints_.size()));
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    if (std::find(following.begin(), following.end(), joints_[k]) != following.end()) continue;
    const Column moved = basis.solve(now.columns[k]);
    for (std::size_t d = 0; d < moved.size(); ++d) factors[d][k] = -moved[d];
  }
  return factors;
}

}  // namespace robcogen::model
