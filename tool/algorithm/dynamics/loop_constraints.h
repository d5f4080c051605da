// Loops, and couplings of joints, as constraints of the tree in which all joints move by themselves.
#pragma once

#include <memory>
#include <vector>

#include "algorithm/dynamics/constraint_system.h"
#include "algorithm/spatial/closures.h"

namespace robcogen::algorithm {

// A loop that formulas close in a plane has two rows there, a distance has one. Of loops that no formulas close the
// rows that say the same as others are left out. A coupling that no loop makes has a row.
class LoopConstraints {
 public:
  // `looped` has the loops and couplings, and outlives this; the robot of the trace is with_free_joints of it. q: by
  // joint.
  LoopConstraints(Trace& trace, const model::KinematicTree& looped, const std::vector<Expression>& q);

  ConstraintRows rows;
  // By row: how far from closed, which changes by `rows`.
  std::vector<Expression> error;

  // By row: what velocities of the joints, `qd`, add to the change of its rate.
  std::vector<Expression> bias(const std::vector<Expression>& qd);
  // Of what the rows push with: by loop its force, as Trace::reactions has it, then by coupling its force on the joint
  // that follows.
  struct Forces {
    std::vector<std::vector<Expression>> of_loops;
    std::vector<Expression> of_couplings;
  };
  Forces forces(const std::vector<Expression>& lambda);

 private:
  struct Part {
    const model::Closure& closure;
    std::unique_ptr<TracedClosure> traced;
  };

  Trace& trace_;
  const model::KinematicTree& looped_;
  std::vector<Part> parts_;

  void add_closure(const model::Closure& closure, const std::vector<Expression>& q);
  void add_coupling(const model::Coupling& coupling, const std::vector<Expression>& q);
  std::vector<Expression>& add_row(const std::string& name);
};

}  // namespace robcogen::algorithm
