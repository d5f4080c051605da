// Quantities of a model: arithmetic expressions over constants, parameters and variables.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "support/diagnostics.h"
#include "support/number.h"

namespace robcogen::model {

// The kind of a parameter follows from where it is used: in the translation or the rotation of a placement, in a factor
// of a coupling, or only in mass properties.
enum class ParameterKind { length, angle, ratio, inertial };

struct Parameter {
  std::string name;
  ParameterKind kind = ParameterKind::length;
  std::optional<double> default_value;
  Place place;                    // first use
  bool is_in_masses_too = false;  // a length or an angle that mass properties depend on too
};

// The interfaces that a parameter belongs to: lengths, angles and ratios belong to the kinematic interface, parameters
// of mass properties to the dynamic interface, and parameters of both kinds to both.
inline bool is_kinematics(const Parameter& p) {
  return p.kind != ParameterKind::inertial;
}
inline bool is_dynamics(const Parameter& p) {
  return p.kind == ParameterKind::inertial || p.is_in_masses_too;
}

// An immutable arithmetic expression over constants, parameters and variables; the latter two are indices into lists of
// the model. Operators fold constants exactly and simplify 0 + x, 1 * x and 0 * x.
class Quantity {
 public:
  enum class Op {
    constant,
    parameter,
    variable,
    negate,
    add,
    subtract,
    multiply,
    divide,
    sine,
    cosine,
    tangent,
    square_root,
  };

  Quantity();  // the constant zero
  explicit Quantity(Number value);
  explicit Quantity(double value) : Quantity(Number(value)) {}
  static Quantity parameter(int index);
  static Quantity variable(int index);

  Op op() const;
  const Number& number() const;   // op constant
  int index() const;              // op parameter, variable
  const Quantity& left() const;   // operand, or first operand
  const Quantity& right() const;  // second operand

  bool is_constant() const { return op() == Op::constant; }
  bool is_zero() const { return is_constant() && number().is_zero(); }

  friend Quantity operator-(const Quantity& a);
  friend Quantity operator+(const Quantity& a, const Quantity& b);
  friend Quantity operator-(const Quantity& a, const Quantity& b);
  friend Quantity operator*(const Quantity& a, const Quantity& b);
  friend Quantity operator/(const Quantity& a, const Quantity& b);
  friend Quantity sin(const Quantity& a);
  friend Quantity cos(const Quantity& a);
  friend Quantity tan(const Quantity& a);
  friend Quantity sqrt(const Quantity& a);

  // Compares structure, not values: true for the same operations on the same constants, parameters and variables.
  friend bool operator==(const Quantity& a, const Quantity& b);

 private:
  struct Node;
  explicit Quantity(std::shared_ptr<const Node> node);
  std::shared_ptr<const Node> node_;
};

// Returns the numerical value; parameters and variables are looked up by index.
double evaluate(const Quantity& q, std::span<const double> parameters = {}, std::span<const double> variables = {});

// Returns the value at the default values of the parameters; nullopt if it is not known, because a parameter has no
// default value or because it depends on one of the `variables`.
std::optional<double> value_at_defaults(
    const Quantity& q,
    const std::vector<Parameter>& parameters,
    std::size_t variables = 0);

// Returns the indices of the parameters that a quantity depends on.
std::vector<int> parameters_of(const Quantity& q);

// Returns the text of a quantity in the syntax of the documents.
std::string print(
    const Quantity& q,
    const std::vector<Parameter>& parameters,
    const std::vector<std::string>& variables = {});

}  // namespace robcogen::model
