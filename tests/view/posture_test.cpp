// Where the parts of a robot are drawn, compared with matrix products.
#include <gtest/gtest.h>

#include "algorithm/kinematics/frame_poses.h"
#include "import/kinematics.h"
#include "robcogen/reference/kinematics.h"
#include "robots.h"
#include "symbolic/interpret.h"

namespace robcogen::test {
namespace {

using reference::Matrix;
using view::ViewedFrame;

constexpr double kRounding = 1e-13;  // m, for robots of a few metres

template <class Placed>
Matrix<double> placement(const Placed& placed) {
  const double t[3] = {placed.translation[0], placed.translation[1], placed.translation[2]};
  const double r[3] = {placed.rotation[0], placed.rotation[1], placed.rotation[2]};
  return reference::placement<double>(t, r);
}

// Returns the index of a joint's position in q; for a spherical joint, of the component after the scalar part.
int element_of(const backend::Library& library, std::size_t joint) {
  int element = static_cast<int>(joint);
  for (std::size_t j = 0; j <= joint; ++j)
    if (library.joints[j].type == backend::JointType::spherical && !library.is_follower(j)) ++element;
  return element;
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

double position(const backend::Library& library, const std::vector<double>& q, std::size_t joint) {
  if (joint < library.joints.size()) return q[static_cast<std::size_t>(element_of(library, joint))];
  if (!library.loops.empty()) {
    for (const backend::Function& f : library.functions) {
      if (f.name != "joint_positions") continue;
      const symbolic::Program& program = f.program;
      return symbolic::interpret<double>(program, {{program.inputs.front().name, q}})
          .at(program.outputs.front().name)
          .at(joint);
    }
  }
  const backend::CoupledJointData& coupled = library.coupled[joint - library.joints.size()];
  double sum = coupled.offset;
  for (std::size_t k = 0; k < q.size(); ++k) sum += coupled.factors[k] * q[k];
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
  links[static_cast<std::size_t>(link)] = pose;
  const std::vector<backend::JointData> all = library.all_joints();
  for (std::size_t j = 0; j < all.size(); ++j) {
    if (all[j].parent != link) continue;
    joints[j] = pose * placement(all[j]);
    if (library.is_follower(j)) continue;
    if (all[j].type == backend::JointType::spherical) {
      const auto k = static_cast<std::size_t>(element_of(library, j)) - 1;
      place(library, q, all[j].child, joints[j] * turn_of(q[k], {q[k + 1], q[k + 2], q[k + 3]}), links, joints);
      continue;
    }
    const double value = position(library, q, j);
    const double turn = backend::turns(all[j].type) ? value : 0;
    const double slide = all[j].type == backend::JointType::prismatic ? value : all[j].pitch * value;
    place(
        library, q, all[j].child, joints[j] * reference::rotation(2, turn) * reference::translation(0.0, 0.0, slide),
        links, joints);
  }
}

class Posture : public testing::TestWithParam<std::string> {};

TEST_P(Posture, IsThatOfProductsOfMatrices) {
  const view::ViewedRobot robot = view::viewed(load_robot(GetParam()), view::Purpose::drawing);
  const std::vector<double> q = some_positions(robot);
  const view::Posture posture = view::posture(robot, q, declared_parameters(robot));
  const backend::Library& library = robot.library;
  std::vector<Matrix<double>> links(library.links.size(), Matrix<double>(4, 4));
  std::vector<Matrix<double>> joints(library.all_joints().size(), Matrix<double>(4, 4));
  place(library, q, 0, Matrix<double>::identity(4), links, joints);
  ASSERT_EQ(posture.frames.size(), robot.frames.size());
  for (std::size_t f = 0; f < robot.frames.size(); ++f) {
    const ViewedFrame& frame = robot.frames[f];
    Matrix<double> expected = Matrix<double>::identity(4);
    if (frame.kind == ViewedFrame::Kind::joint) {
      expected = joints[static_cast<std::size_t>(frame.index)];
    } else {
      expected = links[static_cast<std::size_t>(frame.link)];
      if (frame.kind == ViewedFrame::Kind::user)
        for (const backend::FrameData& data : library.frames)
          if (data.name == frame.name) expected = expected * placement(data);
    }
    for (int r = 0; r < 4; ++r)
      for (int c = 0; c < 4; ++c)
        EXPECT_NEAR(
            posture.frames[f][static_cast<std::size_t>(r)][static_cast<std::size_t>(c)], expected(r, c), kRounding)
            << frame.name << " " << r << " " << c;
  }
  for (std::size_t l = 0; l < links.size(); ++l) {
    const auto& com = library.links[l].com;
    EXPECT_EQ(posture.masses[l], library.links[l].mass);
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
    const auto& list = robot.library.parameters;
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
}  // namespace robcogen::test
