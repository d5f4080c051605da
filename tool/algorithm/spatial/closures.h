// Positions, rates and accelerations of dependent joints: those that a loop ties to the other joints.
//
// A plane loop with two dependent joints is a triangle: two of its sides turn with these joints, the third side follows
// from the other joints. The vertex between the two sides is the intersection of two circles, or of a circle and a
// line; the sines and cosines of the joints follow from it without an arc tangent. A loop that keeps the distance of
// two points, with one dependent joint, is the same triangle in the plane normal to the joint's axis. If a loop cannot
// close, the square root of a negative number gives NaN.
//
// In other loops, the positions of the dependent joints are inputs: Newton's method has found them before.
//
// Rates follow from the constraint K qd = 0, that both ends of a loop have the same motion (Featherstone 2008,
// sec. 8.3; Jain 2012).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "algorithm/spatial/dependent_columns.h"
#include "model/loop.h"
#include "symbolic/derivative.h"

namespace robcogen::algorithm {

class Trace;

// A joint, and a factor of its rate.
struct RateTerm {
  int joint = -1;
  Expression factor;
};

// A closure at given positions.
class TracedClosure {
 public:
  virtual ~TracedClosure() = default;

  // By dependent joint: its rate as a combination of those of the other joints of the loop.
  const std::vector<std::vector<RateTerm>>& rates();
  // By dependent joint: the part of its acceleration that the velocities `qd` of all joints cause.
  std::vector<Expression> accelerations(const std::vector<Expression>& qd);
  // By dependent joint: the term -K_d^-1 dK/dt v that is added to the rate of a motion `v` of all joints that keeps the
  // loops closed, while the positions move by `motion`.
  std::vector<Expression> changes(const std::vector<symbolic::Rate>& motion, const std::vector<Expression>& v);
  // The constraint forces of the loops, by loop: the force of the second end on the first one. `forces`, by joint, are
  // the joint forces of the motion with all loops cut. At the dependent joints d the constraint forces lambda supply
  // them, K_d' lambda = forces_d; then K' lambda is subtracted from `forces`. A plane loop has three numbers (N, axes
  // of the last link that carries both ends), a distance one (N, positive if it pushes the ends apart), a loop in space
  // force and moment (N, N m), a point the force alone.
  std::vector<std::vector<Expression>> reaction(std::vector<Expression>& forces);

  // The column of a joint in K.
  struct Column {
    int joint = -1;
    std::vector<Expression> rows;
  };

  virtual std::vector<Column> columns() = 0;
  // The closure errors of the loops: zero where the loops are closed. K is their derivative by the joint positions; for
  // the rows of parallel axes, only if the axes are nearly parallel.
  virtual std::vector<Expression> error() = 0;
  // dK/dt qd.
  virtual std::vector<Expression> bias(const std::vector<Expression>& qd) = 0;
  // The forces whose work on unit motions of the rows is lambda, in the form of `reaction`.
  virtual std::vector<std::vector<Expression>> force_of(const std::vector<Expression>& lambda) = 0;
  // Reduces redundant rows of K to as many as there are dependent joints, by an orthogonal basis of the columns of
  // these joints. Rows without redundancy stay as they are.
  std::vector<Expression> independent(const std::vector<Expression>& rows);
  // The forces on the rows of K for forces on the reduced rows; of all that do, those of least norm.
  std::vector<Expression> from_independent(const std::vector<Expression>& lambda);

 protected:
  TracedClosure(Trace& trace, const model::Closure& closure) : trace_(trace), closure_(closure) {}

  bool is_dependent(int joint) const;
  const DependentColumns& dependent_columns();

  Trace& trace_;
  const model::Closure& closure_;

 private:
  std::vector<Column> all_;
  std::optional<DependentColumns> dependent_columns_;
  std::vector<std::vector<RateTerm>> rates_;

  bool has_redundant_rows();
  void section(const std::string& what);
};

// Traces the positions of the dependent joints in closed form, and sets them in `q` (by joint). The other elements of
// `q` are given.
std::unique_ptr<TracedClosure> traced(Trace& trace, const model::Closure& closure, std::vector<Expression>& q);

// The closure at given positions of all joints, at which the loops may be open.
std::unique_ptr<TracedClosure> traced_open(Trace& trace, const model::Closure& closure, std::vector<Expression> q);

// The closure of each method. `solved`: the positions of the dependent joints close the loops, by formulas here or by
// Newton's method before. `given`: the loops may be open.
enum class Positions { solved, given };
std::unique_ptr<TracedClosure> traced_in_plane(
    Trace& trace,
    const model::Closure& closure,
    std::vector<Expression>& q,
    Positions positions);
std::unique_ptr<TracedClosure> traced_in_space(
    Trace& trace,
    const model::Closure& closure,
    const std::vector<Expression>& q,
    Positions positions);
std::unique_ptr<TracedClosure> traced_distance(
    Trace& trace,
    const model::Closure& closure,
    std::vector<Expression>& q,
    Positions positions);

// One step of Newton's method for an iterative closure: changes the positions of the dependent joints in `q` (by
// joint).
void newton_step(Trace& trace, const model::Closure& closure, std::vector<Expression>& q);
// The closure errors of an iterative closure: distances in m, and sines of angles.
std::vector<Expression> open_rows(Trace& trace, const model::Closure& closure, const std::vector<Expression>& q);

}  // namespace robcogen::algorithm
