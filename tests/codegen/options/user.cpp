// A user's part: it calls the library through its types over Eigen, and reads results by their indices. Compiled with
// options that the library was not compiled with.
#include <walker/reflection.h>
#include <walker/walker.h>

#include <cstdio>
#include <cstring>

#include "expected.h"
#include "robcogen/pose.h"
#include "robcogen/world.h"

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) > 201703L
#include "robcogen/generic/simulation.h"
#ifdef __cpp_exceptions
#include "robcogen/any_robot.h"
#endif
#endif

namespace {

using options::Quantity;

int failures = 0;

void expect(const char* what, int row, int column, double found, double must_be, double tolerance = 1e-9) {
  if (options::agree(found, must_be, tolerance)) return;
  std::printf("%s(%d, %d) is %.17g, must be %.17g\n", what, row, column, found, must_be);
  ++failures;
}

// Elements by their indices.
template <class Matrix>
void compare(const char* what, const Matrix& found, const double* must_be) {
  for (int column = 0; column < found.cols(); ++column)
    for (int row = 0; row < found.rows(); ++row)
      expect(what, row, column, static_cast<double>(found(row, column)), must_be[row + found.rows() * column]);
}

template <class Matrix>
void compare(const char* what, const Matrix& found, Quantity quantity) {
  compare(what, found, options::expected(quantity));
}

template <class Found, class MustBe>
void compare_both(const char* what, const Found& found, const MustBe& must_be) {
  for (int i = 0; i < found.rows(); ++i)
    for (int j = 0; j < found.cols(); ++j) expect(what, i, j, found(i, j), must_be(i, j));
}

walker::JointState joints(const double* numbers) {
  return walker::JointState(numbers[0], numbers[1], numbers[2], numbers[3]);
}

walker::Parameters<> parameters() {
  walker::ParameterValues values;
  values.trunk_mass = options::kTrunkMass;
  walker::Parameters<> result;
  result.update(values);
  return result;
}

const walker::JointState q = joints(options::kQ), qd = joints(options::kQd), qdd = joints(options::kQdd);
const Eigen::Matrix<double, 6, 1> twist = Eigen::Map<const Eigen::Matrix<double, 6, 1>>(options::kTwist);
const robcogen::Twist velocity(twist);
const robcogen::Gravity gravity(options::kGravity[0], options::kGravity[1], options::kGravity[2]);

void check_dynamics(const walker::Parameters<>& p) {
  const auto inverse = walker::inverse_dynamics(p, q, qd, qdd, velocity, gravity);
  compare("tau", inverse.tau, Quantity::tau);
  compare("base_acceleration", inverse.base_acceleration.vector(), Quantity::base_acceleration);
  const auto forward = walker::forward_dynamics(p, q, qd, inverse.tau, velocity, gravity);
  compare("qdd", forward.qdd, Quantity::qdd);
  compare("base_acceleration of forward dynamics", forward.base_acceleration.vector(), Quantity::base_acceleration);
  walker::LinkWrenches none;
  const auto loaded = walker::inverse_dynamics(p, q, qd, qdd, velocity, gravity, none);
  compare("tau with external wrenches", loaded.tau, Quantity::tau);
  compare("H", walker::joint_space_inertia(p, q), Quantity::inertia);
  compare("C", walker::coriolis_matrix(p, q, qd, velocity), Quantity::coriolis);
  const walker::InertiaFactor factor = walker::joint_space_inertia_factor(p, q);
  compare("L", factor.L(), Quantity::factor);
  const Eigen::Matrix<double, 10, 1> ones = Eigen::Matrix<double, 10, 1>::Ones();
  const Eigen::Matrix<double, 10, 1> back = walker::joint_space_inertia(p, q) * factor.solve(ones);
  for (int i = 0; i < 10; ++i) expect("H H^-1 1", i, 0, back(i), 1);
  const auto d = walker::inverse_dynamics_fully_actuated_derivatives(
      p, q, qd, qdd, velocity, robcogen::SpatialAcceleration(twist), gravity);
  compare("d_q", d.d_q, Quantity::d_q);
  compare("d_qd", d.d_qd, Quantity::d_qd);
  compare("d_base_velocity", d.d_base_velocity, Quantity::d_base_velocity);
  const walker::f32::JointState q32 = q.cast<float>();
  const Eigen::Matrix4f X32 =
      walker::f32::transforms::homogeneous::fr_trunk_X_fr_left_foot(walker::Parameters<float>(), q32);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      expect(
          "X in float", i, j, static_cast<double>(X32(i, j)), options::expected(Quantity::homogeneous)[i + 4 * j],
          1e-6);
}

// Types of the user's own, in the storage order that the user's Eigen has.
void check_kinematics(const walker::Parameters<>& p) {
  const Eigen::Matrix4d X = walker::transforms::homogeneous::fr_trunk_X_fr_left_foot(p, q);
  compare("homogeneous", X, Quantity::homogeneous);
  compare("motion", walker::transforms::motion::fr_trunk_X_fr_left_foot(p, q), Quantity::motion);
  compare("force", walker::transforms::force::fr_trunk_X_fr_left_foot(p, q), Quantity::force);
  const Eigen::Matrix<double, 6, 2> J = walker::jacobians::fr_trunk_J_fr_left_foot(p, q);
  compare("jacobian", J, Quantity::jacobian);
  compare("momentum matrix", walker::centroidal_momentum_matrix(p, q), Quantity::momentum);

  // The functions for frames that are known at run time take matrices of both storage orders.
  const robcogen::BasePose pose = robcogen::BasePose::from_rpy(0.3, -0.2, 0.9, Eigen::Vector3d(1, 2, 3));
  const Eigen::Matrix4d foot = robcogen::homogeneous_in_world(pose, X);
  compare_both("pose of the foot", foot, Eigen::Matrix4d(pose.homogeneous() * X));
  const auto full =
      robcogen::jacobian_with_base<walker::kDof>(X, J, walker::jacobians::fr_trunk_J_fr_left_foot_columns);
  compare("jacobian with base", full.rightCols<4>().leftCols<2>(), Quantity::jacobian);
  const Eigen::Matrix<double, 6, 10> user = full;
  const Eigen::Matrix3d R = pose.rotation();
  compare_both("rows in axes", robcogen::rows_in_axes(R, user), robcogen::rows_in_axes<double, 10>(R, full));
  const robcogen::BasePose again = robcogen::BasePose::from_rotation(R);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) expect("rotation", i, j, again.rotation()(i, j), R(i, j));
}

// The tables were compiled with the library's options.
void check_tables() {
  const robcogen::reflection::Robot& robot = walker::reflection::robot;
  expect("links", 0, 0, robot.links.size, 5);
  expect("mass", 0, 0, robot.links[1].mass, 2.0);
  expect("rotation", 0, 0, robot.joints[0].rotation[0], 0.3);
  expect("is prismatic", 0, 0, robot.joints[3].type == robcogen::JointType::prismatic, 1);
  expect("parameter", 0, 0, robot.parameters[0].default_value, 6.0);
  expect("functions", 0, 0, robot.functions.size > 10, 1);
}

#ifdef __cpp_concepts
// A robot behind an interface that the tables serve as well.
void check_generic(const walker::Parameters<>& p) {
  const walker::Robot robot{p};
  robcogen::State<walker::Robot> state;
  state.q = q;
  state.qd = qd;
  state.base_velocity = velocity;
  const auto motion = robot.forward_dynamics(q, qd, qdd, velocity, gravity);
  const robcogen::State<walker::Robot> next = integrate(state, motion, 0.01);
  for (int i = 0; i < 4; ++i) expect("integrated qd", i, 0, next.qd(i), qd(i) + 0.01 * motion.qdd(i));
#ifdef __cpp_exceptions
  const robcogen::AnyRobot any = robcogen::make_any<walker::Robot>(walker::reflection::robot, robot);
  const Eigen::Matrix4d X = any.homogeneous_transform(any.find_transform("fr_trunk_X_fr_left_foot"), q);
  compare("homogeneous of any robot", X, Quantity::homogeneous);
  robcogen::DynamicMatrix<double> J(6, 2);
  any.jacobian(any.find_jacobian("fr_trunk_J_fr_left_foot"), q, J);
  compare("jacobian of any robot", J, Quantity::jacobian);
  Eigen::MatrixXd H(10, 10);
  any.joint_space_inertia(q, H);
  compare("H of any robot", H, Quantity::inertia);
  char message[200] = "";
  try {
    any.joint_space_inertia(q.head<3>(), H);
  } catch (const std::invalid_argument& error) {
    std::snprintf(message, sizeof message, "%s", error.what());
  }
  const char* const must_be = "joint_space_inertia of Walker: q has 3 elements and must have 4";
  if (std::strcmp(message, must_be) != 0) {
    std::printf("the message is '%s', must be '%s'\n", message, must_be);
    ++failures;
  }
#endif
}
#endif

}  // namespace

int main() {
#ifdef __AVX512F__
  if (!__builtin_cpu_supports("avx512f")) return 77;
#endif
#ifdef __AVX2__
  if (!__builtin_cpu_supports("avx2")) return 77;
#endif
  const walker::Parameters<> p = parameters();
  check_dynamics(p);
  check_kinematics(p);
  check_tables();
#ifdef __cpp_concepts
  check_generic(p);
#endif
  std::printf("%d failures\n", failures);
  return failures == 0 ? 0 : 1;
}
