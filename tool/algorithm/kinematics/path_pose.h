// The pose of the frames along a path in the first frame of the path, from frame to frame, and the matrices that map
// coordinates in the last frame to those in the first.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "algorithm/kinematics/kinematics.h"
#include "algorithm/spatial/pose.h"

namespace robcogen::algorithm {

// R and p of the present frame of the path, in the first frame.
struct PathPose {
  Graph* graph = nullptr;
  Matrix3 rotation = {};
  Vector3 position = {};

  // The factors of the rotation: rotation = before.front() * planes[0] * planes[1] …, no two neighbours about one axis.
  // before[i] is the product up to planes[i]. Quarter turns are pushed to the left, where they are free.
  std::vector<Matrix3> before = {};
  std::vector<PlaneRotation> planes = {};
  std::vector<Expression> angles = {};  // whose sines and cosines exist already

  // [p]x R can be computed at the end, from p and R, or from some segment on along the path, by adding R [offset]x,
  // which avoids sin^2 + cos^2. Which is cheaper depends on the path.
  int segment = 0;
  int moment_from = kNoSegment;
  Matrix3 moment = {};
  static constexpr int kNoSegment = 1 << 30;
};

// The first frame itself.
PathPose start(Graph& graph, int moment_from = PathPose::kNoSegment);

// Advances to the frame with this pose in the present frame.
void advance(PathPose& here, const Pose& pose);

// The cheapest of the programs of `make`: with the moment computed at the end, from the first segment on, or from
// `tail` on, the segment behind the last rotation. A form without moment is traced once.
symbolic::Program cheapest_transform(
    TransformForm form,
    int tail,
    const std::function<symbolic::Program(int moment_from)>& make);

// Names the elements `<subject>_Rxy` and `<subject>_px`.
void name_path_pose(const PathPose& here, const std::string& subject);

// Column k of m.
Vector3 column(const Matrix3& m, std::size_t k);

// A motion in other axes, or the opposite motion.
Motion in_axes(const Matrix3& rotation, const Motion& motion, bool negated);

// The transform from coordinates in the present frame to those in the first one, as the output X.
void output_transform(ProgramTrace& trace, const PathPose& x, TransformForm form);

}  // namespace robcogen::algorithm
