// An experiment in simulation: the inertial parameters and the friction of an arm, the PUMA 560, from measured torques.
//
//  1. A motion that excites all parameters: the best conditioned of many Fourier series (Swevers et al. 1997).
//  2. Measured torques: those of the arm of the document with friction and noise.
//  3. Base parameters and friction by weighted least squares (Khalil and Dombre 2002, ch. 12).
//  4. Inertial parameters of all links that belong to real bodies, whose pseudo-inertia is positive definite (Wensing,
//     Kim and Slotine 2018), near a guess in the metric of such matrices (Lee, Wensing and Park 2020).
#pragma once

#include <puma/puma.h>

#include <Eigen/Core>
#include <vector>

namespace identification {

using puma::JointState;

inline constexpr int kJoints = puma::kDof, kLinks = puma::kLinkCount - 1;
inline constexpr int kBaseParameters = static_cast<int>(puma::base_regressor_columns.size());
inline constexpr int kUnknowns = kBaseParameters + 2 * kJoints;  // then damping and friction of each joint

using InertialParameters = Eigen::Matrix<double, 10 * kLinks, 1>;
using Unknowns = Eigen::Matrix<double, kUnknowns, 1>;
using Rows = Eigen::Matrix<double, kJoints, kUnknowns>;

struct Instant {
  double time;               // s
  JointState q, qd, qdd;     // rad, rad/s, rad/s^2
  JointState tau, measured;  // N m: without and with noise
};

// A periodic motion of all joints: a sum of sines and cosines of multiples of a frequency, which is never at rest.
struct Motion {
  static constexpr int kHarmonics = 5;
  static constexpr double kPeriod = 10;  // s
  Eigen::Matrix<double, kJoints, kHarmonics> sines, cosines;

  Instant at(double time) const;
};

// The best conditioned of `count` random motions within 1.5 rad of the centre and 3 rad/s.
Motion exciting_motion(int count, unsigned seed);
// Condition number of the weighted regressor of base parameters and friction, with scaled columns.
double condition_number(const Motion& motion);

// Measurements over one period, 100 times a second. The noise is normal, with the standard deviations noise().
std::vector<Instant> measure(const Motion& motion, unsigned seed);
JointState noise();

// The regressor of base parameters and friction.
Rows rows(const Instant& instant);

// Base parameters and friction.
Unknowns least_squares(const std::vector<Instant>& instants);

// The actual numbers of the arm of the document, and a guess of them that is wrong by about a fifth.
InertialParameters actual_parameters();
InertialParameters guessed_parameters(unsigned seed);

// The 4 x 4 matrix of second, first and zeroth moments of mass of a link: positive definite for real bodies.
Eigen::Matrix4d pseudo_inertia(const InertialParameters& pi, int link);

// Inertial parameters of real bodies, near the guess where the measurements do not determine them.
InertialParameters consistent_parameters(const std::vector<Instant>& instants, const InertialParameters& guess);

// RMS of the difference between predicted and real torques, without noise, by joint (N m).
JointState prediction_error(const std::vector<Instant>& instants, const Unknowns& unknowns);

}  // namespace identification
