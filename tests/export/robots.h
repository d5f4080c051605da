// Robots to export: those of robots/ and documents from other projects.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "export/urdf.h"
#include "export/urdf_loops.h"
#include "import/kinematics.h"
#include "import/parts.h"

namespace robcogen::test {

struct NamedRobot {
  std::string document;  // file name
  model::KinematicTree tree;
};

inline std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder, const char* extension) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::is_directory(folder)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == extension) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

inline std::shared_ptr<const Source> source_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return std::make_shared<Source>(path.string(), std::string(std::istreambuf_iterator<char>(file), {}));
}

inline std::optional<model::KinematicTree> read_document(
    const std::shared_ptr<const Source>& source,
    Diagnostics& diagnostics) {
  const auto read = import::robot_document(source, {}, diagnostics);
  return read ? import::kinematic_tree(read->document, diagnostics) : std::nullopt;
}

// Documents that are malformed on purpose or written in another dialect.
inline const std::set<std::string>& malformed_documents() {
  static const std::set<std::string> names = {
      "ESROCOS_kin-gen__tests_models_malformed_cmm-disconnected.kindsl",
      "ESROCOS_kin-gen__tests_models_malformed_cmm-typo.kindsl",
      "mfrigerio17_dsl-kinematics__models_two_links.kindsl",  // dialect of 2012
  };
  return names;
}

// True for a document that only declares parts for other documents.
inline bool is_library(const std::shared_ptr<const Source>& source) {
  Diagnostics diagnostics;
  const auto document = language::kinematics::parse(source, diagnostics);
  return !document.has_robot() && !document.parts.empty();
}

// Every robot of robots/ and every well-formed one of the corpus, if there is a corpus. Throws if one does not build.
inline std::vector<NamedRobot> all_robots() {
  std::vector<NamedRobot> robots;
  for (const char* folder : {ROBCOGEN_ROBOTS_DIR, ROBCOGEN_CORPUS_DIR}) {
    for (const std::filesystem::path& file : files_below(folder, ".kindsl")) {
      const std::string name = file.filename().string();
      if (malformed_documents().contains(name)) continue;
      const auto source = source_of(file);
      if (is_library(source)) continue;
      Diagnostics diagnostics;
      const auto tree = read_document(source, diagnostics);
      if (!tree) throw std::runtime_error(diagnostics.render());
      robots.push_back({name, *tree});
    }
  }
  return robots;
}

// The robots that a URDF can describe. URDF has no parameters, no spherical or helical joints, no joints that follow
// others in arbitrary ways, and no drive properties except damping and friction; other drive properties are removed.
// Robots with loops that close only near the position in which they are drawn are left out.
inline std::vector<NamedRobot> constant_robots() {
  std::vector<NamedRobot> robots = all_robots();
  std::erase_if(robots, [](const NamedRobot& robot) {
    const model::KinematicTree& tree = robot.tree;
    const auto is_helical = [](const model::Joint& joint) { return joint.type == model::JointType::helical; };
    return !tree.parameters.empty() || !tree.spherical_joints().empty() ||
           std::any_of(tree.joints.begin(), tree.joints.end(), is_helical) || !tree.closures.empty() ||
           !std::all_of(
               tree.loops.begin(), tree.loops.end(),
               [&](const model::LoopJoint& loop) { return exporting::may_be_urdf_loop(loop); }) ||
           !std::all_of(tree.couplings.begin(), tree.couplings.end(), [&](const model::Coupling& coupling) {
             return exporting::has_urdf_form(tree, coupling);
           });
  });
  for (NamedRobot& robot : robots) {
    for (model::Joint& joint : robot.tree.joints) {
      const model::Drive drive = std::exchange(joint.drive, {});
      joint.drive.damping = drive.damping;
      joint.drive.friction = drive.friction;
    }
  }
  return robots;
}

}  // namespace robcogen::test
