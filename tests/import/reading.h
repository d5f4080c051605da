// URDFs as test input.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "import/urdf.h"

namespace robcogen::test {

inline std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline std::shared_ptr<const Source> source(const std::filesystem::path& path) {
  return std::make_shared<Source>(path.filename().string(), contents(path));
}

// Files of a folder with this extension, sorted; none when there is no such folder.
inline std::vector<std::filesystem::path> files(const std::filesystem::path& folder, const std::string& extension) {
  std::vector<std::filesystem::path> result;
  if (!std::filesystem::is_directory(folder)) return result;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == extension) result.push_back(entry.path());
  std::sort(result.begin(), result.end());
  return result;
}

struct Imported {
  std::optional<model::KinematicTree> tree;
  Diagnostics diagnostics;

  std::vector<const Diagnostic*> of_code(const std::string& code) const {
    std::vector<const Diagnostic*> result;
    for (const Diagnostic& d : diagnostics.all())
      if (d.code == code) result.push_back(&d);
    return result;
  }
};

inline Imported imported(const std::string& text, const import::UrdfOptions& options = {}) {
  Imported result;
  result.tree = import::urdf(std::make_shared<Source>("robot.urdf", text), options, result.diagnostics);
  return result;
}

// A robot that must be read without errors.
inline model::KinematicTree tree_of(const std::string& text, const import::UrdfOptions& options = {}) {
  Imported result = imported(text, options);
  EXPECT_TRUE(result.tree) << result.diagnostics.render();
  return result.tree.value_or(model::KinematicTree());
}

}  // namespace robcogen::test
