// Link frames that the recursions compute in where the frames of the model would cost more.
//
// The frame of a link may be turned about the axis of its joint and moved along it: the joint forces stay the same. It
// also need not turn with the joint. Then the mass properties of the link are rotated instead of the vectors of the
// recursion, which takes 2 to 9 products instead of 20, and chains of parallel axes are computed in one frame.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "algorithm/formulation/representative_limbs.h"
#include "algorithm/spatial/mass_properties.h"

namespace robcogen::algorithm {

// The frame of a link in the recursions: the frame of the model, turned by `turn` (rad) about its z axis and moved by
// `slide` (m) along it. Both are constants or depend on parameters alone.
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

// Axes that are inclined by less (rad) count as parallel, because models give PI with few digits.
inline constexpr double kParallel = 1e-5;

// A joint's placement, split where its axis is not parallel to that of the parent: the part up to the foot of the
// common normal on the joint's axis, and the rest along that axis, which commutes with the joint's own motion. It is
// not split if the foot is so far away that the detour would lose digits.
struct AxisPlacement {
  std::vector<model::PrimitiveTransform> to_axis;
  model::Quantity along;
};
AxisPlacement axis_placement(const model::Placement& placement);
// The placement of each joint.
std::vector<AxisPlacement> axis_placements(const model::KinematicTree& tree);

// The robot in the given frames. `masses` are in the frames of the model. The resulting numbers fold as those of
// `representative`, if these are given.
FramedLinks in_frames(
    Trace& trace,
    const LinkFrames& frames,
    const std::vector<AxisPlacement>& placements,
    const std::vector<Expression>& q,
    const std::vector<MassProperties>& masses,
    const RepresentativeLinks& representative = {});

// Says in one line which links are computed in which frames; empty if all are in those of the model.
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
  std::vector<MassNumbers> masses;        // by link, in the frames of the model; base parameters if these are used
};

}  // namespace robcogen::algorithm
