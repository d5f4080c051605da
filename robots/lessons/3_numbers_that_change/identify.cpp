// Identifies the arm from a log (standard input): what it carries, its inertial parameters, and its friction.
#include <arm/arm.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <cstdio>
#include <vector>

using arm::JointState;
constexpr int kBase = arm::base_regressor_columns.size(), kUnknowns = kBase + 4;
using Rows = Eigen::Matrix<double, 2, kUnknowns>;
using Unknowns = Eigen::Matrix<double, kUnknowns, 1>;

struct Sample {
  double t;
  JointState q, tau;
};

std::vector<Sample> read_log() {
  std::vector<Sample> log;
  Sample s;
  if (std::scanf("%*s") != 0) return log;  // names of the columns
  while (std::scanf("%lf,%lf,%lf,%lf,%lf", &s.t, &s.q[0], &s.q[1], &s.tau[0], &s.tau[1]) == 5) log.push_back(s);
  return log;
}

// The torques are these rows times the unknowns: base parameters, damping and friction of each joint.
Rows rows(const arm::Parameters<>& parameters, const JointState& q, const JointState& qd, const JointState& qdd) {
  Rows Y = Rows::Zero();
  Y.leftCols<kBase>() = arm::base_regressor(parameters, q, qd, qdd);
  for (int j = 0; j < 2; ++j) {
    Y(j, kBase + j) = qd[j];
    Y(j, kBase + 2 + j) = qd[j] > 0 ? 1 : -1;
  }
  return Y;
}

int main() {
  const std::vector<Sample> log = read_log();
  const arm::Parameters<> parameters;  // lengths are known; the payload of the document is 0

  // Least squares, by the normal equations; velocities and accelerations are differences of positions.
  Eigen::Matrix<double, kUnknowns, kUnknowns> A = Eigen::Matrix<double, kUnknowns, kUnknowns>::Zero();
  Unknowns b = Unknowns::Zero();
  std::vector<Rows> all;
  for (std::size_t k = 1; k + 1 < log.size(); ++k) {
    const double h = log[k + 1].t - log[k].t;
    const JointState before = log[k - 1].q, now = log[k].q, after = log[k + 1].q;
    all.push_back(rows(parameters, now, (after - before) / (2 * h), (after - 2 * now + before) / (h * h)));
    A += all.back().transpose() * all.back();
    b += all.back().transpose() * log[k].tau;
  }
  const Unknowns x = A.ldlt().solve(b);
  double error = 0;
  for (std::size_t k = 0; k < all.size(); ++k) error += (all[k] * x - log[k + 1].tau).squaredNorm();

  const Eigen::Matrix<double, kBase, 1> document =
      arm::base_parameters(parameters, arm::inertial_parameters(parameters));
  std::printf("%-32s %10s %10s\n", "base parameter", "document", "identified");
  for (int i = 0; i < kBase; ++i)
    std::printf("%-32s %10.3f %10.3f\n", arm::base_regressor_columns[i], document[i], x[i]);
  std::printf("damping [N m s/rad]  %.2f %.2f\nfriction [N m]       %.2f %.2f\n", x[6], x[7], x[8], x[9]);
  std::printf("torques differ by    %.2f N m (RMS)\n", std::sqrt(error / (2.0 * static_cast<double>(all.size()))));
  std::printf("payload              %.2f kg\n", (x[3] - document[3]) / arm::ParameterValues().forearm_length);
}
