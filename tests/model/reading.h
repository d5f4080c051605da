// Documents read from files and texts, all the way to the model.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>

#include "import/kinematics.h"
#include "import/parts.h"

namespace robcogen::test {

inline std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// A source that messages call by the file's name alone.
inline std::shared_ptr<const Source> source(const std::filesystem::path& path) {
  return std::make_shared<Source>(path.filename().string(), contents(path));
}

inline std::optional<model::KinematicTree> tree_of(
    const std::shared_ptr<const Source>& text,
    Diagnostics& diagnostics) {
  const auto read = import::robot_document(text, {}, diagnostics);
  return read ? import::kinematic_tree(read->document, diagnostics) : std::nullopt;
}

inline std::optional<model::KinematicTree> tree_of(const std::string& text, Diagnostics& diagnostics) {
  return tree_of(std::make_shared<Source>("test.kindsl", text), diagnostics);
}

}  // namespace robcogen::test
