// A cart-pole and the PUMA 560 swing up, with pictures; a quadruped is pushed and keeps standing.
//
//   optimal_control CART_POLE.svg PUMA.svg
#include <chrono>
#include <cstdio>
#include <fstream>

#include "picture.h"
#include "stand.h"

namespace {

using namespace optimal_control;

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

template <class Motion>
bool report(const char* name, const Motion& motion, double time, const char* file_name) {
  const auto& t = motion.trajectory;
  std::printf(
      "%-10s %zu steps of %g ms, %zu iterations in %.0f ms (%s): cost from %.3g to %.4g\n", name, t.u.size(),
      1000 * motion.time_step, t.costs.size() - 1, 1000 * time, t.is_converged ? "converged" : "not converged",
      t.costs.front(), t.costs.back());
  std::ofstream file(file_name);
  file << picture(motion);
  file.close();
  if (!file) std::fprintf(stderr, "optimal_control: cannot write %s\n", file_name);
  return static_cast<bool>(file);
}

void report_standing() {
  const Standing s = standing(0.6);
  const Matrix12 K = regulator(s);
  const std::vector<Instant> instants =
      push(s, K, (Eigen::Matrix<double, 6, 1>() << 0, 0, 0, 0.1, 0.1, 0).finished(), 2);
  double least = HUGE_VAL, friction = 0;
  for (const Instant& i : instants) {
    least = std::min(least, i.least_force);
    friction = std::max(friction, i.most_friction);
  }
  std::printf(
      "quadruped  largest eigenvalue of the regulated state %.4f (at %g Hz); pushed at 0.14 m/s it stands within\n"
      "           %.1e m after 2 s; on the way a foot carries at least %.0f N and needs a friction of %.2f\n",
      closed_loop_moduli(s, K).maxCoeff(), 1 / kControlStep, instants.back().state.segment<3>(3).norm(), least,
      friction);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s CART_POLE.svg PUMA.svg\n", argv[0]);
    return 2;
  }
  const double start = seconds();
  const CartPoleMotion cart_pole = swing_up_cart_pole();
  const double between = seconds();
  const PumaMotion puma = swing_up_puma();
  const double end = seconds();
  const bool is_written =
      report("cart-pole", cart_pole, between - start, argv[1]) && report("PUMA 560", puma, end - between, argv[2]);
  report_standing();
  std::printf("\nPictures: %s, %s\n\n", argv[1], argv[2]);
  return is_written ? 0 : 2;
}
