// Lines of kernels are named after what they compute, and seldom numbered.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "patterns.h"

namespace robcogen::test {
namespace {

// True for a name that is numbered within its section, numbered because another line has that name, or of lanes with
// nothing in common.
bool is_numbered(const std::string& name) {
  return whole_match(name, "(.*_t[0-9]+)|(.*_[0-9]+)|(lanes.*)|(t[0-9]+)").has_value();
}

struct Lines {
  int all = 0;
  int numbered = 0;
};

void count(const std::filesystem::path& file, Lines& lines) {
  const std::string definition = R"( *const (?:Scalar|Lanes[0-9]+) ([A-Za-z0-9_]+) =.*)";
  std::ifstream stream(file);
  ASSERT_TRUE(stream) << file;
  for (std::string line; std::getline(stream, line);) {
    const auto match = whole_match(line, definition);
    if (!match) continue;
    ++lines.all;
    lines.numbered += is_numbered((*match)[1]);
  }
}

TEST(NamedQuantities, TestTellsNumbersFromNames) {
  for (const char* name : {"hip_t3", "trunk_t7_2", "hip_nz_to_az_2", "lanes", "lanes_wx", "t1"})
    EXPECT_TRUE(is_numbered(name)) << name;
  for (const char* name : {"hip_wx2", "L_J2_J1", "hip_nz_to_az", "s2_KFE", "c_2KFE", "hip_Uxx_neg"})
    EXPECT_FALSE(is_numbered(name)) << name;
}

TEST(NamedQuantities, AreMostOfTheDynamics) {
  for (const std::string robot : {"hyl", "puma560", "quadruped"}) {
    Lines lines;
    for (const std::string group :
         {"inverse_dynamics", "bias_forces", "forward_dynamics", "joint_space_inertia", "joint_space_inertia_factor",
          "coriolis_matrix", "centroidal", "energy"})
      count(std::filesystem::path(ROBOTS_DIR) / robot / "kernel" / (group + ".h"), lines);
    EXPECT_GT(lines.all, 200) << robot;
    EXPECT_LE(lines.numbered * 100, lines.all * 15) << robot << ": " << lines.numbered << " of " << lines.all;
  }
}

}  // namespace
}  // namespace robcogen::test
