// Stand-in for a node of rclcpp.
#pragma once

#include <memory>

namespace rclcpp {
struct Node {
  using SharedPtr = std::shared_ptr<Node>;
};
}  // namespace rclcpp
