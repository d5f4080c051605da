// Generated files as they are, so that a reviewer of a change sees what it does to them. generated/<robot>/… holds what
// `robcogen generate` writes. golden_test.h says how these files are updated.
#include "../../golden_test.h"
#include "run_tool.h"

namespace robcogen::test::generated_test {
namespace {

namespace fs = std::filesystem;

const char kPendulum[] = R"(Robot Pendulum {
    RobotBase base { children { rod via swing } }

    link rod {
        id = 1
        inertia_params {
            mass = 2.0  CoM = (0.0, -0.5, 0.0)
            Ix = 0.6  Iy = 0.1  Iz = 0.6  Ixy = 0.0  Ixz = 0.0  Iyz = 0.0
        }
        children {}
    }

    r_joint swing { ref_frame { translation = (0.0, 0.0, 0.0)  rotation = (PI/2.0, 0.0, 0.0) } }
}
)";

struct Case {
  std::string robot;
  fs::path file;  // generated/<file> has the same text as the generator's <file>
  std::string options;

  friend std::ostream& operator<<(std::ostream& out, const Case& given) { return out << given.file.string(); }
};

class GeneratedFiles : public testing::TestWithParam<Case> {};

TEST_P(GeneratedFiles, AreAsExpected) {
  const Case& given = GetParam();
  const Scratch scratch("generated-" + given.robot);
  fs::path document = robot(given.robot);
  if (given.robot == "pendulum") write_text(document = scratch.path / "pendulum.kindsl", kPendulum);
  const Outcome outcome =
      run_tool("generate " + quoted(document) + " " + given.options + " -o " + quoted(scratch.path));
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const fs::path file = fs::path(TEST_SOURCE_DIR) / "generated" / given.file;
  const std::string found = read_text(scratch.path / given.file);
  ASSERT_NE(found, "") << given.file << " was not generated";
  const auto expected = exists(file) ? std::optional(read_text(file)) : std::nullopt;
  expect_golden(file, expected, found, "is missing", [&] {
    create_directories(file.parent_path());
    write_text(file, found);
  });
}

INSTANTIATE_TEST_SUITE_P(
    Reviewed,
    GeneratedFiles,
    testing::Values(
        Case{"pendulum", "pendulum/pendulum.h", ""},
        Case{"pendulum", "pendulum/kernel/inverse_dynamics.h", "--algorithms inverse_dynamics"},
        Case{"hyl", "hyl/kernel/forward_dynamics.h", "--algorithms forward_dynamics"},
        Case{"quadruped", "quadruped/kernel/joint_space_inertia.h", "--algorithms joint_space_inertia"}),
    [](const testing::TestParamInfo<Case>& given) {
      return given.param.robot + "_" + given.param.file.stem().string();
    });

// A file that no case writes would never be compared.
TEST(GeneratedFiles, AreAllCompared) {
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(TEST_SOURCE_DIR) / "generated"))
    files += entry.is_regular_file() ? 1 : 0;
  EXPECT_EQ(files, 4);
}

}  // namespace
}  // namespace robcogen::test::generated_test
