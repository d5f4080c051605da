// Coordinate transforms without a robot: one attitude in two sequences of Euler angles.
#include <euler/euler.h>

#include <cmath>
#include <cstdio>

int main() {
  // An aircraft: yaw, pitch and roll about z, y', x''.
  const double yaw = 0.5, pitch = -0.2, roll = 0.1;
  const Eigen::Matrix4d attitude = euler::transforms::homogeneous::S_X_zyx(yaw, pitch, roll);

  // The same attitude by precession, nutation and spin about z, x', z'', from the last column and the last row.
  const double nutation = std::acos(attitude(2, 2));
  const double precession = std::atan2(attitude(0, 2), -attitude(1, 2));
  const double spin = std::atan2(attitude(2, 0), attitude(2, 1));
  const Eigen::Matrix4d again = euler::transforms::homogeneous::S_X_zxz(precession, nutation, spin);

  std::printf("yaw %.3f, pitch %.3f, roll %.3f rad are\n", yaw, pitch, roll);
  std::printf("precession %.3f, nutation %.3f, spin %.3f rad: S_X_body =\n", precession, nutation, spin);
  for (int row = 0; row < 3; ++row)
    std::printf("  %7.4f %7.4f %7.4f\n", attitude(row, 0), attitude(row, 1), attitude(row, 2));
  const double difference = (attitude - again).cwiseAbs().maxCoeff();
  std::printf("largest difference of the two matrices: %.0e\n", difference);

  // The rate of the body axes in coordinates of S: spatial motion vectors, angular first.
  Eigen::Matrix<double, 6, 1> twist = Eigen::Matrix<double, 6, 1>::Zero();
  twist(2) = 1.0;  // one rad/s about the body's z axis
  const Eigen::Matrix<double, 6, 1> rate = euler::transforms::motion::S_X_zyx(yaw, pitch, roll) * twist;
  std::printf("one rad/s about z of the body: (%.4f, %.4f, %.4f) rad/s in S\n", rate(0), rate(1), rate(2));
  return difference < 1e-12 ? 0 : 1;
}
