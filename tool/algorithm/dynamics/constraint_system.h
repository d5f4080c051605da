// The equations of motion with constraints, H a + C = tau + J^T f, eliminated for the forces f of the constraints.
#pragma once

#include <string>
#include <vector>

#include "algorithm/dynamics/ldl.h"
#include "algorithm/dynamics/ordered_inertia.h"
#include "algorithm/dynamics/traced_robot.h"

namespace robcogen::algorithm {

// Rows of constraints, along which the robot does not move or moves in a prescribed way.
struct ConstraintRows {
  std::string kind;                        // names sections: `contacts`
  std::vector<std::string> names;          // by row: `fr_LF_foot_vx`
  std::vector<std::vector<Expression>> J;  // by row: an element for each coordinate of H

  int size() const { return static_cast<int>(J.size()); }
};

// J v, for velocities or accelerations by coordinate of H.
std::vector<Expression> times(const ConstraintRows& rows, const std::vector<Expression>& v);
// J^T f.
std::vector<Expression> transposed_times(const ConstraintRows& rows, const std::vector<Expression>& f);

// With H = L^T D L and Y = L^-T J^T, W = J H^-1 J^T = Y^T D^-1 Y: only the first half of a solution is computed for
// each row of J, along the ancestors of its coordinates. (Featherstone 2008, sec. 6.5 and 8.4.)
class ConstraintSystem {
 public:
  ConstraintSystem(const TracedRobot& robot, const ConstraintRows& rows);

  // H in the order of its elimination, and its factor.
  const OrderedInertia& inertia() const { return inertia_; }
  const LdlFactors& factors() const { return factors_; }
  // Y, by row of J, in that order.
  const std::vector<std::vector<Expression>>& halves() const { return Y_; }
  // W; a pair of rows that share no coordinate has a literal zero.
  const SquareMatrix& inverse_inertia() const { return W_; }

  // Converts forces by row of H to the form that the following functions take.
  std::vector<Expression> halved(const std::vector<Expression>& forces) const;
  // By row of J: J H^-1 forces.
  std::vector<Expression> at_rows(const std::vector<Expression>& halved) const;
  // H^-1 (forces + J^T f).
  std::vector<Expression> accelerations(std::vector<Expression> halved, const std::vector<Expression>& f) const;

 private:
  Trace& trace_;
  OrderedInertia inertia_;
  LdlFactors factors_;
  std::vector<std::vector<Expression>> Y_, per_d_;  // by row of J; per_d = D^-1 Y
  SquareMatrix W_;
};

}  // namespace robcogen::algorithm
