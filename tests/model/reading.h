// Documents read from files and texts, all the way to the model.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>

#include "import/kinematics.h"

namespace robcogen::test {

inline std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// A source that messages call by the file's name alone.
inline std::shared_ptr<const Source> source(const std::filesystem::path& path) {
  return std::make_shared<Source>(path.filename().string(), contents(path));
}

inline std::optional<model::KinematicTree> tree_of(std::shared_ptr<const Source> text, Diagnostics& diagnostics) {
  const auto document = language::kinematics::parse(std::move(text), diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return import::kinematic_tree(document, diagnostics);
}

inline std::optional<model::KinematicTree> tree_of(const std::string& text, Diagnostics& diagnostics) {
  return tree_of(std::make_shared<Source>("test.kindsl", text), diagnostics);
}

}  // namespace robcogen::test
