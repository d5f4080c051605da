// Computes transforms with known values in both precisions; exits with 1 if one is wrong.
#include <gimbal_left/gimbal_left.h>
#include <harbour/crane/crane.h>

#include <cmath>
#include <cstdio>

namespace {

// A few roundings of lengths of about ten metres, in double and in single precision.
constexpr double kTolerance = 1e-13, kSingleTolerance = 1e-4;

int failures = 0;

template <class Actual, class Expected>
void expect_near(const char* what, const Actual& actual, const Expected& expected, double tolerance) {
  const double error = (actual - expected).cwiseAbs().maxCoeff();
  if (error <= tolerance) return;
  std::printf("%s: off by %g\n", what, error);
  ++failures;
}

}  // namespace

int main() {
  namespace crane = harbour::crane;
  namespace homogeneous = crane::transforms::homogeneous;
  crane::Parameters parameters;
  if (parameters.height != 30.0 || !std::isnan(parameters.jib)) ++failures;
  parameters.jib = 20.0;
  parameters.rope = 5.0;

  // Luffing turns the hook's frame back, so that the rope hangs down: ground_X_hook is a turn and a translation.
  const double slew = 0.7, luff = 0.4;
  const Eigen::Matrix4d hook = homogeneous::ground_X_tower(parameters, slew) *
                               homogeneous::tower_X_tip(parameters, luff) * homogeneous::hook_on_rope(parameters, luff);
  const double reach = 20.0 * std::cos(luff);
  const Eigen::Vector3d place(reach * std::cos(slew), reach * std::sin(slew), 30.0 + 20.0 * std::sin(luff) - 5.0);
  expect_near("hook", hook.topRightCorner<3, 1>(), place, kTolerance);
  expect_near(
      "back", homogeneous::tip_X_tower(parameters, luff) * homogeneous::tower_X_tip(parameters, luff),
      Eigen::Matrix4d::Identity(), kTolerance);

  // Power is the same in all coordinates, so force' * motion = 1.
  namespace transforms = crane::transforms;
  const Eigen::Matrix<double, 6, 6> power =
      transforms::force::tower_X_tip(parameters, luff).transpose() * transforms::motion::tower_X_tip(parameters, luff);
  expect_near("power", power, Eigen::Matrix<double, 6, 6>::Identity(), kTolerance * 400);

  crane::f32::Parameters single;
  single.jib = 20.0f;
  const Eigen::Matrix4f tip = crane::f32::transforms::homogeneous::tower_X_tip(single, static_cast<float>(luff));
  expect_near("single", tip.cast<double>(), homogeneous::tower_X_tip(parameters, luff), kSingleTolerance);

  // mount_X_inner = (inner_X_outer outer_X_mount)^-1 for a mount that is not turned: the roll of PI/2 lays the ring
  // flat.
  const Eigen::Matrix4d gimbal = gimbal_left::transforms::homogeneous::mount_X_inner(0.0, 0.0);
  Eigen::Matrix4d flat;
  flat << 1, 0, 0, 0.1, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1;
  expect_near("gimbal", gimbal, flat, kTolerance);
  return failures == 0 ? 0 : 1;
}
