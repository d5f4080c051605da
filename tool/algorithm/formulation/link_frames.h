// Frames that the recursions compute in, where those of the model cost more.
//
// A link's frame may turn about, and slide along, the axis of its joint: the joint forces stay the same. And it need
// not turn with the joint: then the mass properties of the link turn instead of the vectors of the recursion, 2 to 9
// products for 20, and chains of parallel axes are computed in one frame.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "algorithm/formulation/representative_limbs.h"
#include "algorithm/spatial/mass_properties.h"

namespace robcogen::algorithm {

// Where the recursions see a link: the frame of the model turned by `turn` (rad) about its z axis and moved by `slide`
// (m) along it. Both are constants, or depend on parameters alone.
struct LinkFrame {
  model::Quantity turn;
  model::Quantity slide;
  bool turns_with_joint = true;
  friend bool operator==(const LinkFrame&, const LinkFrame&) = default;
};

// By joint: the frame of its child. Empty: the frames of the model.
using LinkFrames = std::vector<LinkFrame>;

// The robot in these frames, for the recursions.
struct FramedLinks {
  std::vector<Pose> poses;             // by joint
  std::vector<MassProperties> masses;  // by link
  std::vector<Pose> frames_of_model;   // by link: the model's link frame in the frame of the recursions
};

// Axes that are tilted by less (rad) are parallel but for the digits that documents write of PI.
inline constexpr double kParallel = 1e-5;

// A joint's placement, split where its axis is not parallel to that of the parent: the part up to the foot of the
// common normal on the joint's axis, and the rest along that axis, which commutes with the joint's own motion. Not
// split where the foot is so far away that the detour would lose digits.
struct AxisPlacement {
  std::vector<model::PrimitiveTransform> to_axis;
  model::Quantity along;
};
AxisPlacement axis_placement(const model::Placement& placement);
// By joint.
std::vector<AxisPlacement> axis_placements(const model::KinematicTree& tree);

// `masses` are in the frames of the model. The numbers that are found fold as the representative ones do, if those are
// given.
FramedLinks in_frames(
    Trace& trace,
    const LinkFrames& frames,
    const std::vector<AxisPlacement>& placements,
    const std::vector<Expression>& q,
    const std::vector<MassProperties>& masses,
    const RepresentativeLinks& representative = {});

// One line: which links are seen in which frames; empty when all are in the model's.
std::string description(const model::KinematicTree& tree, const LinkFrames& frames);

// The mass properties of a link in numbers.
struct MassNumbers {
  Number mass;
  std::array<Number, 3> first_moment;
  std::array<std::array<Number, 3>, 3> pseudo_inertia;
};

// The numbers that many traces of one robot take from its model, computed once.
struct LinkNumbers {
  std::vector<AxisPlacement> placements;  // by joint
  std::vector<MassNumbers> masses;        // by link, in the frames of the model; those that matter
};

}  // namespace robcogen::algorithm
