// A quadruped stands: a linear-quadratic regulator holds it in place against pushes.
//
// Its feet are points that stick to the ground, so that the twelve joint positions follow from the pose of the trunk.
// The state is the displacement of the trunk (a rotation and a translation, in its axes) and its velocity, twelve
// numbers, and the inputs are the torques of all joints.
#pragma once

#include <quadruped_parametric/quadruped_parametric.h>

#include <Eigen/Core>
#include <vector>

namespace optimal_control {

namespace quadruped = quadruped_parametric;

inline constexpr double kControlStep = 0.002;  // s

using Vector12 = Eigen::Matrix<double, 12, 1>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;

// Linearisation about the posture q, which the torques tau hold: the next state is A times the state plus B times the
// change of the torques.
struct Standing {
  quadruped::JointState q, tau;
  double height;    // m, of the trunk's origin above the feet
  Vector12 forces;  // of the ground on the feet, in trunk axes
  Matrix12 rate;    // of the state by the state, in continuous time
  Matrix12 A, B;
};
Standing standing(double height);

// The gains K of tau + K x that minimise the weighted sum of squares of states and torques. Throws std::runtime_error
// if the Riccati equation does not converge.
Matrix12 regulator(const Matrix12& A, const Matrix12& B, const Vector12& state_weights, double torque_weight);
Matrix12 regulator(const Standing& s);

// The moduli of the eigenvalues of A + B K.
Vector12 closed_loop_moduli(const Standing& s, const Matrix12& K);

struct Instant {
  double time;                        // s
  Vector12 state;                     // of the whole robot, as the regulator sees it
  double least_force, most_friction;  // of the feet: vertical force (N), horizontal by vertical force
};

// Simulates the whole robot under the regulator, with this initial velocity of the trunk (angular, linear; trunk axes).
// Feet stick to the ground whatever their forces.
std::vector<Instant> push(
    const Standing& s,
    const Matrix12& K,
    const Eigen::Matrix<double, 6, 1>& velocity,
    double duration);

}  // namespace optimal_control
