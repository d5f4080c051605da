// A chain of joints between two frames, as numbers: the axes of its joints and the pose of its last frame with all
// positions zero, in coordinates of the first frame.
//
// With E_k the motion of joint k and M that pose, E_1 … E_n M = X. What a task leaves free is joints behind the last
// one, which are never solved: for the position of a point three that turn about it, for a point and an axis one that
// turns about the axis, for an orientation three that slide.
//
// A translation or rotation by an amount that depends on parameters is a joint whose position is known. Its axis is
// placed, and so are those behind it, with this amount zero. For a point and an axis, a translation of the tool along
// its axis moves the target instead, the other way.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "model/inverse_task.h"
#include "model/kinematic_tree.h"
#include "model/loop_geometry.h"
#include "support/index.h"

namespace robcogen::algorithm::inversion {

using model::cross;
using model::dot;
using model::norm;
using model::Numbers3;
using model::operator-;

// Columns: coordinates in the placed frame to those in the first frame.
using NumberMatrix = std::array<Numbers3, 3>;

Numbers3 operator+(const Numbers3& a, const Numbers3& b);
Numbers3 operator*(double k, const Numbers3& a);
Numbers3 operator*(const NumberMatrix& columns, const Numbers3& a);

// Directions that differ by less (rad) are equal; so are points, for a chain that reaches one metre.
inline constexpr double kSameDirection = 1e-9;

bool are_parallel(const Numbers3& a, const Numbers3& b);

struct ChainAxis {
  int joint = -1;        // of the robot; -1: a freedom of the task, or moved by parameters
  bool turns = true;     // or slides
  Numbers3 direction{};  // unit: of the positive motion from the first frame to the last
  Numbers3 point{};      // on the axis
  std::string name = {};
  int amount = -1;  // moved by parameters: the place in parametric_amounts
};

// A translation of the tool along its axis, by an amount of parametric_amounts times 1 or -1.
struct ToolSlide {
  int amount = 0;
  double sign = 1.0;
};

struct SerialChain {
  std::vector<ChainAxis> axes;  // joints in the order of the chain, then freedoms
  int joints = 0;
  NumberMatrix rotation{};  // M
  Numbers3 position{};
  model::InverseTask task = {};
  int given = -1;                      // joint of the chain whose position is an argument
  double same_point = kSameDirection;  // m
  std::vector<ToolSlide> tool_slides = {};

  int size() const { return static_cast<int>(axes.size()); }
  const ChainAxis& axis(int k) const { return axes[at(k)]; }
  bool is_parametric(int k) const { return axis(k).amount >= 0; }
  bool has_parameters() const;
  // Whether the position is an argument, or follows from parameters.
  bool is_known(int k) const { return k == given || is_parametric(k); }
};

// A direction whose elements are exact where they differ from 0, 1, 1/2, … by rounding: they fold in programs.
Numbers3 folded(const Numbers3& direction);

// A point without elements that are zero but for rounding.
Numbers3 without_rounding(const SerialChain& chain, Numbers3 x);

// Why the joints between two frames are not such a chain: `joint 'J2' is helical`; empty if they are.
std::string obstacle(const model::KinematicTree& tree, const model::FramePair& frames);

// The chain of frames without obstacle. `parameter_values`: of all parameters, which are constants then.
SerialChain serial_chain(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const model::InverseTask& task,
    std::span<const double> parameter_values = {});

// The amounts between two frames that depend on parameters, in the order of the path.
std::vector<model::Quantity> parametric_amounts(const model::KinematicTree& tree, const model::FramePair& frames);

// The joints from begin to before end as a chain of their own, for the orientation that they have together.
SerialChain orientation_chain(const SerialChain& chain, int begin, int end);

// The pose of the last frame: the sines and cosines of joints that turn, or positions of those that slide.
struct NumberPose {
  NumberMatrix rotation{};
  Numbers3 position{};
};
struct SineCosine {
  double sine = 0.0;  // or the position (m)
  double cosine = 1.0;
};
NumberPose pose(const SerialChain& chain, const std::vector<SineCosine>& joints);

// The largest difference of two poses that the task does not leave free (rad, m).
double task_error(const SerialChain& chain, const NumberPose& a, const NumberPose& b);

}  // namespace robcogen::algorithm::inversion
