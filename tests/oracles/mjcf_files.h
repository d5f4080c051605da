// MJCF files as MuJoCo reads them, and as this project does.
#pragma once

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <filesystem>
#include <functional>
#include <memory>

#include "model/kinematic_tree.h"

namespace robcogen::oracles {

struct Deleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using ModelPointer = std::unique_ptr<mjModel, Deleter>;
using DataPointer = std::unique_ptr<mjData, Deleter>;

// MuJoCo's model; its warnings are not printed. These throw where a file is refused.
ModelPointer loaded(const std::filesystem::path& file);
model::KinematicTree imported(const std::filesystem::path& file);
// The tree of the robot document that `convert` writes.
model::KinematicTree converted(const model::KinematicTree& tree);

// The main function of a program: runs a test for each file of the folder `suite`, and for those that the arguments
// name.
int run_tests_of_files(
    int argc,
    char** argv,
    const char* suite,
    const std::function<testing::Test*(const std::filesystem::path&)>& make);

}  // namespace robcogen::oracles
