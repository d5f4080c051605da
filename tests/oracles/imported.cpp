#include "imported.h"

#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "import/urdf.h"

namespace robcogen::oracles {

using model::KinematicTree;
using std::filesystem::path;

std::set<path> urdfs_in(const std::set<path>& folders) {
  std::set<path> files;
  for (const path& folder : folders) {
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

KinematicTree imported(const path& file, bool floating, MimicJoints mimic) {
  const auto source = std::make_shared<Source>(file.filename().string(), contents(file));
  Diagnostics diagnostics;
  import::UrdfOptions options;
  options.floating_base = floating;
  options.free_mimic_joints = mimic == MimicJoints::free;
  const auto tree = import::urdf(source, options, diagnostics);
  if (!tree) throw std::runtime_error(diagnostics.render());
  return *tree;
}

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

}  // namespace robcogen::oracles
