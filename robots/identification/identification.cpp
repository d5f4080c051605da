#include "identification.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <array>
#include <cmath>
#include <random>

namespace identification {
namespace {

constexpr double kRate = 100;  // Hz, of measurements
// Friction of each joint, which the document does not have.
const JointState kDamping = (JointState() << 4, 3.5, 2, 0.07, 0.08, 0.04).finished();          // N m s/rad
const JointState kFriction = (JointState() << 5, 4.5, 3, 0.4, 0.35, 0.3).finished();           // N m
const JointState kNoiseLevels = (JointState() << 1.5, 1.5, 0.8, 0.08, 0.08, 0.05).finished();  // N m

// Uses the bits of the engine, not a distribution of the standard library, so that numbers are the same everywhere.
double uniform(std::mt19937& engine) {
  return static_cast<double>(engine()) * 0x1p-31 - 1;
}
double normal(std::mt19937& engine) {
  double sum = 0;
  for (int k = 0; k < 12; ++k) sum += uniform(engine);
  return sum / 2;  // variance 12 / 3 / 4
}

std::vector<Instant> instants_of(const Motion& motion) {
  std::vector<Instant> instants;
  for (int k = 0; k < Motion::kPeriod * kRate; ++k) instants.push_back(motion.at(k / kRate));
  return instants;
}

// The rows of all instants, each in units of its noise.
Eigen::MatrixXd weighted_rows(const std::vector<Instant>& instants) {
  Eigen::MatrixXd all(kJoints * instants.size(), kUnknowns);
  for (std::size_t k = 0; k < instants.size(); ++k)
    all.middleRows<kJoints>(static_cast<Eigen::Index>(k) * kJoints) =
        kNoiseLevels.cwiseInverse().asDiagonal() * rows(instants[k]);
  return all;
}
Eigen::VectorXd weighted_torques(const std::vector<Instant>& instants) {
  Eigen::VectorXd all(kJoints * instants.size());
  for (std::size_t k = 0; k < instants.size(); ++k)
    all.segment<kJoints>(static_cast<Eigen::Index>(k) * kJoints) = instants[k].measured.cwiseQuotient(kNoiseLevels);
  return all;
}

// The derivative of the pseudo-inertia by one inertial parameter.
Eigen::Matrix4d unit_pseudo_inertia(int parameter) {
  InertialParameters unit = InertialParameters::Zero();
  unit[parameter] = 1;
  return pseudo_inertia(unit, 0);
}

}  // namespace

Instant Motion::at(double time) const {
  Instant result{time, JointState::Zero(), JointState::Zero(), JointState::Zero(), JointState::Zero(), {}};
  for (int k = 0; k < kHarmonics; ++k) {
    const double w = 2 * M_PI * (k + 1) / kPeriod, s = std::sin(w * time), c = std::cos(w * time);
    result.q += s * sines.col(k) + c * cosines.col(k);
    result.qd += w * (c * sines.col(k) - s * cosines.col(k));
    result.qdd -= w * w * (s * sines.col(k) + c * cosines.col(k));
  }
  return result;
}

double condition_number(const Motion& motion) {
  Eigen::MatrixXd all = weighted_rows(instants_of(motion));
  all.colwise().normalize();
  const Eigen::VectorXd values = Eigen::MatrixXd(all.transpose() * all).selfadjointView<Eigen::Lower>().eigenvalues();
  return std::sqrt(values.maxCoeff() / values.minCoeff());
}

Motion exciting_motion(int count, unsigned seed) {
  std::mt19937 engine(seed);
  Motion best;
  double least = HUGE_VAL;
  for (int trial = 0; trial < count; ++trial) {
    Motion motion;
    for (int k = 0; k < Motion::kHarmonics; ++k)
      for (int j = 0; j < kJoints; ++j) motion.sines(j, k) = uniform(engine), motion.cosines(j, k) = uniform(engine);
    JointState far = JointState::Zero(), fast = JointState::Zero();
    for (const Instant& instant : instants_of(motion)) {
      far = far.cwiseMax(instant.q.cwiseAbs());
      fast = fast.cwiseMax(instant.qd.cwiseAbs());
    }
    const JointState scale = (1.5 * far.cwiseInverse()).cwiseMin(3 * fast.cwiseInverse());
    motion.sines = scale.asDiagonal() * motion.sines;
    motion.cosines = scale.asDiagonal() * motion.cosines;
    const double condition = condition_number(motion);
    if (condition < least) best = motion, least = condition;
  }
  return best;
}

JointState noise() {
  return kNoiseLevels;
}

std::vector<Instant> measure(const Motion& motion, unsigned seed) {
  std::mt19937 engine(seed);
  std::vector<Instant> instants = instants_of(motion);
  for (Instant& i : instants) {
    i.tau = puma::inverse_dynamics(i.q, i.qd, i.qdd) + kDamping.cwiseProduct(i.qd) +
            kFriction.cwiseProduct(i.qd.cwiseSign());
    for (int j = 0; j < kJoints; ++j) i.measured[j] = i.tau[j] + kNoiseLevels[j] * normal(engine);
  }
  return instants;
}

Rows rows(const Instant& i) {
  Rows Y;
  Y << puma::base_regressor(i.q, i.qd, i.qdd), Eigen::Matrix<double, kJoints, kJoints>(i.qd.asDiagonal()),
      Eigen::Matrix<double, kJoints, kJoints>(i.qd.cwiseSign().asDiagonal());
  return Y;
}

Unknowns least_squares(const std::vector<Instant>& instants) {
  return weighted_rows(instants).colPivHouseholderQr().solve(weighted_torques(instants));
}

InertialParameters actual_parameters() {
  return puma::inertial_parameters();
}

Eigen::Matrix4d pseudo_inertia(const InertialParameters& pi, int link) {
  const auto p = pi.segment<10>(10 * link);
  const double half = (p[4] + p[5] + p[6]) / 2;
  Eigen::Matrix4d J;
  J << half - p[4], p[7], p[8], p[1], p[7], half - p[5], p[9], p[2], p[8], p[9], half - p[6], p[3], p[1], p[2], p[3],
      p[0];
  return J;
}

// The guess stretches and shears the bodies, which keeps them physically consistent.
InertialParameters guessed_parameters(unsigned seed) {
  std::mt19937 engine(seed);
  InertialParameters guess;
  for (int link = 0; link < kLinks; ++link) {
    Eigen::Matrix4d change = Eigen::Matrix4d::Identity();
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) change(r, c) += 0.1 * uniform(engine);
    for (int r = 0; r < 3; ++r) change(r, 3) = 0.02 * uniform(engine);
    const Eigen::Matrix4d J =
        (1 + 0.2 * uniform(engine)) * (change * pseudo_inertia(actual_parameters(), link) * change.transpose());
    guess.segment<10>(10 * link) << J(3, 3), J(0, 3), J(1, 3), J(2, 3), J(1, 1) + J(2, 2), J(0, 0) + J(2, 2),
        J(0, 0) + J(1, 1), J(0, 1), J(0, 2), J(1, 2);
  }
  return guess;
}

// Newton's method for |weighted residual|^2 / 2 + the sum over links of tr(J0^-1 J) - log det J, which is convex and
// keeps every J positive definite. Friction is estimated together with the parameters.
InertialParameters consistent_parameters(const std::vector<Instant>& instants, const InertialParameters& guess) {
  constexpr int n = 10 * kLinks, all = n + 2 * kJoints, kSteps = 100;
  Eigen::Matrix<double, kUnknowns, all> to_unknowns = Eigen::Matrix<double, kUnknowns, all>::Zero();
  for (int k = 0; k < n; ++k)
    to_unknowns.col(k).head<kBaseParameters>() = puma::base_parameters(InertialParameters::Unit(k));
  to_unknowns.bottomRightCorner<2 * kJoints, 2 * kJoints>().setIdentity();
  const Eigen::MatrixXd A = weighted_rows(instants) * to_unknowns;
  const Eigen::MatrixXd normal_matrix = A.transpose() * A;
  const Eigen::VectorXd right = A.transpose() * weighted_torques(instants);

  std::array<Eigen::Matrix4d, 10> unit;
  for (int k = 0; k < 10; ++k) unit[static_cast<std::size_t>(k)] = unit_pseudo_inertia(k);
  Eigen::VectorXd x(all);
  x << guess, Eigen::VectorXd::Zero(2 * kJoints);
  const auto cost = [&](const Eigen::VectorXd& at) {
    double sum = at.dot(normal_matrix * at) / 2 - right.dot(at);
    for (int link = 0; link < kLinks; ++link) {
      const Eigen::Matrix4d J = pseudo_inertia(at.head<n>(), link);
      const Eigen::LLT<Eigen::Matrix4d> factor(J);
      if (factor.info() != Eigen::Success) return HUGE_VAL;
      sum += (pseudo_inertia(guess, link).inverse() * J).trace();
      for (int i = 0; i < 4; ++i) sum -= 2 * std::log(factor.matrixL()(i, i));
    }
    return sum;
  };
  for (int step = 0; step < kSteps; ++step) {
    Eigen::VectorXd gradient = normal_matrix * x - right;
    Eigen::MatrixXd curvature = normal_matrix;
    for (int link = 0; link < kLinks; ++link) {
      const Eigen::Matrix4d inverse = pseudo_inertia(x.head<n>(), link).inverse();
      const Eigen::Matrix4d pull = pseudo_inertia(guess, link).inverse() - inverse;
      for (int k = 0; k < 10; ++k) {
        const Eigen::Matrix4d column = inverse * unit[static_cast<std::size_t>(k)] * inverse;
        gradient[10 * link + k] += (pull * unit[static_cast<std::size_t>(k)]).trace();
        for (int l = 0; l < 10; ++l)
          curvature(10 * link + k, 10 * link + l) += (column * unit[static_cast<std::size_t>(l)]).trace();
      }
    }
    const Eigen::VectorXd direction = -curvature.ldlt().solve(gradient);
    const double descent = -gradient.dot(direction), before = cost(x);
    if (descent < 1e-9) break;
    double length = 1;
    while (length > 1e-12 && !(cost(x + length * direction) <= before - 0.1 * length * descent)) length /= 2;
    if (length <= 1e-12) break;
    x += length * direction;
  }
  return x.head<n>();
}

JointState prediction_error(const std::vector<Instant>& instants, const Unknowns& unknowns) {
  JointState sum = JointState::Zero();
  for (const Instant& i : instants) sum += (rows(i) * unknowns - i.tau).cwiseAbs2();
  return (sum / static_cast<double>(instants.size())).cwiseSqrt();
}

}  // namespace identification
