// Squat jumps of many quadrupeds, the best lengths of legs, and a picture.
//
//   squat_jump FILE.svg
#include <limits>

#include "picture.h"
#include "report.h"

int main(int argc, char** argv) {
  using namespace design;
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FILE.svg\n", argv[0]);
    return 2;
  }
  const double none = std::numeric_limits<double>::infinity();
  const double before = seconds();
  std::vector<JumpCurve> curves;
  for (const double start : kStarts)
    for (const double limit : {kTorqueLimit, 200.0, none}) curves.push_back({start, limit, jump_curve(start, limit)});
  const double time = seconds() - before;

  std::printf("Squat jump: rise of the trunk by the length of the lower leg; upper leg %g m\n\n", kUpperLength);
  std::printf("%-26s", "lower leg [m]");
  for (const Sample& sample : curves[0].samples) std::printf(" %4.2f", sample.x);
  std::printf("\n");
  for (const JumpCurve& c : curves) {
    std::printf("from %.2f m, limit %5g N m", c.start, c.torque_limit);
    for (const Sample& sample : c.samples) std::printf(" %4.2f", sample.value);
    std::printf("\n");
  }
  const std::size_t jumps = curves.size() * curves[0].samples.size();
  std::printf(
      "\n%zu designs in %.2f s, %.1f ms each; of that, %.0f ns in the update of parameters\n\n", jumps, time,
      1000 * time / static_cast<double>(jumps), update_time());

  for (const double start : kStarts) {
    const Optimum best = best_jump(start, kTorqueLimit);
    std::printf(
        "best from %.2f m with %g N m: lower leg of %.3f m, %.3f (golden section, %d jumps)\n", start, kTorqueLimit,
        best.x[0], -best.value, best.evaluations);
  }
  std::printf("\n");
  if (can_minimise()) {
    print_head("highest jump from 0.50 m (COBYLA)", "rise m");
    print("two lengths, 150 N m", minimise(jump_of_lengths(), Method::cobyla), -1);
    print("lengths and motors", minimise(jump_of_lengths_and_motors(), Method::cobyla), -1);
  } else {
    print_absence();
  }
  std::vector<JumpCurve> drawn;
  for (const JumpCurve& c : curves)
    if (c.torque_limit == kTorqueLimit || c.torque_limit == none) drawn.push_back(c);
  return write(argv[0], argv[1], jump_picture(drawn));
}
