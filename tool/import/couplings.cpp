#include "import/couplings.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "import/kinematics.h"

namespace robcogen::import {
namespace {

namespace kinematics = language::kinematics;
using language::Expression;
using model::ParameterKind;
using model::Quantity;
using Kind = Expression::Kind;

// Powers of rad and m, where the document says them.
struct Dimension {
  int rad = 0, m = 0;
  bool is_said = false;

  friend bool operator==(const Dimension&, const Dimension&) = default;
};

Dimension product(const Dimension& a, const Dimension& b, int sign) {
  return {a.rad + sign * b.rad, a.m + sign * b.m, a.is_said || b.is_said};
}

struct Term {
  Quantity factor;
  Dimension unit;
  Span span;  // of the joint's name
};

// Sum of the terms, in the order of the text, and the offset.
struct Sum {
  std::vector<std::pair<std::string, Term>> terms;
  Quantity offset;
  Dimension unit;  // of the offset

  bool is_constant() const { return terms.empty(); }
};

class Couplings {
 public:
  Couplings(const kinematics::Document& document, QuantityReader& reader, Diagnostics& diagnostics)
      : document_(document), reader_(reader), diagnostics_(diagnostics) {
    for (const kinematics::Joint& joint : document.joints) {
      const auto compound = compound_type_of(joint.type);
      if (!compound) {
        turns_.insert({joint.name.text, model::turns(type_of(joint.type))});
        continue;
      }
      std::string& coordinates = coordinates_[joint.name.text];
      for (const model::CompoundCoordinate& coordinate : model::coordinates_of(*compound)) {
        const std::string name = model::coordinate_name(joint.name.text, coordinate);
        turns_.insert({name, model::turns(coordinate.type)});
        coordinates += fmt::format("{}'{}'", coordinates.empty() ? "" : ", ", name);
      }
    }
  }

  // False for a joint of several coordinates, which have names of their own.
  bool is_single(const std::string& joint) const { return !coordinates_.contains(joint); }

  model::DescribedCoupling read(const kinematics::Coupling& coupling) {
    check_single(coupling.joint.text, coupling.joint.span);
    const auto known = turns_.find(coupling.joint.text);
    const bool turns = known == turns_.end() || known->second;
    model::DescribedCoupling result = {coupling.joint.text, place(coupling.joint.span), {}, {}};
    const Sum sum = this->sum(*coupling.value, turns ? ParameterKind::angle : ParameterKind::length);
    if (is_wrong_) {
      is_wrong_ = false;
      return result;
    }
    result.offset = sum.offset;
    for (const auto& [joint, term] : sum.terms) {
      if (known != turns_.end()) check_unit(coupling, joint, term);
      result.terms.push_back({joint, term.factor, place(term.span)});
    }
    const Dimension own = unit_of(turns);
    if (sum.unit.is_said && sum.unit != own)
      report_unit(coupling.value->span, "the constant", own, coupling.joint.text);
    return result;
  }

 private:
  const kinematics::Document& document_;
  QuantityReader& reader_;
  Diagnostics& diagnostics_;
  std::map<std::string, bool> turns_;               // by joint
  std::map<std::string, std::string> coordinates_;  // of joints that have several: their names
  bool is_wrong_ = false;                           // an error in the present coupling was reported

  Place place(const Span& span) const { return {document_.source, span}; }

  // Reports a joint of several coordinates.
  void check_single(const std::string& joint, const Span& span) {
    if (is_single(joint)) return;
    is_wrong_ = true;
    diagnostics_.error("coupling-of-several", place(span), fmt::format("joint '{}' has several coordinates", joint))
        .hint = fmt::format("couple one of them: {}", coordinates_.at(joint));
  }

  static Dimension unit_of(bool turns) { return {turns ? 1 : 0, turns ? 0 : 1, true}; }

  bool is_plain(const Expression& e) const {
    return e.kind == Kind::name && e.group.empty() && !e.is_parameter && !e.default_value;
  }
  // What is neither a joint nor a parameter is reported as an unknown joint.
  bool is_joint(const Expression& e) const {
    return is_plain(e) && !is_unit(e) && (turns_.contains(e.name) || !reader_.knows_parameter(e.name));
  }
  bool is_unit(const Expression& e) const {
    return is_plain(e) && (e.name == "rad" || e.name == "m") && !turns_.contains(e.name) &&
           !reader_.knows_parameter(e.name);
  }
  bool has_joint_or_unit(const Expression& e) const {
    return is_joint(e) || is_unit(e) || (e.left && has_joint_or_unit(*e.left)) ||
           (e.right && has_joint_or_unit(*e.right));
  }

  Sum sum(const Expression& e, ParameterKind kind) {
    Sum result;
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

  Sum multiplied(const Expression& e, ParameterKind kind) {
    const bool is_left_factor = !follows_joint(*e.left);
    if (!is_left_factor && follows_joint(*e.right)) return not_linear(e);
    const bool is_constant = is_left_factor && !follows_joint(*e.right);
    const Sum left = sum(*e.left, is_left_factor && !is_constant ? ParameterKind::ratio : kind);
    const Sum right = sum(*e.right, is_left_factor && !is_constant ? kind : ParameterKind::ratio);
    return is_left_factor ? scaled(right, left.offset, left.unit, 1) : scaled(left, right.offset, right.unit, 1);
  }

  Sum divided(const Expression& e, ParameterKind kind) {
    if (follows_joint(*e.right)) return not_linear(e);
    const Sum left = sum(*e.left, kind), right = sum(*e.right, ParameterKind::ratio);
    if (right.offset.is_zero()) {
      is_wrong_ = true;
      diagnostics_.error("not-finite", place(e.span), "division by zero");
      return {};
    }
    return scaled(left, Quantity(1.0) / right.offset, right.unit, -1);
  }

  bool follows_joint(const Expression& e) const {
    return is_joint(e) || (e.left && follows_joint(*e.left)) || (e.right && follows_joint(*e.right));
  }

  static Sum scaled(Sum sum, const Quantity& factor, const Dimension& unit, int sign) {
    sum.offset = factor * sum.offset;
    if (sum.is_constant()) sum.unit = product(sum.unit, unit, sign);
    for (auto& [joint, term] : sum.terms) {
      term.factor = factor * term.factor;
      term.unit = product(term.unit, unit, sign);
    }
    return sum;
  }

  Sum added(const Expression& e, ParameterKind kind) {
    // In this order, which determines the order of the parameters.
    Sum a = sum(*e.left, kind);
    const Sum b = sum(*e.right, kind);
    const Sum other = scaled(b, Quantity(e.kind == Kind::subtract ? -1.0 : 1.0), {}, 1);
    a.offset = a.offset + other.offset;
    if (other.unit.is_said) a.unit = other.unit;
    a.terms.insert(a.terms.end(), other.terms.begin(), other.terms.end());
    return a;
  }

  Sum not_linear(const Expression& e) {
    if (!std::exchange(is_wrong_, true))
      diagnostics_.error(
          "coupling-not-linear", place(e.span),
          "a coupling is a sum of joints times constants, and of a constant: this is not linear in the joints");
    return {};
  }

  // A factor between joints of different kinds needs its unit; elsewhere it has none.
  void check_unit(const kinematics::Coupling& coupling, const std::string& joint, const Term& term) {
    const auto followed = turns_.find(joint);
    if (followed == turns_.end()) return;
    const bool turns = turns_.at(coupling.joint.text);
    const bool followed_turns = followed->second;
    Dimension wanted = product(unit_of(turns), unit_of(followed_turns), -1);
    wanted.is_said = term.unit.is_said;
    if (term.unit == wanted && (term.unit.is_said || turns == followed_turns)) return;
    if (turns == followed_turns) {
      diagnostics_.error(
          "coupling-units", place(coupling.value->span),
          fmt::format("the factor of joint '{}' has no unit: both joints {}", joint, turns ? "turn" : "slide"));
      return;
    }
    diagnostics_
        .error(
            "coupling-units", place(term.span),
            fmt::format(
                "joint '{}' {} and joint '{}' {}: the factor needs its unit", coupling.joint.text,
                turns ? "turns" : "slides", joint, followed_turns ? "turns" : "slides"))
        .hint = fmt::format("write '20.0 {} * {}', for example", turns ? "rad/m" : "m/rad", joint);
  }

  void report_unit(const Span& span, const std::string& what, const Dimension& own, const std::string& joint) {
    diagnostics_.error(
        "coupling-units", place(span),
        fmt::format("{} of the coupling of joint '{}' is in {}", what, joint, own.rad != 0 ? "rad" : "m"));
  }
};

}  // namespace

std::vector<model::DescribedCoupling> read_couplings(
    const kinematics::Document& document,
    QuantityReader& reader,
    Diagnostics& diagnostics) {
  Couplings couplings(document, reader, diagnostics);
  std::vector<model::DescribedCoupling> result;
  for (const kinematics::Coupling& coupling : document.couplings) {
    model::DescribedCoupling read = couplings.read(coupling);
    if (couplings.is_single(coupling.joint.text)) result.push_back(std::move(read));
  }
  return result;
}

}  // namespace robcogen::import
