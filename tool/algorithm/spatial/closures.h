// Loops in closed form: the positions, rates and accelerations of joints that follow others through a loop.
//
// A loop in a plane whose joints are all given but for two is a triangle: two sides turn with these joints, and the
// third one is given. Its vertex is the intersection of two circles, or of a circle and a line, and tells the sines and
// cosines of the joints without any arc tangent. A distance between two points with one joint free is the same in the
// plane normal to the joint's axis. Where a loop cannot close, the root is that of a negative number: not a number.
//
// Rates follow from the condition that both ends move alike, K qd = 0 (Featherstone 2008, sec. 8.3; Jain 2012).
#pragma once

#include <memory>
#include <vector>

#include "algorithm/spatial/vectors.h"
#include "model/loop.h"

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
  // What the second end pushes the first one with where motors and drives give `forces`, by joint, less than the motion
  // needs, and none at the joints that follow: K_d' lambda = forces_d. Subtracts K' lambda. Of a plane (N, axes of the
  // last link that carries both ends), or of a distance (N, positive where it pushes the ends apart).
  std::vector<Expression> reaction(std::vector<Expression>& forces);

 protected:
  // A column of K: of a joint, a row or two.
  struct Column {
    int joint = -1;
    std::vector<Expression> rows;
  };

  TracedClosure(Trace& trace, const model::Closure& closure) : trace_(trace), closure_(closure) {}

  virtual std::vector<Column> columns() = 0;
  // dK/dt qd.
  virtual std::vector<Expression> bias(const std::vector<Expression>& qd) = 0;
  // The force whose work on unit motions of the rows is lambda.
  virtual std::vector<Expression> force_of(const std::vector<Expression>& lambda) = 0;

  Trace& trace_;
  const model::Closure& closure_;

 private:
  std::vector<std::vector<Expression>> inverse_;  // of the columns of the dependent joints
  std::vector<std::vector<RateShare>> rates_;

  std::vector<Expression> solved(const std::vector<Expression>& rows) const;
};

// Traces the positions of the joints that follow, into `q`, by joint, where those of the others are.
std::unique_ptr<TracedClosure> traced(Trace& trace, const model::Closure& closure, std::vector<Expression>& q);

// That of each method.
std::unique_ptr<TracedClosure> traced_in_plane(Trace& trace, const model::Closure& closure, std::vector<Expression>& q);
std::unique_ptr<TracedClosure> traced_distance(Trace& trace, const model::Closure& closure, std::vector<Expression>& q);

}  // namespace robcogen::algorithm
