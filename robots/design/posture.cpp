#include "posture.h"

#include <Eigen/LU>
#include <stdexcept>

namespace design {
namespace {

namespace homogeneous = quadruped::transforms::homogeneous;
namespace ik = quadruped::inverse_kinematics;
using quadruped::Twist;
using ByJoints = Eigen::Matrix<double, 12, 12>;
using ByParameters = Eigen::Matrix<double, 12, kParameters>;

constexpr double kClose = 1e-9;  // m, from the given position of a foot: closer than this but for rounding

ByJoints feet_jacobian(const Parameters& parameters, const JointState& q) {
  return contact_jacobian(parameters, q).rightCols<12>();
}

// Derivatives of the positions of the feet with constant joint positions.
ByParameters feet_by_parameters(const Parameters& parameters, const JointState& q) {
  // Matrices are stored column by column, so rows 12 to 14 are those of the translation.
  const auto translation = [](const auto& d) { return d.d_parameters.template middleRows<3>(12); };
  ByParameters result;
  result << translation(homogeneous::fr_trunk_X_fr_LF_foot_d_parameters(parameters, q)),
      translation(homogeneous::fr_trunk_X_fr_RF_foot_d_parameters(parameters, q)),
      translation(homogeneous::fr_trunk_X_fr_LH_foot_d_parameters(parameters, q)),
      translation(homogeneous::fr_trunk_X_fr_RH_foot_d_parameters(parameters, q));
  return result;
}

}  // namespace

Feet feet_below_hips(double height) {
  constexpr double kForward = 0.3735, kLeft = 0.207;  // quadruped_parametric.kindsl
  Feet feet;
  feet << kForward, kLeft, height, kForward, -kLeft, height, -kForward, kLeft, height, -kForward, -kLeft, height;
  return feet;
}

Feet feet_positions(const Parameters& parameters, const JointState& q) {
  const quadruped::JointTrigonometry at(parameters, q);
  const auto translation = [](const auto& X) { return X.template topRightCorner<3, 1>(); };
  Feet feet;
  feet << translation(homogeneous::fr_trunk_X_fr_LF_foot(parameters, at)),
      translation(homogeneous::fr_trunk_X_fr_RF_foot(parameters, at)),
      translation(homogeneous::fr_trunk_X_fr_LH_foot(parameters, at)),
      translation(homogeneous::fr_trunk_X_fr_RH_foot(parameters, at));
  return feet;
}

JointState bent_knees() {
  JointState q;
  q << 0, 0.7, -1.4, 0, 0.7, -1.4, 0, -0.7, 1.4, 0, -0.7, 1.4;
  return q;
}

JointState posture(const Parameters& parameters, const Feet& feet, const JointState& like) {
  JointState q = like;
  const auto take = [&](const auto& leg) {
    if (!(leg.misfit[0] < kClose)) throw std::domain_error("the legs do not reach where their feet shall be");
    q = leg.q;
  };
  const auto foot = [&](int number) { return Eigen::Vector3d(feet.segment<3>(3 * number)); };
  namespace configuration = ik::configuration;
  take(ik::branch::fr_trunk_X_fr_LF_foot(
      parameters, foot(0), configuration::fr_trunk_X_fr_LF_foot(parameters, like), q));
  take(ik::branch::fr_trunk_X_fr_RF_foot(
      parameters, foot(1), configuration::fr_trunk_X_fr_RF_foot(parameters, like), q));
  take(ik::branch::fr_trunk_X_fr_LH_foot(
      parameters, foot(2), configuration::fr_trunk_X_fr_LH_foot(parameters, like), q));
  take(ik::branch::fr_trunk_X_fr_RH_foot(
      parameters, foot(3), configuration::fr_trunk_X_fr_RH_foot(parameters, like), q));
  return q;
}

Motion motion(
    const Parameters& parameters,
    const Feet& positions,
    const Feet& velocities,
    const Feet& accelerations,
    const JointState& like) {
  Motion result;
  result.q = posture(parameters, positions, like);
  const Eigen::PartialPivLU<ByJoints> J(feet_jacobian(parameters, result.q));
  result.qd = J.solve(velocities);
  result.qdd = J.solve(accelerations - contact_bias(parameters, result.q, result.qd, Twist()));
  return result;
}

MotionDerivatives motion_derivatives(const Parameters& parameters, const Motion& m) {
  const Eigen::PartialPivLU<ByJoints> J(feet_jacobian(parameters, m.q));
  MotionDerivatives d;
  d.q = -J.solve(feet_by_parameters(parameters, m.q));

  // J qd is the velocity of the feet, and J qdd is the same function with qdd in place of qd.
  const auto velocity = contact_velocity_d_parameters_q(parameters, m.q, m.qd, Twist());
  d.qd = -J.solve(velocity.d_parameters + velocity.d_q * d.q);

  const auto linear = contact_velocity_d_parameters_q(parameters, m.q, m.qdd, Twist());
  const auto bias = contact_bias_d_parameters_q_qd(parameters, m.q, m.qd, Twist());
  d.qdd = -J.solve(linear.d_parameters + linear.d_q * d.q + bias.d_parameters + bias.d_q * d.q + bias.d_qd * d.qd);
  return d;
}

}  // namespace design
