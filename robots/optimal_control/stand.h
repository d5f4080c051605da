// A quadruped stands: a linear-quadratic regulator holds it where it is, against pushes.
//
// Its feet are points that hold to the ground, so that the twelve joints follow from the pose of the trunk: the state
// is the displacement of the trunk (a turn and a shift, in its axes) and its velocity, twelve numbers, and the inputs
// are the torques of all joints.
#pragma once

#include <quadruped_parametric/quadruped_parametric.h>

#include <Eigen/Core>
#include <vector>

namespace optimal_control {

namespace quadruped = quadruped_parametric;

inline constexpr double kControlStep = 0.002;  // s

using Vector12 = Eigen::Matrix<double, 12, 1>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;

// About the posture q, which the torques tau hold: the next state is A times the state plus B times the change of the
// torques.
struct Standing {
  quadruped::JointState q, tau;
  double height;    // m, of the trunk's origin above the feet
  Vector12 forces;  // of the ground on the feet, in trunk axes
  Matrix12 rate;    // of the state by the state, in continuous time
  Matrix12 A, B;
};
Standing standing(double height);

// The gains K of tau + K x, with the smallest sum of squares of states and torques, as weighted. Throws
// std::runtime_error where the Riccati equation does not converge.
Matrix12 regulator(const Matrix12& A, const Matrix12& B, const Vector12& state_weights, double torque_weight);
Matrix12 regulator(const Standing& s);

// The moduli of the eigenvalues of A + B K.
Vector12 closed_loop_moduli(const Standing& s, const Matrix12& K);

struct Instant {
  double time;                        // s
  Vector12 state;                     // of the whole robot, as the regulator sees it
  double least_force, most_friction;  // of the feet: vertical force (N), horizontal by vertical force
};

// The whole robot, with the trunk given this velocity at the start (angular, linear; trunk axes), under the regulator.
// Feet hold to the ground whatever their forces.
std::vector<Instant> push(
    const Standing& s,
    const Matrix12& K,
    const Eigen::Matrix<double, 6, 1>& velocity,
    double duration);

}  // namespace optimal_control
