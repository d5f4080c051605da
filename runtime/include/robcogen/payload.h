// Bodies whose mass properties are parameters of a robot, such as a tool or a load at the flange.
//
//     auto values = arm::Parameters<>().array();
//     robcogen::set_payload(arm::kParameterNames, "tool0", {1.5, {0, 0, 0.08}, inertia}, values);
//     parameters.update(values);
//
// The parameters are those that `PARAMETERS tool0.inertia` makes: `tool0_mass`, `tool0_com_x`, …, `tool0_iyz`. Nothing
// allocates or throws.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string_view>

#include "robcogen/matrix.h"

namespace robcogen {

// A rigid body at a frame.
struct Payload {
  double mass = 0;                                                     // kg
  Matrix<double, 3, 1> center_of_mass = Matrix<double, 3, 1>::Zero();  // m, in the frame
  // kg m^2, about the centre of mass, in axes of the frame
  Matrix<double, 3, 3> inertia = Matrix<double, 3, 3>::Zero();
};

namespace detail {

// The inertia of a point mass at this position, about the origin.
inline Matrix<double, 3, 3> inertia_of_point(double mass, const Matrix<double, 3, 1>& p) noexcept {
  return mass * (p.squaredNorm() * Matrix<double, 3, 3>::Identity() - p * p.transpose());
}

inline constexpr std::array<std::string_view, 10> kInertialSuffixes = {"_mass", "_com_x", "_com_y", "_com_z", "_ixx",
                                                                       "_iyy",  "_izz",   "_ixy",   "_ixz",   "_iyz"};

// The index of `element` with `suffix` among the names; their number if there is none.
template <std::size_t Count>
std::size_t parameter_index(
    const std::array<const char*, Count>& names,
    std::string_view element,
    std::string_view suffix) noexcept {
  for (std::size_t i = 0; i < Count; ++i) {
    const std::string_view name(names[i]);
    if (name.size() == element.size() + suffix.size() && name.substr(0, element.size()) == element &&
        name.substr(element.size()) == suffix)
      return i;
  }
  return Count;
}

}  // namespace detail

// Both bodies as one; they are given in the same frame.
inline Payload operator+(const Payload& a, const Payload& b) noexcept {
  Payload sum;
  sum.mass = a.mass + b.mass;
  if (sum.mass != 0) sum.center_of_mass = (a.mass * a.center_of_mass + b.mass * b.center_of_mass) / sum.mass;
  sum.inertia = a.inertia + detail::inertia_of_point(a.mass, a.center_of_mass - sum.center_of_mass) + b.inertia +
                detail::inertia_of_point(b.mass, b.center_of_mass - sum.center_of_mass);
  return sum;
}

// The same body in another frame: `to_X_from` is the homogeneous transform from the frame of the body to that frame.
inline Payload in_frame(const Payload& body, const Matrix<double, 4, 4>& to_X_from) noexcept {
  const Matrix<double, 3, 3> R = to_X_from.topLeftCorner<3, 3>();
  Payload result;
  result.mass = body.mass;
  result.center_of_mass = R * body.center_of_mass + to_X_from.topRightCorner<3, 1>();
  result.inertia = R * body.inertia * R.transpose();
  return result;
}

// Sets the parameters `<element>_mass`, … to those of this body, in the frame of the element. Returns false, and sets
// nothing, if some of the ten parameters do not exist.
template <std::size_t Count>
bool set_payload(
    const std::array<const char*, Count>& names,
    std::string_view element,
    const Payload& body,
    std::array<double, Count>& values) noexcept {
  const Matrix<double, 3, 3> I = body.inertia + detail::inertia_of_point(body.mass, body.center_of_mass);
  const Matrix<double, 3, 1>& c = body.center_of_mass;
  // Products have positive sign: minus the elements of the tensor.
  const std::array<double, 10> numbers = {body.mass, c.x(),   c.y(),    c.z(),    I(0, 0),
                                          I(1, 1),   I(2, 2), -I(0, 1), -I(0, 2), -I(1, 2)};
  std::array<std::size_t, 10> indices{};
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    indices[k] = detail::parameter_index(names, element, detail::kInertialSuffixes[k]);
    if (indices[k] == Count) return false;
  }
  for (std::size_t k = 0; k < numbers.size(); ++k) values[indices[k]] = numbers[k];
  return true;
}

// The body that the parameters of the element describe; parameters that do not exist count as zero.
template <std::size_t Count>
Payload payload_of(
    const std::array<const char*, Count>& names,
    std::string_view element,
    const std::array<double, Count>& values) noexcept {
  std::array<double, 10> numbers{};
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const std::size_t index = detail::parameter_index(names, element, detail::kInertialSuffixes[k]);
    if (index < Count) numbers[k] = values[index];
  }
  const auto& [m, x, y, z, xx, yy, zz, xy, xz, yz] = numbers;
  Payload body;
  body.mass = m;
  body.center_of_mass = Matrix<double, 3, 1>(x, y, z);
  body.inertia << xx, -xy, -xz, -xy, yy, -yz, -xz, -yz, zz;
  body.inertia -= detail::inertia_of_point(m, body.center_of_mass);
  return body;
}

}  // namespace robcogen
