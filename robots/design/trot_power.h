// A quadruped trots at a constant speed: the second of the two design studies of Frigerio et al., JOSER 7(1), 2016, 7.5
// (Fig. 14b).
//
// The motion is given: the trunk does not accelerate, and diagonal pairs of feet alternate on the ground, which pushes
// them vertically. Inverse dynamics gives the torques.
#pragma once

#include "posture.h"

namespace design {

struct Trot {
  double speed;             // m/s
  double height = 0.6;      // m, of the trunk's origin above the ground: the hips are 0.08 m below
  double period = 0.6;      // s, of a step of all legs
  double clearance = 0.08;  // m, of the swinging feet
};

// Motion of the feet in trunk axes at this phase, a fraction of the period.
struct FeetMotion {
  Feet positions, velocities, accelerations;
  Eigen::Vector4d on_ground;  // 1 or 0
};
FeetMotion trotting_feet(const Trot& trot, double phase);

// Power of joints and motors per leg, mean over a step.
struct Power {
  double value;                                    // W
  Eigen::Matrix<double, kParameters, 1> gradient;  // W, in the order of kParameterNames
};

// Sum of |torque times velocity| of hip and knee.
Power mechanical_power(const ParameterArray& parameters, const Trot& trot);

// Power of electric motors, including the losses of their windings and bearings.
Power electric_power(const ParameterArray& parameters, const Trot& trot);

// The values without gradients.
double mechanical_power_value(const ParameterArray& parameters, const Trot& trot);
double electric_power_value(const ParameterArray& parameters, const Trot& trot);

}  // namespace design
