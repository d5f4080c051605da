// Where a chain of frames has got to, and the matrices that map coordinates of there back to its first frame.
#pragma once

#include <string>

#include "algorithm/geometry.h"
#include "algorithm/kinematics.h"

namespace robcogen::algorithm {

// R and p of the frame reached, in the first frame.
struct Reached {
  Matrix3 rotation;
  Vector3 position;
};

// The first frame itself.
Reached start(Graph& graph);

// Goes on to a frame of this pose in the one reached.
void advance(Reached& here, const Pose& pose);

// Names the elements `<subject>_Rxy` and `<subject>_px`.
void name_reached(Graph& graph, const Reached& here, const std::string& subject);

// Column k of m.
Vector3 column(const Matrix3& m, std::size_t k);

// The transform from coordinates in the frame reached to those in the first one, as the output X.
void output_transform(ProgramTrace& trace, const Reached& x, TransformForm form);

}  // namespace robcogen::algorithm
