// Files of robots with shapes, in a folder that is removed.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "driver/load.h"

namespace robcogen::test {

class Folder {
 public:
  Folder()
      : path_(
            std::filesystem::temp_directory_path() /
            (std::string("robcogen_shapes_") +
             ::testing::UnitTest::GetInstance()->current_test_info()->test_suite_name() + "_" +
             ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::remove_all(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path file(const std::string& name, const std::string& content) const {
    const std::filesystem::path path = path_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// A tetrahedron with edges of 1 m along the axes, from the origin.
inline const std::string kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

struct Loaded {
  std::optional<driver::Model> model;
  Diagnostics diagnostics;

  const model::KinematicTree& tree() const { return model->robot()->tree; }
  const std::vector<model::Shape>& shapes() const { return tree().geometry.shapes; }
  std::vector<std::string> messages() const {
    std::vector<std::string> list;
    for (const Diagnostic& d : diagnostics.all())
      if (d.severity != Severity::note) list.push_back(d.code + ": " + d.message);
    return list;
  }
};

inline Loaded loaded(const std::filesystem::path& file, const driver::LoadOptions& options) {
  Loaded result;
  result.model = driver::load(file, options, result.diagnostics);
  return result;
}

// As for functions of collision shapes.
inline driver::LoadOptions checked() {
  driver::LoadOptions options;
  options.groups = {"collision"};
  return options;
}

}  // namespace robcogen::test
