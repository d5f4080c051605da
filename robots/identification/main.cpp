// Identifies the PUMA 560, prints how well torques of another motion are predicted, and draws them.
//
//   puma560_identify FILE.svg
#include <cstdio>
#include <fstream>
#include <string>

#include "picture.h"

namespace {

using namespace identification;

// The unknowns for given inertial parameters, with the identified friction.
Unknowns with_friction(const InertialParameters& pi, const Unknowns& identified) {
  Unknowns result = identified;
  result.head<kBaseParameters>() = puma::base_parameters(pi);
  return result;
}

void print(const char* name, const JointState& values) {
  std::printf("%-34s", name);
  for (int j = 0; j < kJoints; ++j) std::printf(" %8.3f", values[j]);
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FILE.svg\n", argv[0]);
    return 2;
  }
  const Motion motion = exciting_motion(50, 1);
  const std::vector<Instant> instants = measure(motion, 2), others = measure(exciting_motion(1, 3), 4);
  const InertialParameters guess = guessed_parameters(5), bodies = consistent_parameters(instants, guess);
  const Unknowns identified = least_squares(instants);
  const Unknowns of_guess = with_friction(guess, identified), of_bodies = with_friction(bodies, identified);
  std::printf(
      "%d base parameters and %d of friction from %zu instants; condition number %.1f\n\n", kBaseParameters,
      2 * kJoints, instants.size(), condition_number(motion));
  std::printf("%-34s", "torques of another motion [N m]");
  for (int j = 0; j < kJoints; ++j) std::printf(" %8s", ("J" + std::to_string(j + 1)).c_str());
  std::printf("\n");
  print("noise of the measurements", noise());
  print("error (RMS), guess", prediction_error(others, of_guess));
  print("error, least squares", prediction_error(others, identified));
  print("error, links as real bodies", prediction_error(others, of_bodies));
  std::printf("\n%-40s %12s %12s\n", "base parameters", "identified", "document");
  const auto known = puma::base_parameters(actual_parameters());
  for (int k = 0; k < kBaseParameters; ++k)
    std::printf(
        "%-40.40s %12.4f %12.4f\n", puma::base_regressor_columns[static_cast<std::size_t>(k)], identified[k], known[k]);

  std::ofstream file(argv[1]);
  file << picture(others, of_guess, of_bodies);
  file.close();
  if (!file) {
    std::fprintf(stderr, "%s: cannot write %s\n", argv[0], argv[1]);
    return 2;
  }
  std::printf("\nPicture: %s\n\n", argv[1]);
}
