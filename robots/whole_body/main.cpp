// A quadruped and a humanoid under whole-body control: simulates motions, prints results, and writes pictures.
//
//   whole_body FOLDER
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>

#include "picture.h"

namespace {

using namespace whole_body;

bool report(const Motion& motion, const std::string& file_name) {
  const Instant& last = motion.instants.back();
  double farthest = 0;
  for (const Instant& i : motion.instants) farthest = std::max(farthest, (i.com - i.goal).norm());
  std::vector<double> times = motion.times;
  std::sort(times.begin(), times.end());
  std::printf(
      "%s%s\n"
      "  centre of mass up to %.0f mm from its goal, at the end %.1f mm and %.1f mm/s; feet slip by %.2f mm\n"
      "  friction up to %.2f of %.2f, torques up to %.0f N m; a step of the controller takes %.0f us, 99 %% less than "
      "%.0f us\n",
      motion.title.c_str(), motion.has_fallen ? ", and falls" : "", 1e3 * farthest, 1e3 * (last.com - last.goal).norm(),
      1e3 * motion.last_speed, 1e3 * motion.greatest_slip, motion.greatest_friction, kFriction, motion.greatest_torque,
      1e6 * times[times.size() / 2], 1e6 * times[times.size() * 99 / 100]);
  std::ofstream file(file_name);
  file << picture(motion);
  file.close();
  if (!file) std::fprintf(stderr, "whole_body: cannot write %s\n", file_name.c_str());
  return static_cast<bool>(file);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
    return 2;
  }
  const std::string folder = argv[1];
  bool is_written = report(quadruped_stands({0, 400, 0}), folder + "/quadruped_stands.svg");
  is_written = report(quadruped_trots({0, 300, 0}), folder + "/quadruped_trots.svg") && is_written;
  is_written = report(quadruped_squats(0.15), folder + "/quadruped_squats.svg") && is_written;
  is_written = report(humanoid_stands({120, 0, 0}), folder + "/humanoid_stands.svg") && is_written;
  is_written = report(humanoid_squats(0.2), folder + "/humanoid_squats.svg") && is_written;
  std::printf("\nThe loop has %.0f us. Pictures: %s\n", 1e6 * kControlStep, folder.c_str());
  return is_written ? 0 : 2;
}
