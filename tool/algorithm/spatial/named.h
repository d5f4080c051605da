// Says what values are, where they are declared: `const Vector3 h = named("h", link, to_parent(X_PC, m.h))`. Each
// function returns the value.
//
// `named` makes the elements statements of their own; `described` leaves passes free to merge them into others. Without
// a symbol, the elements take those of their type: n and f of forces, w and v of motions, A, B and M of inertias, h and
// S of mass properties, w, wd and a of the motion of a link.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "algorithm/spatial/link_motion.h"
#include "algorithm/spatial/spatial_inertia.h"

namespace robcogen::algorithm {

// What the elements of a value have in common (symbolic::Quantity). Holds references.
struct Label {
  Label(const std::string& link, std::string_view qualifier_ = {}, std::string_view state_ = {})
      : subject(link), qualifier(qualifier_), state(state_) {}
  Label(const char* whole) : subject(whole) {}
  explicit Label(std::string_view link) : subject(link) {}

  std::string_view subject, qualifier, state, symbol = {}, second = {};
  bool of_coordinates = false;
};

// About the origin of the parent and in its axes.
inline Label in_parent(const std::string& link, std::string_view qualifier = {}) {
  return {link, qualifier, "P"};
}

// Of the motion or force of a joint, at a link.
inline Label at_link(const std::string& joint, const std::string& link, std::string_view qualifier = {}) {
  Label result(joint, qualifier);
  result.second = link;
  return result;
}

// An element of a vector or matrix over joints or coordinates.
Label coordinate(std::string_view symbol, const std::string& row, std::string_view state = {});
Label coordinates(
    std::string_view symbol,
    const std::string& row,
    const std::string& column,
    std::string_view state = {},
    std::string_view qualifier = {});

void set_quantity(const Label& label, const Expression& e, bool is_own);
void set_quantity(const Label& label, const Vector3& v, bool is_own);
void set_quantity(const Label& label, const Matrix3& m, bool is_own);
void set_quantity(const Label& label, const Force& f, bool is_own);
void set_quantity(const Label& label, const Motion& v, bool is_own);
void set_quantity(const Label& label, const SpatialInertia& x, bool is_own);
void set_quantity(const Label& label, const MassProperties& m, bool is_own);
void set_quantity(const Label& label, LinkMotion& motion, bool is_own);

template <class T>
T named(const Label& label, T value) {
  set_quantity(label, value, true);
  return value;
}

template <class T>
T named(std::string_view symbol, Label label, T value) {
  label.symbol = symbol;
  return named(label, value);
}

template <class T>
T described(const Label& label, T value) {
  set_quantity(label, value, false);
  return value;
}

template <class T>
T described(std::string_view symbol, Label label, T value) {
  label.symbol = symbol;
  return described(label, value);
}

// The acceleration (dw, da) of a link by those of its joints.
inline Motion named_acceleration(const Label& link, const Motion& a) {
  return {named("dw", link, a.angular), named("da", link, a.linear)};
}
inline Motion described_acceleration(const Label& link, const Motion& a) {
  return {described("dw", link, a.angular), described("da", link, a.linear)};
}

// The elements of a vector over joints or coordinates with these names.
void describe_elements(
    std::string_view symbol,
    const std::vector<std::string>& names,
    const std::vector<Expression>& values,
    std::string_view state = {});

// The element of U or of the products of w of a link in this row and column.
Expression described_u(std::string_view link, std::size_t row, std::size_t column, const Expression& value);
Expression described_product_of_w(std::string_view link, std::size_t i, std::size_t j, const Expression& value);

}  // namespace robcogen::algorithm
