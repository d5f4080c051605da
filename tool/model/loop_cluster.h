// Loops that Newton's method closes together, because no formula closes them. They may have any joints, in space.
#pragma once

#include <vector>

#include "model/loop_geometry.h"

namespace robcogen::model {

class LoopCluster {
 public:
  // `loops` are indices of loops of the tree, which must outlive this object. In the functions below, positions q (rad,
  // m) are by joint; positions of coupled joints are ignored and computed from the joints that they follow.
  LoopCluster(const KinematicTree& tree, std::vector<int> loops, std::vector<double> parameters);

  // The joints that move the ends of the loops, in the order of the tree. Coupled joints are replaced by the joints
  // that they follow.
  const std::vector<int>& joints() const { return joints_; }
  // The longest lever arm (m).
  double size(const std::vector<double>& q) const;

  // The number of joint motions that the loops remove: the rank of their constraints.
  int rank(std::vector<double> q) const;
  // Chooses the dependent joints: as many of the candidates as the other joints determine. Earlier candidates are
  // preferred, and well determined ones above all.
  std::vector<int> following(std::vector<double> q, const std::vector<int>& candidates) const;
  // Moves these joints from their present positions until the loops close. Returns the remaining gap (m).
  double close(std::vector<double>& q, const std::vector<int>& following) const;
  // By joint of `following` and by joint of joints(): the displacement of the first per unit displacement of the
  // second; zero if the second is dependent too.
  std::vector<std::vector<double>> rates(std::vector<double> q, const std::vector<int>& following) const;

 private:
  const KinematicTree& tree_;
  std::vector<int> loops_;
  std::vector<double> parameters_;
  std::vector<int> joints_;

  // Rows are in metres: rotations are multiplied by the size. There is one column for each of joints().
  struct Rows {
    std::vector<double> error;
    std::vector<std::vector<double>> columns;
  };
  Rows rows(std::vector<double>& q) const;
  void follow_couplings(std::vector<double>& q) const;
  std::size_t column_of(int joint) const;
  bool has_opposite_frames(const std::vector<double>& q) const;
};

}  // namespace robcogen::model
