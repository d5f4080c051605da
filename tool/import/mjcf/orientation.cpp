#include "import/mjcf/orientation.h"

#include <fmt/format.h>

#include <cmath>

#include "import/mjcf/vector3.h"
#include "import/rotation_matrix.h"
#include "support/index.h"

namespace robcogen::import::from_mjcf {

namespace {

using Real = long double;
using Vector = std::array<Real, 3>;

// A few roundings of doubles.
constexpr Real kRounding = 1e-15L;

class OrientationReader {
 public:
  OrientationReader(const Settings& settings, Diagnostics& diagnostics)
      : settings_(settings), diagnostics_(diagnostics), values_(diagnostics) {}

  Rotation multiple(const Attribute& euler, std::size_t factor) {
    const std::optional<std::vector<Number>> given = values_.read(euler, 3, 3);
    return given ? of_euler(euler, *given, factor) : Rotation();
  }

  // Returns the identity if the value is malformed.
  Rotation read(const Attribute& attribute) {
    const bool has_six = attribute.name == "xyaxes", has_three = attribute.name == "euler" || attribute.name == "zaxis";
    const std::size_t count = has_six ? 6 : has_three ? 3 : 4;
    const std::optional<std::vector<Number>> given = values_.read(attribute, count, count);
    if (!given) return {};
    const std::vector<Number>& n = *given;
    if (attribute.name == "euler") return of_euler(attribute, n, 1);
    if (attribute.name == "xyaxes") return of_axes(attribute, n);
    if (attribute.name == "zaxis") return of_z_axis(attribute, n);
    if (attribute.name == "axisangle") return about(attribute, {n[0], n[1], n[2]}, angle(attribute, n[3]));
    const std::array<Real, 4> q = {n[0].value(), n[1].value(), n[2].value(), n[3].value()};
    if (q == std::array<Real, 4>()) return no_direction(attribute);
    return rotation_of_quaternion(q);
  }

 private:
  Rotation no_direction(const Attribute& attribute) {
    diagnostics_.error("no-direction", attribute.place, fmt::format("this '{}' gives no direction", attribute.name));
    return {};
  }

  Number angle(const Attribute& attribute, const Number& written) {
    settings_.check_angle(written, 1.0, attribute.place, diagnostics_);
    return settings_.angle(written);
  }

  // Lower-case letters are axes of the rotating frame, capitals are fixed axes.
  Rotation of_euler(const Attribute& attribute, const std::vector<Number>& angles, std::size_t factor) {
    const Number times = Number::rational(static_cast<std::int64_t>(factor));
    Rotation result;
    for (std::size_t i = 0; i < 3; ++i) {
      const char letter = settings_.euler_sequence[i];
      const bool is_fixed = letter < 'a';
      const Rotation turn = rotation_about(letter - (is_fixed ? 'X' : 'x'), times * angle(attribute, angles[i]));
      result = is_fixed ? turn * result : result * turn;
    }
    return result;
  }

  // y is made orthogonal to x.
  Rotation of_axes(const Attribute& attribute, const std::vector<Number>& n) {
    Vector x = {n[0].value(), n[1].value(), n[2].value()}, y = {n[3].value(), n[4].value(), n[5].value()};
    const Real length = std::sqrt(dot(x, x));
    if (length == 0) return no_direction(attribute);
    for (Real& element : x) element /= length;
    const Real along = dot(x, y);
    for (std::size_t i = 0; i < 3; ++i) y[i] -= along * x[i];
    const Real rest = std::sqrt(dot(y, y));
    if (rest <= kRounding * std::abs(along)) return no_direction(attribute);
    for (Real& element : y) element /= rest;
    const Vector z = cross(x, y);
    return rotation_of_matrix({{{x[0], y[0], z[0]}, {x[1], y[1], z[1]}, {x[2], y[2], z[2]}}});
  }

  Rotation of_z_axis(const Attribute& attribute, const std::vector<Number>& n) {
    const bool is_zero = n[0].is_zero() && n[1].is_zero() && n[2].is_zero();
    return is_zero ? no_direction(attribute) : smallest_rotation_to_axis({n[0], n[1], n[2]});
  }

  Rotation about(const Attribute& attribute, const std::array<Number, 3>& axis, const Number& angle) {
    const Vector a = {axis[0].value(), axis[1].value(), axis[2].value()};
    const Real length = std::sqrt(dot(a, a));
    if (length == 0) return no_direction(attribute);
    for (std::size_t i = 0; i < 3; ++i)
      if (axis[(i + 1) % 3].is_zero() && axis[(i + 2) % 3].is_zero())
        return rotation_about(static_cast<int>(i), a[i] < 0 ? -angle : angle);
    const Real half = static_cast<Real>(angle.value()) / 2, sine = std::sin(half) / length;
    return rotation_of_quaternion({std::cos(half), sine * a[0], sine * a[1], sine * a[2]});
  }

  const Settings& settings_;
  Diagnostics& diagnostics_;
  Values values_;
};

}  // namespace

Rotation orientation_of(const Element& element, const Settings& settings, Diagnostics& diagnostics) {
  const Attribute* given = nullptr;
  for (const Attribute& attribute : element.attributes) {
    if (!is_orientation(attribute)) continue;
    if (given != nullptr) {
      diagnostics
          .error(
              "two-orientations", attribute.place,
              fmt::format("this '{}' has two orientations: '{}' and '{}'", element.name, given->name, attribute.name))
          .notes.push_back({given->place, "the other one is here"});
      return {};
    }
    given = &attribute;
  }
  return given == nullptr ? Rotation() : OrientationReader(settings, diagnostics).read(*given);
}

Rotation multiple_of_euler(
    const Attribute& euler,
    std::size_t factor,
    const Settings& settings,
    Diagnostics& diagnostics) {
  return OrientationReader(settings, diagnostics).multiple(euler, factor);
}

Rotation smallest_rotation_to_axis(const std::array<Number, 3>& direction) {
  const Vector axis = {direction[0].value(), direction[1].value(), direction[2].value()};
  const Real length = std::sqrt(dot(axis, axis));
  const Real w = 1 + axis[2] / length;
  if (w == 0) return rotation_about(0, Number::pi_multiple(1));
  return rotation_of_quaternion({w, -axis[1] / length, axis[0] / length, 0});
}

model::Quantity quantity(const Number& number) {
  return model::Quantity(number);
}

std::array<model::Quantity, 3> quantities(const std::array<Number, 3>& numbers) {
  return {quantity(numbers[0]), quantity(numbers[1]), quantity(numbers[2])};
}

Pose pose_of(const Element& element, const Settings& settings, Diagnostics& diagnostics) {
  return {quantities(Values(diagnostics).triple(element, "pos", {})), orientation_of(element, settings, diagnostics)};
}

}  // namespace robcogen::import::from_mjcf
