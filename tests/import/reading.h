// URDFs as test input.
#pragma once

#include "../golden_messages.h"
#include "import/urdf.h"

namespace robcogen::test {

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

// Reads a robot; expects no errors.
inline model::KinematicTree tree_of(const std::string& text, const import::UrdfOptions& options = {}) {
  Imported result = imported(text, options);
  EXPECT_TRUE(result.tree) << result.diagnostics.render();
  return result.tree.value_or(model::KinematicTree());
}

// Returns the messages with the names of files relative to the folder.
inline std::string without_folder(std::string text, const std::filesystem::path& folder) {
  const std::string prefix = folder.lexically_normal().string() + "/";
  for (std::size_t at; (at = text.find(prefix)) != std::string::npos;) text.erase(at, prefix.size());
  return text;
}

}  // namespace robcogen::test
