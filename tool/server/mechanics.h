// Values of a robot at q = 0, or where its loops are assembled, for hover texts. Parameters have their default values;
// what depends on a parameter without a default value is NaN. SI units.
#pragma once

#include <array>
#include <vector>

#include "model/coordinate_transforms.h"
#include "model/kinematic_tree.h"

namespace robcogen::server {

using Vector3 = std::array<double, 3>;

// left_X_right: the pose of a frame in another frame; for a robot, in its base.
struct Pose {
  std::array<Vector3, 3> rotation = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // row by row
  Vector3 translation = {};
};

// Returns the angles (rad) about the intrinsic axes x, y', z'' (R = Rx Ry Rz).
Vector3 angles_of(const Pose& pose);

// Returns the pose of a transform between frames of these motions, in the convention `right`, with all variables at
// zero and without the rotations of spherical joints.
Pose pose_of(const model::CoordinateTransform& transform, const model::RigidMotions& motions);

struct Carried {
  double mass = 0.0;
  Vector3 com = {};  // in base coordinates; NaN if the mass is zero
};

class RestingRobot {
 public:
  // Independent joints are at zero, or where loops are assembled; coupled joints are where the couplings put them.
  explicit RestingRobot(const model::KinematicTree& tree);

  const Pose& link(int link) const { return links_[static_cast<std::size_t>(link)]; }
  Pose frame(const model::Frame& frame) const;
  // The link with everything beyond it.
  const Carried& carried(int link) const { return carried_[static_cast<std::size_t>(link)]; }
  double mass(int link) const;
  Vector3 com(int link) const;                // in the link's frame
  Vector3 principal_moments(int link) const;  // about the centre of mass, in ascending order
  Vector3 axis(int joint) const;              // joint axis, in base coordinates
  double value(const model::Quantity& q) const;

 private:
  const model::KinematicTree& tree_;
  std::vector<double> parameters_;
  std::vector<Pose> links_;
  std::vector<Carried> carried_;

  Pose placed(const Pose& parent, const model::Placement& placement) const;
  Pose moved(const Pose& frame, const model::Joint& joint, double q) const;
};

}  // namespace robcogen::server
