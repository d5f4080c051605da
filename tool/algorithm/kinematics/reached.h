// The frame that a path has reached, and the matrices that map coordinates of there back to its first frame.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "algorithm/kinematics/kinematics.h"
#include "algorithm/spatial/pose.h"

namespace robcogen::algorithm {

// R and p of the frame reached, in the first frame.
struct Reached {
  Graph* graph = nullptr;
  Matrix3 rotation = {};
  Vector3 position = {};

  // How the rotation came about: rotation = before.front() * planes[0] * planes[1] …, no two neighbours about one axis.
  // before[i] is the product up to planes[i]. Quarter turns are pushed to the left, where they are free.
  std::vector<Matrix3> before = {};
  std::vector<PlaneRotation> planes = {};
  std::vector<Expression> angles = {};  // whose sines and cosines are at hand

  // [p]x R can be made in the end, of p and R, or from some segment on along the path, where R [offset]x is added:
  // sin^2
  // + cos^2 does not come up then. Which is cheaper depends on the chain.
  int segment = 0;
  int moment_from = kNoSegment;
  Matrix3 moment = {};
  static constexpr int kNoSegment = 1 << 30;
};

// The first frame itself.
Reached start(Graph& graph, int moment_from = Reached::kNoSegment);

// Goes on to a frame of this pose in the one reached.
void advance(Reached& here, const Pose& pose);

// The cheapest of the programs that `make` makes: with the moment made in the end, from the first segment on, or from
// `tail` on, the segment behind the last turn. A form that has no moment is made once.
symbolic::Program cheapest_transform(
    TransformForm form,
    int tail,
    const std::function<symbolic::Program(int moment_from)>& make);

// Names the elements `<subject>_Rxy` and `<subject>_px`.
void name_reached(Graph& graph, const Reached& here, const std::string& subject);

// Column k of m.
Vector3 column(const Matrix3& m, std::size_t k);

// A motion in other axes, or the opposite motion.
Motion in_axes(const Matrix3& rotation, const Motion& motion, bool negated);

// The transform from coordinates in the frame reached to those in the first one, as the output X.
void output_transform(ProgramTrace& trace, const Reached& x, TransformForm form);

}  // namespace robcogen::algorithm
