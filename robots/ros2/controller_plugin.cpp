// The controller as a plugin of ros2_control.
#include <demo_arm/demo_arm.h>
#include <demo_arm/reflection.h>

#include <controller_interface/controller_interface.hpp>
#include <pluginlib/class_list_macros.hpp>

#include "computed_torque_controller.h"

namespace demo_arm_control {

using controller_interface::CallbackReturn;
using controller_interface::interface_configuration_type;
using controller_interface::InterfaceConfiguration;
using controller_interface::return_type;

class ControllerPlugin : public controller_interface::ControllerInterface {
 public:
  InterfaceConfiguration command_interface_configuration() const override {
    return {interface_configuration_type::INDIVIDUAL, controller_.command_interfaces()};
  }
  InterfaceConfiguration state_interface_configuration() const override {
    return {interface_configuration_type::INDIVIDUAL, controller_.state_interfaces()};
  }

  CallbackReturn on_init() override {
    auto_declare<double>("frequency", 10.0);
    states_.resize(controller_.state_interfaces().size());
    commands_.resize(controller_.command_interfaces().size());
    return CallbackReturn::SUCCESS;
  }
  CallbackReturn on_configure(const rclcpp_lifecycle::State&) override {
    return answer(controller_.configure(get_node()->get_parameter("frequency").as_double()));
  }
  CallbackReturn on_activate(const rclcpp_lifecycle::State&) override {
    read();
    return answer(controller_.activate(states_));
  }
  CallbackReturn on_deactivate(const rclcpp_lifecycle::State&) override {
    for (auto& interface : command_interfaces_) interface.set_value(0.0);
    return CallbackReturn::SUCCESS;
  }

  return_type update(const rclcpp::Time&, const rclcpp::Duration&) override {
    read();
    const bool is_good = controller_.update(states_, commands_);
    for (std::size_t j = 0; j < commands_.size(); ++j) command_interfaces_[j].set_value(commands_[j]);
    return is_good ? return_type::OK : return_type::ERROR;
  }

 private:
  ComputedTorqueController controller_{robcogen::make_any<demo_arm::Robot>(demo_arm::reflection::robot)};
  std::vector<double> states_, commands_;

  static CallbackReturn answer(bool is_good) { return is_good ? CallbackReturn::SUCCESS : CallbackReturn::ERROR; }
  void read() {
    for (std::size_t i = 0; i < states_.size(); ++i) states_[i] = state_interfaces_[i].get_value();
  }
};

}  // namespace demo_arm_control

PLUGINLIB_EXPORT_CLASS(demo_arm_control::ControllerPlugin, controller_interface::ControllerInterface)
