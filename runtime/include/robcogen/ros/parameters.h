// Parameters of a ROS node for a plugin: `prefix.name`, of the expected type.
#pragma once

#include <rclcpp/node_interfaces/node_parameters_interface.hpp>
#include <rclcpp/parameter.hpp>

#include <memory>
#include <string>
#include <vector>

namespace robcogen::ros {

// Reads parameters; an absent one, or a node that is a null pointer, gives the fallback. A value of another type does
// so too, and is then described by `problem`.
class Parameters {
 public:
  using Node = std::shared_ptr<const rclcpp::node_interfaces::NodeParametersInterface>;

  Parameters(Node node, const std::string& prefix)
      : node_(std::move(node)), prefix_(prefix.empty() ? "" : prefix + ".") {}

  // The first value of another type; an empty text if there is none.
  const std::string& problem() const noexcept { return problem_; }

  bool has(const std::string& name) const { return node_ && node_->has_parameter(prefix_ + name); }

  std::string text(const std::string& name) {
    rclcpp::Parameter parameter;
    if (!get(name, parameter)) return "";
    if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_STRING) return parameter.as_string();
    refuse(name, "a text");
    return "";
  }
  double number(const std::string& name, double fallback) {
    rclcpp::Parameter parameter;
    if (!get(name, parameter)) return fallback;
    if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_DOUBLE) return parameter.as_double();
    if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_INTEGER)
      return static_cast<double>(parameter.as_int());
    refuse(name, "a number");
    return fallback;
  }
  bool flag(const std::string& name, bool fallback) {
    rclcpp::Parameter parameter;
    if (!get(name, parameter)) return fallback;
    if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_BOOL) return parameter.as_bool();
    refuse(name, "true or false");
    return fallback;
  }
  std::vector<double> numbers(const std::string& name, std::vector<double> fallback) {
    rclcpp::Parameter parameter;
    if (!get(name, parameter)) return fallback;
    if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_DOUBLE_ARRAY) return parameter.as_double_array();
    if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_INTEGER_ARRAY) {
      const auto integers = parameter.as_integer_array();
      return std::vector<double>(integers.begin(), integers.end());
    }
    refuse(name, "a list of numbers");
    return fallback;
  }
  std::vector<std::string> texts(const std::string& name) {
    rclcpp::Parameter parameter;
    if (!get(name, parameter)) return {};
    if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_STRING_ARRAY) return parameter.as_string_array();
    refuse(name, "a list of texts");
    return {};
  }

  // The robot description: the argument of the plugin, or the parameter of the node, which has no prefix.
  std::string robot_description(const std::string& argument) {
    if (!argument.empty()) return argument;
    return Parameters(node_, "").text("robot_description");
  }

 private:
  Node node_;
  std::string prefix_, problem_;

  bool get(const std::string& name, rclcpp::Parameter& parameter) const {
    return has(name) && node_->get_parameter(prefix_ + name, parameter) &&
           parameter.get_type() != rclcpp::ParameterType::PARAMETER_NOT_SET;
  }
  void refuse(const std::string& name, const std::string& type) {
    if (problem_.empty()) problem_ = "parameter '" + prefix_ + name + "' is not " + type;
  }
};

}  // namespace robcogen::ros
