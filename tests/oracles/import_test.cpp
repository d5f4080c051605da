// The import of URDFs: the imported robot, run in the interpreter, compared with other libraries on the same file. The
// files are those in this folder, the exported robots of this project, and published URDFs if there are any.
#include <gtest/gtest.h>

#include <set>

#include "imported.h"
#include "interpreted_robot.h"
#include "judge.h"

namespace robcogen::oracles {
namespace {

using model::KinematicTree;
using std::filesystem::path;

// MuJoCo accepts a rotation to principal axes when its cosine is 1 - 1e-12, which is about 1e-6 rad. The error is
// visible in the results for tensors with products of inertia.
constexpr double kPrincipalAxes = 1e-6;

const Decisions kDecisions = {
    {
        // KDL supports only fixed bases.
        {"KDL", "a1_floating", "no floating base"},
        {"KDL", "centaur", "no floating base"},
        {"KDL", "floating_tree", "no floating base"},
        {"KDL", "humanoid", "no floating base"},
        {"KDL", "quadruped", "no floating base"},
        {"KDL", "hyq_no_sensors_floating", "no floating base"},
        {"KDL", "simple_humanoid_floating", "no floating base"},
        {"KDL", "solo12_floating", "no floating base"},
        {"KDL", "talos_reduced_floating", "no floating base"},
        {"KDL chain", "a1_floating", "no floating base"},
        {"KDL chain", "centaur", "no floating base"},
        {"KDL chain", "floating_tree", "no floating base"},
        {"KDL chain", "humanoid", "no floating base"},
        {"KDL chain", "quadruped", "no floating base"},
        {"KDL chain", "hyq_no_sensors_floating", "no floating base"},
        {"KDL chain", "simple_humanoid_floating", "no floating base"},
        {"KDL chain", "solo12_floating", "no floating base"},
        {"KDL chain", "talos_reduced_floating", "no floating base"},
        // These robots branch; some only in bodies on fixed joints, which KDL keeps as segments.
        {"KDL chain", "a1", "one chain"},
        {"KDL chain", "allegro_left_hand", "one chain"},
        {"KDL chain", "fixed_tree", "one chain"},
        {"KDL chain", "quadruped_fixed", "one chain"},
        {"KDL chain", "tree5", "one chain"},
        {"KDL chain", "hyq_no_sensors", "one chain"},
        {"KDL chain", "kinova", "one chain"},
        {"KDL chain", "mimic_tree", "one chain"},
        {"KDL chain", "panda", "one chain"},
        {"KDL chain", "simple_humanoid", "one chain"},
        {"KDL chain", "solo12", "one chain"},
        {"KDL chain", "talos_reduced", "one chain"},
        // urdfdom, which reads the file for these libraries, requires limits of revolute joints.
        {"KDL", "iiwa14", "urdfdom refuses the URDF"},
        {"KDL chain", "iiwa14", "urdfdom refuses the URDF"},
        {"DART", "iiwa14", "refuses the URDF"},
        // MuJoCo requires mass properties that are physical.
        {"MuJoCo", "allegro_left_hand", "inertia must satisfy A + B >= C"},
        {"MuJoCo", "hyq_no_sensors", "inertia must satisfy A + B >= C"},
        {"MuJoCo", "hyq_no_sensors_floating", "inertia must satisfy A + B >= C"},
        {"MuJoCo", "talos_reduced", "inertia must satisfy A + B >= C"},
        {"MuJoCo", "talos_reduced_floating", "inertia must satisfy A + B >= C"},
        {"MuJoCo", "massless_link", "mass and inertia of moving bodies"},
    },
    {
        {"MuJoCo", "a1", kPrincipalAxes},
        {"MuJoCo", "a1_floating", kPrincipalAxes},
        {"MuJoCo", "fixed_tree", kPrincipalAxes},
        {"MuJoCo", "floating_tree", kPrincipalAxes},
        {"MuJoCo", "kinova", kPrincipalAxes},
        {"MuJoCo", "mimic_tree", kPrincipalAxes},
        {"MuJoCo", "panda", kPrincipalAxes},
    }};

Judged imported_robot(const path& file, bool floating) {
  const KinematicTree tree = imported(file, floating, MimicJoints::free);
  const auto robot = std::make_shared<const numeric::InterpretedRobot>(tree, jacobians_of_leaves(tree));
  Judged result = judged(file.string(), robot->tables(), robot);
  result.urdf_names = changed_names(contents(file));
  return result;
}

void register_file(const path& file, bool floating) {
  const std::string name = file.stem().string() + (floating ? "_floating" : "");
  register_tests(
      name, [=] { return imported_robot(file, floating); }, kDecisions);
}

}  // namespace
}  // namespace robcogen::oracles

int main(int argc, char** argv) {
  using namespace robcogen::oracles;
  testing::InitGoogleTest(&argc, argv);
  // Robots whose root is a body that can float. (Exported robots say so themselves.)
  const std::set<std::string> floating = {"a1", "hyq_no_sensors", "simple_humanoid", "solo12", "talos_reduced"};
  for (const auto& file : urdfs_in({TEST_SOURCE_DIR, EXPORTED_DIR, ROBCOGEN_MODELS_DIR})) {
    register_file(file, false);
    if (floating.contains(file.stem().string())) register_file(file, true);
  }
  return RUN_ALL_TESTS();
}
