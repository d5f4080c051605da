#include "algorithm/spatial/named.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

namespace robcogen::algorithm {
namespace {

constexpr std::string_view kAxisLetters = "xyz";

// No text is made for values that would not take it.
void set(const Label& label, std::string_view symbol, std::string_view element, const Expression& e, bool is_own) {
  Graph* graph = e.graph();
  if (!graph || !graph->takes_quantity(e, is_own)) return;
  symbolic::Quantity quantity;
  quantity.subject = label.subject;
  quantity.symbol = symbol;
  quantity.element = element;
  quantity.second = label.second;
  quantity.qualifier = label.qualifier;
  quantity.state = label.state;
  quantity.of_coordinates = label.of_coordinates;
  if (is_own)
    graph->name(e, std::move(quantity));
  else
    graph->describe(e, std::move(quantity));
}

void set(const Label& label, std::string_view symbol, const Vector3& v, bool is_own) {
  for (std::size_t i = 0; i < 3; ++i) set(label, symbol, kAxisLetters.substr(i, 1), v[i], is_own);
}

void set(const Label& label, std::string_view symbol, const Matrix3& m, bool is_own) {
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) {
      const char element[] = {kAxisLetters[r], kAxisLetters[c]};
      set(label, symbol, std::string_view(element, 2), m[r][c], is_own);
    }
}

}  // namespace

Label coordinate(std::string_view symbol, const std::string& row, std::string_view state) {
  Label result(row, {}, state);
  result.symbol = symbol;
  result.of_coordinates = true;
  return result;
}

Label coordinates(
    std::string_view symbol,
    const std::string& row,
    const std::string& column,
    std::string_view state,
    std::string_view qualifier) {
  Label result = coordinate(symbol, row, state);
  result.second = column;
  result.qualifier = qualifier;
  return result;
}

void set_quantity(const Label& label, const Expression& e, bool is_own) {
  set(label, label.symbol, {}, e, is_own);
}

void set_quantity(const Label& label, const Vector3& v, bool is_own) {
  set(label, label.symbol, v, is_own);
}

void set_quantity(const Label& label, const Matrix3& m, bool is_own) {
  set(label, label.symbol, m, is_own);
}

void set_quantity(const Label& label, const Force& f, bool is_own) {
  set(label, "n", f.moment, is_own);
  set(label, "f", f.linear, is_own);
}

void set_quantity(const Label& label, const Motion& v, bool is_own) {
  set(label, "w", v.angular, is_own);
  set(label, "v", v.linear, is_own);
}

void set_quantity(const Label& label, const SpatialInertia& x, bool is_own) {
  set(label, "A", x.a, is_own);
  set(label, "B", x.b, is_own);
  set(label, "M", x.m, is_own);
}

void set_quantity(const Label& label, const MassProperties& m, bool is_own) {
  set(label, "h", m.first_moment, is_own);
  set(label, "S", m.pseudo_inertia, is_own);
}

void set_quantity(const Label& label, LinkMotion& motion, bool is_own) {
  motion.angular.link = label.subject;
  set(label, "w", motion.angular.w, is_own);
  set(label, "wd", motion.angular.wd, is_own);
  set(label, "a", motion.a, is_own);
}

void describe_elements(
    std::string_view symbol,
    const std::vector<std::string>& names,
    const std::vector<Expression>& values,
    std::string_view state) {
  for (std::size_t k = 0; k < values.size(); ++k) described(coordinate(symbol, names[k], state), values[k]);
}

Expression described_u(std::string_view link, std::size_t row, std::size_t column, const Expression& value) {
  const char element[] = {kAxisLetters[row], kAxisLetters[column]};
  set(Label(link), "U", std::string_view(element, 2), value, false);
  return value;
}

Expression described_product_of_w(std::string_view link, std::size_t i, std::size_t j, const Expression& value) {
  if (!value.graph() || !value.graph()->takes_quantity(value, false)) return value;
  const auto w = [&](std::size_t axis) { return symbolic::Quantity{std::string(link), "w", {kAxisLetters[axis]}}; };
  if (i == j)
    value.graph()->describe(
        value, symbolic::made(symbolic::Quantity::Form::square, std::make_shared<const symbolic::Quantity>(w(i))));
  else
    value.graph()->describe(value, symbolic::product(w(std::min(i, j)), w(std::max(i, j))));
  return value;
}

}  // namespace robcogen::algorithm
