#include "trot_power.h"

#include <cmath>

namespace design {
namespace {

using quadruped::Gravity, quadruped::SpatialAcceleration, quadruped::Twist;
using Gradient = Eigen::Matrix<double, kParameters, 1>;

constexpr int kRotor = static_cast<int>(index_of("rotor_inertia")), kGear = static_cast<int>(index_of("gear_ratio"));

constexpr int kInstants = 100;  // of a step
// Two vertical forces cannot balance the moment about the line through the feet, and swinging legs pull the trunk back
// and forth, so the forces are those of the nearest wrench.
constexpr double kRegularization = 1e-6;

// All motors have the same diameter. The square of their torque per watt of heat is proportional to their length, and
// thus to the inertia of their rotors: 0.06 (N m)^2/W with a rotor of 1e-4 kg m^2. Losses of gears and bearings depend
// on the speed only.
constexpr double kMotorConstant = 600;  // (N m)^2/W for each kg m^2
constexpr double kMotorDrag = 2e-4;     // N m s/rad

// A polynomial from -1 to 1 with slope `slope` and no curvature at its ends, for s from 0 to 1, with its derivatives.
struct Swing {
  double value, rate, curvature;
};
Swing forwards(double s, double slope) {
  // 2 s - 1 + (slope - 2) times a polynomial that is zero at both ends and in the middle, with slope 1 at the ends.
  const double a = slope - 2;
  const double s2 = s * s, s3 = s2 * s, s4 = s3 * s, s5 = s4 * s;
  return {
      2 * s - 1 + a * (s - 10 * s3 + 15 * s4 - 6 * s5), 2 + a * (1 - 30 * s2 + 60 * s3 - 30 * s4),
      a * (-60 * s + 180 * s2 - 120 * s3)};
}
// A polynomial that rises to 1 and falls again, with zero speed and acceleration at both ends.
Swing upwards(double s) {
  const double u = s * (1 - s), du = 1 - 2 * s;
  return {64 * u * u * u, 192 * u * u * du, 384 * u * du * du - 384 * u * u};
}

// Torques and their derivatives at one instant.
struct Forces {
  JointState tau;
  Eigen::Matrix<double, 12, kParameters> tau_by_parameters;
};

// Weights of the foot forces: feet on the ground carry by vertical forces only.
Feet weights_of(const FeetMotion& feet) {
  Feet weights = Feet::Zero();
  for (int foot = 0; foot < 4; ++foot) weights[3 * foot + 2] = feet.on_ground[foot];
  return weights;
}

const Gravity kGravity(0, 0, -9.81);
const Eigen::Matrix<double, 1, 1> kRegular(kRegularization);

JointState torques(const Parameters& parameters, const Motion& m, const FeetMotion& feet) {
  return constrained_inverse_dynamics(
             parameters, m.q, m.qd, m.qdd, Twist(), SpatialAcceleration(), weights_of(feet), kRegular, kGravity)
      .tau;
}

// The joint motion depends on the parameters, because the motion of the feet does not.
Forces torques_and_derivatives(
    const Parameters& parameters,
    const Motion& m,
    const MotionDerivatives& by_parameters,
    const FeetMotion& feet) {
  const auto d = constrained_inverse_dynamics_d_parameters_q_qd_qdd(
      parameters, m.q, m.qd, m.qdd, Twist(), SpatialAcceleration(), weights_of(feet), kRegular, kGravity);
  return {
      d.tau, d.tau_d_parameters + d.tau_d_q * by_parameters.q + d.tau_d_qd * by_parameters.qd +
                 d.tau_d_qdd * by_parameters.qdd};
}

bool is_driven(int joint) {
  return joint % 3 != 0;  // hip and knee
}

// Calls visit(motion, feet) in every instant of a step.
template <class Visit>
void step(const Parameters& parameters, const Trot& trot, const Visit& visit) {
  for (int i = 0; i < kInstants; ++i) {
    const FeetMotion feet = trotting_feet(trot, (i + 0.5) / kInstants);
    const Motion m = motion(parameters, feet.positions, feet.velocities, feet.accelerations, bent_knees());
    visit(m, feet);
  }
}

// Sum of a function of torque, velocity and parameters over hips and knees, per leg, mean over a step.
template <class Loss>
double mean(const ParameterArray& values, const Trot& trot, const Loss& loss) {
  const Parameters parameters(values);
  double sum = 0;
  step(parameters, trot, [&](const Motion& m, const FeetMotion& feet) {
    const JointState tau = torques(parameters, m, feet);
    for (int j = 0; j < 12; ++j)
      if (is_driven(j)) sum += loss(tau[j], m.qd[j]).value;
  });
  return sum / (4 * kInstants);
}

template <class Loss>
Power mean_and_gradient(const ParameterArray& values, const Trot& trot, const Loss& loss) {
  const Parameters parameters(values);
  Power sum{0, Gradient::Zero()};
  step(parameters, trot, [&](const Motion& m, const FeetMotion& feet) {
    const MotionDerivatives by_parameters = motion_derivatives(parameters, m);
    const Forces forces = torques_and_derivatives(parameters, m, by_parameters, feet);
    for (int j = 0; j < 12; ++j) {
      if (!is_driven(j)) continue;
      const auto l = loss(forces.tau[j], m.qd[j]);
      sum.value += l.value;
      sum.gradient += l.by_torque * forces.tau_by_parameters.row(j).transpose() +
                      l.by_velocity * by_parameters.qd.row(j).transpose() + l.by_parameters;
    }
  });
  return {sum.value / (4 * kInstants), sum.gradient / (4 * kInstants)};
}

// Power of one joint, with its partial derivatives.
struct Loss {
  double value, by_torque, by_velocity;
  Gradient by_parameters;
};

Loss mechanical(double torque, double velocity) {
  const double power = torque * velocity, sign = power < 0 ? -1 : 1;
  return {sign * power, sign * velocity, sign * torque, Gradient::Zero()};
}

auto electric(const ParameterArray& parameters) {
  const quadruped::ParameterValues values = Parameters(parameters).values();
  const double gear = values.gear_ratio, inertia = values.rotor_inertia;
  return [=](double torque, double velocity) {
    const double resistance = 1 / (gear * gear * kMotorConstant * inertia), damping = kMotorDrag * gear * gear;
    const double heat = resistance * torque * torque, drag = damping * velocity * velocity;
    Loss loss = mechanical(torque, velocity);
    loss.value += heat + drag;
    loss.by_torque += 2 * resistance * torque;
    loss.by_velocity += 2 * damping * velocity;
    loss.by_parameters[kGear] = (2 * drag - 2 * heat) / gear;
    loss.by_parameters[kRotor] = -heat / inertia;
    return loss;
  };
}

}  // namespace

FeetMotion trotting_feet(const Trot& trot, double phase) {
  const double stance = trot.period / 2;  // s, as long as the swing
  const double reach = trot.speed * stance / 2;
  FeetMotion result{feet_below_hips(-trot.height), Feet::Zero(), Feet::Zero(), Eigen::Vector4d::Zero()};
  for (int foot = 0; foot < 4; ++foot) {
    // LF and RH are on the ground in the first half of the period, RF and LH in the second.
    const bool is_first = foot == 0 || foot == 3;
    const double share = 2 * (is_first ? phase : phase - 0.5), s = share - std::floor(share);
    const int x = 3 * foot, z = x + 2;
    if ((phase < 0.5) == is_first) {
      result.on_ground[foot] = 1;
      result.positions[x] += reach * (1 - 2 * s);
      result.velocities[x] = -trot.speed;
    } else {
      const Swing forward = forwards(s, -2), up = upwards(s);
      result.positions[x] += reach * forward.value;
      result.velocities[x] = reach * forward.rate / stance;
      result.accelerations[x] = reach * forward.curvature / (stance * stance);
      result.positions[z] += trot.clearance * up.value;
      result.velocities[z] = trot.clearance * up.rate / stance;
      result.accelerations[z] = trot.clearance * up.curvature / (stance * stance);
    }
  }
  return result;
}

Power mechanical_power(const ParameterArray& parameters, const Trot& trot) {
  return mean_and_gradient(parameters, trot, mechanical);
}

Power electric_power(const ParameterArray& parameters, const Trot& trot) {
  return mean_and_gradient(parameters, trot, electric(parameters));
}

double mechanical_power_value(const ParameterArray& parameters, const Trot& trot) {
  return mean(parameters, trot, mechanical);
}

double electric_power_value(const ParameterArray& parameters, const Trot& trot) {
  return mean(parameters, trot, electric(parameters));
}

}  // namespace design
