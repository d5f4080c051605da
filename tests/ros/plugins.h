// Plugins of the arm of robots/ros2_arm, loaded from their libraries, and parameters for them.
#pragma once

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <ros_test/six_axis/reflection.h>
#include <ros_test/six_axis/six_axis.h>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <rclcpp/logging.hpp>
#include <rclcpp/node_interfaces/node_parameters_interface.hpp>
#include <sstream>
#include <string>

namespace robcogen::test {

namespace arm = ros_test::six_axis;

// The parameters of a node.
struct Node : rclcpp::node_interfaces::NodeParametersInterface {
  std::map<std::string, rclcpp::Parameter> parameters;

  bool has_parameter(const std::string& name) const override { return parameters.count(name) > 0; }
  bool get_parameter(const std::string& name, rclcpp::Parameter& parameter) const override {
    const auto at = parameters.find(name);
    if (at == parameters.end()) return false;
    parameter = at->second;
    return true;
  }
};

inline std::shared_ptr<Node> node_with(const std::map<std::string, rclcpp::Parameter::Value>& values) {
  auto node = std::make_shared<Node>();
  for (const auto& [name, value] : values) node->parameters.emplace(name, rclcpp::Parameter(value));
  return node;
}

// Makes an object of the class of a plugin. The library stays loaded.
template <class Base>
std::unique_ptr<Base> load(const char* library) {
  void* const handle = dlopen(library, RTLD_NOW | RTLD_GLOBAL);
  if (!handle) throw std::runtime_error(dlerror());
  const auto create = reinterpret_cast<Base* (*)()>(dlsym(handle, "create_plugin"));
  if (!create) throw std::runtime_error(dlerror());
  return std::unique_ptr<Base>(create());
}

inline std::string description() {
  std::ifstream file(DESCRIPTION);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// The description with the first such part replaced.
inline std::string description_with(const std::string& part, const std::string& other) {
  std::string text = description();
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return text.replace(at, part.size(), other);
}

inline std::string last_message() {
  return rclcpp::messages().empty() ? "" : rclcpp::messages().back();
}

// Positions within the limits of the arm, different for each index.
inline arm::JointState some_positions(int index) {
  arm::JointState q;
  for (int j = 0; j < 6; ++j) {
    const auto& limits = arm::kJointLimits[static_cast<std::size_t>(j)];
    const double part = 0.5 + 0.45 * std::sin(1.3 + 2.1 * index + 5.9 * j);
    q[j] = limits.lower + part * (limits.upper - limits.lower);
  }
  return q;
}

}  // namespace robcogen::test
