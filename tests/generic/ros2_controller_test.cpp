// The controller of robots/ros2 on the simulated arm, both by itself and as the plugin that ros2_control would load.
#include <gtest/gtest.h>

#include <limits>

#include "../../robots/ros2/controller_plugin.cpp"
#include "../real_time/allocation_hook.h"

namespace demo_arm_control {
namespace {

using demo_arm::JointState;

constexpr double kStep = 1e-3;  // s

// Moves the arm for one step under the commands; `states` holds the position and the velocity of each joint in turn.
void advance(std::vector<double>& states, const std::vector<double>& commands) {
  JointState q, qd;
  for (int j = 0; j < 3; ++j) q[j] = states[2 * std::size_t(j)], qd[j] = states[2 * std::size_t(j) + 1];
  qd += kStep * demo_arm::forward_dynamics(q, qd, JointState(commands[0], commands[1], commands[2]));
  q += kStep * qd;
  for (int j = 0; j < 3; ++j) states[2 * std::size_t(j)] = q[j], states[2 * std::size_t(j) + 1] = qd[j];
}

ComputedTorqueController controller() {
  return ComputedTorqueController(robcogen::make_any<demo_arm::Robot>(demo_arm::reflection::robot));
}

TEST(Ros2Controller, NamesTheInterfacesOfTheJoints) {
  EXPECT_EQ(
      controller().command_interfaces(),
      (std::vector<std::string>{"shoulder_pan/effort", "shoulder_lift/effort", "elbow/effort"}));
  EXPECT_EQ(controller().state_interfaces().size(), 6U);
  EXPECT_EQ(controller().state_interfaces()[3], "shoulder_lift/velocity");
}

TEST(Ros2Controller, HoldsThenGoesToTheGoal) {
  ComputedTorqueController c = controller();
  ASSERT_TRUE(c.configure(8));
  std::vector<double> states = {0.2, 0, -0.5, 0, 0.7, 0}, commands(3);
  ASSERT_TRUE(c.activate(states));
  for (int i = 0; i < 500; ++i) {
    ASSERT_TRUE(c.update(states, commands));
    advance(states, commands);
  }
  EXPECT_NEAR(states[2], -0.5, 1e-9);
  ASSERT_TRUE(c.set_goal(std::vector<double>{0.4, -0.2, 0.3}));
  for (int i = 0; i < 3000; ++i) {
    ASSERT_TRUE(c.update(states, commands));
    advance(states, commands);
  }
  // Errors decay as (1 + 8 t) exp(-8 t).
  EXPECT_NEAR(states[0], 0.4, 1e-8);
  EXPECT_NEAR(states[2], -0.2, 1e-8);
  EXPECT_NEAR(states[4], 0.3, 1e-8);
}

TEST(Ros2Controller, KeepsToTheLimits) {
  ComputedTorqueController c = controller();
  std::vector<double> states(6), commands(3);
  ASSERT_TRUE(c.activate(states));
  EXPECT_FALSE(c.set_goal(std::vector<double>{0, 2.1, 0}));  // beyond the limit of the joint
  EXPECT_FALSE(c.set_goal(std::vector<double>{0, 0}));
  EXPECT_FALSE(c.set_goal(std::vector<double>{0, std::numeric_limits<double>::quiet_NaN(), 0}));
  ASSERT_TRUE(c.set_goal(std::vector<double>{0, 1.9, 0}));
  ASSERT_TRUE(c.configure(100));
  ASSERT_TRUE(c.update(states, commands));
  EXPECT_EQ(commands[1], 60);
}

TEST(Ros2Controller, RefusesWhatIsNotANumber) {
  ComputedTorqueController c = controller();
  EXPECT_FALSE(c.configure(0));
  EXPECT_FALSE(c.configure(std::numeric_limits<double>::infinity()));
  std::vector<double> states(6), commands(3, 7.0);
  ASSERT_TRUE(c.activate(states));
  states[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(c.activate(states));
  EXPECT_FALSE(c.update(states, commands));
  EXPECT_EQ(commands, std::vector<double>(3, 0.0));
  EXPECT_FALSE(c.update(std::vector<double>(5), commands));
}

TEST(Ros2Controller, AllocatesNothingInTheLoop) {
  ComputedTorqueController c = controller();
  std::vector<double> states(6, 0.1), commands(3);
  ASSERT_TRUE(c.activate(states));
  bool is_good = true;
  {
    const robcogen::NoAllocation during("a loop of the controller");
    for (int i = 0; i < 10; ++i) is_good = c.update(states, commands) && is_good;
  }
  EXPECT_TRUE(is_good);
}

TEST(Ros2Plugin, DrivesTheArm) {
  ControllerPlugin plugin;
  using controller_interface::CallbackReturn;
  ASSERT_EQ(plugin.on_init(), CallbackReturn::SUCCESS);
  const std::vector<std::string> names = plugin.state_interface_configuration().names;
  std::vector<double> states = {0.2, 0, -0.5, 0, 0.7, 0},
                      commands(plugin.command_interface_configuration().names.size());
  ASSERT_EQ(names.size(), states.size());
  std::vector<hardware_interface::Loaned> loaned_states, loaned_commands;
  for (double& state : states) loaned_states.emplace_back(&state);
  for (double& command : commands) loaned_commands.emplace_back(&command);
  plugin.assign_interfaces(loaned_commands, loaned_states);
  ASSERT_EQ(plugin.on_configure({}), CallbackReturn::SUCCESS);
  ASSERT_EQ(plugin.on_activate({}), CallbackReturn::SUCCESS);
  ASSERT_EQ(plugin.update({}, {}), controller_interface::return_type::OK);
  // At rest at the goal, the commands are the forces that hold the arm.
  const JointState held = demo_arm::gravity_forces(JointState(0.2, -0.5, 0.7));
  for (int j = 0; j < 3; ++j) EXPECT_NEAR(commands[std::size_t(j)], held[j], 1e-12);
  states[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(plugin.update({}, {}), controller_interface::return_type::ERROR);
  EXPECT_EQ(plugin.on_deactivate({}), CallbackReturn::SUCCESS);
  EXPECT_EQ(commands, std::vector<double>(3, 0.0));
  plugin.get_node()->parameters["frequency"].value = -1;
  EXPECT_EQ(plugin.on_configure({}), CallbackReturn::ERROR);
}

}  // namespace
}  // namespace demo_arm_control
