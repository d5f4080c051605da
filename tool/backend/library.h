// The input of a back end: the constants and the programs of a robot, or of a document of coordinate transforms. It
// contains no algorithm and no syntax.
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
#include "symbolic/cost.h"
#include "symbolic/derivative.h"
#include "symbolic/program.h"
#include "symbolic/solved_columns.h"

namespace robcogen::backend {

// In rad or m, rad/s or m/s, N m or N; infinite where the model gives no limit.
struct JointLimits {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  double velocity = std::numeric_limits<double>::infinity();
  double effort = std::numeric_limits<double>::infinity();
};

// The same data as robcogen::JointDrive of the runtime.
struct DriveData {
  double damping = 0, friction = 0, friction_velocity = 0, armature = 0, stiffness = 0, rest = 0;
  double rotor_inertia = 0, rotor_ratio = 0;
  std::array<double, 3> rotor_axis{};
  int rotor_carrier = -1;
};

// The same values as robcogen::JointType of the runtime. A spherical joint has three consecutive components between the
// same two links: the angular velocities about the x, y and z axes of the child.
enum class JointType { revolute, prismatic, helical, spherical };

// Whether the joint position is an angle; otherwise it is a length.
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
  double pitch = 0;      // of a helical joint, in m/rad
  double assembled = 0;  // position of a coordinate (rad, m) where loops are assembled
};

// The joint's name in the document. For `hip_x`, a component of a spherical joint, this is `hip`.
inline std::string declared_name(const JointData& joint) {
  return joint.type == JointType::spherical ? joint.name.substr(0, joint.name.size() - 2) : joint.name;
}

// A joint whose position is `offset` plus the sum of factor * q over the joints that have positions of their own.
struct CoupledJointData {
  JointData joint;
  std::vector<double> factors;  // one per joint of Library::joints
  double offset = 0;            // rad or m
  double assembled = 0;         // for loops: see reflection::Coupling
};

struct LinkData {
  std::string name;
  int parent_joint = -1;  // -1: base; indices continue from Library::joints to Library::coupled
  double mass = 0;
  std::array<double, 3> com{};  // in the link frame
  std::array<double, 6>
      inertia{};  // about the link origin: ixx iyy izz, then products of inertia ixy ixz iyz (positive)
};

struct FrameData {
  std::string name;
  int link = 0;                         // the link it moves with; -1 without a robot
  std::array<double, 3> translation{};  // in that link's frame
  std::array<double, 3> rotation{};
};

// An instance of a part in the document.
struct LimbData {
  // A link, joint or frame of the limb, with its name in the part.
  struct Element {
    std::string own;
    int index = 0;
  };
  std::string name;  // unique: the prefix of its elements' names, then the part's name if limbs share the prefix
  std::string part;
  int first_link = 0;
  std::vector<Element> links;
  std::vector<Element> joints;  // joints that have an element in joint arrays
  std::vector<Element> frames;  // user frames, into Library::frames
};

struct ContactData {
  int frame = 0;  // into Library::frames
  bool is_surface = false;
};

// The same data as reflection::Loop.
struct LoopData {
  std::string name, type;                 // type: an enumerator
  int first_frame = 0, second_frame = 0;  // into Library::frames
  double length = 0.0;
};

// The same data as reflection::Actuator.
struct ActuatorData {
  std::string name;
  int from = 0, to = 0;  // into Library::frames
};

// A parameter. Library::parameters has the order of the elements of inputs of role `parameters`.
struct ParameterData {
  std::string name;
  double default_value = std::numeric_limits<double>::quiet_NaN();  // NaN: none
  bool is_kinematics = true;                                        // appears in the placement of a joint or frame
  bool is_dynamics = false;                                         // appears in mass properties
};

// The convention of the user's Rx(a). Right: it maps coordinates from the frame rotated by +a to the original frame.
// Left: it is the inverse.
enum class PrimitiveConvention { none, left, right };

struct PrimitiveData {
  bool rotation = false;
  int axis = 0;  // 0 x, 1 y, 2 z
};

// A coordinate transform as a product: its factors from left to right, and the program that computes their amounts (m,
// rad), one row per factor.
struct ProductData {
  std::vector<PrimitiveData> primitives;
  symbolic::Program amounts;
};

// One callable function. Overloads share `name` and differ in inputs (gravity, external wrenches); `kernel` is unique.
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
  std::vector<symbolic::DerivativeBlock> derivatives = {};  // blocks of its outputs, to be checked by differences
  // Set for languages whose functions take precomputed sines and cosines, if the program reads any.
  std::optional<symbolic::AngleParts> parts = {};
  // Set for languages with vectors: the same program with congruent limbs in lanes, if there is one, and a text for
  // each class of congruent limbs.
  std::optional<symbolic::Program> in_lanes = {};
  std::vector<std::string> limbs_in_lanes = {};
  // Set where Features::column_loops asks for a loop: the function calls the stage that has the name of `right_sides`,
  // whose last output is `factor`, and solves. `program` then has inputs and outputs only.
  std::optional<symbolic::SolvedColumns> solved = {};
  // Set for homogeneous transforms, where Library::primitives is a convention: the product in this convention.
  std::optional<ProductData> product = {};
  // Set for homogeneous transforms without a robot, for checks: the product in the convention `right`, from all
  // parameters and all variables.
  std::optional<ProductData> factors = {};
};

// Which functions loop over right-hand sides: Function::solved, Library::stages.
enum class ColumnLoops {
  none,       // all code is written out
  if_long,    // functions that are too long without the loop
  if_faster,  // also functions that are faster with columns in lanes
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
  bool uses_passive_forces = true;  // the forces of `drive` are part of the dynamics
  std::vector<LinkData> links;      // [0] is the base; empty: a library of transforms of `variables`, without a robot
  std::vector<JointData> joints;    // joints that have an element in joint arrays
  // The names of the elements of q, if q differs from the order of `joints`: the scalar part of a spherical joint's
  // quaternion precedes the joint's components, and `followers` come last. Otherwise empty.
  std::vector<std::string> positions = {};
  std::vector<CoupledJointData> coupled = {};
  std::vector<FrameData> frames;
  std::vector<LimbData> limbs = {};
  std::vector<LoopData> loops = {};
  // The last elements of q: joints that follow the others through loops that have no closed-form solution.
  struct Follower {
    int joint = 0;           // index into all_joints()
    double assembled = 0.0;  // its position where loops are assembled
  };
  std::vector<Follower> followers = {};
  std::vector<ActuatorData> actuators = {};
  std::vector<ContactData> contacts = {};  // only if the library has contact functions
  std::vector<ParameterData> parameters;   // constants above that depend on a parameter without default are NaN
  std::vector<std::string> variables;      // without a robot: in the order of their first use in the document
  std::vector<std::string> groups;         // the groups that were asked for, in canonical order
  std::vector<Function> functions;
  std::vector<Function> stages = {};  // called by functions that have Function::solved
  // For robots with parameters, in languages that cache the values that depend on parameters alone (`functions` then
  // read the cache as their parameters). Each update computes one part of the cache from the parameters: the values
  // that depend on kinematics parameters alone, on dynamics parameters alone, and on both. The parts follow one
  // another.
  std::vector<Function> updates;
  // For the same robots: functions of the parameters that compute the numbers of `links`, `joints` (then `coupled`) and
  // `frames`, one column per item; and, where joints are coupled, the factors and the offset of each, one column per
  // coupled joint.
  std::vector<Function> numbers;
  // For a robot, in languages whose functions take precomputed sines and cosines: the sines and cosines of all angles.
  // The angles are the positions of all joints, followed by sums of positions.
  struct Trigonometry {
    int angle_count = 0;
    symbolic::Program angles;  // [parameters,] q -> all angles
    Function addition;         // [parameters,] sines and cosines of the joints -> of all angles
  };
  std::optional<Trigonometry> trigonometry = {};
  PrimitiveConvention primitives = PrimitiveConvention::none;
  bool has_batches = false;              // each function also exists over many states: C++, robots
  std::vector<std::string> levels = {};  // processors, besides the baseline, that kernels are compiled for: C++, robots
  bool has_single_precision = true;      // everything also exists in float: C++

  // Whether the elements of q differ from those of qd.
  bool has_own_positions() const { return !positions.empty(); }
  bool has_spherical_joints() const { return !quaternions().empty(); }
  // Whether the joint is the second or third component of a spherical joint.
  bool is_follower(std::size_t joint) const {
    return joint > 0 && joint < joints.size() && joints[joint].type == JointType::spherical &&
           joints[joint - 1].child == joints[joint].child;
  }
  // The indices of the elements of q at which quaternions begin.
  std::vector<int> quaternions() const {
    std::vector<int> first;
    for (std::size_t j = 0; j < joints.size(); ++j)
      if (joints[j].type == JointType::spherical && !is_follower(j))
        first.push_back(static_cast<int>(j + first.size()));
    return first;
  }
  // The names of the elements of q.
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
  // The joints that have an element in joint arrays, then the coupled joints.
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
