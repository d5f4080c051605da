#include "algorithm/spatial/couplings.h"

#include <algorithm>

namespace robcogen::algorithm {

std::vector<std::vector<MovedJoint>> moved_joints(Trace& trace) {
  const model::KinematicTree& tree = trace.tree;
  std::vector<std::vector<MovedJoint>> result;
  for (const int joint : tree.coordinates()) result.push_back({{joint, Expression()}});
  for (const model::Coupling& coupling : tree.couplings) {
    if (!coupling.is_linear()) {
      for (const RateTerm& share : trace.rates_of(coupling))
        result[at(tree.coordinate_of(share.joint))].push_back({coupling.joint, share.factor});
      continue;
    }
    for (const model::Coupling::Term& term : coupling.terms)
      result[at(tree.coordinate_of(term.joint))].push_back({coupling.joint, trace.lift(term.factor)});
  }
  return result;
}

std::vector<std::vector<MovedJoint>> moved_joint_rates(Trace& trace, const std::vector<Expression>& qd) {
  std::vector<std::vector<MovedJoint>> result;
  for (const std::vector<MovedJoint>& moved : moved_joints(trace)) {
    std::vector<Expression> unit(trace.tree.joints.size());
    unit[at(moved.front().joint)] = trace.graph.one();
    for (std::size_t k = 1; k < moved.size(); ++k) unit[at(moved[k].joint)] = moved[k].factor;
    const std::vector<Expression> added = trace.added_by_loops(qd, unit);
    std::vector<MovedJoint>& changes = result.emplace_back();
    for (std::size_t j = 0; j < added.size(); ++j)
      if (!added[j].is_zero()) changes.push_back({static_cast<int>(j), added[j]});
  }
  return result;
}

std::vector<Expression> by_coordinate(Trace& trace, const std::vector<Expression>& by_joint) {
  if (trace.tree.couplings.empty()) return by_joint;
  std::vector<Expression> result;
  for (const std::vector<MovedJoint>& moved : moved_joints(trace))
    result.push_back(sum_of(moved, [&](int joint) { return by_joint[at(joint)]; }));
  return result;
}

namespace {

// Elements of G' m G.
class ReducedMatrix {
 public:
  ReducedMatrix(Trace& trace, const SquareMatrix& by_joint, int base)
      : moved_(moved_joints(trace)), by_joint_(by_joint), base_(base) {}

  int size() const { return base_ + static_cast<int>(moved_.size()); }
  Expression element(int row, int column) const {
    if (row < base_) return times_G(row, column);
    return sum_of(moved_[at(row - base_)], [&](int joint) { return times_G(base_ + joint, column); });
  }

 private:
  std::vector<std::vector<MovedJoint>> moved_;
  const SquareMatrix& by_joint_;
  int base_;

  // An element of m G, whose rows are those of joints.
  Expression times_G(int row, int column) const {
    if (column < base_) return by_joint_(row, column);
    return sum_of(moved_[at(column - base_)], [&](int joint) { return by_joint_(row, base_ + joint); });
  }
};

}  // namespace

SquareMatrix by_coordinate(Trace& trace, const SquareMatrix& by_joint, int base, Symmetry symmetry) {
  if (trace.tree.couplings.empty()) return by_joint;
  const ReducedMatrix reduced(trace, by_joint, base);
  SquareMatrix result(reduced.size());
  for (int row = 0; row < result.size(); ++row) {
    const int end = symmetry == Symmetry::symmetric ? row + 1 : result.size();
    for (int column = 0; column < end; ++column) result(row, column) = reduced.element(row, column);
    if (symmetry == Symmetry::symmetric)
      for (int column = 0; column < row; ++column) result(column, row) = result(row, column);
  }
  return result;
}

SquareMatrix coriolis_by_coordinate(
    Trace& trace,
    const SquareMatrix& C,
    const SquareMatrix& H,
    const std::vector<Expression>& qd,
    int base) {
  const std::vector<std::vector<MovedJoint>> rows = moved_joints(trace), changes = moved_joint_rates(trace, qd);
  SquareMatrix result = by_coordinate(trace, C, base, Symmetry::none);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const auto of_changes = [&](int row) {
      Expression sum;
      for (const MovedJoint& change : changes[i]) sum += H(row, base + change.joint) * change.factor;
      return sum;
    };
    const int column = base + static_cast<int>(i);
    for (int row = 0; row < base; ++row) result(row, column) += of_changes(row);
    for (std::size_t r = 0; r < rows.size(); ++r)
      result(base + static_cast<int>(r), column) +=
          sum_of(rows[r], [&](int joint) { return of_changes(base + joint); });
  }
  return result;
}

Columns rows_by_coordinate(Trace& trace, const Columns& columns, int base) {
  if (trace.tree.couplings.empty()) return columns;
  const std::vector<std::vector<MovedJoint>> moved = moved_joints(trace);
  Columns result;
  for (const std::vector<Expression>& column : columns) {
    std::vector<Expression>& reduced = result.emplace_back(column.begin(), column.begin() + base);
    for (const std::vector<MovedJoint>& rows : moved)
      reduced.push_back(sum_of(rows, [&](int joint) { return column[at(base + joint)]; }));
  }
  return result;
}

Columns by_coordinate(Trace& trace, const Columns& by_joint, int base) {
  if (trace.tree.couplings.empty()) return by_joint;
  const Columns columns = rows_by_coordinate(trace, by_joint, base);
  Columns result;
  for (const std::vector<MovedJoint>& moved : moved_joints(trace)) {
    std::vector<Expression>& sum = result.emplace_back();
    for (std::size_t row = 0; row < columns.front().size(); ++row)
      sum.push_back(sum_of(moved, [&](int joint) { return columns[at(joint)][row]; }));
  }
  return result;
}

std::vector<Motion> columns_by_coordinate(
    Trace& trace,
    const std::vector<int>& joints,
    const std::vector<Motion>& columns) {
  if (trace.tree.couplings.empty()) return columns;
  const std::vector<std::vector<MovedJoint>> moved = moved_joints(trace);
  std::vector<Motion> result;
  for (const int coordinate : coordinates_of(trace.tree, joints)) {
    const auto column = [&](int joint) {
      const auto found = std::find(joints.begin(), joints.end(), joint);
      return found == joints.end() ? Motion() : columns[static_cast<std::size_t>(found - joints.begin())];
    };
    result.push_back(sum_of(moved[at(coordinate)], column));
  }
  return result;
}

std::vector<int> coordinates_of(const model::KinematicTree& tree, const std::vector<int>& joints) {
  std::vector<int> result;
  const auto add = [&](int joint) {
    const int coordinate = tree.coordinate_of(joint);
    if (std::find(result.begin(), result.end(), coordinate) == result.end()) result.push_back(coordinate);
  };
  for (const int joint : joints) {
    const model::Coupling* coupling = tree.coupling_of(joint);
    if (coupling == nullptr) add(joint);
    if (coupling != nullptr)
      for (const model::Coupling::Term& term : coupling->terms) add(term.joint);
  }
  return result;
}

}  // namespace robcogen::algorithm
