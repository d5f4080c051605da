// The import of URDFs: the imported robot, run by the interpreter, compared with other libraries on the same
// file. The files are those beside this one, and URDFs from the field where there are any.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

#include "import/urdf.h"
#include "interpreted_robot.h"
#include "judge.h"

namespace robcogen::oracles {
namespace {

using model::KinematicTree;
using std::filesystem::path;

// MuJoCo takes a rotation to principal axes for complete when its cosine is 1 - 1e-12, some 1e-6 rad: that shows in the
// results where tensors have products of inertia.
constexpr double kPrincipalAxes = 1e-6;

const Decisions kDecisions = {
    {
        // KDL's roots are fixed.
        {"KDL", "a1_floating", "no floating base"},
        {"KDL", "floating_tree", "no floating base"},
        {"KDL", "hyq_no_sensors_floating", "no floating base"},
        {"KDL", "simple_humanoid_floating", "no floating base"},
        {"KDL", "solo12_floating", "no floating base"},
        {"KDL", "talos_reduced_floating", "no floating base"},
        {"KDL chain", "a1_floating", "no floating base"},
        {"KDL chain", "floating_tree", "no floating base"},
        {"KDL chain", "hyq_no_sensors_floating", "no floating base"},
        {"KDL chain", "simple_humanoid_floating", "no floating base"},
        {"KDL chain", "solo12_floating", "no floating base"},
        {"KDL chain", "talos_reduced_floating", "no floating base"},
        // They branch; some only in bodies on fixed joints, which KDL keeps as segments.
        {"KDL chain", "a1", "one chain"},
        {"KDL chain", "allegro_left_hand", "one chain"},
        {"KDL chain", "fixed_tree", "one chain"},
        {"KDL chain", "hyq_no_sensors", "one chain"},
        {"KDL chain", "kinova", "one chain"},
        {"KDL chain", "panda", "one chain"},
        {"KDL chain", "simple_humanoid", "one chain"},
        {"KDL chain", "solo12", "one chain"},
        {"KDL chain", "talos_reduced", "one chain"},
        // urdfdom, which reads for them, asks for limits of revolute joints.
        {"KDL", "iiwa14", "urdfdom refuses the URDF"},
        {"KDL chain", "iiwa14", "urdfdom refuses the URDF"},
        {"DART", "iiwa14", "refuses the URDF"},
        // MuJoCo asks for mass properties of real bodies.
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
        {"MuJoCo", "panda", kPrincipalAxes},
    }};

std::set<path> urdfs() {
  std::set<path> files;
  for (const char* folder : {TEST_SOURCE_DIR, ROBCOGEN_MODELS_DIR}) {
    if (!std::filesystem::is_directory(folder)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".urdf") files.insert(entry.path());
    }
  }
  return files;
}

std::string contents(const path& file) {
  std::ifstream text(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(text), {}};
}

KinematicTree imported(const path& file, bool floating) {
  const auto source = std::make_shared<Source>(file.filename().string(), contents(file));
  Diagnostics diagnostics;
  import::UrdfOptions options;
  options.floating_base = floating;
  options.free_mimic_joints = true;
  const auto tree = import::urdf(source, options, diagnostics);
  if (!tree) throw std::runtime_error(diagnostics.render());
  return *tree;
}

// From the base to one frame on each leaf: the last of the file, which is farthest out.
model::DesiredTransforms jacobians_of_leaves(const KinematicTree& tree) {
  model::DesiredTransforms desired;
  const std::vector<model::Frame> frames = tree.frames();
  for (int link = 1; link < static_cast<int>(tree.links.size()); ++link) {
    if (!tree.links[static_cast<std::size_t>(link)].child_joints.empty()) continue;
    const model::Frame* last = nullptr;
    for (const model::Frame& frame : frames) {
      if (frame.kind == model::Frame::Kind::user && tree.link_of(frame) == link) last = &frame;
    }
    if (last != nullptr) desired.jacobians.push_back({frames.front(), *last});
  }
  return desired;
}

// Characters that an identifier cannot have become underscores: all names of the file with such characters.
std::map<std::string, std::string> changed_names(const std::string& urdf) {
  const std::string attribute = "name=\"";
  std::map<std::string, std::string> names;
  for (std::size_t at = urdf.find(attribute); at != std::string::npos; at = urdf.find(attribute, at + 1)) {
    const std::size_t begin = at + attribute.size();
    const std::string name = urdf.substr(begin, urdf.find('"', begin) - begin);
    std::string identifier = name;
    for (char& c : identifier) {
      const bool fits = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
      if (!fits) c = '_';
    }
    if (identifier != name) names[identifier] = name;
  }
  return names;
}

Judged imported_robot(const path& file, bool floating) {
  const KinematicTree tree = imported(file, floating);
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
  // Those of which the root is a body that can float.
  const std::set<std::string> floating = {"a1", "hyq_no_sensors", "simple_humanoid", "solo12", "talos_reduced"};
  for (const auto& file : urdfs()) {
    register_file(file, false);
    if (floating.contains(file.stem().string())) register_file(file, true);
  }
  return RUN_ALL_TESTS();
}
