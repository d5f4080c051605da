// Inverse kinematics in closed form of published robots.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "driver/load.h"
#include "inverted.h"
#include "model/named_frame.h"

namespace robcogen::numeric::inverse_corpus_test {
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

std::optional<KinematicTree> tree_of_urdf(const fs::path& file) {
  Diagnostics diagnostics;
  driver::LoadOptions options;
  options.urdf.snap_angles = true;
  const auto model = driver::load(file, options, diagnostics);
  return model ? std::optional(model->robot()->tree) : std::nullopt;
}

TEST(InverseCorpus, LimbsHaveTheirBranches) {
  int count = 0;
  for (const Limb& limb : limbs()) {
    const fs::path file = fs::path(ROBCOGEN_MODELS_DIR) / limb.file;
    if (!fs::exists(file)) continue;
    SCOPED_TRACE(limb.file + " " + limb.tip);
    ++count;
    const std::optional<KinematicTree> loaded = tree_of_urdf(file);
    ASSERT_TRUE(loaded);
    const KinematicTree& tree = *loaded;
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
        const double error = inverted.error(branch.q, target);
        EXPECT_LT(error, branch.misfit + 1e-13);
        if (branch.misfit > 1e-9) continue;
        EXPECT_LT(error, 1e-10);
        nearest = std::min(nearest, inverted.distance(branch.q, q));
      }
      EXPECT_LT(nearest, 1e-6);
    }
  }
  if (count == 0) GTEST_SKIP() << "no URDFs in " << ROBCOGEN_MODELS_DIR;
}

// ---- How many limbs have a closed form.

// Chains of joints from one link with several children, or the root, to the next, or to a leaf.
std::vector<model::FramePair> limbs_of(const KinematicTree& tree) {
  std::vector<std::vector<int>> children(tree.links.size());
  for (const model::Joint& joint : tree.joints) children[static_cast<std::size_t>(joint.parent)].push_back(joint.child);
  const auto frame = [&](int link) {
    const std::string& name = tree.links[static_cast<std::size_t>(link)].name;
    return model::Frame{model::Frame::Kind::link, link, model::implicit_frame_name(name)};
  };
  std::vector<model::FramePair> limbs;
  for (std::size_t link = 0; link < children.size(); ++link) {
    if (link > 0 && children[link].size() == 1) continue;
    for (int end : children[link]) {
      while (children[static_cast<std::size_t>(end)].size() == 1) end = children[static_cast<std::size_t>(end)].front();
      limbs.push_back({frame(static_cast<int>(link)), frame(end)});
    }
  }
  return limbs;
}

bool has_closed_form(const KinematicTree& tree, const model::FramePair& limb, int joints) {
  const auto has = [&](const InverseTask& task) {
    return algorithm::report_inverse_kinematics(tree, limb, task).has_closed_form;
  };
  if (has({})) return true;
  if (joints == 3) return has({InverseTask::Kind::point});
  if (joints != 7) return false;
  for (int joint = 0; joint < static_cast<int>(tree.joints.size()); ++joint)
    if (has({InverseTask::Kind::pose, joint})) return true;
  return has({InverseTask::Kind::pose, -1, true});
}

// `3: 4 of 4, 6: 1 of 2`: of limbs with three joints four have a closed form, and so on, up to seven joints.
std::string census(const KinematicTree& tree) {
  std::map<int, std::pair<int, int>> counts;  // by number of joints: closed forms, limbs
  for (const model::FramePair& limb : limbs_of(tree)) {
    const auto joints = static_cast<int>(algorithm::chain_coordinates(tree, limb).size());
    if (joints < 3 || joints > 7) continue;
    counts[joints].first += has_closed_form(tree, limb, joints);
    ++counts[joints].second;
  }
  std::string text;
  for (const auto& [joints, count] : counts)
    text += (text.empty() ? "" : ", ") + std::to_string(joints) + ": " + std::to_string(count.first) + " of " +
            std::to_string(count.second);
  return text;
}

// The table has a line for each file: its name, then the census.
TEST(InverseCorpus, LimbsWithClosedForms) {
  std::ifstream table(TEST_SOURCE_DIR "/closed_forms.txt");
  int count = 0;
  for (std::string line; std::getline(table, line);) {
    const std::size_t space = line.find(' ');
    const std::string name = line.substr(0, space);
    for (const char* folder : {ROBCOGEN_MODELS_DIR, ROBCOGEN_URDFS_DIR}) {
      const fs::path file = fs::path(folder) / name;
      if (!fs::exists(file)) continue;
      ++count;
      const std::optional<KinematicTree> tree = tree_of_urdf(file);
      ASSERT_TRUE(tree) << name;
      EXPECT_EQ(census(*tree), line.substr(space + 1)) << name;
    }
  }
  if (count == 0) GTEST_SKIP() << "no URDFs in " << ROBCOGEN_MODELS_DIR << " and " << ROBCOGEN_URDFS_DIR;
}

}  // namespace
}  // namespace robcogen::numeric::inverse_corpus_test
