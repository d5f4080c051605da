// Published robot descriptions, from text to results: parser, model, programs and interpreter, compared with the
// reference and with the identities P1 to P5.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "import/kinematics.h"
#include "import/parts.h"
#include "interpreted_robot.h"

namespace robcogen::numeric::corpus_test {
namespace {

using std::filesystem::path;

std::vector<path> documents(const std::string& extension) {
  std::vector<path> result;
  if (!std::filesystem::is_directory(ROBCOGEN_CORPUS_DIR)) return result;
  for (const auto& entry : std::filesystem::directory_iterator(ROBCOGEN_CORPUS_DIR)) {
    if (entry.path().extension() == extension) result.push_back(entry.path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::shared_ptr<const Source> source(const path& document) {
  std::ifstream file(document, std::ios::binary);
  return std::make_shared<Source>(document.string(), std::string(std::istreambuf_iterator<char>(file), {}));
}

// Returns nullopt for documents that are malformed on purpose; the tests of the languages say which ones and why.
std::optional<model::KinematicTree> robot_of(const path& document) {
  Diagnostics diagnostics;
  const auto read = import::robot_document(source(document), {}, diagnostics);
  const auto tree = read ? import::kinematic_tree(read->document, diagnostics) : std::nullopt;
  return diagnostics.has_errors() ? std::nullopt : tree;
}

// Default values of the document, and moderate numbers for parameters that have none.
std::vector<double> parameters_of(const model::KinematicTree& robot) {
  std::vector<double> values;
  for (const model::Parameter& p : robot.parameters)
    values.push_back(p.default_value.value_or(0.4 + 0.13 * static_cast<double>(values.size() % 7)));
  return values;
}

constexpr int kStates = 5;
constexpr std::uint64_t kSeed = 3;

void expect_agreement(
    const model::KinematicTree& robot,
    const model::DesiredTransforms& desired,
    const path& document) {
  const InterpretedRobot programs(robot, desired, pass::names(), parameters_of(robot));
  EXPECT_EQ(check_all(programs, kSeed, kStates).failure_report(), "") << document.filename() << ", seed " << kSeed;
}

class Corpus : public testing::Test {
 protected:
  void SetUp() override {
    if (documents(".kindsl").empty()) GTEST_SKIP() << "no documents in " << ROBCOGEN_CORPUS_DIR;
  }
};

TEST_F(Corpus, RobotsAgreeWithTheReference) {
  int robots = 0;
  for (const path& document : documents(".kindsl")) {
    const std::optional<model::KinematicTree> robot = robot_of(document);
    if (!robot) continue;
    ++robots;
    expect_agreement(*robot, model::all_desired(*robot), document);
  }
  EXPECT_GT(robots, 20);
}

// Checks every list of desired transforms with each robot of the name that the list gives.
TEST_F(Corpus, DesiredTransformsAgreeWithTheReference) {
  int lists = 0;
  for (const path& list : documents(".dtdsl")) {
    Diagnostics diagnostics;
    const language::desired::Document document = language::desired::parse(source(list), diagnostics);
    if (diagnostics.has_errors()) continue;
    for (const path& robot_document : documents(".kindsl")) {
      const std::optional<model::KinematicTree> robot = robot_of(robot_document);
      if (!robot || robot->name != document.robot.text) continue;
      ++lists;
      expect_agreement(*robot, import::desired_transforms(document, *robot, diagnostics), list);
    }
  }
  EXPECT_GT(lists, 5);
}

}  // namespace
}  // namespace robcogen::numeric::corpus_test
