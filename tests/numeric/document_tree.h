// Kinematic trees of robot documents, for tests that link the import.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "import/kinematics.h"
#include "import/parts.h"

namespace robcogen::numeric {

// Throws the messages if the document has no tree.
inline model::KinematicTree tree_of(const std::shared_ptr<const Source>& source) {
  Diagnostics diagnostics;
  const auto read = import::robot_document(source, {}, diagnostics);
  auto tree = read ? import::kinematic_tree(read->document, diagnostics) : std::nullopt;
  if (!tree) throw std::runtime_error(diagnostics.render());
  return *std::move(tree);
}

inline model::KinematicTree tree_of_text(const std::string& text) {
  return tree_of(std::make_shared<const Source>("robot.kindsl", text));
}

// Returns the tree of a robot in the folder of robots.
inline model::KinematicTree tree_of_robot(const std::filesystem::path& robots, const std::string& name) {
  const std::filesystem::path path = robots / name / (name + ".kindsl");
  std::ifstream file(path, std::ios::binary);
  return tree_of(std::make_shared<const Source>(path.string(), std::string(std::istreambuf_iterator<char>(file), {})));
}

}  // namespace robcogen::numeric
