// Coupled joints (Jain 2012, constraint embedding). The positions q of all joints follow from independent coordinates
// y. Linear couplings: q = G y + c with constant G, so that qd = G yd and qdd = G ydd. Loops (closures.h): G depends on
// q, and qdd = G ydd + dG/dt yd. By virtual work, forces tau of the joints correspond to forces G' tau of the
// coordinates. Algorithms compute with all joints; inputs and outputs of programs are by coordinate.
#pragma once

#include <vector>

#include "algorithm/spatial/trace.h"

namespace robcogen::algorithm {

// A joint that a coordinate moves, and the element of G: the rate of the joint per rate of the coordinate.
struct MovedJoint {
  int joint = 0;
  Expression factor;
};

// By coordinate: the joints that it moves, a column of G. The first joint is the one whose position is the coordinate;
// its factor is one and is not set.
std::vector<std::vector<MovedJoint>> moved_joints(Trace& trace);

// dG/dt for the dependent joints of loops, when all joints move with `qd`.
std::vector<std::vector<MovedJoint>> moved_joint_rates(Trace& trace, const std::vector<Expression>& qd);

// The sum of factor * of_joint(joint): the element for a coordinate of a quantity that is linear in the rates of the
// joints.
template <class OfJoint>
auto sum_of(const std::vector<MovedJoint>& moved, OfJoint of_joint) {
  auto total = of_joint(moved.front().joint);
  for (std::size_t k = 1; k < moved.size(); ++k) total += moved[k].factor * of_joint(moved[k].joint);
  return total;
}

// G' tau.
std::vector<Expression> by_coordinate(Trace& trace, const std::vector<Expression>& by_joint);

// G' m G, for a matrix whose first `base` rows and columns are those of the base and stay. A symmetric matrix is
// computed from one triangle.
enum class Symmetry { none, symmetric };
SquareMatrix by_coordinate(Trace& trace, const SquareMatrix& by_joint, int base, Symmetry symmetry);

// G' (C G + H dG/dt), when all joints move with `qd` and the forces of joints are C qd + H qdd.
SquareMatrix coriolis_by_coordinate(
    Trace& trace,
    const SquareMatrix& C,
    const SquareMatrix& H,
    const std::vector<Expression>& qd,
    int base);

// m G with G' applied to its rows, for columns by joint; the first `base` rows are those of the base and stay.
Columns by_coordinate(Trace& trace, const Columns& by_joint, int base);
// G' alone, for columns that do not belong to joints.
Columns rows_by_coordinate(Trace& trace, const Columns& columns, int base);

// The columns of a Jacobian over these joints of a chain, as columns over the chain_coordinates of the same joints.
std::vector<Motion> columns_by_coordinate(
    Trace& trace,
    const std::vector<int>& joints,
    const std::vector<Motion>& columns);

// The coordinates that move these joints, as indices, in the order of their first joint.
std::vector<int> coordinates_of(const model::KinematicTree& tree, const std::vector<int>& joints);

}  // namespace robcogen::algorithm
