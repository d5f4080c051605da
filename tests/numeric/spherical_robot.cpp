#include "spherical_robot.h"

#include <cmath>
#include <complex>

#include "at.h"
#include "dice.h"
#include "model/plausibility.h"
#include "model/spherical_joints.h"
#include "robcogen/reference/algebra.h"

namespace robcogen::numeric {
namespace {

using model::KinematicTree;
using model::Quantity;
using reference::Matrix;
using reference::Vector;

// The constant rotations about x in front of the three axes, in quarter turns.
std::array<int, 3> quarters(const EulerRobot& euler) {
  return {euler.other ? 1 : 0, 1, -1};
}

// Returns a rotation as intrinsic rotations about x, y', z''.
std::array<Quantity, 3> angles_of(const Matrix<double>& R) {
  const double cosine = std::hypot(R(0, 0), R(0, 1)), y = std::atan2(R(0, 2), cosine);
  if (cosine < 1e-9) return {Quantity(std::atan2(R(2, 1), R(1, 1))), Quantity(y), Quantity()};
  return {Quantity(std::atan2(-R(1, 2), R(2, 2))), Quantity(y), Quantity(std::atan2(-R(0, 1), R(0, 0)))};
}

// Element k < 3 is the rotation up to the axis of joint k; the last element is the whole rotation.
template <class Scalar>
std::array<Matrix<Scalar>, 4> products(const EulerRobot& euler, const std::array<Scalar, 3>& angles) {
  const double quarter = std::acos(-1.0) / 2;
  std::array<Matrix<Scalar>, 4> result;
  Matrix<Scalar> R = Matrix<Scalar>::identity(4);
  for (std::size_t k = 0; k < 3; ++k) {
    R = R * reference::rotation(0, Scalar(quarters(euler)[k] * quarter));
    result[k] = reference::rotation_of(R);
    R = R * reference::rotation(2, angles[k]);
  }
  result[3] = reference::rotation_of(R);
  return result;
}

// Maps the rates of the angles to the angular velocity in axes of the child.
template <class Scalar>
Matrix<Scalar> rates_to_velocity(const EulerRobot& euler, const std::array<Scalar, 3>& angles) {
  const std::array<Matrix<Scalar>, 4> R = products(euler, angles);
  Matrix<Scalar> E(3, 3);
  for (int k = 0; k < 3; ++k) {
    const Matrix<Scalar> axes = transpose(R[3]) * R[at(k)];
    E.set_block(0, k, axes.col(2));
  }
  return E;
}

// Returns w, x, y, z. The largest element is computed first, because it is never small.
std::array<double, 4> quaternion_of(const Matrix<double>& R) {
  const double t[4] = {
      R(0, 0) + R(1, 1) + R(2, 2), R(0, 0) - R(1, 1) - R(2, 2), R(1, 1) - R(0, 0) - R(2, 2),
      R(2, 2) - R(0, 0) - R(1, 1)};
  const Vector<double> a{R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1)};
  int largest = 0;
  for (int i = 1; i < 4; ++i)
    if (t[i] > t[largest]) largest = i;
  const double twice = std::sqrt(1 + t[largest]), share = 1 / (2 * twice);
  std::array<double, 4> q{};
  q[at(largest)] = twice / 2;
  if (largest == 0) return {twice / 2, a(0) * share, a(1) * share, a(2) * share};
  const int x = largest - 1;
  q[0] = a(x) * share;
  for (int y = 0; y < 3; ++y)
    if (y != x) q[at(1 + y)] = (R(x, y) + R(y, x)) * share;
  return q;
}

}  // namespace

KinematicTree with_spherical_joints(const KinematicTree& robot, std::uint64_t seed, bool have_drives) {
  Dice dice(seed + 0x2545f491);
  KinematicTree result = robot;
  for (model::Joint& joint : result.joints) {
    if (!dice.chance(0.4)) continue;
    joint.type = model::JointType::spherical;
    joint.drive = {};
    if (have_drives && dice.chance(0.3)) joint.drive.damping = Quantity(dice.between(0.1, 2));
    if (have_drives && dice.chance(0.3)) joint.drive.armature = Quantity(dice.between(0.1, 2));
  }
  for (model::Tendon& tendon : result.tendons)
    std::erase_if(tendon.terms, [&](const model::Tendon::Term& term) {
      return result.joints[at(term.joint)].type == model::JointType::spherical;
    });
  model::expand_spherical_joints(result);
  result.inertia_defects = model::inertia_defects(result);
  return result;
}

EulerRobot with_euler_angles(const KinematicTree& spherical, bool other) {
  EulerRobot euler = {spherical, other};
  for (model::Joint& joint : euler.robot.joints) {
    if (joint.spherical.empty()) continue;
    joint.type = model::JointType::revolute;
    joint.spherical.clear();
    if (joint.axis > 0) {
      joint.placement.rotation[0] = Quantity(Number::pi_multiple(quarters(euler)[at(joint.axis)], 2));
    } else if (other) {
      const auto rotation = model::rotation_matrix(joint.placement);
      Matrix<double> R(3, 3);
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) R(r, c) = rotation[at(r)][at(c)].number().value();
      joint.placement.rotation = angles_of(R * products(euler, std::array{0.0, 0.0, 0.0})[0]);
    }
    joint.axis = 2;
  }
  for (std::size_t i = 0; i < euler.robot.links.size(); ++i) {
    model::Link& link = euler.robot.links[i];
    if (link.is_repeated) link.name += "_" + std::to_string(i);
    link.is_repeated = false;
  }
  // At a pole its inertia matrix is singular, so functions that divide by it are left out.
  euler.robot.inertia_defects.joints = {{euler.robot.topological().front(), false}};
  return euler;
}

SphericalState spherical_state(
    const KinematicTree& spherical,
    const EulerRobot& euler,
    const Positions& q,
    const Positions& qd,
    const Positions& qdd) {
  using Complex = std::complex<double>;
  const int n = spherical.dof();
  SphericalState state{Positions(spherical.position_count()), qd, qdd, Matrix<double>::identity(n)};
  const std::vector<int> elements = spherical.position_elements();
  for (int j = 0; j < n; ++j) state.q(elements[at(j)]) = q(j);
  for (const int first : spherical.spherical_joints()) {
    std::array<double, 3> angles{};
    std::array<Complex, 3> moved{};
    Vector<double> rates(3), accelerations(3);
    Vector<Complex> moved_rates(3);
    constexpr double kStep = 1e-30;
    for (int k = 0; k < 3; ++k) {
      angles[at(k)] = q(first + k);
      rates(k) = qd(first + k);
      accelerations(k) = qdd(first + k);
      moved[at(k)] = Complex(q(first + k), kStep * qd(first + k));
      moved_rates(k) = qd(first + k);
    }
    const Matrix<double> E = rates_to_velocity(euler, angles);
    const Vector<double> w = E * rates;
    const Vector<double> change =
        (rates_to_velocity(euler, moved) * moved_rates).mapped([&](const Complex& x) { return x.imag() / kStep; });
    const Vector<double> wd = E * accelerations + change;
    const std::array<double, 4> quaternion = quaternion_of(products(euler, angles)[3]);
    for (int k = 0; k < 4; ++k) state.q(elements[at(first)] - 1 + k) = quaternion[at(k)];
    for (int k = 0; k < 3; ++k) {
      state.qd(first + k) = w(k);
      state.qdd(first + k) = wd(k);
    }
    state.G.set_block(first, first, E);
  }
  return state;
}

Positions other_angles(const KinematicTree& spherical, const EulerRobot& from, const Positions& q) {
  Positions result = q;
  for (const int first : spherical.spherical_joints()) {
    const Matrix<double> R = products(from, std::array{q(first), q(first + 1), q(first + 2)})[3];
    const EulerRobot to = {{}, !from.other};
    const Matrix<double> M = transpose(products(to, std::array{0.0, 0.0, 0.0})[0]) * R;
    result(first) = std::atan2(-M(1, 2), -M(0, 2));
    result(first + 1) = std::atan2(std::hypot(M(0, 2), M(1, 2)), M(2, 2));
    result(first + 2) = std::atan2(-M(2, 1), M(2, 0));
  }
  return result;
}

}  // namespace robcogen::numeric
