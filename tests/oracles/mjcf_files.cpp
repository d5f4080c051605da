#include "mjcf_files.h"

#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "export/kinematics.h"
#include "import/kinematics.h"
#include "import/mjcf.h"

namespace robcogen::oracles {
namespace {

using std::filesystem::path;

std::string contents(const path& file) {
  std::ifstream text(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(text), {}};
}

}  // namespace

ModelPointer loaded(const path& file) {
  mju_user_warning = [](const char*) {};
  char error[1000] = "";
  ModelPointer model(mj_loadXML(file.c_str(), nullptr, error, sizeof error));
  if (!model) throw std::runtime_error(error);
  return model;
}

model::KinematicTree imported(const path& file) {
  Diagnostics diagnostics;
  const auto source = std::make_shared<Source>(file.filename().string(), contents(file));
  import::MjcfOptions options;
  options.shapes.collisions = true;
  auto robot = import::mjcf(source, file, options, diagnostics);
  if (!robot) throw std::runtime_error(diagnostics.render());
  return std::move(robot->tree);
}

model::KinematicTree converted(const model::KinematicTree& tree) {
  Diagnostics diagnostics;
  const std::string text =
      language::kinematics::print(exporting::numbered_parents_first(tree, exporting::kinematics_document(tree)));
  const auto document = language::kinematics::parse(std::make_shared<Source>("converted", text), diagnostics);
  auto robot = import::kinematic_tree(document, diagnostics);
  if (!robot) throw std::runtime_error(diagnostics.render());
  EXPECT_EQ(robot->dof(), tree.dof());
  for (std::size_t j = 0; j < tree.joints.size(); ++j)
    EXPECT_EQ(robot->joints[j].limits, tree.joints[j].limits) << tree.joints[j].name;
  return *std::move(robot);
}

int run_tests_of_files(
    int argc,
    char** argv,
    const char* suite,
    const std::function<testing::Test*(const path&)>& make) {
  testing::InitGoogleTest(&argc, argv);
  std::set<path> files(argv + 1, argv + argc);
  for (const auto& entry : std::filesystem::directory_iterator(path(TEST_SOURCE_DIR) / suite))
    if (entry.path().extension() == ".xml") files.insert(entry.path());
  for (const path& file : files)
    testing::RegisterTest(suite, file.stem().c_str(), nullptr, nullptr, __FILE__, __LINE__, [=]() -> testing::Test* {
      return make(file);
    });
  return RUN_ALL_TESTS();
}

}  // namespace robcogen::oracles
