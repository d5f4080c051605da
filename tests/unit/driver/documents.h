// Small documents in each language, and a temporary folder for them.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "driver/load.h"

namespace robcogen::driver::test {

namespace fs = std::filesystem;

// A new folder, empty at first, that is removed at the end.
class Folder {
 public:
  Folder() {
    static int count = 0;
    path_ =
        fs::temp_directory_path() / ("robcogen-driver-" + std::to_string(::getpid()) + "-" + std::to_string(++count));
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  fs::path file(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }

 private:
  fs::path path_;
};

// Point masses of 2 and 0.5 kg at the ends of rods of 0.75 and 1.25 m, in the base's x-z plane.
inline constexpr double kM1 = 2.0, kL1 = 0.75, kM2 = 0.5, kL2 = 1.25, kGravity = 9.81;

inline constexpr const char* kRods = R"(Robot Rods {
RobotBase base { children { upper via shoulder } }
link upper {
    id = 1
    inertia_params {
        mass = 2.0  CoM = (0.75, 0.0, 0.0)
        Ix = 0.0  Iy = 1.125  Iz = 1.125  Ixy = 0.0  Ixz = 0.0  Iyz = 0.0
    }
    children { lower via elbow }
}
link lower {
    id = 2
    inertia_params {
        mass = 0.5  CoM = (1.25, 0.0, 0.0)
        Ix = 0.0  Iy = 0.78125  Iz = 0.78125  Ixy = 0.0  Ixz = 0.0  Iyz = 0.0
    }
    children {}
    frames { tip { translation = (1.25, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
}
r_joint shoulder { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (PI/2.0, 0.0, 0.0) } }
r_joint elbow { ref_frame { translation = (0.75, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
}
)";

inline constexpr const char* kRodsUrdf = R"(<robot name="Rods">
  <link name="base"/>
  <link name="upper"><inertial><origin xyz="0.75 0 0"/><mass value="2"/>
    <inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="lower"><inertial><origin xyz="1.25 0 0"/><mass value="0.5"/>
    <inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="shoulder" type="continuous"><parent link="base"/><child link="upper"/>
    <origin xyz="0 0 0" rpy="1.5707963267948966 0 0"/><axis xyz="0 0 1"/></joint>
  <joint name="elbow" type="continuous"><parent link="upper"/><child link="lower"/>
    <origin xyz="0.75 0 0"/><axis xyz="0 0 1"/></joint>
</robot>
)";

// The same frames as motions and as transforms: turned by a about x, then shifted by 0.5 m along y.
inline constexpr const char* kMotions = "Model Arm Convention = local base -> hand : rotx(a) try(0.5)";
inline constexpr const char* kTransforms =
    "Model Arm MovedFramePos = right {base}_X_{hand} = Rx(a) Ty(0.5) {hand}_X_{base} = Ty(-0.5) Rx(-a)";

inline Model loaded(const fs::path& file, const LoadOptions& options = {}) {
  Diagnostics diagnostics;
  std::optional<Model> model = load(file, options, diagnostics);
  if (!model) throw std::runtime_error(diagnostics.render());  // ends the test
  return *model;
}

inline Model rods() {
  const Folder folder;
  return loaded(folder.file("rods.kindsl", kRods));
}

// Replaces the first occurrence of `what`.
inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

}  // namespace robcogen::driver::test
