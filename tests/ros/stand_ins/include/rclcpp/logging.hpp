// Stand-in for logging of rclcpp: messages are kept, so that tests read them.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace rclcpp {

struct Logger {
  std::string name;
};
inline Logger get_logger(const std::string& name) {
  return {name};
}

// All messages so far: `robcogen.arm: text`.
inline std::vector<std::string>& messages() {
  static std::vector<std::string> all;
  return all;
}

template <class... Values>
void log(const Logger& logger, const char* format, Values... values) {
  char text[4096];
  std::snprintf(text, sizeof text, format, values...);
  messages().push_back(logger.name + ": " + text);
}

}  // namespace rclcpp

#define RCLCPP_ERROR(...) ::rclcpp::log(__VA_ARGS__)
#define RCLCPP_WARN(...) ::rclcpp::log(__VA_ARGS__)
