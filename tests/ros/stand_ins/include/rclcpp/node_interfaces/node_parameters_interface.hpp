// Stand-in for the parameters of a node of rclcpp, with those that tests set.
#pragma once

#include <rclcpp/parameter.hpp>

#include <map>
#include <memory>
#include <string>

namespace rclcpp::node_interfaces {

class NodeParametersInterface {
 public:
  using SharedPtr = std::shared_ptr<NodeParametersInterface>;
  using ConstSharedPtr = std::shared_ptr<const NodeParametersInterface>;

  virtual ~NodeParametersInterface() = default;
  virtual bool has_parameter(const std::string& name) const = 0;
  virtual bool get_parameter(const std::string& name, Parameter& parameter) const = 0;
};

}  // namespace rclcpp::node_interfaces
