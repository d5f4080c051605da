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
#include "model/geometry.h"
#include "model/inverse_task.h"
#include "model/loop.h"
#include "model/placement.h"
#include "model/quantity.h"
#include "model/tendon.h"

namespace robcogen::model {

// The motion of one coordinate: a rotation about the z axis of the joint frame (rad), a translation along it (m), or a
// screw motion: a rotation (rad) with a proportional translation.
// A spherical joint is represented by three joints, its components: the angular velocity of the child relative to the
// parent about the child's x, y and z axes (rad/s). The positions of these three are the last elements of one unit
// quaternion.
enum class JointType { revolute, prismatic, helical, spherical };

// Whether the coordinate is an angle rather than a length.
bool turns(JointType type);

// Mass properties as a document gives them: about the origin and in the axes of the link frame, or of `reference` (the
// pose of a user frame in the link frame). Products of inertia have positive sign: ixy = integral of x y dm.
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
  Quantity ixx, iyy, izz, ixy, ixz, iyz;  // moments, and products with positive sign
};

// Transforms the properties from `reference` to the link frame. Constants are folded exactly.
RigidBodyInertia in_link_frame(const Inertia& inertia);

// Transforms the properties to the frame in which this pose places the link frame.
RigidBodyInertia in_outer_frame(const RigidBodyInertia& body, const Placement& pose);

RigidBodyInertia operator+(const RigidBodyInertia& a, const RigidBodyInertia& b);

// Returns the sum of the parts, each of which has a `reference`: about the origin and in the axes of the frame in which
// the references are given. nullopt if there are no parts.
std::optional<Inertia> sum_of(const std::vector<Inertia>& parts);

// parent_R_frame by rows: maps coordinates in the placed frame to coordinates in its parent. Exact for multiples of
// PI/2.
std::array<std::array<Quantity, 3>, 3> rotation_matrix(const Placement& placement);

struct Link {
  std::string name;
  std::optional<Inertia> inertia;  // absent: massless (a virtual link)
  int parent_joint = -1;           // index of the joint that supports it; -1 for the base
  std::vector<int> child_joints;   // indices, in the order of the document's `children`
  Place place;
  bool is_virtual = false;  // not a body: between the coordinates of a joint, or between the joints of a body
  // A massless copy of the frame of the link of this name, between two components of the spherical joint that carries
  // that link.
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
  Quantity pitch = {};  // of a helical joint: m/rad
  // The position (rad, m) in which the loops that the joint is part of are assembled; approximate if the joint is
  // dependent. Zero if absent.
  std::optional<double> assembled = {};
  // For a component of a spherical joint: the name of that joint, and the index of the component's axis in the child,
  // 0, 1 or 2. The first component has the placement; the other two have the identity. All three have the same drive
  // and limits.
  std::string spherical = {};
  int axis = 2;
  // For the motor of a series-elastic joint: the name of that joint (elastic_joints.h).
  std::string motor_of = {};

  // The name in the document.
  const std::string& declared_name() const { return spherical.empty() ? name : spherical; }
  double assembled_position() const { return assembled.value_or(0.0); }
  // False for the second and third component of a spherical joint.
  bool is_first() const { return spherical.empty() || axis == 0; }
};

// Returns the translation of the child along z per unit of the coordinate: 0, 1, or the pitch.
Quantity slide_of(const Joint& joint);

// Returns the axis of the joint's rotor: a unit vector in axes of its carrier.
std::array<Quantity, 3> rotor_axis(const Joint& joint);

// A joint that follows others: q_joint = offset + sum of factor * q_k over independent joints k. A joint that follows
// through a loop does so differently: its terms only tell which joints it follows, and its offset is its position where
// the loops are assembled.
struct Coupling {
  struct Term {
    int joint = -1;   // independent
    Quantity factor;  // not the constant zero; meaningless for a loop
  };
  int joint = -1;
  std::vector<Term> terms;  // empty: the joint does not move
  Quantity offset;          // rad or m
  int closure = -1;         // index in KinematicTree::closures, or -1
  int loop = -1;            // index in KinematicTree::loops of the parallelogram that it keeps closed, or -1

  bool is_linear() const { return closure < 0; }
};

struct UserFrame {
  std::string name;
  int link = -1;
  Placement placement;  // in the link frame
  bool hidden = false;  // an implicit frame has this name: only an inertia's ref_frame can refer to this one
  Place place;
  bool by_name_only = false;  // not among the default frames: a frame of a locked joint
};

// An instance of a part in the document, such as a leg that is described once and attached four times.
struct Limb {
  // An element and its name in the part.
  struct Element {
    std::string own;
    int index = -1;  // of the link, joint or user frame
  };
  std::string name;  // the prefix of the names of its elements
  std::string part;
  int first_link = -1;
  std::vector<Element> links, joints, frames;
};

// A linear actuator between the origins of two frames. A positive force pushes them apart.
struct Actuator {
  std::string name;
  std::array<std::string, 2> frames;
  Place place;
};

// The frame that a name denotes. `fr_<link>` (including the base) and `fr_<joint>` exist implicitly.
struct Frame {
  enum class Kind { link, joint, user };
  Kind kind = Kind::link;
  int index = -1;  // of the link, joint or user frame
  std::string name;
};

// Returns the name of the implicit frame of the link or joint of this name.
std::string implicit_frame_name(const std::string& element);

// Mass properties that make functions of the dynamics undefined in every position (see inertia_defects in
// plausibility.h).
struct InertiaDefects {
  // A joint that meets no inertia while the joints beyond it are free; if `locked`, not even while they are locked.
  struct FreeJoint {
    int joint = -1;
    bool locked = false;
  };
  bool no_inertia = false;  // no moving link has mass properties: kinematics only
  bool no_mass = false;     // the total mass of the moving links is zero: the centre of mass is undefined
  std::vector<FreeJoint> joints = {};
  bool free_base = false;    // the floating base meets no inertia in some direction while the joints are free
  bool locked_base = false;  // the same while the joints are locked: the robot as one body

  // Whether the joint-space inertia matrix is singular.
  bool is_singular() const { return free_base || !joints.empty(); }
};

class KinematicTree {
 public:
  std::string name;
  bool floating_base = false;
  bool uses_passive_forces = true;       // damping, friction and springs are part of inverse and forward dynamics
  std::vector<Link> links;               // [0] is the base, then the links as declared
  std::vector<Joint> joints;             // as declared; q, qd, tau, … contain the independent ones, in this order
  std::vector<Coupling> couplings = {};  // of the dependent joints, in the order of `joints`
  std::vector<LoopJoint> loops = {};
  std::vector<Closure> closures = {};        // in an order in which they can be solved
  std::vector<Closure> parallelograms = {};  // loops that linear couplings keep closed; solved before `closures`
  std::vector<Tendon> tendons = {};
  std::vector<Actuator> actuators = {};
  std::vector<UserFrame> user_frames;
  std::vector<Parameter> parameters;
  std::vector<Limb> limbs = {};  // in the order of the document
  InertiaDefects inertia_defects = {};
  Geometry geometry = {};  // as far as it was asked for

  // The number of independent coordinates: the length of qd, tau, …
  int dof() const { return static_cast<int>(joints.size() - couplings.size()); }
  // Returns the first component if the joint is a component of a spherical joint, otherwise the joint itself.
  int first_component_of(int joint) const;
  // The first components of the spherical joints.
  std::vector<int> spherical_joints() const;
  // The joints that follow through loops which no formulas close. Their positions are elements of q.
  std::vector<int> followers_in_q() const;
  // The number of elements of q: one per coordinate, but four per spherical joint: w, x, y, z of the unit quaternion
  // that rotates coordinates in the child frame to coordinates in the joint frame. followers_in_q() come last.
  int position_count() const { return dof() + static_cast<int>(spherical_joints().size() + followers_in_q().size()); }
  // By joint: the index of its element of q; -1 for coupled joints that have none. The scalar part of a quaternion is
  // in front of the first component.
  std::vector<int> position_elements() const;
  // The number of links in the document: those that are not repeated.
  int link_count() const;
  // The independent joints: coordinate k is the velocity of joint coordinates()[k].
  std::vector<int> coordinates() const;
  // The index of the coordinate that is the velocity of this independent joint.
  int coordinate_of(int joint) const;
  // Whether any joint has a drive; whether any joint has a rotor.
  bool has_drives() const;
  bool has_rotors() const;
  // Whether any joint is helical.
  bool has_pitches() const;
  // Whether any joint follows others by a linear sum; whether any joint follows through a loop in a ratio that depends
  // on the position.
  bool has_linear_couplings() const;
  bool has_closures() const { return !closures.empty(); }
  // Returns nullptr for an independent joint.
  const Coupling* coupling_of(int joint) const;
  // Returns, by joint, the position (rad, m) in which loops are assembled. Coupled joints follow by their sums;
  // dependent joints of closures are where the closures put them. `parameter_values` are the values of `parameters`.
  std::vector<double> assembled_positions(std::span<const double> parameter_values) const;
  // Joint indices, depth first: parents before children, and children in the order of the document.
  std::vector<int> topological() const;
  // Returns -1 for a joint on the base.
  int parent_joint_of(int joint) const {
    return links[static_cast<std::size_t>(joints[static_cast<std::size_t>(joint)].parent)].parent_joint;
  }
  // All frames that can be named: link frames, joint frames, then user frames that are not hidden.
  std::vector<Frame> frames() const;
  std::optional<Frame> find_frame(const std::string& name) const;
  std::optional<int> find_link(const std::string& name) const;
  // Finds a joint by its declared name; for a spherical joint, returns the first component.
  std::optional<int> find_joint(const std::string& name) const;
  // The link that a frame is fixed to. A joint frame is fixed to the parent link of its joint.
  int link_of(const Frame& frame) const;
  // The pose of the frame in the frame of link_of(frame).
  Placement placement_of(const Frame& frame) const;
};

// All joints: first the independent ones, then the coupled ones.
std::vector<int> independent_joints_first(const KinematicTree& tree);
// The same without the second and third components of spherical joints: the joints of the document.
std::vector<int> declared_joints_first(const KinematicTree& tree);

// The names of the elements of q: the names of the joints, and `<joint>_w` for the scalar parts of quaternions.
std::vector<std::string> position_names(const KinematicTree& tree);

// The suffixes of the names of a spherical joint's positions, scalar first; the last three are also the suffixes of its
// velocities.
inline constexpr std::array<const char*, 4> kQuaternionSuffixes = {"_w", "_x", "_y", "_z"};

struct FramePair {
  Frame left;
  Frame right;
  friend bool operator==(const FramePair& a, const FramePair& b) {
    return a.left.name == b.left.name && a.right.name == b.right.name;
  }
};

// A frame in contact with the fixed environment: a point contact at its origin, or a surface contact, which also
// prevents rotation.
struct ContactFrame {
  Frame frame;
  bool is_surface = false;
};

// A function with the results of several others, its parts, which are named as users name them: `bias_forces`,
// `jacobians.fr_base_J_fr_foot`.
struct FusedFunction {
  struct Part {
    std::string function;
    Place place = {};
  };
  std::string name;
  std::vector<Part> parts;
  Place place = {};
};

// Inverse kinematics of left_X_right.
struct InverseTarget {
  FramePair frames;
  InverseTask task = {};
  Place place = {};  // where it is asked for
};

// What to generate: coordinate transforms left_X_right, geometric Jacobians left_J_right, contact functions, inverse
// kinematics, and fused functions.
struct DesiredTransforms {
  std::vector<FramePair> transforms;
  std::vector<FramePair> jacobians;
  std::vector<ContactFrame> contacts = {};
  std::vector<FusedFunction> functions = {};
  std::vector<InverseTarget> inverses = {};
};

// Every link frame and user frame except that of the base. If a link has a user frame of its own name, that frame
// stands for the link.
std::vector<Frame> link_and_user_frames(const KinematicTree& tree);

// The same without the links in the middle of a limb, which have one child: what remains are the user frames, and the
// links at which limbs end, the leaves and those with several children.
std::vector<Frame> end_frames(const KinematicTree& tree);

// The transforms and Jacobians of desired_of_frames, of the end frames (the default) and of all of these frames.
DesiredTransforms default_desired(const KinematicTree& tree);
DesiredTransforms all_desired(const KinematicTree& tree);

// For frames that are named one by one: transforms of each to and from the base frame, and its Jacobian relative to the
// base. The base frame itself has none.
DesiredTransforms desired_of_frames(const KinematicTree& tree, const std::vector<Frame>& frames);

}  // namespace robcogen::model
