// Stand-in for parameters of rclcpp.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rclcpp {

enum class ParameterType : std::uint8_t {
  PARAMETER_NOT_SET,
  PARAMETER_BOOL,
  PARAMETER_INTEGER,
  PARAMETER_DOUBLE,
  PARAMETER_STRING,
  PARAMETER_INTEGER_ARRAY,
  PARAMETER_DOUBLE_ARRAY,
  PARAMETER_STRING_ARRAY
};

// Reading a value as another type throws, as there.
class Parameter {
 public:
  using Value = std::variant<
      std::monostate,
      bool,
      std::int64_t,
      double,
      std::string,
      std::vector<std::int64_t>,
      std::vector<double>,
      std::vector<std::string>>;

  Parameter() = default;
  explicit Parameter(Value value) : value_(std::move(value)) {}

  ParameterType get_type() const { return static_cast<ParameterType>(value_.index()); }
  bool as_bool() const { return std::get<bool>(value_); }
  std::int64_t as_int() const { return std::get<std::int64_t>(value_); }
  double as_double() const { return std::get<double>(value_); }
  const std::string& as_string() const { return std::get<std::string>(value_); }
  const std::vector<std::int64_t>& as_integer_array() const { return std::get<std::vector<std::int64_t>>(value_); }
  const std::vector<double>& as_double_array() const { return std::get<std::vector<double>>(value_); }
  const std::vector<std::string>& as_string_array() const { return std::get<std::vector<std::string>>(value_); }

 private:
  Value value_;
};

}  // namespace rclcpp
