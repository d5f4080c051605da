// Power of trotting quadrupeds, the best lengths of legs and motors, and a picture.
//
//   trot_power FILE.svg
#include "picture.h"
#include "report.h"

namespace {

using namespace design;

// Searches with and without gradients lead to the same optimum; gradients are generated derivatives.
void compare(const std::string& name, const Problem& problem) {
  print(name + ", with gradients", minimise(problem, Method::slsqp));
  print(name + ", without", minimise(problem, Method::cobyla));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FILE.svg\n", argv[0]);
    return 2;
  }
  const double before = seconds();
  std::vector<TrotCurve> curves;
  for (const double speed : kSpeeds) curves.push_back({speed, trot_curve(speed)});
  const double time = seconds() - before;

  std::printf("Trot: power of hip and knee of a leg [W]; upper and lower leg %g m together\n\n", kTotalLength);
  std::printf("%-14s", "upper/lower");
  for (const Sample& sample : curves[0].samples) std::printf(" %5.1f", sample.x);
  std::printf("\n");
  for (const TrotCurve& c : curves) {
    std::printf("%.1f m/s       ", c.speed);
    for (const Sample& sample : c.samples) std::printf(" %5.1f", sample.value);
    std::printf("\n");
  }
  const std::size_t designs = curves.size() * curves[0].samples.size();
  std::printf(
      "\n%zu designs in %.0f ms, %.2f ms each; of that, %.0f ns in the update of parameters\n", designs, 1000 * time,
      1000 * time / static_cast<double>(designs), update_time());
  const double start = seconds();
  constexpr int kTimes = 20;
  for (int i = 0; i < kTimes; ++i) mechanical_power(with_lengths(0.35, 0.32 + 1e-3 * i), Trot{kSpeeds[1]});
  std::printf("with the gradient %.2f ms each\n\n", 1000 * (seconds() - start) / kTimes);

  if (can_minimise()) {
    print_head("least mechanical power, two lengths", "W");
    for (const double speed : kSpeeds) compare(std::to_string(speed).substr(0, 3) + " m/s", trot_of_lengths(speed));
    std::printf("\n");
    print_head("least electric power, lengths and motors", "W");
    for (const double speed : kSpeeds)
      compare(std::to_string(speed).substr(0, 3) + " m/s", trot_of_lengths_and_motors(speed));
  } else {
    print_absence();
  }
  return write(argv[0], argv[1], trot_picture(curves));
}
