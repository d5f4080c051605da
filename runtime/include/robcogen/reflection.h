// Tables in a generated library: constants of the model, transforms, Jacobians and functions.
//
// The self-check and the benchmark of a robot are written once over these tables. No Eigen, no allocation.
#pragma once

#include <cstddef>

#include "robcogen/batch.h"
#include "robcogen/joint_drive.h"
#include "robcogen/joint_type.h"
#include "robcogen/layout.h"
#include "robcogen/limb.h"

namespace robcogen::reflection {

// A spherical joint has three of these in a row, with the same parent and child: its components, which are the angular
// velocities about the x, y and z axis of the child.
struct Joint {
  const char* name;
  JointType type;
  int parent;  // link index
  int child;   // link index
  // Pose of the joint frame in the parent link's frame: translation (m), then rotation about the intrinsic axes
  // x, y', z'' (rad). Motion is about or along z.
  double translation[3];
  double rotation[3];
  JointDrive drive = {};
  double pitch = 0;      // of a helical joint, m/rad
  double assembled = 0;  // for elements of qd: position (rad, m) at which loops are assembled
};

struct Link {
  const char* name;
  int parent_joint;   // -1: the base
  double mass;        // kg
  double com[3];      // m, link frame
  double inertia[6];  // kg m^2 about the link origin: moments xx yy zz, then products xy xz yz of positive sign
};

struct Frame {
  const char* name;
  int link;  // the link that it moves with
  double translation[3];
  double rotation[3];
};

// A kernel that reads some arrays, q first, and writes another one, matrices column by column. For a robot with
// parameters it reads the cache before q.
template <class... Arrays>
class Kernel {
 public:
  using Constant = void (*)(Arrays... read, double* written) noexcept;
  using Parametric = void (*)(const double* parameters, Arrays... read, double* written) noexcept;

  constexpr Kernel(std::nullptr_t) {}  // no kernel: must not be called
  constexpr Kernel(Constant kernel) : constant_(kernel) {}
  constexpr Kernel(Parametric kernel) : parametric_(kernel) {}

  constexpr bool exists() const { return constant_ != nullptr || parametric_ != nullptr; }

  // `parameters` may be null when the robot has none.
  void operator()(const double* parameters, Arrays... read, double* written) const noexcept {
    if (parametric_ != nullptr)
      parametric_(parameters, read..., written);
    else
      constant_(read..., written);
  }

 private:
  Constant constant_ = nullptr;
  Parametric parametric_ = nullptr;
};

// Kernels that read q, and kernels that read q and qd.
using MatrixKernel = Kernel<const double*>;
using RateKernel = Kernel<const double*, const double*>;

// left_X_right, three forms.
struct Transform {
  const char* name;
  int left;  // frame indices
  int right;
  MatrixKernel homogeneous;  // 4 x 4
  MatrixKernel motion;       // 6 x 6, angular first
  MatrixKernel force;        // 6 x 6, angular first
};

// left_J_right: velocity of the origin of `right` with respect to `left`, in coordinates of `left`, angular rows first.
struct Jacobian {
  const char* name;
  int left;
  int right;
  const int* columns;  // joint index of each column
  int column_count;
  MatrixKernel kernel;  // 6 x column_count
};

// Other quantities of a pair of frames. Twists and columns of Jacobians are angular first.
enum class FrameQuantity {
  jacobian_in_target,       // left_J_right in axes of `right`
  spatial_jacobian,         // of the twist about the origin and in axes of `left`
  jacobian_derivative,      // time derivative of left_J_right
  frame_bias_acceleration,  // time derivative of left_J_right, times qd
  frame_velocity,           // twist of `right` with respect to `left`, about the origin and in axes of `left`
  frame_acceleration,       // time derivative of this twist, in coordinates of `left`
};

constexpr bool is_jacobian(FrameQuantity quantity) {
  return quantity == FrameQuantity::jacobian_in_target || quantity == FrameQuantity::spatial_jacobian ||
         quantity == FrameQuantity::jacobian_derivative;
}

struct FrameFunction {
  const char* name;  // the kernel's name
  FrameQuantity quantity;
  int left;
  int right;
  const int* columns;  // Jacobians: joint index of each column
  int column_count;    // of the result, which has six rows
  // Like Function::call; the inputs are q, q and qd, or q, qd and qdd.
  void (*call)(const double* inputs, double* outputs) noexcept;
};

// Offsets of arrays among the scalars that a function of the tables reads, or writes.
template <int... offsets>
struct At {};

namespace detail {

template <auto kernel, class Read, class Written>
struct Flat;

template <auto kernel, int... read, int... written>
struct Flat<kernel, At<read...>, At<written...>> {
  static void call([[maybe_unused]] const double* in, [[maybe_unused]] double* out) noexcept {
    kernel(in + read..., out + written...);
  }
};

template <auto kernel, class Before, class Behind, class Written>
struct FlatCore;

template <auto kernel, int... before, int... behind, int... written>
struct FlatCore<kernel, At<before...>, At<behind...>, At<written...>> {
  static void call(const double* in, const double* sin_q, const double* cos_q, [[maybe_unused]] double* out) noexcept {
    kernel(in + before..., sin_q, cos_q, in + behind..., out + written...);
  }
};

template <auto kernel, bool has_parameters, class Read, class Written>
struct FlatBatch;

template <auto kernel, bool has_parameters, int... read, int... written>
struct FlatBatch<kernel, has_parameters, At<read...>, At<written...>> {
  static void call(
      [[maybe_unused]] const double* parameters,
      std::ptrdiff_t n,
      [[maybe_unused]] const batch::Strided<const double>& in,
      [[maybe_unused]] const batch::Strided<double>& out,
      batch::Level most) noexcept {
    if constexpr (has_parameters)
      kernel(parameters, n, in.from(read)..., out.from(written)..., most);
    else
      kernel(n, in.from(read)..., out.from(written)..., most);
  }
};

}  // namespace detail

// A kernel with one signature for all kernels: the arrays that it reads follow one another in memory, and so do the
// arrays that it writes.
template <auto kernel, class Read, class Written>
inline constexpr auto* kFlat = &detail::Flat<kernel, Read, Written>::call;

// The same for a kernel that takes sines and cosines after some of these arrays and before the others.
template <auto kernel, class Before, class Behind, class Written>
inline constexpr auto* kFlatCore = &detail::FlatCore<kernel, Before, Behind, Written>::call;

// The same for a function over many states. Parameters, if there are any, are a separate argument.
template <auto kernel, bool has_parameters, class Read, class Written>
inline constexpr auto* kFlatBatch = &detail::FlatBatch<kernel, has_parameters, Read, Written>::call;

struct OperationCount {
  int mul;
  int add;
  int div;
  int sqrt;
  int sincos;
  int instructions;
  int critical_path;
};

struct Function {
  const char* name;  // the kernel's name
  OperationCount count;
  // Numbers of scalars that it reads and writes. `call` takes the arrays of the kernel one after another, in the order
  // of the kernel.
  int inputs;
  int outputs;
  void (*call)(const double* inputs, double* outputs) noexcept;
  // Index of the first joint position among the inputs, for functions that read sines or cosines of joints and for
  // robots with spherical joints; -1 if there is none, or if it is not stated. `call_core` is the same function of the
  // sines and cosines of all joints, as Trigonometry computes them.
  int positions = -1;
  void (*call_core)(const double* inputs, const double* sin_q, const double* cos_q, double* outputs) noexcept = nullptr;
};

// What one column of a derivative varies.
enum class Variation : unsigned char {
  of_input,            // the input of its index
  of_gravity_in_base,  // gravity, three inputs: the base rotates about its own axes
  of_base_pose,        // seven inputs: the base rotates about its own axes; after three columns, its position changes
};

// Whether all derivatives of `rows` results by `columns` inputs are computed, or their product with a vector that is
// among the inputs of the function: with weights of the results, or with rates of the inputs.
enum class Form : unsigned char { matrix, gradient, tangent };

// Derivatives of results of a function by an input, which are among the results of the same function.
struct Derivative {
  const char* name;    // `inverse_dynamics_d_q: tau by q`
  int function;        // index into the functions
  bool by_parameters;  // by the parameters of the model; the first inputs, the cache, are computed from them
  int input, columns;  // index of the first input, and number of inputs
  int value, rows;     // index of the first result, and number of results
  int place;           // index of the first derivative among the results: of a matrix, one column for each input; of a
                       // gradient, one number for each input; of a tangent, one for each result
  Variation variation = Variation::of_input;
  Form form = Form::matrix;
  int vector = 0;  // index of the first input of the vector, unless it is a matrix
};

// `size` inputs of a fused function, from `of_function` on, are those of its part from `of_part` on.
struct PartInput {
  int of_function, of_part, size;
};

// A function whose results are among those of a fused function.
struct Part {
  const char* name;         // `control: bias_forces`
  int function, part;       // indices into the functions
  int place;                // index of its first result among those of the fused function
  const PartInput* inputs;  // all inputs of the part
  int input_count;
};

// What inverse kinematics of left_X_right inverts: all of it, the position of the origin of `right`, or that and the
// direction of its z axis.
enum class InverseTask { pose, position, position_and_axis };

// The functions of a chain with inverse kinematics in closed form: indices into the functions, -1 where there is none.
struct InverseKinematics {
  const char* name;  // left_X_right
  InverseTask task;
  int left;  // frame indices
  int right;
  const int* joints;  // element of qd of each row of sin_q and cos_q
  int joint_count;
  int branches;
  int given;  // element of qd whose position is that of the reference; -1: none
  int all, branch, configuration, redundancy;
  // By how much axes may be off those of a chain with a closed form, which Newton steps follow then; 0: not at all.
  double tolerance = 0;
};

// The function of the same name over n states. `parameters` is the cache of a robot with parameters, which is not among
// the inputs here; other robots do not read it.
struct BatchFunction {
  const char* name;
  int inputs;  // of each state
  int outputs;
  void (*call)(
      const double* parameters,
      std::ptrdiff_t n,
      const batch::Strided<const double>& inputs,
      const batch::Strided<double>& outputs,
      batch::Level most) noexcept;
};

// Sines and cosines of all angles that functions read, those of the joints first. `parameters` is the cache of a robot
// with parameters; other robots do not read it.
struct Trigonometry {
  int angles = 0;
  void (*compute)(const double* parameters, const double* q, double* sin_q, double* cos_q) noexcept = nullptr;
  void (*complete)(
      const double* parameters,
      const double* sin_joint,
      const double* cos_joint,
      double* sin_q,
      double* cos_q) noexcept = nullptr;
};

struct Parameter {
  const char* name;
  bool dynamics;         // a parameter of mass properties; otherwise a length or an angle
  double default_value;  // NaN: no default
  bool shared = false;   // a parameter of mass properties that is a length or an angle too
};

// A joint whose position follows others: offset + the sum of factor * q.
struct Coupling {
  const double* factors;  // one per element of qd; NaN where a loop (not a parallelogram) gives no factors
  double offset;          // rad or m; NaN likewise
  double assembled = 0;   // position at which the loop is assembled, if that is not next to where the joint is drawn
};

// A spring and damper between joints. Its length is the sum of factor * q; joint j must overcome its factor times
// stiffness * (length - rest) + damping * (rate of the length).
struct Tendon {
  const char* name;
  const double* factors;  // one per joint of the table, coupled ones included
  double stiffness;
  double damping;
  double rest;
};

template <class T>
struct Table {
  const T* data;
  int size;
  constexpr const T& operator[](int i) const { return data[i]; }
  constexpr const T* begin() const { return data; }
  constexpr const T* end() const { return data + size; }
};

using BatchFunctions = Table<BatchFunction>;

// A frame that touches something that does not move, with a point or with a surface.
struct Contact {
  int frame;
  bool is_surface;
};

enum class LoopType { point, hinge, slider, weld, distance };

// What a loop keeps constant between two frames. A point keeps their origins together, a hinge also their z axes; a
// slider keeps everything but the displacement along the z axes, a weld everything, a distance that of their origins.
struct Loop {
  const char* name;
  LoopType type;
  int frames[2];
  double length;  // of a distance (m); NaN if it depends on parameters without defaults
};

// A linear actuator between the origins of two frames.
struct Actuator {
  const char* name;
  int frames[2];
};

// Kernels for all actuators, in the order of their table. A library has them with the groups transforms and jacobians.
struct ActuatorKernels {
  MatrixKernel lengths = nullptr;   // m
  RateKernel velocities = nullptr;  // rates of the lengths (m/s)
  MatrixKernel jacobian = nullptr;  // lever arms: one row per actuator, one column per element of qd
};

// A coupled joint whose position is an element of q: it follows through loops that no formulas close.
struct Follower {
  int joint;
  double assembled;  // its position where loops are assembled; for elements of qd it is Joint::assembled
};

struct Robot {
  const char* name;
  bool floating_base;
  Table<Link> links;    // [0] is the base
  Table<Joint> joints;  // those of the elements of qd, then coupled ones
  Table<Frame> frames;
  Table<Transform> transforms;
  Table<Jacobian> jacobians;
  Table<FrameFunction> frame_functions;
  Table<Function> functions;
  Trigonometry trigonometry = {};
  // For robots with parameters, `links`, `joints` and `frames` above hold the numbers of the defaults. `numbers`
  // computes them for other values, in the order of the tables: mass, com and inertia of each link, translation and
  // rotation of each joint and frame.
  Table<Parameter> parameters = {nullptr, 0};
  void (*numbers)(const double* parameters, double* links, double* joints, double* frames) noexcept = nullptr;
  // Whether the numbers of a joint include those of its drive, in the order of JointDrive, after its rotation.
  bool numbers_of_drives = false;
  // Whether damping, friction and springs of the drives are part of inverse and forward dynamics.
  bool passive_forces = true;
  // The same for couplings: the factors of each coupling, then its offset.
  void (*coupling_numbers)(const double* parameters, double* couplings) noexcept = nullptr;
  Table<Coupling> couplings = {nullptr, 0};  // of the last joints, in order
  Table<Derivative> derivatives = {nullptr, 0};
  Table<Contact> contacts = {nullptr, 0};  // in the order of their rows
  // Whether the numbers of a joint end with its pitch.
  bool numbers_of_pitches = false;
  Limbs limbs = {};
  // Couplings whose factors are NaN follow through these loops.
  Table<Loop> loops = {nullptr, 0};
  Table<Actuator> actuators = {nullptr, 0};
  Table<Follower> followers = {nullptr, 0};  // the last elements of q, in order
  ActuatorKernels actuator_kernels = {};
  Table<Part> parts = {nullptr, 0};
  Table<InverseKinematics> inverse_kinematics = {nullptr, 0};
  // The same for tendons: the factors of each tendon, then its stiffness, damping and rest length.
  void (*tendon_numbers)(const double* parameters, double* tendons) noexcept = nullptr;
  Table<Tendon> tendons = {nullptr, 0};

  constexpr int dof() const { return joints.size - couplings.size; }  // elements of qd
  // Elements of q: those of qd, the scalar part of the quaternion of each spherical joint, and followers.
  constexpr int position_count() const { return dof() + quaternions_up_to(dof() - 1) + followers.size; }
  // The element of q that belongs to an element of qd. For a component of a spherical joint it is an element of the
  // vector part of the quaternion, whose scalar part precedes the first component.
  constexpr int position_of(int joint) const { return joint + quaternions_up_to(joint); }
  // The axis of the child that a joint turns about: 0, 1, 2 for the components of a spherical joint, 2 for others.
  constexpr int axis_of(int joint) const {
    if (joints[joint].type != JointType::spherical) return 2;
    int axis = 0;
    while (axis < 2 && joint - axis > 0 && joints[joint - axis - 1].child == joints[joint].child) ++axis;
    return axis;
  }
  // Whether a joint is a component of a spherical joint other than the first.
  constexpr bool is_follower(int joint) const {
    return joints[joint].type == JointType::spherical && axis_of(joint) > 0;
  }

 private:
  constexpr int quaternions_up_to(int joint) const {
    int count = 0;
    for (int j = 0; j <= joint; ++j)
      if (joints[j].type == JointType::spherical && !is_follower(j)) ++count;
    return count;
  }
};

}  // namespace robcogen::reflection
