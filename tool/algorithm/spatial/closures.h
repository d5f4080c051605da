// The positions, rates and accelerations of joints that follow others through loops.
//
// A loop in a plane with all joints given except two is a triangle: two sides turn with these joints, and the third
// side is given. Its vertex is the intersection of two circles, or of a circle and a line, and gives the sines and
// cosines of the joints without an arc tangent. A distance between two points with one free joint is the same problem
// in the plane normal to the joint's axis. If a loop cannot close, the square root of a negative number gives NaN.
//
// For other loops the positions of the joints that follow are given, too: Newton's method finds them beforehand.
//
// Rates follow from the condition that both ends of a loop have the same motion, K qd = 0 (Featherstone 2008, sec. 8.3;
// Jain 2012).
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
struct RateShare {
  int joint = -1;
  Expression factor;
};

// A closure at given positions.
class TracedClosure {
 public:
  virtual ~TracedClosure() = default;

  // By dependent joint: its rate as a combination of those of the other joints of the loop.
  const std::vector<std::vector<RateShare>>& rates();
  // By dependent joint: the part of its acceleration that the velocities `qd` of all joints cause.
  std::vector<Expression> accelerations(const std::vector<Expression>& qd);
  // By dependent joint: the term -K_d^-1 dK/dt v that is added to the rate of a motion `v` of all joints that keeps the
  // loops closed, while the positions move by `motion`.
  std::vector<Expression> changes(const std::vector<symbolic::Rate>& motion, const std::vector<Expression>& v);
  // The forces of the second ends on the first ones. `forces`, by joint, are those that the motion needs if the loops
  // are cut. The loops supply all of them at the joints that follow, K_d' lambda = forces_d, and K' lambda is
  // subtracted from `forces`. The result has for each loop of the closure: three numbers for a loop in a plane (N, axes
  // of the last link that carries both ends); one for a distance (N, positive if it pushes the ends apart); force and
  // moment (N, N m) for other loops in space, the force alone for a point.
  std::vector<std::vector<Expression>> reaction(std::vector<Expression>& forces);

  // The column of a joint in K.
  struct Column {
    int joint = -1;
    std::vector<Expression> rows;
  };

  virtual std::vector<Column> columns() = 0;
  // How far the loops are open. K is the derivative; for axes that should be parallel, only if they nearly are.
  virtual std::vector<Expression> error() = 0;
  // dK/dt qd.
  virtual std::vector<Expression> bias(const std::vector<Expression>& qd) = 0;
  // The forces whose work on unit motions of the rows is lambda, in the form of `reaction`.
  virtual std::vector<std::vector<Expression>> force_of(const std::vector<Expression>& lambda) = 0;
  // Reduces redundant rows to as many as there are joints that follow, by an orthogonal basis of the columns of these
  // joints. Rows without redundancy stay as they are.
  std::vector<Expression> independent(const std::vector<Expression>& rows);
  // The way back, for lambda: the shortest one.
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
  std::vector<std::vector<RateShare>> rates_;

  bool has_redundant_rows();
  void section(const std::string& what);
};

// Traces the positions of the joints that follow in closed form and sets them in `q` (by joint), which has all others.
std::unique_ptr<TracedClosure> traced(Trace& trace, const model::Closure& closure, std::vector<Expression>& q);

// The closure at given positions of all joints, at which the loops may be open.
std::unique_ptr<TracedClosure> traced_open(Trace& trace, const model::Closure& closure, std::vector<Expression> q);

// The closure of each method. `solved`: the positions of the joints that follow close the loops, by formulas here or by
// Newton's method before.
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

// Moves the joints that follow in `q` (by joint) by one step of Newton's method towards positions at which the loops of
// an iterative closure close.
void newton_step(Trace& trace, const model::Closure& closure, std::vector<Expression>& q);
// How far the loops of an iterative closure are open: m, and sines of angles.
std::vector<Expression> open_rows(Trace& trace, const model::Closure& closure, const std::vector<Expression>& q);

}  // namespace robcogen::algorithm
