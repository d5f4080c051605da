// The kinematic tree: the paper's domain model of an articulated robot (its Fig. 3), free of any syntax.
//
// A KinematicTree is valid by construction: `build` makes it from a Description and reports what is wrong. Links and
// joints keep the order in which the document declares them; the tree structure is a separate order (`topological`).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/drive.h"
#include "model/loop.h"
#include "model/placement.h"
#include "model/quantity.h"

namespace robcogen::model {

// Of one coordinate: a turn about the z axis of the joint frame (rad), a slide along it (m), or a screw motion: a turn
// (rad) that slides in proportion.
// A spherical joint has three joints here, its components: the angular velocity of the child relative to the parent
// about the child's x, y and z axis (rad/s). Their positions are the last elements of one unit quaternion.
enum class JointType { revolute, prismatic, helical, spherical };

// Whether the coordinate is an angle; else it is a length.
bool turns(JointType type);

// Mass properties as a document gives them: about the origin and in the axes of the link frame, or of `reference`
// (the pose of a user frame in the link frame). Products of inertia have positive sign: ixy = integral of x y dm.
struct Inertia {
  Quantity mass;                // kg
  std::array<Quantity, 3> com;  // m
  Quantity ixx, iyy, izz;       // kg m^2, moments
  Quantity ixy, ixz, iyz;       // kg m^2, products
  std::optional<Placement> reference;
};

// Mass properties about the origin and in the axes of the link frame.
struct RigidBodyInertia {
  Quantity mass;
  std::array<Quantity, 3> first_moment;   // mass * centre of mass
  Quantity ixx, iyy, izz, ixy, ixz, iyz;  // moments, and products of positive sign
};

// Moves the properties from `reference` to the link frame: constants are folded exactly.
RigidBodyInertia in_link_frame(const Inertia& inertia);

// The sum of the parts, each with a `reference`: about the origin and in the axes of the frame that the references are
// in. nullopt for no parts.
std::optional<Inertia> sum_of(const std::vector<Inertia>& parts);

// parent_R_frame, row by row: maps coordinates in the placed frame to coordinates in its parent. Exact for multiples of
// PI/2.
std::array<std::array<Quantity, 3>, 3> rotation_matrix(const Placement& placement);

struct Link {
  std::string name;
  std::optional<Inertia> inertia;  // absent: massless (a virtual link)
  int parent_joint = -1;           // index of the joint that supports it; -1 for the base
  std::vector<int> child_joints;   // indices, in the order of the document's `children`
  Place place;
  bool is_virtual = false;  // between the joints of a joint with several coordinates: no body
  // The frame of the link of this name again, massless: between two components of the spherical joint that carries it.
  bool is_repeated = false;
};

struct Joint {
  std::string name;
  JointType type = JointType::revolute;
  int parent = -1;      // link index
  int child = -1;       // link index
  Placement placement;  // of the joint frame in the parent link frame; motion is about or along its z axis
  Place place;
  JointLimits limits = {};  // infinite when the document has none
  Drive drive = {};
  Quantity pitch = {};  // of a helical joint: m a radian
  // Its position (rad, m) where the loops that it is part of are assembled: near there, where it follows; else at zero.
  std::optional<double> assembled = {};
  // Of a component of a spherical joint: the name of that joint, and the axis of the child, 0, 1 or 2. The first one
  // has the placement, the others stay where it is; all three have the same drive and limits.
  std::string spherical = {};
  int axis = 2;

  // As the document has it.
  const std::string& declared_name() const { return spherical.empty() ? name : spherical; }
  double assembled_position() const { return assembled.value_or(0.0); }
  // False for components that only follow the first one of their joint.
  bool is_first() const { return spherical.empty() || axis == 0; }
};

// How far the child slides along z per unit of the coordinate: 0, 1, or the pitch.
Quantity slide_of(const Joint& joint);

// Of the joint's rotor: of unit length, in axes of its carrier.
std::array<Quantity, 3> rotor_axis(const Joint& joint);

// A joint that follows others: q_joint = offset + sum of factor * q_k, over independent joints k. Through a loop it
// follows in another way: then the terms only tell which joints it follows, and the offset is its position where loops
// are assembled.
struct Coupling {
  struct Term {
    int joint = -1;   // independent
    Quantity factor;  // not the constant zero; of a loop, no number
  };
  int joint = -1;
  std::vector<Term> terms;  // none: the joint stands still
  Quantity offset;          // rad or m
  int closure = -1;         // of KinematicTree::closures, or none
  int loop = -1;            // of KinematicTree::loops: the parallelogram that it keeps closed, or none

  bool is_linear() const { return closure < 0; }
};

struct UserFrame {
  std::string name;
  int link = -1;
  Placement placement;  // in the link frame
  bool hidden = false;  // an implicit frame has this name: only an inertia's ref_frame can refer to this one
  Place place;
};

// An instance of a part in the document: a leg that is described once and attached four times.
struct Limb {
  // With its name in the part.
  struct Element {
    std::string own;
    int index = -1;  // of the link, joint or user frame
  };
  std::string name;  // with which the names of its elements begin
  std::string part;
  int first_link = -1;
  std::vector<Element> links, joints, frames;
};

// A linear actuator between the origins of two frames. Its force is positive where it pushes them apart.
struct Actuator {
  std::string name;
  std::array<std::string, 2> frames;
  Place place;
};

// Which frame a name denotes. `fr_<link>` (base too) and `fr_<joint>` exist implicitly.
struct Frame {
  enum class Kind { link, joint, user };
  Kind kind = Kind::link;
  int index = -1;  // of the link, joint or user frame
  std::string name;
};

// The name of the implicit frame of the link or joint of this name.
std::string implicit_frame_name(const std::string& element);

// Mass properties that make functions of the dynamics undefined in every position (inertia_defects in plausibility.h).
struct InertiaDefects {
  // A joint that meets no inertia while the joints beyond it are free; `locked`: nor while they are locked.
  struct FreeJoint {
    int joint = -1;
    bool locked = false;
  };
  bool no_inertia = false;  // no moving link has mass properties: kinematics only
  bool no_mass = false;     // the total mass of the moving links is zero: the centre of mass is undefined
  std::vector<FreeJoint> joints = {};
  bool free_base = false;    // the floating base meets no inertia in some direction while the joints are free
  bool locked_base = false;  // the same while the joints are locked: the robot as one body

  // Of the joint-space inertia matrix.
  bool is_singular() const { return free_base || !joints.empty(); }
};

class KinematicTree {
 public:
  std::string name;
  bool floating_base = false;
  bool uses_passive_forces = true;       // damping, friction and springs are part of inverse and forward dynamics
  std::vector<Link> links;               // [0] is the base, then the links as declared
  std::vector<Joint> joints;             // as declared; q, qd, tau, … have the independent ones, in this order
  std::vector<Coupling> couplings = {};  // of the other joints, in their order
  std::vector<LoopJoint> loops = {};
  std::vector<Closure> closures = {};        // an order in which they can be solved
  std::vector<Closure> parallelograms = {};  // loops that linear couplings keep closed; before closures
  std::vector<Actuator> actuators = {};
  std::vector<UserFrame> user_frames;
  std::vector<Parameter> parameters;
  std::vector<Limb> limbs = {};  // in the order of the document
  InertiaDefects inertia_defects = {};

  // Independent coordinates: what qd, tau, … have elements of.
  int dof() const { return static_cast<int>(joints.size() - couplings.size()); }
  // Itself, or of a component of a spherical joint the first one.
  int first_component_of(int joint) const;
  // First components of spherical joints.
  std::vector<int> spherical_joints() const;
  // Joints that follow through loops that no formulas close: their positions are elements of q.
  std::vector<int> followers_in_q() const;
  // Elements of q: coordinates, but four of a spherical joint: w, x, y, z of the unit quaternion that rotates
  // coordinates of the child to those of the joint frame. Behind them followers_in_q().
  int position_count() const { return dof() + static_cast<int>(spherical_joints().size() + followers_in_q().size()); }
  // By joint: its element of q; -1 for other coupled joints. The scalar part of a quaternion is in front of its first
  // component.
  std::vector<int> position_elements() const;
  // The links of the document: those whose frame is not repeated.
  int link_count() const;
  // The independent joints: coordinate k is the velocity of joint coordinates()[k].
  std::vector<int> coordinates() const;
  // The coordinate that an independent joint is the velocity of.
  int coordinate_of(int joint) const;
  // Whether a joint has anything of a drive; whether one has a rotor.
  bool has_drives() const;
  bool has_rotors() const;
  // Whether a joint is helical.
  bool has_pitches() const;
  // Whether a joint follows others by a sum; whether one does through a loop in a proportion that changes.
  bool has_linear_couplings() const;
  bool has_closures() const { return !closures.empty(); }
  // nullptr for an independent joint.
  const Coupling* coupling_of(int joint) const;
  // By joint: where loops are assembled. Coupled joints follow by their sums; those that follow through closures are
  // where these put them. `parameter_values` are those of `parameters`.
  std::vector<double> assembled_positions(std::span<const double> parameter_values) const;
  // Joint indices, parents before children, depth first, children in the order of the document.
  std::vector<int> topological() const;
  // -1 for the parent of the base.
  int parent_joint_of(int joint) const {
    return links[static_cast<std::size_t>(joints[static_cast<std::size_t>(joint)].parent)].parent_joint;
  }
  // All frames that can be named: link frames, joint frames, then user frames that are not hidden.
  std::vector<Frame> frames() const;
  std::optional<Frame> find_frame(const std::string& name) const;
  std::optional<int> find_link(const std::string& name) const;
  // By the declared name; of a spherical joint the first component.
  std::optional<int> find_joint(const std::string& name) const;
  // The link that a frame moves with: a joint frame is fixed to the parent link of its joint.
  int link_of(const Frame& frame) const;
  // In that link's frame.
  Placement placement_of(const Frame& frame) const;
};

// All joints: those of coordinates, then coupled ones.
std::vector<int> independent_joints_first(const KinematicTree& tree);
// The same without the components that only follow the first one of their joint: the joints of the document.
std::vector<int> declared_joints_first(const KinematicTree& tree);

// Of the elements of q: those of joints, and `<joint>_w` of quaternions.
std::vector<std::string> position_names(const KinematicTree& tree);

// The suffixes of the names of a spherical joint's positions, scalar first; of its velocities the last three.
inline constexpr std::array<const char*, 4> kQuaternionSuffixes = {"_w", "_x", "_y", "_z"};

struct FramePair {
  Frame left;
  Frame right;
  friend bool operator==(const FramePair& a, const FramePair& b) {
    return a.left.name == b.left.name && a.right.name == b.right.name;
  }
};

// A frame that touches what does not move, by a point at its origin or by a surface, which does not let it turn either.
struct ContactFrame {
  Frame frame;
  bool is_surface = false;
};

// What to generate: coordinate transforms left_X_right, geometric Jacobians left_J_right, and functions of contacts.
struct DesiredTransforms {
  std::vector<FramePair> transforms;
  std::vector<FramePair> jacobians;
  std::vector<ContactFrame> contacts = {};
};

// Every link frame and user frame to and from the base frame; a Jacobian, from the base, for every user frame and
// every leaf link. Where a link has a user frame of its own name, that one stands for the link.
DesiredTransforms default_desired(const KinematicTree& tree);

}  // namespace robcogen::model
