// Base parameters, compared with regrouping by hand.
#include "algorithm/formulation/base_parameters.h"

#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/traced_robot.h"
#include "hand_robots.h"

namespace robcogen::algorithm::base_parameters_test {
namespace {

using namespace test;

std::vector<double> numbers(const MassProperties& m) {
  std::vector<double> list;
  const auto append = [&](const Expression& e) { list.push_back(e.is_zero() ? 0 : e.number().value()); };
  append(m.mass);
  for (std::size_t i = 0; i < 3; ++i) append(m.first_moment[i]);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j) append(m.pseudo_inertia[i][j]);
  return list;
}

std::vector<MassProperties> regrouped_masses(Trace& trace) {
  const auto q = trace.joint_input("q", symbolic::Role::joint_position);
  const TracedRobot robot(trace, q, Formulation{.base_parameters = true});
  return robot.masses;
}

// The second rod's joint axis passes through the end of the first rod, so the second mass can be moved there; the fixed
// base takes the rest.
TEST(Regroup, MassOfTheSecondRodGoesToTheElbow) {
  const model::KinematicTree tree = two_rods();
  Trace trace(tree);
  const std::vector<MassProperties> masses = regrouped_masses(trace);
  expect_near(numbers(masses[1]), {0, (kM1 + kM2) * kL1, 0, 0, (kM1 + kM2) * kL1 * kL1, 0, 0, 0, 0, 0});
  expect_near(numbers(masses[2]), {0, kM2 * kL2, 0, 0, kM2 * kL2 * kL2, 0, 0, 0, 0, 0});
}

// A bead that slides does not turn relative to the ball, so its moments are added to the ball's.
TEST(Regroup, PseudoInertiaOfASliderGoesToTheParent) {
  model::Description d;
  d.name = "slider";
  d.floating_base = true;
  d.base = model::test::link("ball", {{"bead", "wire", {}, {}}});
  d.base.inertia = model::test::ball(kBall, kBallMoment);
  d.links = {model::test::link("bead")};
  d.links[0].inertia = point_mass_on_x(kBead, 0.5);
  model::Placement upright;
  upright.rotation[1] = model::test::pi(1, 2);  // the slider's x axis is the ball's -z axis
  d.joints = {model::test::joint("wire", model::JointType::prismatic, upright)};
  const model::KinematicTree tree = built(d);
  Trace trace(tree);
  const std::vector<MassProperties> masses = regrouped_masses(trace);
  expect_near(numbers(masses[1]), {kBead, kBead * 0.5, 0, 0, 0, 0, 0, 0, 0, 0});
  const double s = kBallMoment / 2;
  expect_near(numbers(masses[0]), {kBall, 0, 0, 0, s, 0, 0, s, 0, s + kBead * 0.25});
}

TEST(Regroup, SavesOperations) {
  const auto size = [](const Formulation& formulation) {
    return newton_euler(two_rods(), "f", Loads::gravity, formulation).statements.size();
  };
  EXPECT_LT(size({.base_parameters = true}), size({.base_parameters = false}));
}

TEST(Formulation, IsTakenOutOfAListOfNames) {
  std::vector<std::string> names{"sink", "base-parameters", "canonical"};
  EXPECT_TRUE(take_formulation(names).base_parameters);
  EXPECT_EQ(names, (std::vector<std::string>{"sink", "canonical"}));
  EXPECT_FALSE(take_formulation(names).base_parameters);
}

}  // namespace
}  // namespace robcogen::algorithm::base_parameters_test
