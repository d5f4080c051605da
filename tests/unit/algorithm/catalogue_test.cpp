// The list of a robot's functions: groups, overloads, names, inputs and outputs.
#include "algorithm/catalogue/catalogue.h"

#include <gtest/gtest.h>

#include <set>

#include "algorithm/dynamics/dynamics.h"
#include "model/descriptions.h"
#include "pass/passes.h"
#include "symbolic/interpret.h"
#include "symbolic/text.h"
#include "symbolic/verify.h"

namespace robcogen::algorithm::catalogue_test {
namespace {

model::KinematicTree robot(bool floating) {
  model::Description d = model::test::two_links();
  d.floating_base = floating;
  Diagnostics diagnostics;
  const auto tree = model::build(d, diagnostics);
  EXPECT_TRUE(tree) << diagnostics.render();
  return *tree;
}

std::vector<symbolic::Function> all(const model::KinematicTree& tree) {
  std::vector<symbolic::Function> list;
  for (const std::string& group : groups())
    for (symbolic::Function& f : functions(tree, model::all_desired(tree), group)) list.push_back(std::move(f));
  return list;
}

std::string signature(const symbolic::Program& p) {
  std::string text = p.name + ":";
  for (const symbolic::InputArray& array : p.inputs) text += " " + array.name;
  text += " ->";
  for (const symbolic::OutputArray& array : p.outputs)
    text += " " + array.name + " " + std::to_string(array.rows) + "x" + std::to_string(array.columns);
  return text;
}

std::vector<std::string> signatures(const model::KinematicTree& tree, const std::string& group) {
  std::vector<std::string> list;
  model::DesiredTransforms desired = model::all_desired(tree);
  desired.jacobians = model::default_desired(tree).jacobians;
  for (const symbolic::Function& f : functions(tree, desired, group)) list.push_back(signature(f.program));
  return list;
}

TEST(RobotPrograms, OfAFixedBase) {
  const model::KinematicTree tree = robot(false);
  using List = std::vector<std::string>;
  EXPECT_EQ(
      signatures(tree, "inverse_dynamics"),
      (List{
          "inverse_dynamics: q qd qdd -> tau 2x1", "inverse_dynamics_gravity: q qd qdd gravity -> tau 2x1",
          "inverse_dynamics_external: q qd qdd gravity external -> tau 2x1"}));
  EXPECT_EQ(
      signatures(tree, "bias_forces"),
      (List{
          "bias_forces: q qd -> tau 2x1", "bias_forces_gravity: q qd gravity -> tau 2x1",
          "bias_forces_external: q qd gravity external -> tau 2x1", "gravity_forces: q -> tau 2x1",
          "gravity_forces_gravity: q gravity -> tau 2x1", "coriolis_forces: q qd -> tau 2x1"}));
  EXPECT_EQ(
      signatures(tree, "forward_dynamics"),
      (List{
          "forward_dynamics: q qd tau -> qdd 2x1", "forward_dynamics_gravity: q qd tau gravity -> qdd 2x1",
          "forward_dynamics_external: q qd tau gravity external -> qdd 2x1"}));
  EXPECT_EQ(signatures(tree, "joint_space_inertia"), (List{"joint_space_inertia: q -> H 2x2"}));
  EXPECT_EQ(
      signatures(tree, "joint_space_inertia_factor"),
      (List{
          "joint_space_inertia_factor: q -> L 2x2 inverse_diagonal 2x1",
          "inertia_factor_solve: L inverse_diagonal x -> y 2x1",
          "inertia_factor_inverse: L inverse_diagonal -> inverse 2x2",
          "inertia_factor_inverse_L: L inverse_diagonal -> inverse 2x2"}));
  EXPECT_EQ(signatures(tree, "coriolis_matrix"), (List{"coriolis_matrix: q qd -> C 2x2"}));
  EXPECT_EQ(
      signatures(tree, "inverse_dynamics_derivatives"),
      (List{
          "inverse_dynamics_derivatives: q qd qdd -> tau 2x1 d_q 2x2 d_qd 2x2 d_qdd 2x2",
          "inverse_dynamics_derivatives_gravity: q qd qdd gravity -> tau 2x1 d_q 2x2 d_qd 2x2 d_qdd 2x2",
          "inverse_dynamics_derivatives_external: q qd qdd gravity external -> tau 2x1 d_q 2x2 d_qd 2x2 d_qdd 2x2",
          "gravity_forces_derivative: q -> d_q 2x2", "gravity_forces_derivative_gravity: q gravity -> d_q 2x2"}));
  EXPECT_EQ(
      signatures(tree, "inverse_dynamics_gradient"),
      (List{
          "inverse_dynamics_gradient: q qd qdd weights -> tau 2x1 d_q 2x1 d_qd 2x1 d_qdd 2x1",
          "inverse_dynamics_gradient_gravity: q qd qdd weights gravity -> tau 2x1 d_q 2x1 d_qd 2x1 d_qdd 2x1",
          "inverse_dynamics_gradient_external: q qd qdd weights gravity external -> tau 2x1 d_q 2x1 d_qd 2x1 d_qdd "
          "2x1"}));
  EXPECT_EQ(
      signatures(tree, "forward_dynamics_derivatives"),
      (List{
          "forward_dynamics_derivatives: q qd tau -> qdd 2x1 d_q 2x2 d_qd 2x2 d_tau 2x2",
          "forward_dynamics_derivatives_gravity: q qd tau gravity -> qdd 2x1 d_q 2x2 d_qd 2x2 d_tau 2x2",
          "forward_dynamics_derivatives_external: q qd tau gravity external -> qdd 2x1 d_q 2x2 d_qd 2x2 d_tau 2x2"}));
  EXPECT_EQ(
      signatures(tree, "centroidal"), (List{
                                          "center_of_mass: q -> com 3x1", "center_of_mass_jacobian: q -> J 3x2",
                                          "centroidal_momentum_matrix: q -> A 6x2"}));
  EXPECT_EQ(
      signatures(tree, "energy"), (List{
                                      "kinetic_energy: q qd -> T 1x1", "potential_energy: q -> V 1x1",
                                      "potential_energy_gravity: q gravity -> V 1x1"}));
  EXPECT_EQ(
      signatures(tree, "regressor"),
      (List{
          "regressor: q qd qdd -> Y 2x20", "regressor_gravity: q qd qdd gravity -> Y 2x20",
          "inertial_parameters: -> pi 20x1", "drive_regressor: q qd qdd -> Y 2x10", "drive_parameters: -> pi 10x1"}));
  EXPECT_EQ(
      signatures(tree, "base_regressor"),
      (List{
          "base_regressor: q qd qdd -> Y 2x2", "base_parameters: inertial_parameters -> beta 2x1",
          "base_regressor_any_gravity: q qd qdd gravity -> Y 2x6",
          "base_parameters_any_gravity: inertial_parameters -> beta 6x1"}));
  EXPECT_EQ(
      signatures(tree, "energy_regressor"),
      (List{"energy_regressor: q qd -> Y 2x20", "energy_regressor_gravity: q qd gravity -> Y 2x20"}));
  EXPECT_EQ(
      signatures(tree, "slotine_li_regressor"),
      (List{
          "slotine_li_regressor: q qd qd_r qdd_r -> Y 2x20",
          "slotine_li_regressor_gravity: q qd qd_r qdd_r gravity -> Y 2x20"}));
}

TEST(RobotPrograms, OfAFloatingBase) {
  const model::KinematicTree tree = robot(true);
  using List = std::vector<std::string>;
  EXPECT_EQ(
      signatures(tree, "inverse_dynamics"),
      (List{
          "inverse_dynamics: q qd qdd base_velocity gravity -> tau 2x1 base_acceleration 6x1",
          "inverse_dynamics_external: q qd qdd base_velocity gravity external -> tau 2x1 base_acceleration 6x1",
          "inverse_dynamics_fully_actuated: q qd qdd base_velocity base_acceleration gravity -> tau 2x1 base_wrench "
          "6x1",
          "inverse_dynamics_fully_actuated_external: q qd qdd base_velocity base_acceleration gravity external -> tau "
          "2x1 base_wrench 6x1"}));
  EXPECT_EQ(
      signatures(tree, "forward_dynamics"),
      (List{
          "forward_dynamics: q qd tau base_velocity gravity -> qdd 2x1 base_acceleration 6x1",
          "forward_dynamics_external: q qd tau base_velocity gravity external -> qdd 2x1 base_acceleration 6x1"}));
  EXPECT_EQ(signatures(tree, "joint_space_inertia"), (List{"joint_space_inertia: q -> H 8x8"}));
  EXPECT_EQ(
      signatures(tree, "joint_space_inertia_factor"),
      (List{
          "joint_space_inertia_factor: q -> L 8x8 inverse_diagonal 8x1",
          "inertia_factor_solve: L inverse_diagonal x -> y 8x1",
          "inertia_factor_inverse: L inverse_diagonal -> inverse 8x8",
          "inertia_factor_inverse_L: L inverse_diagonal -> inverse 8x8"}));
  EXPECT_EQ(signatures(tree, "coriolis_matrix"), (List{"coriolis_matrix: q qd base_velocity -> C 8x8"}));
  const std::string blocks = " d_q 8x2 d_qd 8x2 d_qdd 8x2 d_base_rotation 8x3 d_base_velocity 8x6";
  const std::string free = " -> tau 2x1 base_acceleration 6x1" + blocks;
  const std::string held = " -> tau 2x1 base_wrench 6x1" + blocks + " d_base_acceleration 8x6";
  EXPECT_EQ(
      signatures(tree, "inverse_dynamics_derivatives"),
      (List{
          "inverse_dynamics_derivatives: q qd qdd base_velocity gravity" + free,
          "inverse_dynamics_derivatives_external: q qd qdd base_velocity gravity external" + free,
          "inverse_dynamics_fully_actuated_derivatives: q qd qdd base_velocity base_acceleration gravity" + held,
          "inverse_dynamics_fully_actuated_derivatives_external: q qd qdd base_velocity base_acceleration gravity "
          "external" +
              held,
          "gravity_forces_derivative: q gravity -> d_q 8x2 d_base_rotation 8x3"}));
  const std::string moved =
      " -> qdd 2x1 base_acceleration 6x1 d_q 8x2 d_qd 8x2 d_tau 8x2 d_base_rotation 8x3 d_base_velocity 8x6";
  EXPECT_EQ(
      signatures(tree, "forward_dynamics_derivatives"),
      (List{
          "forward_dynamics_derivatives: q qd tau base_velocity gravity" + moved,
          "forward_dynamics_derivatives_external: q qd tau base_velocity gravity external" + moved}));
  EXPECT_EQ(
      signatures(tree, "centroidal"), (List{
                                          "center_of_mass: q -> com 3x1", "center_of_mass_jacobian: q -> J 3x8",
                                          "centroidal_momentum_matrix: q -> A 6x8"}));
  EXPECT_EQ(
      signatures(tree, "energy"),
      (List{"kinetic_energy: q qd base_velocity -> T 1x1", "potential_energy: q gravity -> V 1x1"}));
  const std::string moving = "q qd qdd base_velocity base_acceleration";
  EXPECT_EQ(
      signatures(tree, "regressor"),
      (List{
          "regressor: " + moving + " gravity -> Y 8x30", "inertial_parameters: -> pi 30x1",
          "drive_regressor: " + moving + " -> Y 8x10", "drive_parameters: -> pi 10x1"}));
  EXPECT_EQ(
      signatures(tree, "base_regressor"),
      (List{"base_regressor: " + moving + " gravity -> Y 8x24", "base_parameters: inertial_parameters -> beta 24x1"}));
  EXPECT_EQ(signatures(tree, "energy_regressor"), (List{"energy_regressor: q qd base_velocity gravity -> Y 2x30"}));
  EXPECT_EQ(
      signatures(tree, "slotine_li_regressor"),
      (List{"slotine_li_regressor: q qd qd_r qdd_r base_velocity base_velocity_r base_acceleration_r gravity -> Y "
            "8x30"}));
}

class EveryProgram : public testing::TestWithParam<bool> {};

TEST_P(EveryProgram, IsSoundUniqueAndExplained) {
  const model::KinematicTree tree = robot(GetParam());
  std::set<std::string> names;
  for (const symbolic::Function& f : all(tree)) {
    EXPECT_EQ(verify(f.program), "") << f.program.name;
    EXPECT_TRUE(names.insert(f.program.name).second) << f.program.name;
    EXPECT_FALSE(f.summary.empty()) << f.program.name;
  }
}

// A program can be stored as text: the printed text reads back as the traced program.
TEST_P(EveryProgram, ReadsBackFromText) {
  for (const symbolic::Function& f : all(robot(GetParam()))) {
    std::string error;
    const auto back = symbolic::parse(print(f.program), error);
    ASSERT_TRUE(back) << error;
    EXPECT_EQ(print(*back), print(f.program));
  }
}

TEST_P(EveryProgram, ComputesTheSameAfterThePasses) {
  for (const symbolic::Function& f : all(robot(GetParam()))) {
    symbolic::Arrays<double> inputs;
    double x = 0;
    for (const symbolic::InputArray& array : f.program.inputs)
      for (std::size_t k = 0; k < array.elements.size(); ++k) inputs[array.name].push_back(std::sin(x += 1.7));
    const auto before = symbolic::interpret<double>(f.program, inputs);
    const auto after = symbolic::interpret<double>(pass::run(f.program), inputs);
    for (const auto& [name, values] : before)
      for (std::size_t k = 0; k < values.size(); ++k)
        EXPECT_NEAR(after.at(name)[k], values[k], 1e-11) << f.program.name << " " << name << k;
  }
}

INSTANTIATE_TEST_SUITE_P(, EveryProgram, testing::Bool(), [](const auto& base) {
  return base.param ? "floating" : "fixed";
});

TEST(RobotPrograms, OverloadsAgree) {
  const model::KinematicTree tree = robot(false);
  const auto list = functions(tree, {}, "inverse_dynamics");
  const symbolic::Arrays<double> state{{"q", {0.3, -0.7}}, {"qd", {1.1, 0.2}}, {"qdd", {-0.4, 2.0}}};
  symbolic::Arrays<double> with_gravity = state;
  with_gravity["gravity"] = {0, 0, -kStandardGravity};
  const auto standard = symbolic::interpret<double>(list[0].program, state).at("tau");
  const auto gravity = symbolic::interpret<double>(list[1].program, with_gravity).at("tau");
  const auto external = symbolic::interpret<double>(list[2].program, with_gravity).at("tau");
  for (std::size_t k = 0; k < standard.size(); ++k) {
    EXPECT_NEAR(gravity[k], standard[k], 1e-13);
    EXPECT_NEAR(external[k], standard[k], 1e-13);
  }
}

TEST(RobotPrograms, OfFrames) {
  const model::KinematicTree tree = robot(false);
  using List = std::vector<std::string>;
  EXPECT_EQ(signatures(tree, "jacobians"), (List{"fr_base_J_fr_two: q -> J 6x2"}));
  EXPECT_EQ(
      signatures(tree, "jacobian_references"),
      (List{"in_target_fr_base_J_fr_two: q -> J 6x2", "spatial_fr_base_J_fr_two: q -> J 6x2"}));
  EXPECT_EQ(
      signatures(tree, "jacobians_with_base"),
      (List{"with_base_fr_base_J_fr_two: q -> J 6x2", "with_base_fr_base_bias_fr_two: q qd -> a 6x1"}));
  EXPECT_EQ(
      signatures(tree, "jacobian_derivatives"),
      (List{"fr_base_Jd_fr_two: q qd -> Jd 6x2", "fr_base_Jd_qd_fr_two: q qd -> a 6x1"}));
  EXPECT_EQ(signatures(tree, "velocities"), (List{"fr_base_V_fr_two: q qd -> V 6x1"}));
  EXPECT_EQ(signatures(tree, "accelerations"), (List{"fr_base_A_fr_two: q qd qdd -> A 6x1"}));
  EXPECT_EQ(
      signatures(tree, "world"),
      (List{
          "in_world_X_fr_one: q base_pose -> X 4x4", "in_world_X_fr_two: q base_pose -> X 4x4",
          "in_world_position_fr_one: q base_pose -> p 3x1", "in_world_position_fr_two: q base_pose -> p 3x1",
          "in_world_velocity_fr_two: q qd base_pose -> v 6x1",
          "in_world_acceleration_fr_two: q qd qdd base_pose -> a 6x1", "in_world_J_fr_two: q base_pose -> J 6x2",
          "in_world_bias_fr_two: q qd base_pose -> a 6x1", "world_in_target_velocity_fr_two: q qd -> v 6x1",
          "world_in_target_acceleration_fr_two: q qd qdd -> a 6x1", "world_in_target_J_fr_two: q -> J 6x2",
          "world_in_target_bias_fr_two: q qd -> a 6x1"}));
}

TEST(RobotPrograms, OfContacts) {
  using List = std::vector<std::string>;
  const auto of = [](bool floating, const std::string& group) {
    const model::KinematicTree tree = robot(floating);
    model::DesiredTransforms desired;
    EXPECT_TRUE(functions(tree, desired, group).empty());
    desired.contacts = {{*tree.find_frame("fr_one")}, {*tree.find_frame("fr_two"), true}};
    std::vector<std::string> list;
    for (const symbolic::Function& f : functions(tree, desired, group)) list.push_back(signature(f.program));
    return list;
  };
  const List fixed = of(false, "contacts"), floating = of(true, "contacts");
  ASSERT_EQ(fixed.size(), 11U);
  EXPECT_EQ(
      List(fixed.begin(), fixed.begin() + 5),
      (List{
          "contact_jacobian: q -> J 9x2", "contact_velocity: q qd -> velocity 9x1", "contact_bias: q qd -> bias 9x1",
          "inverse_contact_inertia: q -> W 9x9",
          "constrained_forward_dynamics: q qd tau contact_acceleration active compliance -> qdd 2x1 contact_wrenches "
          "9x1"}));
  EXPECT_EQ(
      List(floating.begin() + 3, floating.end()),
      (List{
          "inverse_contact_inertia: q -> W 9x9",
          "constrained_forward_dynamics: q qd tau base_velocity contact_acceleration active compliance gravity -> qdd "
          "2x1 base_acceleration 6x1 contact_wrenches 9x1",
          "constrained_forward_dynamics_external: q qd tau base_velocity contact_acceleration active compliance "
          "gravity "
          "external -> qdd 2x1 base_acceleration 6x1 contact_wrenches 9x1",
          "impact: q qd base_velocity restitution active compliance -> qd_after 2x1 base_velocity_after 6x1 "
          "contact_impulses 9x1",
          "inverse_dynamics_with_contacts: q qd qdd base_velocity base_acceleration contact_wrenches gravity -> tau "
          "2x1 "
          "base_wrench 6x1",
          "inverse_dynamics_with_contacts_external: q qd qdd base_velocity base_acceleration contact_wrenches gravity "
          "external -> tau 2x1 base_wrench 6x1",
          "constrained_inverse_dynamics: q qd qdd base_velocity base_acceleration weights regularization gravity -> "
          "tau "
          "2x1 contact_wrenches 9x1 base_wrench 6x1",
          "constrained_inverse_dynamics_external: q qd qdd base_velocity base_acceleration weights regularization "
          "gravity external -> tau 2x1 contact_wrenches 9x1 base_wrench 6x1",
          "minimum_torque_inverse_dynamics: q qd qdd base_velocity base_acceleration weights torque_weights "
          "regularization gravity -> tau 2x1 contact_wrenches 9x1 base_wrench 6x1",
          "minimum_torque_inverse_dynamics_external: q qd qdd base_velocity base_acceleration weights torque_weights "
          "regularization gravity external -> tau 2x1 contact_wrenches 9x1 base_wrench 6x1"}));
  EXPECT_EQ(
      of(true, "operational_space"),
      List{"operational_space: q active compliance -> inertia 9x9 inverse 8x9 projector 8x8"});
  EXPECT_EQ(
      of(true, "constrained_forward_dynamics_derivatives"),
      (List{
          "constrained_forward_dynamics_derivatives: q qd tau base_velocity contact_acceleration active compliance "
          "gravity -> qdd 2x1 base_acceleration 6x1 contact_wrenches 9x1 d_q 17x2 d_qd 17x2 d_tau 17x2 d_base_rotation "
          "17x3 d_base_velocity 17x6 d_contact_acceleration 17x9",
          "constrained_forward_dynamics_derivatives_external: q qd tau base_velocity contact_acceleration active "
          "compliance gravity external -> qdd 2x1 base_acceleration 6x1 contact_wrenches 9x1 d_q 17x2 d_qd 17x2 d_tau "
          "17x2 d_base_rotation 17x3 d_base_velocity 17x6 d_contact_acceleration 17x9",
          "impact_derivatives: q qd base_velocity restitution active compliance -> qd_after 2x1 base_velocity_after "
          "6x1 "
          "contact_impulses 9x1 d_q 17x2 d_qd 17x2 d_base_velocity 17x6 d_restitution 17x2"}));
}

TEST(RobotPrograms, DefaultGroupsAreGroupsInTheirOrder) {
  std::size_t found = 0;
  for (const std::string& group : groups())
    if (found < default_groups().size() && default_groups()[found] == group) ++found;
  EXPECT_EQ(found, default_groups().size());
}

TEST(RobotPrograms, AnUnknownGroupIsEmpty) {
  EXPECT_TRUE(functions(robot(false), {}, "dynamics").empty());
}

TEST(RobotPrograms, ParametersAreTheFirstInput) {
  model::KinematicTree tree = robot(false);
  tree.parameters = {{"m", model::ParameterKind::inertial, {}, {}}};
  tree.links[1].inertia->mass = model::Quantity::parameter(0);
  for (const symbolic::Function& f : all(tree)) {
    ASSERT_FALSE(f.program.inputs.empty());
    if (f.program.inputs[0].role == symbolic::Role::inertia_factor) continue;  // it includes the parameters
    EXPECT_EQ(f.program.inputs[0].role, symbolic::Role::parameters) << f.program.name;
    EXPECT_EQ(f.program.inputs[0].elements, std::vector<std::string>{"m"});
  }
}

}  // namespace
}  // namespace robcogen::algorithm::catalogue_test
