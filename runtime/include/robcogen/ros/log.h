// Messages of the plugins. Needs rclcpp.
#pragma once

#include <rclcpp/logging.hpp>

#include <string>

namespace robcogen::ros {

// Writes a message as `robcogen.arm`, and returns false: what a function of an interface that fails returns.
inline bool refuse(const char* robot, const std::string& text) {
  RCLCPP_ERROR(rclcpp::get_logger("robcogen." + std::string(robot)), "%s", text.c_str());
  return false;
}

// What is wrong with a vector; for every interface in the same words.
inline std::string wrong_size(const std::string& name, long long size, long long expected) {
  return name + " has " + std::to_string(size) + " elements instead of " + std::to_string(expected);
}

}  // namespace robcogen::ros
