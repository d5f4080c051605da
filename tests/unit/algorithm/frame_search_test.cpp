// The link frames that the search finds are cheaper than the model's and give the same results.
#include "algorithm/search/frame_search.h"

#include <cmath>
#include <map>

#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/traced_robot.h"
#include "random_robots.h"

namespace robcogen::algorithm::frame_search_test {
namespace {

using namespace test;

double value(const model::Quantity& q) {
  return q.number().value();
}

symbolic::Program inertia(const model::KinematicTree& tree, const Formulation& formulation) {
  return joint_space_inertia(tree, "H", formulation);
}

const TraceOf kInertia = trace_joint_space_inertia;

// A planar arm whose second rod is given in axes that do not pass through its mass.
model::KinematicTree crooked_arm() {
  model::Description d;
  d.name = "crooked";
  d.base = model::test::link("base", {{"upper", "shoulder", {}, {}}});
  d.links = {model::test::link("upper", {{"lower", "elbow", {}, {}}}), model::test::link("lower")};
  d.links[0].inertia = point_mass_on_x(1.0, 0.5);
  d.links[1].inertia = point_mass_on_x(1.0, 0.5);
  d.links[1].inertia->com[1] = model::Quantity(0.25);
  d.links[1].inertia->ixy = model::Quantity(0.5 * 0.25);
  d.links[1].inertia->ixx = model::Quantity(0.25 * 0.25);
  d.links[1].inertia->izz = model::Quantity(0.25 + 0.25 * 0.25);
  model::Placement elbow;
  elbow.translation[0] = model::Quantity(1.0);
  d.joints = {
      model::test::joint("shoulder", model::JointType::revolute, {}),
      model::test::joint("elbow", model::JointType::revolute, elbow)};
  return built(d);
}

TEST(FrameSearch, PutsTheAxisThroughTheMass) {
  const model::KinematicTree tree = crooked_arm();
  const LinkFrames frames = cheap_frames(tree, {.effort = 1}, kInertia);
  ASSERT_EQ(frames.size(), 2U);
  const double turn = value(frames[1].turn);
  EXPECT_NEAR(std::remainder(turn - std::atan2(0.25, 0.5), std::numbers::pi / 2), 0.0, 1e-12) << turn;
  EXPECT_LT(symbolic::work(inertia(tree, {.frames = frames})), symbolic::work(inertia(tree, {})));
}

TEST(FrameSearch, FindsTheSameAgain) {
  const model::KinematicTree tree = crooked_arm();
  const auto text = [&] { return description(tree, cheap_frames(tree, {.effort = 1}, kInertia)); };
  EXPECT_EQ(text(), text());
  EXPECT_NE(text(), "");
}

TEST(FrameSearch, LeavesFramesWithoutEffort) {
  const model::KinematicTree tree = crooked_arm();
  EXPECT_TRUE(cheap_frames(tree, {}, kInertia).empty());
  EXPECT_TRUE(cheap_frames(tree, {.choose_frames = false, .turn_inertia = false, .effort = 1}, kInertia).empty());
  for (const LinkFrame& frame : cheap_frames(tree, {.choose_frames = false, .effort = 1}, kInertia))
    EXPECT_TRUE(frame.turn.is_zero() && frame.slide.is_zero());
  for (const LinkFrame& frame : cheap_frames(tree, {.turn_inertia = false, .effort = 1}, kInertia))
    EXPECT_TRUE(frame.turns_with_joint);
}

symbolic::Program inverse_dynamics(const model::KinematicTree& tree, const Formulation& formulation) {
  return newton_euler(tree, "tau", Loads::standard_gravity, formulation);
}

void trace_inverse_dynamics(Trace& trace, const Formulation& formulation) {
  trace_newton_euler(trace, Loads::standard_gravity, formulation);
}

class SearchOf : public testing::TestWithParam<int> {
 protected:
  static constexpr int kJoints = 4;
  Numbers n{static_cast<unsigned>(GetParam())};
  model::KinematicTree tree = random_robot(n, kJoints, true);
  symbolic::Arrays<double> state;

  void SetUp() override {
    for (const char* array : {"q", "qd", "qdd"})
      for (int j = 0; j < kJoints; ++j) state[array].push_back(n.real());
  }
};

// Every joint of a chain affects the whole chain, so no step of the search increases its cost.
TEST_P(SearchOf, FramesCostNoMoreThanTheModels) {
  using Function = symbolic::Program (*)(const model::KinematicTree&, const Formulation&);
  const std::vector<std::pair<TraceOf, Function>> functions = {
      {kInertia, inertia}, {trace_inverse_dynamics, inverse_dynamics}};
  for (const auto& [trace, function] : functions) {
    const LinkFrames frames = cheap_frames(tree, {.effort = 1}, trace);
    const symbolic::Program found = function(tree, {.frames = frames, .is_draft = true});
    const symbolic::Program of_model = function(tree, {.frames = LinkFrames(kJoints), .is_draft = true});
    EXPECT_LE(symbolic::work(found), symbolic::work(of_model));
  }
}

TEST_P(SearchOf, FramesKeepTheResults) {
  const LinkFrames frames = cheap_frames(tree, {.effort = 1}, trace_inverse_dynamics);
  const std::vector<double> expected = run(inverse_dynamics(tree, plain_formulation()), state);
  const std::vector<double> found = run(inverse_dynamics(tree, {.frames = frames}), state);
  double size = 0;  // largest force: some thousand newtons at velocities of a few rad/s
  for (const double force : expected) size = std::max(size, std::abs(force));
  for (std::size_t j = 0; j < expected.size(); ++j) EXPECT_NEAR(found[j], expected[j], 1e-12 * size) << j;
}

INSTANTIATE_TEST_SUITE_P(, SearchOf, testing::Range(0, 8));

// Crooked shanks; the axis through the mass has the same angle in both, or the opposite one.
TEST(FrameSearch, LimbsOfOneShapeGetCorrespondingFrames) {
  const model::KinematicTree tree = two_legs(0.125, -0.125);
  const LinkFrames frames = cheap_frames(tree, {.effort = 1}, kInertia);
  const auto frame = [&](const char* joint) { return frames.at(static_cast<std::size_t>(*tree.find_joint(joint))); };
  EXPECT_NE(value(frame("L_knee").turn), 0.0);
  EXPECT_NEAR(value(frame("L_knee").turn), -value(frame("R_knee").turn), kByHand);
  for (const char* joint : {"hip", "knee"})
    EXPECT_EQ(
        frame((std::string("L_") + joint).c_str()).turns_with_joint,
        frame((std::string("R_") + joint).c_str()).turns_with_joint);
}

// Returns which numbers of a joint's child vanish in these frames: offset, slide, moments.
std::vector<bool> vanishing(const model::KinematicTree& tree, const LinkFrames& frames, const char* joint) {
  Formulation formulation;
  formulation.frames = frames;
  for (LinkFrame& frame : formulation.frames) frame.turns_with_joint = true;
  Trace trace(tree);
  const TracedRobot robot(trace, trace.joint_input("q", symbolic::Role::joint_position), formulation);
  const auto j = static_cast<std::size_t>(*tree.find_joint(joint));
  const Pose& pose = robot.poses[j];
  const MassProperties& mass = robot.masses[static_cast<std::size_t>(tree.joints[j].child)];
  std::vector<Expression> numbers(pose.offset.element.begin(), pose.offset.element.end());
  numbers.push_back(pose.slide);
  numbers.insert(numbers.end(), mass.first_moment.element.begin(), mass.first_moment.element.end());
  for (const Vector3& row : mass.pseudo_inertia.row)
    numbers.insert(numbers.end(), row.element.begin(), row.element.end());
  std::vector<bool> result;
  for (const Expression& e : numbers) result.push_back(e.is_constant() && std::abs(e.number().value()) < 1e-12);
  return result;
}

// The second leg is mirrored, or its shank has another centre of mass, or differs by a rounding in the document.
TEST(FrameSearch, TheSameNumbersVanishInCongruentLimbs) {
  for (const double right_y : {-0.125, 0.375, 0.1250004, -0.1249997}) {
    const model::KinematicTree tree = two_legs(0.125, right_y);
    for (const TraceOf& trace : {kInertia, TraceOf(trace_inverse_dynamics)}) {
      const LinkFrames frames = cheap_frames(tree, {.effort = 1}, trace);
      EXPECT_NE(description(tree, frames), "") << right_y;
      EXPECT_EQ(vanishing(tree, frames, "L_hip"), vanishing(tree, frames, "R_hip")) << right_y;
      EXPECT_EQ(vanishing(tree, frames, "L_knee"), vanishing(tree, frames, "R_knee")) << right_y;
    }
  }
}

// The second leg takes the steps of the first; it is traced once, to find out which leg costs more.
TEST(FrameSearch, SearchesCongruentLimbsOnce) {
  const model::KinematicTree tree = two_legs(0.125, -0.125);
  std::map<char, int> traces;  // by the first letter of the joints
  cheap_frames(tree, {.effort = 1}, [&](Trace& trace, const Formulation& formulation) {
    if (trace.tree.joints.size() < tree.joints.size()) ++traces[trace.tree.joints.front().name[0]];
    trace_joint_space_inertia(trace, formulation);
  });
  EXPECT_GE(traces['L'], 10);
  EXPECT_EQ(traces['R'], 1);
}

}  // namespace
}  // namespace robcogen::algorithm::frame_search_test
