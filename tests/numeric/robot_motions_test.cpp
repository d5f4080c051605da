// The motions of robots as documents of their own: transforms made from such a text agree with the reference, with the
// robot's own programs, and with the poses that its dynamics use.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "algorithm/catalogue/transform_functions.h"
#include "algorithm/kinematics/joint_poses.h"
#include "export/frames.h"
#include "import/frames.h"
#include "import/kinematics.h"
#include "import/parts.h"
#include "reference_tables.h"
#include "robcogen/reference/kinematics.h"
#include "symbolic/interpret.h"

namespace robcogen::numeric::robot_motions_test {
namespace {

using algorithm::TransformForm;
using model::FrameNames;
using reference::Matrix;
using std::filesystem::path;

// For chains of up to 30 frames within some metres, computed in another order of operations.
constexpr double kTolerance = 1e-12;
constexpr int kStates = 3;

std::vector<path> documents(const path& folder) {
  std::vector<path> result;
  if (!std::filesystem::is_directory(folder)) return result;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".kindsl") result.push_back(entry.path());
  std::sort(result.begin(), result.end());
  return result;
}

// Returns nullopt for documents that are malformed on purpose, and for those that contain only parts.
std::optional<model::KinematicTree> robot_of(const path& document) {
  std::ifstream file(document, std::ios::binary);
  const auto source =
      std::make_shared<Source>(document.string(), std::string(std::istreambuf_iterator<char>(file), {}));
  Diagnostics diagnostics;
  const auto read = import::robot_document(source, {}, diagnostics);
  const auto tree = read ? import::kinematic_tree(read->document, diagnostics) : std::nullopt;
  return diagnostics.has_errors() || tree->name.empty() ? std::nullopt : tree;
}

// Returns the text that `robcogen convert robot.kindsl robot.motdsl` writes.
std::string motions_text(const model::KinematicTree& robot) {
  return language::motion::print(exporting::motion_document(model::motions_over_coordinates(robot)));
}

std::optional<model::RigidMotions> read(const std::string& text) {
  Diagnostics diagnostics;
  const auto document = language::motion::parse(std::make_shared<Source>("robot.motdsl", text), diagnostics);
  const auto motions = import::rigid_motions(document, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.render();
  return motions;
}

Matrix<double> matrix(const std::vector<double>& values, int size) {
  Matrix<double> m(size, size);
  std::copy(values.begin(), values.end(), m.data());
  return m;
}

double difference(const Matrix<double>& a, const Matrix<double>& b) {
  return reference::largest(a - b) / std::max(1.0, reference::largest(b));
}

// A robot, and its motions as read from their document.
class Both {
 public:
  Both(const model::KinematicTree& robot, const model::RigidMotions& motions)
      : robot_(robot), motions_(motions), tables_(reference_tables(robot, parameters_of(robot))) {
    for (const model::Parameter& p : motions.parameters) parameters_.push_back(value_of(p.name));
  }

  // Returns the largest difference of all forms of left_X_right from the reference and from the robot's own programs.
  double difference_of(const model::FramePair& pair, const std::vector<double>& q) const {
    const auto transforms = model::transforms_of(motions_, {{pair.left.name, pair.right.name}});
    const Matrix<double> expected = reference::transform<double>(
        tables_.robot(), vector(q), frame_index(robot_, pair.left), frame_index(robot_, pair.right));
    double worst = 0;
    const auto compare = [&](TransformForm form, const Matrix<double>& wanted) {
      const Matrix<double> of_document = matrix(run(transforms, form, q), wanted.rows());
      const auto own = algorithm::coordinate_transform(robot_, pair, form, "own");
      symbolic::Arrays<double> inputs = {{"q", q}};
      if (!robot_.parameters.empty()) inputs["parameters"] = parameters_of(robot_);
      const Matrix<double> of_robot = matrix(symbolic::interpret<double>(own, inputs).at("X"), wanted.rows());
      worst = std::max({worst, difference(of_document, wanted), difference(of_document, of_robot)});
    };
    compare(TransformForm::homogeneous, expected);
    compare(TransformForm::spatial_motion, reference::motion_form(expected));
    compare(TransformForm::spatial_force, reference::force_form(expected));
    return worst;
  }

  // Returns the largest difference of the joints' poses from those that the dynamics use.
  double difference_of_poses(const std::vector<double>& q) const {
    algorithm::Trace trace(robot_);
    const auto positions = trace.joint_input("q", symbolic::Role::joint_position);
    std::vector<algorithm::Expression> values;
    for (const algorithm::Pose& pose : algorithm::joint_poses(trace, positions)) {
      for (std::size_t k = 0; k < 4; ++k) {
        algorithm::Vector3 column;
        if (k < 3) column[k] = trace.graph.one();
        if (k == 3) column[2] = pose.slide;
        column = algorithm::to_parent(pose.rotation, column);
        if (k == 3) column += pose.offset;
        for (std::size_t i = 0; i < 3; ++i) values.push_back(column[i]);
      }
    }
    trace.output("poses", symbolic::Role::value, values);
    symbolic::Arrays<double> inputs = {{"q", q}};
    if (!robot_.parameters.empty()) inputs["parameters"] = parameters_of(robot_);
    const std::vector<double> poses = symbolic::interpret<double>(trace.program("poses"), inputs).at("poses");
    double worst = 0;
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
      const FrameNames names = {link_frame(robot_.joints[j].parent), link_frame(robot_.joints[j].child)};
      const Matrix<double> X = matrix(run(model::transforms_of(motions_, {names}), TransformForm::homogeneous, q), 4);
      for (int k = 0; k < 4; ++k)
        for (int i = 0; i < 3; ++i)
          worst = std::max(worst, std::abs(X(i, k) - poses[12 * j + static_cast<std::size_t>(3 * k + i)]));
    }
    return worst;
  }

 private:
  static std::vector<double> parameters_of(const model::KinematicTree& robot) {
    std::vector<double> values;
    for (const model::Parameter& p : robot.parameters)
      values.push_back(p.default_value.value_or(0.4 + 0.13 * static_cast<double>(values.size() % 7)));
    return values;
  }
  double value_of(const std::string& parameter) const {
    const std::vector<double> values = parameters_of(robot_);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (robot_.parameters[i].name == parameter && model::is_kinematics(robot_.parameters[i])) return values[i];
    ADD_FAILURE() << "the motions have a parameter that the robot has not: " << parameter;
    return 0;
  }
  static reference::Vector<double> vector(const std::vector<double>& q) {
    reference::Vector<double> v(static_cast<int>(q.size()));
    std::copy(q.begin(), q.end(), v.data());
    return v;
  }
  std::string link_frame(int link) const {
    return model::implicit_frame_name(robot_.links[static_cast<std::size_t>(link)].name);
  }
  std::vector<double> run(
      const model::CoordinateTransforms& transforms,
      TransformForm form,
      const std::vector<double>& q) const {
    const model::CoordinateTransform& transform = transforms.transforms.front();
    const algorithm::Arguments arguments = algorithm::arguments_of(transforms, transform);
    symbolic::Arrays<double> inputs;
    if (arguments.parameters) inputs["parameters"] = parameters_;
    std::vector<double> variables;
    for (int i : arguments.variables)
      variables.push_back(position_of(transforms.variables[static_cast<std::size_t>(i)], q));
    if (!variables.empty()) inputs["variables"] = variables;
    return symbolic::interpret<double>(algorithm::transform_program(transforms, transform, form, "X"), inputs).at("X");
  }
  // Variables are named `q_<joint>`, with underscores appended where a parameter has that name.
  double position_of(const std::string& variable, const std::vector<double>& q) const {
    for (std::size_t j = 0; j < q.size(); ++j)
      if (model::motions_over_coordinates(robot_).variables[j] == variable) return q[j];
    ADD_FAILURE() << "no joint moves " << variable;
    return 0;
  }

  const model::KinematicTree& robot_;
  const model::RigidMotions& motions_;
  reference::Tables tables_;
  std::vector<double> parameters_;
};

class RobotMotions : public testing::Test {
 protected:
  // Calls check(robot, both) for each robot of the folder; returns the number of robots.
  template <class Check>
  int for_each_robot(const path& folder, const Check& check) {
    int robots = 0;
    for (const path& document : documents(folder)) {
      SCOPED_TRACE(document.filename().string());
      const std::optional<model::KinematicTree> robot = robot_of(document);
      // A motion has one variable, and motion documents have no loops.
      if (!robot || !robot->spherical_joints().empty() || !robot->loops.empty()) continue;
      const std::optional<model::RigidMotions> motions = read(motions_text(*robot));
      if (!motions) continue;
      ++robots;
      check(*robot, Both(*robot, *motions));
    }
    return robots;
  }

  std::vector<double> positions(const model::KinematicTree& robot) {
    std::vector<double> q;
    for (const int j : robot.coordinates()) {
      const bool turns = model::turns(robot.joints[static_cast<std::size_t>(j)].type);
      q.push_back(std::uniform_real_distribution<double>(-1, 1)(random_) * (turns ? 3.0 : 1.0));
    }
    return q;
  }

  // Checks all robots of the folder, and returns how many there were.
  int check(const path& folder) {
    return for_each_robot(folder, [&](const model::KinematicTree& robot, const Both& both) {
      for (int state = 0; state < kStates; ++state) {
        const std::vector<double> q = positions(robot);
        EXPECT_LE(both.difference_of_poses(q), kTolerance);
        for (const model::FramePair& pair : model::all_desired(robot).transforms)
          EXPECT_LE(both.difference_of(pair, q), kTolerance) << pair.left.name << "_X_" << pair.right.name;
      }
    });
  }

  std::mt19937 random_{1};
};

TEST_F(RobotMotions, OfOurRobotsMeanTheSameAsADocument) {
  EXPECT_GE(check(ROBCOGEN_ROBOTS_DIR), 8);
}

TEST_F(RobotMotions, OfTheCorpusMeanTheSameAsADocument) {
  if (documents(ROBCOGEN_CORPUS_DIR).empty()) GTEST_SKIP() << "no documents in " << ROBCOGEN_CORPUS_DIR;
  EXPECT_GT(check(ROBCOGEN_CORPUS_DIR), 20);
}

}  // namespace
}  // namespace robcogen::numeric::robot_motions_test
