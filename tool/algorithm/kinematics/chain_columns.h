// Columns of Jacobians as expressions.
#pragma once

#include <vector>

#include "algorithm/kinematics/kinematics.h"
#include "algorithm/spatial/motion_force.h"
#include "algorithm/spatial/trace.h"

namespace robcogen::algorithm {

// The columns of the joints of a chain, in order, as in geometric_jacobian.
struct ChainColumns {
  std::vector<int> joints;
  std::vector<Motion> columns;
  Vector3 point;  // whose velocity the linear part gives: the target's origin, or the target's point at the left origin
};
ChainColumns chain_columns(
    Trace& trace,
    const std::vector<Expression>& q,
    const model::FramePair& frames,
    JacobianReference reference);

// The columns of jacobian_with_base, in axes of `left` or of the target.
std::vector<Motion> columns_with_base(
    Trace& trace,
    const std::vector<Expression>& q,
    const model::FramePair& frames,
    JacobianReference reference = JacobianReference::in_left);

// The linear parts of these columns alone, for a left frame on the base: the velocity of a point of the robot by each
// coordinate. The cheaper of two ways is used: axes and origins of the joints are expressed in the base, or the columns
// are computed in axes of the joints and rotated to the base by the joints before them.
std::vector<Vector3> point_columns(Trace& trace, const std::vector<Expression>& q, const model::FramePair& frames);

// The elements of columns, column by column, angular rows first.
std::vector<Expression> elements_of(const std::vector<Motion>& columns);

}  // namespace robcogen::algorithm
