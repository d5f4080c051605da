// Joint motions that move the feet as given, and their derivatives by the parameters of the design.
#pragma once

#include <quadruped_parametric/quadruped_parametric.h>

#include <cstddef>
#include <string_view>

namespace design {

namespace quadruped = quadruped_parametric;
using quadruped::JointState, quadruped::ParameterArray;
using Parameters = quadruped::Parameters<>;

inline constexpr int kParameters = static_cast<int>(quadruped::kParameterNames.size());

// Index of a parameter in kParameterNames.
constexpr std::size_t index_of(std::string_view name) {
  std::size_t index = 0;
  while (quadruped::kParameterNames.at(index) != name) ++index;
  return index;
}

// Coordinates x, y, z of LF, RF, LH and RH in trunk axes: positions (m), velocities, accelerations or forces.
using Feet = Eigen::Matrix<double, 12, 1>;

// Positions of the feet below the origins of the four hips, at this height (m, negative).
Feet feet_below_hips(double height);

Feet feet_positions(const Parameters& parameters, const JointState& q);

// Front and hind knees point inwards.
JointState bent_knees();

// Joint positions (rad) with the feet at the given positions, and hips and knees bent to the same sides as in `like`.
// Throws std::domain_error if the legs do not reach.
JointState posture(const Parameters& parameters, const Feet& feet, const JointState& like);

struct Motion {
  JointState q, qd, qdd;
};

// Joint motion for this motion of the feet with respect to a trunk that does not accelerate.
Motion motion(
    const Parameters& parameters,
    const Feet& positions,
    const Feet& velocities,
    const Feet& accelerations,
    const JointState& like);

// Columns in the order of kParameterNames.
struct MotionDerivatives {
  Eigen::Matrix<double, 12, kParameters> q, qd, qdd;
};

// Derivatives of a motion in which the feet move in the same way for all parameters: J q' = -P', where P' is the
// derivative of the positions of the feet with constant joint positions, and so on for velocities and accelerations.
MotionDerivatives motion_derivatives(const Parameters& parameters, const Motion& motion);

}  // namespace design
