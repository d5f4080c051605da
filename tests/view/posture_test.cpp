// Where the parts of a robot are drawn, compared with matrix products.
#include <gtest/gtest.h>

#include "algorithm/kinematics/frame_poses.h"
#include "import/kinematics.h"
#include "robcogen/reference/kinematics.h"
#include "robots.h"
#include "symbolic/interpret.h"

namespace robcogen::test::posture_test {
namespace {

using reference::Matrix;
using view::ViewedFrame;

constexpr double kRounding = 1e-13;  // m, for robots of a few metres

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

Matrix<double> placement(const model::Placement& placed, const model::KinematicTree& tree) {
  const model::DefaultValues value(tree.parameters);
  const std::array<double, 3> t = value(placed.translation), r = value(placed.rotation);
  return reference::placement<double>({t[0], t[1], t[2]}, {r[0], r[1], r[2]});
}

// The rotation of a unit quaternion, from its angle and axis by Rodrigues' formula.
Matrix<double> turn_of(double w, const std::array<double, 3>& vector) {
  const double sine = std::hypot(vector[0], vector[1], vector[2]), angle = 2 * std::atan2(sine, w);
  Matrix<double> K(3, 3), result = Matrix<double>::identity(4);
  for (int i = 0; i < 3; ++i) {
    const double u = vector[static_cast<std::size_t>(i)] / sine;
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    K(k, j) = u;
    K(j, k) = -u;
  }
  const Matrix<double> square = K * K;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) result(r, c) += std::sin(angle) * K(r, c) + (1 - std::cos(angle)) * square(r, c);
  return result;
}

// The position of a joint that has a single one.
double position(const backend::Library& library, const std::vector<double>& q, int joint) {
  const model::KinematicTree& tree = library.tree;
  const model::Coupling* const coupling = tree.coupling_of(joint);
  if (coupling == nullptr) return q[index(tree.position_elements()[index(joint)])];
  if (!tree.loops.empty()) {
    const std::vector<int> joints = model::independent_joints_first(tree);
    const auto place = std::find(joints.begin(), joints.end(), joint) - joints.begin();
    for (const backend::Function& f : library.functions) {
      if (f.name != "joint_positions") continue;
      const symbolic::Program& program = f.program;
      return symbolic::interpret<double>(program, {{program.inputs.front().name, q}})
          .at(program.outputs.front().name)
          .at(static_cast<std::size_t>(place));
    }
  }
  const model::DefaultValues value(tree.parameters);
  double sum = value(coupling->offset);
  for (const model::Coupling::Term& term : coupling->terms)
    sum += value(term.factor) * position(library, q, term.joint);
  return sum;
}

// Computes the poses of links and joint frames in the base, parents first.
void place(
    const backend::Library& library,
    const std::vector<double>& q,
    int link,
    const Matrix<double>& pose,
    std::vector<Matrix<double>>& links,
    std::vector<Matrix<double>>& joints) {
  links[index(link)] = pose;
  const model::KinematicTree& tree = library.tree;
  const std::vector<int> all = model::independent_joints_first(tree);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const int j = all[k];
    const model::Joint& joint = tree.joints[index(j)];
    if (model::parent_link(tree, j) != link) continue;
    joints[k] = pose * placement(model::placement_of_joint(tree, j), tree);
    if (!joint.is_first()) continue;
    const int child = model::child_link(tree, j);
    if (joint.type == model::JointType::spherical) {
      const auto w = index(tree.position_elements()[index(j)]) - 1;
      place(library, q, child, joints[k] * turn_of(q[w], {q[w + 1], q[w + 2], q[w + 3]}), links, joints);
      continue;
    }
    const double value = position(library, q, j);
    const double turn = model::turns(joint.type) ? value : 0;
    const double slide = model::DefaultValues(tree.parameters)(model::slide_of(joint)) * value;
    place(
        library, q, child, joints[k] * reference::rotation(2, turn) * reference::translation(0.0, 0.0, slide), links,
        joints);
  }
}

class Posture : public testing::TestWithParam<std::string> {};

TEST_P(Posture, IsThatOfProductsOfMatrices) {
  const view::ViewedRobot robot = view::viewed(load_robot(GetParam()), view::Purpose::drawing);
  const std::vector<double> q = some_positions(robot);
  const view::Posture posture = view::posture(robot, q, declared_parameters(robot));
  const model::KinematicTree& tree = robot.library.tree;
  std::vector<Matrix<double>> links(index(tree.link_count()), Matrix<double>(4, 4));
  std::vector<Matrix<double>> joints(tree.joints.size(), Matrix<double>(4, 4));
  place(robot.library, q, 0, Matrix<double>::identity(4), links, joints);
  ASSERT_EQ(posture.frames.size(), robot.frames.size());
  for (std::size_t f = 0; f < robot.frames.size(); ++f) {
    const ViewedFrame& frame = robot.frames[f];
    Matrix<double> expected = Matrix<double>::identity(4);
    if (frame.kind == ViewedFrame::Kind::joint) {
      expected = joints[static_cast<std::size_t>(frame.index)];
    } else {
      expected = links[static_cast<std::size_t>(frame.link)];
      if (frame.kind == ViewedFrame::Kind::user)
        expected = expected * placement(tree.placement_of(tree.find_frame(frame.name).value()), tree);
    }
    for (int r = 0; r < 4; ++r)
      for (int c = 0; c < 4; ++c)
        EXPECT_NEAR(
            posture.frames[f][static_cast<std::size_t>(r)][static_cast<std::size_t>(c)], expected(r, c), kRounding)
            << frame.name << " " << r << " " << c;
  }
  for (std::size_t l = 0; l < links.size(); ++l) {
    const auto [mass, com, inertia] = model::mass_properties(tree.links[l], model::DefaultValues(tree.parameters));
    EXPECT_EQ(posture.masses[l], mass);
    const Matrix<double> at = links[l] * reference::translation(com[0], com[1], com[2]);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(posture.centres[l][static_cast<std::size_t>(i)], at(i, 3), kRounding);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Posture, testing::ValuesIn(kRobots), [](const auto& robot) { return robot.param; });

// Each link is placed once. The programs of single transforms grow with the square of the length.
TEST(FramePoses, GrowLinearlyWithTheLengthOfAChain) {
  const auto size = [](int joints) {
    std::string text = "Robot Chain { RobotBase l0 { children { l1 via j1 } } ";
    for (int k = 1; k <= joints; ++k) {
      const std::string n = std::to_string(k), next = std::to_string(k + 1);
      text += "link l" + n + " { id = " + n + " children {" + (k < joints ? " l" + next + " via j" + next + " " : "") +
              "} } r_joint j" + n + " { ref_frame { translation = (0.1, 0.02, 0.0) rotation = (0.3, 0.4, 0.0) } } ";
    }
    Diagnostics diagnostics;
    const auto source = std::make_shared<const Source>("chain.kindsl", text + "}");
    const auto tree = import::kinematic_tree(language::kinematics::parse(source, diagnostics), diagnostics);
    if (!tree) throw std::runtime_error(diagnostics.render());
    return algorithm::frame_poses(*tree, "frame_poses").statements.size();
  };
  const std::size_t first = size(20), second = size(40), third = size(80);
  EXPECT_LE(third - second, 2 * (second - first) + 20);
}

// A robot with parameters is drawn with the given values, not with those of the document.
TEST(PostureWithParameters, FollowsThem) {
  const view::ViewedRobot robot = view::viewed(load_robot("hyl_parametric"), view::Purpose::drawing);
  std::vector<double> parameters = declared_parameters(robot);
  const auto at = [&](const std::string& name) {
    const auto& list = robot.library.tree.parameters;
    return static_cast<std::size_t>(
        std::find_if(list.begin(), list.end(), [&](const auto& p) { return p.name == name; }) - list.begin());
  };
  const std::vector<double> q = {0, 0, 0};
  const view::Posture before = view::posture(robot, q, parameters);
  parameters[at("upperleg_length")] += 0.25;
  parameters[at("lowerleg_mass")] = 3.5;
  const view::Posture after = view::posture(robot, q, parameters);
  // The leg hangs down, so a longer thigh lowers the knee.
  EXPECT_NEAR(after.frames[3][2][3], before.frames[3][2][3] - 0.25, kRounding);
  EXPECT_EQ(after.masses[3], 3.5);
}

// The loop closes at the positions that the sliders give.
TEST(PostureOfLoops, ClosesThem) {
  const view::ViewedRobot robot = view::viewed(load_robot("five_bar"), view::Purpose::drawing);
  ASSERT_EQ(robot.loops.size(), 1U);
  EXPECT_EQ(robot.loops[0].name, "tip");
  EXPECT_EQ(robot.frames[robot.loops[0].frames[0]].name, "tool");
  EXPECT_EQ(robot.frames[robot.loops[0].frames[1]].name, "right_end");
  const view::Posture posture = view::posture(robot, {0.3, -0.2}, {});
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(
        posture.frames[robot.loops[0].frames[0]][i][3], posture.frames[robot.loops[0].frames[1]][i][3], kRounding);
}

}  // namespace
}  // namespace robcogen::test::posture_test
