// The input of a back end: the constants and the programs of a robot, or of a document of coordinate transforms. No
// algorithm, no syntax.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "support/files.h"
#include "symbolic/accuracy.h"
#include "symbolic/angle_parts.h"
#include "symbolic/count.h"
#include "symbolic/derivative.h"
#include "symbolic/program.h"
#include "symbolic/solved_columns.h"

namespace robcogen::backend {

// rad or m, rad/s or m/s, N m or N; infinite where the model gives no limit.
struct JointLimits {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  double velocity = std::numeric_limits<double>::infinity();
  double effort = std::numeric_limits<double>::infinity();
};

// As robcogen::JointDrive of the runtime.
struct DriveData {
  double damping = 0, friction = 0, friction_velocity = 0, armature = 0, stiffness = 0, rest = 0;
  double rotor_inertia = 0, rotor_ratio = 0;
  std::array<double, 3> rotor_axis{};
  int rotor_carrier = -1;
};

// As robcogen::JointType of the runtime. A spherical joint has three components in a row, between the same links: the
// angular velocities about the x, y and z axis of the child.
enum class JointType { revolute, prismatic, helical, spherical };

// Whether the joint turns; else its position is a length.
inline bool turns(JointType type) {
  switch (type) {
    case JointType::revolute:
    case JointType::helical:
    case JointType::spherical:
      return true;
    case JointType::prismatic:
      break;
  }
  return false;
}

// Constants of the model in SI units, for traits and for the self-check's independent recursion.
struct JointData {
  std::string name;
  JointType type = JointType::revolute;
  int parent = 0;  // link index
  int child = 0;   // link index
  // Pose of the joint frame in the parent link frame: translation (m), rotation about intrinsic x, y', z'' (rad).
  std::array<double, 3> translation{};
  std::array<double, 3> rotation{};
  JointLimits limits{};
  std::optional<DriveData> drive = {};
  double pitch = 0;      // of a helical joint: m a radian
  double assembled = 0;  // of a coordinate: its position (rad, m) where loops are assembled
};

// As in the document: of a component of a spherical joint, `hip_x`, the name of that joint.
inline std::string declared_name(const JointData& joint) {
  return joint.type == JointType::spherical ? joint.name.substr(0, joint.name.size() - 2) : joint.name;
}

// A joint whose position is a sum of factor * q of the joints that have positions of their own, and of `offset`.
struct CoupledJointData {
  JointData joint;
  std::vector<double> factors;  // one a joint of Library::joints
  double offset = 0;            // rad or m
  double assembled = 0;         // of loops: see reflection::Coupling
};

struct LinkData {
  std::string name;
  int parent_joint = -1;  // -1: base; counted on from Library::joints to Library::coupled
  double mass = 0;
  std::array<double, 3> com{};  // link frame
  std::array<double, 6>
      inertia{};  // about the link origin: ixx iyy izz, then products of inertia ixy ixz iyz (positive)
};

struct FrameData {
  std::string name;
  int link = 0;                         // the link it moves with; -1 with no robot
  std::array<double, 3> translation{};  // in that link's frame
  std::array<double, 3> rotation{};
};

// An instance of a part in the document.
struct LimbData {
  // With its name in the part.
  struct Element {
    std::string own;
    int index = 0;
  };
  std::string name;  // unique; with which the names of its elements begin, then, where several begin so, the part
  std::string part;
  int first_link = 0;
  std::vector<Element> links;
  std::vector<Element> joints;  // those of joint arrays
  std::vector<Element> frames;  // user frames, into Library::frames
};

struct ContactData {
  int frame = 0;  // into Library::frames
  bool is_surface = false;
};

// As reflection::Loop.
struct LoopData {
  std::string name, type;                 // of the enumeration
  int first_frame = 0, second_frame = 0;  // into Library::frames
  double length = 0.0;
};

// As reflection::Actuator.
struct ActuatorData {
  std::string name;
  int from = 0, to = 0;  // into Library::frames
};

// In the order of the elements of inputs of role `parameters`.
struct ParameterData {
  std::string name;
  double default_value = std::numeric_limits<double>::quiet_NaN();  // not a number: none
  bool is_kinematics = true;                                        // stands in the placement of a joint or frame
  bool is_dynamics = false;                                         // stands in mass properties
};

// The convention of a user's Rx(a): right: it maps coordinates from the frame rotated by +a to the original frame;
// left: the inverse.
enum class PrimitiveConvention { none, left, right };

struct PrimitiveData {
  bool rotation = false;
  int axis = 0;  // 0 x, 1 y, 2 z
};

// A coordinate transform as a product: its factors, the first one leftmost, and the program of their amounts (m, rad),
// a row each.
struct ProductData {
  std::vector<PrimitiveData> primitives;
  symbolic::Program amounts;
};

// One callable. Overloads share `name` and differ in inputs (gravity, external wrenches); `kernel` is unique.
struct Function {
  std::string group;   // file stem: inverse_dynamics, forward_dynamics, joint_space_inertia, transforms, jacobians
  std::string scope;   // nested namespace: "", "transforms::motion", "jacobians", …
  std::string name;    // `inverse_dynamics`, `fr_base_X_fr_foot`
  std::string kernel;  // `inverse_dynamics_external`; identifier, unique in the library
  std::vector<std::string> summary;       // documentation lines: what, frames, units, source
  std::vector<int> columns;               // jacobians: joint index of each column
  std::vector<std::string> labels = {};   // regressors: what each column multiplies
  int left_frame = -1, right_frame = -1;  // transforms, jacobians: indices into frames
  symbolic::Program program;
  std::string method = {};                                  // how it is computed, where there was a choice
  std::optional<symbolic::RoundingError> error = {};        // where it was measured
  std::vector<symbolic::DerivativeBlock> derivatives = {};  // among its outputs, to be checked by differences
  // For languages whose functions take precomputed sines and cosines, if the program reads any.
  std::optional<symbolic::AngleParts> parts = {};
  // For languages with vectors: the same program with congruent limbs in lanes, if there is one; and the limbs, a text
  // for each class.
  std::optional<symbolic::Program> in_lanes = {};
  std::vector<std::string> limbs_in_lanes = {};
  // By Features::column_loops: that it calls the stage of this name, `right_sides`, of which `factor` is the last
  // output, and solves. Then `program` has inputs and outputs only.
  std::optional<symbolic::SolvedColumns> solved = {};
  // Homogeneous transforms, where Library::primitives is a convention: in this convention.
  std::optional<ProductData> product = {};
  // The same without a robot, for checks: in the convention `right`, from all parameters and all variables.
  std::optional<ProductData> factors = {};
};

// Which functions loop over right-hand sides: Function::solved, Library::stages.
enum class ColumnLoops {
  none,       // all is written out
  if_long,    // those that are too long without the loop
  if_faster,  // those too that are faster with columns in lanes
};

// The forms of programs that a language uses.
struct Features {
  bool caches_parameters =
      false;                 // functions read values that depend on parameters alone from a cache: Library::updates
  bool has_lanes = false;    // congruent limbs share the lanes of vectors: Function::in_lanes
  bool takes_sines = false;  // functions take precomputed sines and cosines: Library::trigonometry
  ColumnLoops column_loops = ColumnLoops::none;
};

struct Library {
  std::string name;               // identifier: namespace and folder
  std::string enclosing;          // enclosing namespace `a::b`, or empty
  std::string robot;              // the name of the robot, or of the model, in the document
  std::string model_file;         // file name without folders
  std::string model_hash;         // of the canonical document
  std::string generator_version;  // of the tool: printed in one file only, so that a new version recompiles little
  bool floating_base = false;
  bool uses_passive_forces = true;  // those of `drive` are part of the dynamics
  std::vector<LinkData> links;      // [0] is the base; empty: a library without robot, of transforms of `variables`
  std::vector<JointData> joints;    // those of joint arrays
  // Of a robot with spherical joints the elements of q, which are more: in front of the components of such a joint is
  // the scalar part of its quaternion. Else empty.
  std::vector<std::string> positions = {};
  std::vector<CoupledJointData> coupled = {};
  std::vector<FrameData> frames;
  std::vector<LimbData> limbs = {};
  std::vector<LoopData> loops = {};
  // Of the last elements of q, which follow the others through loops that no formulas close.
  struct Follower {
    int joint = 0;           // of all_joints()
    double assembled = 0.0;  // its position where loops are assembled
  };
  std::vector<Follower> followers = {};
  std::vector<ActuatorData> actuators = {};
  std::vector<ContactData> contacts = {};  // where the library has functions of them
  std::vector<ParameterData> parameters;   // constants above that depend on one without default are not a number
  std::vector<std::string> variables;      // with no robot: in the document's order of their first use
  std::vector<std::string> groups;         // which groups were asked for, in canonical order
  std::vector<Function> functions;
  std::vector<Function> stages = {};  // that functions with Function::solved call
  // Of robots with parameters, for languages that cache the values that depend on parameters alone (`functions` then
  // read the cache as their parameters). Each update computes a part of the cache from the parameters: the values that
  // depend on kinematics parameters alone, on dynamics parameters alone, and on both; the parts follow one another.
  std::vector<Function> updates;
  // Of the same robots: the numbers of `links`, `joints` (then `coupled`) and `frames`, a column each, from the
  // parameters; where joints are coupled, then a column of factors and offset of each of these.
  std::vector<Function> numbers;
  // Of a robot, for languages whose functions take precomputed sines and cosines: those of all angles, first the
  // position of each joint, then sums.
  struct Trigonometry {
    int angle_count = 0;
    symbolic::Program angles;  // [parameters,] q -> all of them
    Function addition;         // [parameters,] sines and cosines of the joints -> of all angles
  };
  std::optional<Trigonometry> trigonometry = {};
  PrimitiveConvention primitives = PrimitiveConvention::none;
  bool has_batches = false;              // each function also over many states at once: C++, robots
  std::vector<std::string> levels = {};  // processors that kernels are compiled for besides the baseline: C++, robots
  bool has_single_precision = true;      // all of it in float, too: C++

  // Whether the elements of q are others than those of qd.
  bool has_own_positions() const { return !positions.empty(); }
  bool has_spherical_joints() const { return !quaternions().empty(); }
  // Whether it is a component of a spherical joint behind the first one.
  bool is_follower(std::size_t joint) const {
    return joint > 0 && joint < joints.size() && joints[joint].type == JointType::spherical &&
           joints[joint - 1].child == joints[joint].child;
  }
  // Elements of q at which quaternions begin.
  std::vector<int> quaternions() const {
    std::vector<int> first;
    for (std::size_t j = 0; j < joints.size(); ++j)
      if (joints[j].type == JointType::spherical && !is_follower(j))
        first.push_back(static_cast<int>(j + first.size()));
    return first;
  }
  // Of the elements of q.
  std::vector<std::string> position_names() const {
    std::vector<std::string> names = positions;
    if (names.empty())
      for (const JointData& joint : joints) names.push_back(joint.name);
    return names;
  }
  std::vector<std::string> parameter_names() const {
    std::vector<std::string> names;
    for (const ParameterData& parameter : parameters) names.push_back(parameter.name);
    return names;
  }
  bool has_robot() const { return !links.empty(); }
  std::vector<JointData> coupled_joints() const {
    std::vector<JointData> list;
    for (const CoupledJointData& c : coupled) list.push_back(c.joint);
    return list;
  }
  // The joints of joint arrays, then coupled ones.
  std::vector<JointData> all_joints() const {
    std::vector<JointData> all = coupled_joints();
    all.insert(all.begin(), joints.begin(), joints.end());
    return all;
  }
  bool has_drives() const {
    return std::any_of(joints.begin(), joints.end(), [](const JointData& j) { return j.drive.has_value(); }) ||
           std::any_of(coupled.begin(), coupled.end(), [](const auto& c) { return c.joint.drive.has_value(); });
  }
  bool has_pitches() const {
    const std::vector<JointData> all = all_joints();
    return std::any_of(all.begin(), all.end(), [](const JointData& joint) { return joint.type == JointType::helical; });
  }
};

}  // namespace robcogen::backend
