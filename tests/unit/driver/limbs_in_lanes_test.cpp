// Congruent limbs share lanes even if their numbers differ, and the search for link frames makes no function slower.
#include "driver/limbs_in_lanes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "documents.h"
#include "driver/driver.h"
#include "model/unlike_limbs.h"
#include "symbolic/cost.h"
#include "symbolic/interpret.h"

#if READS_URDF

namespace robcogen::driver::limbs_in_lanes_test {
namespace {

using namespace test;

// ---------------------------------------------------------------------------------------------------------------------
// A humanoid as a CAD program writes it: its left and right limbs are mirror images up to the 6th digit.

class NoisyHumanoid {
 public:
  std::string text() {
    link("torso", 12.0, {0.01, 0.002, 0.2});
    for (const bool left : {true, false}) {
      is_left_ = left;
      const std::string side = left ? "left_" : "right_";
      const double y = left ? 1.0 : -1.0;
      // A right angle of one side has 16 digits; the same angle of the other side is written with other turns.
      joint(side + "hip_yaw", "torso", {-0.02, 0.1 * y, -0.1}, {0, 0, 0}, "0 0 1", 1.5, {0.01, 0.003 * y, -0.05});
      joint(side + "hip_roll", side + "hip_yaw", {0.05, 0, -0.04}, {0, 1.5707963, 0}, "0 0 1", 1.25, {0.02, 0, 0.04});
      joint(
          side + "hip_pitch", side + "hip_roll", {0, 0, 0.0325}, {1.57079 * y, 0, 0.3 * y}, left ? "0 0 1" : "0 0 -1",
          4, {0.004, 0.02 * y, -0.16});
      joint(
          side + "knee", side + "hip_pitch", {0, 0.01 * y, -0.4}, {0, 0, 0}, "0 1 0", 2.75, {0.006, 0.001 * y, -0.17});
      joint(
          side + "ankle", side + "knee", {0.003, 0, -0.4}, {0, 0, left ? 0.0 : 3.14159265}, "0 1 0", 0.9,
          {left ? 0.04 : -0.04, 0, -0.03});
      if (left) {
        joint(
            side + "shoulder", "torso", {0.005, 0.15, 0.4}, {0.43, 0, 1.5707963267948966}, "0 1 0", 1.1,
            {0, 0.05, 0.01});
      } else {
        joint(
            side + "shoulder", "torso", {0.005, -0.15, 0.4}, {-0.43, 0, 1.5707963267948966}, "0 1 0", 1.1,
            {0, -0.05, 0.01});
      }
      joint(
          side + "upper_arm", side + "shoulder", {-0.005, 0.04 * y, -0.05}, {0, 0, 0}, "1 0 0", 0.75,
          {0.01, 0.004 * y, -0.06});
      joint(side + "elbow", side + "upper_arm", {0.02, 0, -0.2}, {0, 0, 0}, "0 0 1", 1.2, {0.03, 0.001 * y, -0.1});
      // One hand holds a camera.
      joint(
          side + "hand", side + "elbow", {0.02, 0, -0.18}, {0, 0, 0}, "0 1 0", left ? 0.4 : 0.55,
          {0.08, left ? 0 : 0.01, 0});
    }
    return "<robot name='noisy'>\n" + text_ + "</robot>\n";
  }

 private:
  std::string text_;
  bool is_left_ = true;
  unsigned state_ = 1;

  // The number on the left; on the right, with a change of the 6th digit.
  double noisy(double value) {
    if (is_left_ || value == 0) return value;
    state_ = state_ * 1664525U + 1013904223U;
    return value * (1 + 1e-6 * (static_cast<double>(state_ >> 8) / (1 << 23) - 1.0));
  }
  std::string noisy(const std::array<double, 3>& v) {
    const double x = noisy(v[0]), y = noisy(v[1]), z = noisy(v[2]);
    return fmt::format("{} {} {}", x, y, z);
  }

  void link(const std::string& name, double mass, const std::array<double, 3>& com) {
    const double y = is_left_ ? 1 : -1, size = 0.01 * mass;
    const double ixx = noisy(size), iyy = noisy(1.2 * size), izz = noisy(0.6 * size);
    const double ixy = noisy(0.02 * size * y), ixz = noisy(-0.05 * size), iyz = noisy(0.03 * size * y);
    text_ += fmt::format(
        "<link name='{}'><inertial><origin xyz='{}'/><mass value='{}'/><inertia ixx='{}' iyy='{}' izz='{}' ixy='{}' "
        "ixz='{}' iyz='{}'/></inertial></link>\n",
        name, noisy(com), noisy(mass), ixx, iyy, izz, ixy, ixz, iyz);
  }

  void joint(
      const std::string& name,
      const std::string& parent,
      const std::array<double, 3>& xyz,
      const std::array<double, 3>& rpy,
      const char* axis,
      double mass,
      const std::array<double, 3>& com) {
    text_ += fmt::format(
        "<joint name='{0}_joint' type='revolute'><parent link='{1}'/><child link='{0}'/><origin xyz='{2}' rpy='{3} {4} "
        "{5}'/><axis xyz='{6}'/><limit lower='-1' upper='1' effort='9' velocity='9'/></joint>\n",
        name, parent, noisy(xyz), rpy[0], rpy[1], rpy[2], axis);
    link(name, mass, com);
  }
};

std::optional<Model> model_of(const fs::path& file, bool floating_base) {
  LoadOptions options;
  options.urdf.floating_base = floating_base;
  options.urdf.allow_implausible = true;
  options.prints_canonical = false;
  Diagnostics diagnostics;
  return load(file, options, diagnostics);
}

const std::vector<std::string> kGroups = {"inverse_dynamics", "forward_dynamics", "joint_space_inertia"};

Functions with_lanes(const Model& model, int effort) {
  std::vector<std::string> groups = kGroups;
  if (!algorithm::is_available(model.robot()->tree, "forward_dynamics")) std::erase(groups, "forward_dynamics");
  return programs(model, groups, {all_steps(), effort}, {.has_lanes = true});
}

const symbolic::Program& printed(const Function& function) {
  return function.in_lanes ? *function.in_lanes : function.program;
}

TEST(LimbsInLanes, OfOneShapeShareThemWhateverTheirNumbers) {
  const Folder folder;
  for (const bool floating : {false, true}) {
    const std::optional<Model> model = model_of(folder.file("noisy.urdf", NoisyHumanoid().text()), floating);
    ASSERT_TRUE(model);
    for (const int effort : {0, 1}) {
      for (const Function& f : with_lanes(*model, effort).list) {
        SCOPED_TRACE(fmt::format("{}, effort {}", f.kernel, effort));
        const std::vector<std::string> both = {
            "left_hip_yaw_joint, right_hip_yaw_joint", "left_shoulder_joint, right_shoulder_joint"};
        EXPECT_EQ(f.limbs_in_lanes, both) << f.without_lanes;
        EXPECT_EQ(f.without_lanes, "");
        const symbolic::Cost scalar = symbolic::cost(f.program), packed = symbolic::cost(printed(f));
        EXPECT_LT(packed.instructions, 0.75 * scalar.instructions);
        EXPECT_TRUE(f.results->are_kept_by(printed(f)));
      }
    }
  }
}

// The half cycles in which the instructions of the first overloads start, by function.
std::map<std::string, int> times(const Model& model, int effort) {
  std::map<std::string, int> result;
  for (const Function& f : with_lanes(model, effort).list)
    result.emplace(f.name, weighted(symbolic::cost(printed(f)), symbolic::kStarts));
  return result;
}

void expect_no_loss(const Model& model, const std::vector<int>& efforts) {
  std::map<std::string, int> before = times(model, 0);
  for (const int effort : efforts) {
    for (const auto& [name, time] : times(model, effort)) {
      EXPECT_LE(time, before.at(name)) << model.name() << ", " << name << ", effort " << effort;
      before.at(name) = time;
    }
  }
}

TEST(LimbsInLanes, AreNoSlowerWithMoreEffort) {
  const Folder folder;
  const fs::path file = folder.file("noisy.urdf", NoisyHumanoid().text());
  expect_no_loss(model_of(file, true).value(), {1, 4});
}

// Public descriptions, if they are there: a quadruped and a humanoid, or all.
TEST(LimbsInLanes, OfPublicRobotsAreNoSlowerWithMoreEffort) {
  std::vector<fs::path> files;
  for (const char* folder : {ROBCOGEN_URDFS_DIR, ROBCOGEN_MODELS_DIR})
    if (fs::is_directory(folder))
      for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".urdf") files.push_back(entry.path());
  if (files.empty()) GTEST_SKIP() << "no documents in " << ROBCOGEN_URDFS_DIR;
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    const std::string name = file.stem().string();
    const auto ends_with = [&](const std::string& end) { return name.size() >= end.size() && name.ends_with(end); };
    if (!ROBCOGEN_TEST_EVERYTHING && !ends_with("_go2") && !ends_with("_h1")) continue;
    for (const bool floating : {false, true})
      if (const std::optional<Model> model = model_of(file, floating))
        expect_no_loss(*model, ROBCOGEN_TEST_EVERYTHING ? std::vector<int>{1, 2, 8} : std::vector<int>{1, 2});
  }
}

// ---------------------------------------------------------------------------------------------------------------------
// Reasons

TEST(LimbsInLanes, HaveAReasonIfTheyAreUnlike) {
  std::string text = NoisyHumanoid().text();
  const std::string joint = "<joint name='right_elbow_joint' type='revolute'>";
  text.replace(text.find(joint), joint.size(), "<joint name='right_elbow_joint' type='prismatic'>");
  const Folder folder;
  const std::optional<Model> model = model_of(folder.file("noisy.urdf", text), false);
  ASSERT_TRUE(model);
  const std::vector<model::UnlikeLimbs> unlike = model::unlike_limbs(model->robot()->tree);
  ASSERT_EQ(unlike.size(), 1U);
  EXPECT_EQ(unlike[0].first, "left_shoulder_joint");
  EXPECT_EQ(unlike[0].second, "right_shoulder_joint");
  EXPECT_EQ(unlike[0].reason, "left_elbow_joint is revolute, right_elbow_joint is prismatic");
}

}  // namespace
}  // namespace robcogen::driver::limbs_in_lanes_test

#endif
