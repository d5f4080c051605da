// Loops, and couplings of joints, as constraints of the tree in which all joints move independently.
#pragma once

#include <memory>
#include <vector>

#include "algorithm/dynamics/constraint_system.h"
#include "algorithm/spatial/closures.h"

namespace robcogen::algorithm {

// A loop that formulas close in a plane has two rows, a distance has one. For loops that no formulas close, redundant
// rows are left out. A coupling that does not come from a loop has one row.
class LoopConstraints {
 public:
  // `looped` has the loops and couplings and must outlive this object; the robot of the trace is
  // with_free_joints(looped). `q`: by joint.
  LoopConstraints(Trace& trace, const model::KinematicTree& looped, const std::vector<Expression>& q);

  ConstraintRows rows;
  // By row: the distance from closed, whose derivative is given by `rows`.
  std::vector<Expression> error;

  // By row: the contribution of the joint velocities `qd` to the second derivative of the error.
  std::vector<Expression> bias(const std::vector<Expression>& qd);
  // The constraint forces that belong to `lambda`: by loop as in Trace::reactions, and by coupling the force on the
  // dependent joint.
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
