// The positions, rates and accelerations of joints that follow others through loops.
//
// A loop in a plane whose joints are all given but for two is a triangle: two sides turn with these joints, and the
// third one is given. Its vertex is the intersection of two circles, or of a circle and a line, and tells the sines and
// cosines of the joints without any arc tangent. A distance between two points with one joint free is the same in the
// plane normal to the joint's axis. Where a loop cannot close, the root is that of a negative number: not a number.
//
// Of other loops the positions of joints that follow are given, too: Newton's method finds them beforehand.
//
// Rates follow from the condition that both ends move alike, K qd = 0 (Featherstone 2008, sec. 8.3; Jain 2012).
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

  // By dependent joint: its rate over those of the other joints of the loop.
  const std::vector<std::vector<RateShare>>& rates();
  // By dependent joint: what velocities of all joints, `qd`, add to its acceleration.
  std::vector<Expression> accelerations(const std::vector<Expression>& qd);
  // By dependent joint: what is added to the rate of a motion `v` of all joints that keeps the loops closed, while the
  // positions move as `motion` says: -K_d^-1 dK/dt v.
  std::vector<Expression> changes(const std::vector<symbolic::Rate>& motion, const std::vector<Expression>& v);
  // What the second ends push the first ones with where motors and drives give `forces`, by joint, less than the motion
  // needs, and none at the joints that follow: K_d' lambda = forces_d. Subtracts K' lambda. By loop of the closure
  // three of one in a plane (N, axes of the last link that carries both ends); one of a distance (N, positive where it
  // pushes the ends apart); of others in space force and moment (N, N m), of a point the force.
  std::vector<std::vector<Expression>> reaction(std::vector<Expression>& forces);

  // A column of K: of a joint.
  struct Column {
    int joint = -1;
    std::vector<Expression> rows;
  };

  virtual std::vector<Column> columns() = 0;
  // How the loops are open: K is the derivative, of axes that are to be parallel where they nearly are.
  virtual std::vector<Expression> error() = 0;
  // dK/dt qd.
  virtual std::vector<Expression> bias(const std::vector<Expression>& qd) = 0;
  // The forces whose work on unit motions of the rows is lambda, as those of a reaction.
  virtual std::vector<std::vector<Expression>> force_of(const std::vector<Expression>& lambda) = 0;
  // Of rows some of which say the same as others: as many as joints follow. By an orthogonal basis of the columns of
  // the joints that follow; others stay as they are.
  std::vector<Expression> independent(const std::vector<Expression>& rows);
  // And back, of lambda: the shortest one.
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

// Traces the positions of the joints that follow in closed form, into `q`, by joint, where all others are.
std::unique_ptr<TracedClosure> traced(Trace& trace, const model::Closure& closure, std::vector<Expression>& q);

// At given positions of all joints, where the loops may be open.
std::unique_ptr<TracedClosure> traced_open(Trace& trace, const model::Closure& closure, std::vector<Expression> q);

// That of each method. `solved`: the joints that follow are, by formulas here or by Newton's method before.
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

// Moves the joints that follow in `q`, by joint, a step of Newton's method towards where the loops of an iterative
// closure close.
void newton_step(Trace& trace, const model::Closure& closure, std::vector<Expression>& q);
// How the loops of an iterative closure are open: m, and sines.
std::vector<Expression> open_rows(Trace& trace, const model::Closure& closure, const std::vector<Expression>& q);

}  // namespace robcogen::algorithm
