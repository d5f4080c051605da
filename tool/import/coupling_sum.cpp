#include "import/coupling_sum.h"

#include <fmt/format.h>

#include <utility>

namespace robcogen::import {
namespace {

using language::Expression;
using model::ParameterKind;
using model::Quantity;
using Kind = Expression::Kind;

class SumReader {
 public:
  // `owner`: what is a sum of joints, for messages.
  SumReader(const CoupledJoints& joints, QuantityReader& reader, Diagnostics& diagnostics, std::string owner)
      : joints_(joints), reader_(reader), diagnostics_(diagnostics), owner_(std::move(owner)) {}

  std::optional<CouplingSum> read(const language::kinematics::Coupling& coupling) {
    check_single(coupling.joint.text, coupling.joint.span);
    const bool turns = joints_.turns(coupling.joint.text).value_or(true);
    return read(*coupling.value, turns ? ParameterKind::angle : ParameterKind::length);
  }

  std::optional<CouplingSum> read(const Expression& value, ParameterKind kind) {
    CouplingSum result = sum(value, kind);
    return is_wrong_ ? std::nullopt : std::optional(std::move(result));
  }

 private:
  const CoupledJoints& joints_;
  QuantityReader& reader_;
  Diagnostics& diagnostics_;
  std::string owner_;
  bool is_wrong_ = false;  // an error was reported

  // Reports a joint with several coordinates.
  void check_single(const std::string& joint, const Span& span) {
    if (joints_.is_single(joint)) return;
    is_wrong_ = true;
    diagnostics_
        .error("coupling-of-several", reader_.place(span), fmt::format("joint '{}' has several coordinates", joint))
        .hint = fmt::format("couple one of them: {}", joints_.coordinates_of(joint));
  }

  bool is_plain(const Expression& e) const {
    return e.kind == Kind::name && e.group.empty() && !e.is_parameter && !e.default_value;
  }
  // A name that is neither a joint nor a parameter is reported as an unknown joint.
  bool is_joint(const Expression& e) const {
    return is_plain(e) && !is_unit(e) && (joints_.contains(e.name) || !reader_.knows_parameter(e.name));
  }
  bool is_unit(const Expression& e) const {
    return is_plain(e) && (e.name == "rad" || e.name == "m") && !joints_.contains(e.name) &&
           !reader_.knows_parameter(e.name);
  }
  bool has_joint_or_unit(const Expression& e) const {
    return is_joint(e) || is_unit(e) || (e.left && has_joint_or_unit(*e.left)) ||
           (e.right && has_joint_or_unit(*e.right));
  }

  CouplingSum sum(const Expression& e, ParameterKind kind) {
    CouplingSum result;
    if (!has_joint_or_unit(e)) {
      result.offset = reader_.read(e, kind);
      return result;
    }
    if (is_unit(e)) {
      result.offset = Quantity(1.0);
      result.unit = unit_of(e.name == "rad");
      return result;
    }
    switch (e.kind) {
      case Kind::name:
        check_single(e.name, e.span);
        result.terms.push_back({e.name, {Quantity(1.0), {}, e.span}});
        return result;
      case Kind::negate:
        return scaled(sum(*e.left, kind), Quantity(-1.0), {}, 1);
      case Kind::add:
      case Kind::subtract:
        return added(e, kind);
      case Kind::multiply:
      case Kind::divide:
        return e.kind == Kind::multiply ? multiplied(e, kind) : divided(e, kind);
      default:
        return not_linear(e);
    }
  }

  CouplingSum multiplied(const Expression& e, ParameterKind kind) {
    const bool is_left_factor = !follows_joint(*e.left);
    if (!is_left_factor && follows_joint(*e.right)) return not_linear(e);
    const bool is_constant = is_left_factor && !follows_joint(*e.right);
    const CouplingSum left = sum(*e.left, is_left_factor && !is_constant ? ParameterKind::ratio : kind);
    const CouplingSum right = sum(*e.right, is_left_factor && !is_constant ? kind : ParameterKind::ratio);
    return is_left_factor ? scaled(right, left.offset, left.unit, 1) : scaled(left, right.offset, right.unit, 1);
  }

  CouplingSum divided(const Expression& e, ParameterKind kind) {
    if (follows_joint(*e.right)) return not_linear(e);
    const CouplingSum left = sum(*e.left, kind), right = sum(*e.right, ParameterKind::ratio);
    if (right.offset.is_zero()) {
      is_wrong_ = true;
      diagnostics_.error("not-finite", reader_.place(e), "division by zero");
      return {};
    }
    return scaled(left, Quantity(1.0) / right.offset, right.unit, -1);
  }

  bool follows_joint(const Expression& e) const {
    return is_joint(e) || (e.left && follows_joint(*e.left)) || (e.right && follows_joint(*e.right));
  }

  static CouplingSum scaled(CouplingSum sum, const Quantity& factor, const Dimension& unit, int sign) {
    sum.offset = factor * sum.offset;
    if (sum.is_constant()) sum.unit = product(sum.unit, unit, sign);
    for (auto& [joint, term] : sum.terms) {
      term.factor = factor * term.factor;
      term.unit = product(term.unit, unit, sign);
    }
    return sum;
  }

  CouplingSum added(const Expression& e, ParameterKind kind) {
    // Evaluation order matters: it determines the order of the parameters.
    CouplingSum a = sum(*e.left, kind);
    const CouplingSum b = sum(*e.right, kind);
    const CouplingSum other = scaled(b, Quantity(e.kind == Kind::subtract ? -1.0 : 1.0), {}, 1);
    a.offset = a.offset + other.offset;
    if (other.unit.is_said) a.unit = other.unit;
    a.terms.insert(a.terms.end(), other.terms.begin(), other.terms.end());
    return a;
  }

  // The first name that is neither a joint nor a parameter, or nullptr.
  const Expression* undeclared_in(const Expression& e) const {
    if (is_joint(e)) return joints_.contains(e.name) || !joints_.is_single(e.name) ? nullptr : &e;
    const Expression* left = e.left ? undeclared_in(*e.left) : nullptr;
    return left == nullptr && e.right ? undeclared_in(*e.right) : left;
  }

  CouplingSum not_linear(const Expression& e) {
    if (std::exchange(is_wrong_, true)) return {};
    if (const Expression* name = undeclared_in(e))
      diagnostics_
          .error(
              "undeclared-factor", reader_.place(*name),
              fmt::format("'{}' is neither a joint nor a parameter", name->name))
          .hint = fmt::format("write '{}[0.5]' to declare a parameter with this default", name->name);
    else
      diagnostics_.error(
          "coupling-not-linear", reader_.place(e),
          fmt::format(
              "this is not linear in the joints: {} is a sum of joints times constants, plus a constant", owner_));
    return {};
  }
};

}  // namespace

std::optional<CouplingSum> read_coupling_sum(
    const language::kinematics::Coupling& coupling,
    const CoupledJoints& joints,
    QuantityReader& reader,
    Diagnostics& diagnostics) {
  return SumReader(joints, reader, diagnostics, "a coupling").read(coupling);
}

std::optional<CouplingSum> read_length(
    const Expression& length,
    const CoupledJoints& joints,
    QuantityReader& reader,
    Diagnostics& diagnostics) {
  return SumReader(joints, reader, diagnostics, "the length of a tendon").read(length, ParameterKind::inertial);
}

}  // namespace robcogen::import
