// In place of a real arm: writes a log of a motion as a robot would, time, positions and noisy torques at 200 Hz. This
// arm carries something, and has friction.
#include <arm/arm.h>

#include <cmath>
#include <cstdio>
#include <random>

int main() {
  arm::ParameterValues values;
  values.payload = 0.75;  // kg
  arm::Parameters<> parameters;
  parameters.update(values);
  const arm::JointState damping(0.4, 0.2), friction(0.8, 0.5);  // N m s/rad, N m
  std::mt19937 engine(1);
  const auto noise = [&engine] {  // about normal, with a standard deviation of 0.2 N m; the same on every machine
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += static_cast<double>(engine()) * 0x1p-32;
    return 0.2 * sum;
  };

  std::puts("t,shoulder_q,elbow_q,shoulder_tau,elbow_tau");
  for (int k = 0; k <= 2000; ++k) {
    const double t = k / 200.0;
    arm::JointState q(0, 0.5), qd(0, 0), qdd(0, 0);
    for (int harmonic = 1; harmonic <= 4; ++harmonic) {
      const double w = 2 * M_PI * 0.2 * harmonic;  // rad/s
      const arm::JointState phase(w * t + harmonic * harmonic, w * t + 2 * harmonic);
      q += arm::JointState(0.3 * phase.array().sin());
      qd += arm::JointState(0.3 * w * phase.array().cos());
      qdd -= arm::JointState(0.3 * w * w * phase.array().sin());
    }
    const arm::JointState tau = arm::inverse_dynamics(parameters, q, qd, qdd) + damping.cwiseProduct(qd) +
                                friction.cwiseProduct(qd.cwiseSign());
    std::printf("%.3f,%.7f,%.7f,%.3f,%.3f\n", t, q[0], q[1], tau[0] + noise(), tau[1] + noise());
  }
}
