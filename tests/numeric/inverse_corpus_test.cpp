// Inverse kinematics in closed form of published robots.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "driver/load.h"
#include "inverted.h"
#include "model/named_frame.h"

namespace robcogen::numeric {
namespace {

namespace fs = std::filesystem;

struct Limb {
  std::string file, base, tip, task;  // `point`, or a given joint
  int branches = 8;
};

// Each with a class of its own.
const std::vector<Limb>& limbs() {
  static const std::vector<Limb> all = {
      {"ur5_robot.urdf", "base_link", "wrist_3_link", ""},
      {"iiwa14.urdf", "fr_iiwa_link_0", "fr_iiwa_link_7", "iiwa_joint_3"},
      {"panda.urdf", "panda_link0", "panda_link8", "panda_joint7"},
      {"hyq_no_sensors.urdf", "trunk", "lf_foot", "point", 4},
      {"talos_reduced.urdf", "base_link", "leg_left_6_link", ""},
      {"talos_reduced.urdf", "torso_2_link", "arm_left_7_link", "arm_left_1_joint"},
  };
  return all;
}

TEST(InverseCorpus, LimbsHaveTheirBranches) {
  int count = 0;
  for (const Limb& limb : limbs()) {
    const fs::path file = fs::path(ROBCOGEN_MODELS_DIR) / limb.file;
    if (!fs::exists(file)) continue;
    SCOPED_TRACE(limb.file + " " + limb.tip);
    ++count;
    Diagnostics diagnostics;
    driver::LoadOptions options;
    options.urdf.snap_angles = true;
    const auto model = driver::load(file, options, diagnostics);
    ASSERT_TRUE(model) << diagnostics.render();
    const KinematicTree& tree = model->robot()->tree;
    const auto frame = [&](const std::string& name) {
      const auto found = tree.find_frame(name);
      return found ? *found : tree.find_frame(model::implicit_frame_name(name)).value();
    };
    InverseTask task;
    if (limb.task == "point")
      task.kind = InverseTask::Kind::point;
    else if (!limb.task.empty())
      task.given = tree.find_joint(limb.task).value();
    const Inverted inverted(tree, {frame(limb.base), frame(limb.tip)}, task);
    ASSERT_EQ(inverted.size().branches, limb.branches);
    Dice dice(3);
    for (int i = 0; i < 100; ++i) {
      const Values q = random_positions(inverted, dice, false);
      const Matrix<double> target = inverted.pose(q);
      double nearest = 10.0;
      for (const Inverted::Branch& branch : inverted.branches(target, q)) {
        if (branch.misfit > 1e-9) continue;
        EXPECT_LT(inverted.error(branch.q, target), 1e-10);
        nearest = std::min(nearest, inverted.distance(branch.q, q));
      }
      EXPECT_LT(nearest, 1e-6);
    }
  }
  if (count == 0) GTEST_SKIP() << "no URDFs in " << ROBCOGEN_MODELS_DIR;
}

}  // namespace
}  // namespace robcogen::numeric
