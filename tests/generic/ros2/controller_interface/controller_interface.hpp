// What the plugin of robots/ros2 uses of ros2_control and rclcpp, by the interfaces that their documentation describes
// (ROS 2 Humble), with states and commands as plain numbers.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rclcpp {
struct Time {};
struct Duration {};
struct Parameter {
  double value = 0;
  double as_double() const { return value; }
};
}  // namespace rclcpp

namespace rclcpp_lifecycle {
struct State {};
struct LifecycleNode {
  std::map<std::string, rclcpp::Parameter> parameters;
  rclcpp::Parameter get_parameter(const std::string& name) const { return parameters.at(name); }
};
}  // namespace rclcpp_lifecycle

namespace hardware_interface {
// A number of the robot's hardware.
class Loaned {
 public:
  explicit Loaned(double* value) : value_(value) {}
  double get_value() const { return *value_; }
  void set_value(double value) { *value_ = value; }

 private:
  double* value_;
};
}  // namespace hardware_interface

namespace controller_interface {

enum class CallbackReturn : std::uint8_t { SUCCESS = 97, FAILURE = 98, ERROR = 99 };
enum class return_type : std::uint8_t { OK = 0, ERROR = 1 };
enum class interface_configuration_type : std::uint8_t { ALL = 0, INDIVIDUAL = 1, NONE = 2 };
struct InterfaceConfiguration {
  interface_configuration_type type;
  std::vector<std::string> names;
};

class ControllerInterface {
 public:
  virtual ~ControllerInterface() = default;
  virtual InterfaceConfiguration command_interface_configuration() const = 0;
  virtual InterfaceConfiguration state_interface_configuration() const = 0;
  virtual CallbackReturn on_init() = 0;
  virtual CallbackReturn on_configure(const rclcpp_lifecycle::State&) { return CallbackReturn::SUCCESS; }
  virtual CallbackReturn on_activate(const rclcpp_lifecycle::State&) { return CallbackReturn::SUCCESS; }
  virtual CallbackReturn on_deactivate(const rclcpp_lifecycle::State&) { return CallbackReturn::SUCCESS; }
  virtual return_type update(const rclcpp::Time&, const rclcpp::Duration&) = 0;

  std::shared_ptr<rclcpp_lifecycle::LifecycleNode> get_node() const { return node_; }
  void assign_interfaces(
      std::vector<hardware_interface::Loaned> commands,
      std::vector<hardware_interface::Loaned> states) {
    command_interfaces_ = std::move(commands);
    state_interfaces_ = std::move(states);
  }

 protected:
  template <class T>
  void auto_declare(const std::string& name, const T& value) {
    node_->parameters.insert({name, {value}});
  }
  std::vector<hardware_interface::Loaned> command_interfaces_, state_interfaces_;

 private:
  std::shared_ptr<rclcpp_lifecycle::LifecycleNode> node_ = std::make_shared<rclcpp_lifecycle::LifecycleNode>();
};

}  // namespace controller_interface
