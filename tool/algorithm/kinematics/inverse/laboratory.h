// Expressions of a chain on trial: what they cost, and their values in some states.
#pragma once

#include <cstddef>
#include <vector>

#include "algorithm/kinematics/inverse/probes.h"
#include "algorithm/kinematics/inverse/step_solver.h"

namespace robcogen::algorithm::inversion {

// Of all operations since the mark, in products and sums.
int weight(const Graph& graph, std::size_t mark);

// A graph whose inputs are a target, references, and sines and cosines of joints, with numbers for them.
class Laboratory {
 public:
  explicit Laboratory(const SerialChain& chain);

  Graph graph;
  Target target;
  std::vector<Expression> references;
  std::vector<JointValue> joints;

  // Numbers for one state after the other.
  void set(std::size_t state, const NumberPose& pose, const std::vector<double>& q);
  std::vector<ProbeValues> inputs;

  JointValues known() const;

 private:
  const SerialChain& chain_;
};

}  // namespace robcogen::algorithm::inversion
