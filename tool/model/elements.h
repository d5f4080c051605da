// The elements of a robot as generated code lists them, and their numbers with the defaults of the parameters. Joints
// are in the order of independent_joints_first, links are those that are not repeated, and frames are those of
// KinematicTree::frames.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

std::vector<std::string> names_of(const KinematicTree& tree, const std::vector<int>& joints);
std::vector<std::string> coupled_names(const KinematicTree& tree);
std::vector<std::string> link_names(const KinematicTree& tree);
std::vector<std::string> frame_names(const KinematicTree& tree);
std::vector<std::string> names_of(const std::vector<Parameter>& parameters);

// The coupled joints.
std::vector<int> dependent_joints(const KinematicTree& tree);
// The links that a joint connects, and its placement. Those of a component of a spherical joint are those of the joint.
int parent_link(const KinematicTree& tree, int joint);
int child_link(const KinematicTree& tree, int joint);
const Placement& placement_of_joint(const KinematicTree& tree, int joint);
// By link: the place in the list of joints of the joint that carries it, of a spherical joint its first component; -1
// for the base.
std::vector<int> carrying_joints(const KinematicTree& tree);
// The place of the frame of this name in the list of frames.
int place_of_frame(const KinematicTree& tree, const std::string& name);
// The indices of the elements of q at which quaternions begin.
std::vector<int> quaternions(const KinematicTree& tree);
// Whether the elements of q differ from those of qd.
bool has_own_positions(const KinematicTree& tree);

// The limbs with unique names, and with places in these lists instead of indices. Coupled joints are left out, because
// joint arrays have no elements for them. If limbs share their name, that of the part is appended.
std::vector<Limb> listed_limbs(const KinematicTree& tree);
std::vector<std::string> limb_names(const KinematicTree& tree);

// Evaluates quantities with the defaults of the parameters. NaN: the value depends on a parameter without default.
class DefaultValues {
 public:
  explicit DefaultValues(const std::vector<Parameter>& parameters);

  double operator()(const Quantity& q) const { return evaluate(q, values_); }
  std::array<double, 3> operator()(const std::array<Quantity, 3>& q) const;

 private:
  std::vector<double> values_;
};

// The default of a parameter; NaN: it has none.
double default_of(const Parameter& parameter);

// In the link frame; zero for a massless link.
struct MassProperties {
  double mass = 0;
  std::array<double, 3> com{};
  std::array<double, 6> inertia{};  // about the origin: moments xx, yy, zz, then products xy, xz, yz of positive sign
};
MassProperties mass_properties(const Link& link, const DefaultValues& value);

// The numbers of a joint's drive, in this order; zero where it has none. Only a rotor also has an axis.
inline constexpr std::array<const char*, 8> kDriveNumbers = {
    "damping", "friction", "friction_velocity", "armature", "stiffness", "rest", "rotor_inertia", "rotor_ratio"};
std::array<double, 8> drive_numbers(const Joint& joint, const DefaultValues& value);
std::array<double, 3> rotor_axis(const Joint& joint, const DefaultValues& value);
int rotor_carrier(const Joint& joint);

// The position (rad, m) of an independent joint in which loops are assembled; zero for a coupled joint.
double assembled_coordinate(const KinematicTree& tree, int joint);

// How a coupled joint follows the others: its factors, one per coordinate, and its offset. A joint that follows through
// a loop has none: they are NaN.
struct CouplingNumbers {
  std::vector<double> factors;
  double offset = 0;
  // Zero, or the position in which loops are assembled, if that is not next to where they are drawn.
  double assembled = 0;
};
CouplingNumbers coupling_numbers(const KinematicTree& tree, const Coupling& coupling, const DefaultValues& value);

// How the length of a tendon follows the joints: its factors, one per joint, coupled ones included.
struct TendonNumbers {
  std::vector<double> factors;
  double stiffness = 0, damping = 0, rest = 0;
};
TendonNumbers tendon_numbers(const KinematicTree& tree, const Tendon& tendon, const DefaultValues& value);

}  // namespace robcogen::model
