// Loops that are closed together by Newton's method, because no formula closes them: of any joints, in space.
#pragma once

#include <vector>

#include "model/loop_geometry.h"

namespace robcogen::model {

class LoopCluster {
 public:
  // `loops`: of the tree, which outlives this. Positions q below are by joint; those of joints that couplings tie to
  // others are set by these.
  LoopCluster(const KinematicTree& tree, std::vector<int> loops, std::vector<double> parameters);

  // Those that move the ends of the loops, in the order of the tree: without joints that couplings tie to others, but
  // with these others.
  const std::vector<int>& joints() const { return joints_; }
  // The longest lever (m).
  double size(const std::vector<double>& q) const;

  // How many motions of the joints the loops take away.
  int rank(std::vector<double> q) const;
  // As many of the candidates, the first ones first, as follow the other joints; well determined ones before others.
  std::vector<int> following(std::vector<double> q, const std::vector<int>& candidates) const;
  // Moves these joints until the loops close, from where they are. Returns how far they remain from closed (m).
  double close(std::vector<double>& q, const std::vector<int>& following) const;
  // By joint of `following` and of joints(): what it moves by unit motion of the other; zero where that follows, too.
  std::vector<std::vector<double>> rates(std::vector<double> q, const std::vector<int>& following) const;

 private:
  const KinematicTree& tree_;
  std::vector<int> loops_;
  std::vector<double> parameters_;
  std::vector<int> joints_;

  // Rows in metres: turns are multiplied by the size. A column for each of joints().
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
