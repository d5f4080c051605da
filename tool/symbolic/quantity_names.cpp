#include "symbolic/quantity_names.h"

#include <optional>
#include <utility>

#include "support/unique_names.h"
#include "symbolic/lane_names.h"

namespace robcogen::symbolic {
namespace {

Quantity quantity_called(const std::string& name) {
  const std::string plain = without_sign(name);
  return {plain, plain.size() < name.size()};
}

// The prefix of names for elements of an array: `qd_` in `qd_HFE`.
std::string prefix_of(const InputArray& array) {
  if (array.role == Role::base_velocity) return "base_";
  const bool is_labelled = array.role == Role::joint_sine || array.role == Role::joint_cosine ||
                           array.role == Role::parameters || array.role == Role::variables;
  return is_labelled ? "" : array.name + "_";
}

// Joins two names, with the link named once if both are quantities of one link: `hip_wx_wy`.
std::string joined(const std::string& a, const std::string& word, const std::string& b) {
  const NameParts x = parts_of(a), y = parts_of(b);
  return x.subject == y.subject && !x.subject.empty() ? a + word + y.quantity : a + word + b;
}

Quantity angle(const QuantityNames& names, const Statement& s) {
  const Quantity argument = names.of(s.a);
  if (argument.name.empty()) return {};
  const std::string label = argument.name.starts_with("q_") ? argument.name.substr(2) : argument.name;
  return {(s.op == Op::sine ? "s_" : "c_") + label, s.op == Op::sine && argument.negative};
}

Quantity product(const QuantityNames& names, const Statement& s) {
  Quantity a = names.of(s.a), b = names.of(s.b);
  // 2 sin cos.
  for (const auto& [number, value] : {std::pair(s.a, b), std::pair(s.b, a)})
    if (names.is_number(number, 2.0) && value.name.starts_with("sc_"))
      return {"s_2" + value.name.substr(3), value.negative != number.negative};
  if (a.name.empty() || b.name.empty()) return {};
  const bool negative = a.negative != b.negative;
  const bool a_is_sine = a.name.starts_with("s_"), a_is_cosine = a.name.starts_with("c_");
  if (a.name == b.name) {
    if (a_is_sine || a_is_cosine) return {a.name.substr(0, 1) + "2" + a.name.substr(1), negative};
    return {a.name + "2", negative};
  }
  const bool b_is_sine = b.name.starts_with("s_"), b_is_cosine = b.name.starts_with("c_");
  const bool are_both = (a_is_sine && b_is_cosine) || (a_is_cosine && b_is_sine);
  if (are_both && a.name.substr(1) == b.name.substr(1)) return {"sc" + a.name.substr(1), negative};
  if (a_is_cosine && b_is_sine) std::swap(a, b);
  return {joined(a.name, "_", b.name), negative};
}

// The factor that a term multiplies by a sine or cosine, whose name `angle` receives: `s_KFE`.
Operand beside_angle(const QuantityNames& names, const Operand& term, std::string& angle) {
  const Statement* product = names.statement(term);
  if (!product || product->op != Op::multiply || term.lane >= 0) return {};
  for (const auto& [function, value] : {std::pair(product->a, product->b), std::pair(product->b, product->a)}) {
    const std::string name = names.of(function).name;
    if (!name.starts_with("s_") && !name.starts_with("c_")) continue;
    angle = name;
    Operand result = value;
    result.negative = (result.negative != function.negative) != term.negative;
    return result;
  }
  return {};
}

// c x - s y, s x + c y: a component of a vector rotated by an angle, named after the component that the cosine
// multiplies.
Quantity component_of_turned(const QuantityNames& names, const Statement& s) {
  std::string of_a, of_b;
  Operand a = beside_angle(names, s.a, of_a), b = beside_angle(names, s.b, of_b);
  if (of_a.empty() || of_b.empty() || of_a.substr(1) != of_b.substr(1) || of_a == of_b) return {};
  b.negative = b.negative != (s.op == Op::subtract);
  const Quantity along = names.of(of_a.front() == 'c' ? a : b);
  if (along.name.empty()) return {};
  return {along.name + "_by" + of_a.substr(1), along.negative};
}

// A quantity plus a multiple of another one of the same link: the same quantity about another point.
Quantity moved_value(const QuantityNames& names, const Statement& s, const Quantity& a, const Quantity& b) {
  for (const auto& [kept, other] : {std::pair(a, s.b), std::pair(b, s.a)}) {
    const Statement* product = names.statement(other);
    if (kept.name.empty() || !product || product->op != Op::multiply || has_meaning(*product)) continue;
    for (const auto& [number, value] : {std::pair(product->a, product->b), std::pair(product->b, product->a)}) {
      if (!is_constant(number)) continue;
      const NameParts x = parts_of(kept.name), y = parts_of(names.of(value).name);
      if (!x.subject.empty() && x.subject == y.subject && x.quantity.front() != 't')
        return {kept.name + "_moved", kept.negative};
    }
  }
  return {};
}

// An element of U = [wd]x + [w]x [w]x: w_r w_c -+ wd, or minus the squares of two components.
std::optional<Quantity> element_of_U(const Quantity& a, const Quantity& b) {
  for (const auto& [rate, product] : {std::pair(a, b), std::pair(b, a)}) {
    const NameParts d = parts_of(rate.name);
    if (d.quantity.size() != 3 || !d.quantity.starts_with("wd")) continue;
    const char axis = d.quantity[2];
    const std::string axes = "xyz";
    const std::size_t k = axes.find(axis);
    if (k == std::string::npos) continue;
    const char i = axes[(k + 1) % 3], j = axes[(k + 2) % 3];
    const std::string stem = d.subject + "_w";
    const bool is_product = product.name == stem + i + "_w" + j || product.name == stem + j + "_w" + i;
    if (!is_product) continue;
    const bool same = rate.negative == product.negative;
    return Quantity{d.subject + "_U" + (same ? std::string{j, i} : std::string{i, j}), product.negative};
  }
  const auto axis_of_square = [](const std::string& quantity) {
    return quantity.size() == 3 && quantity[0] == 'w' && quantity[2] == '2' ? quantity[1] : '\0';
  };
  const NameParts x = parts_of(a.name), y = parts_of(b.name);
  const char i = axis_of_square(x.quantity), j = axis_of_square(y.quantity);
  const auto is_axis = [](char c) { return c >= 'x' && c <= 'z'; };
  if (!is_axis(i) || !is_axis(j) || i == j || x.subject != y.subject || a.negative != b.negative) return std::nullopt;
  const char rest = static_cast<char>('x' + 'y' + 'z' - i - j);
  return Quantity{x.subject + "_U" + rest + rest, !a.negative};
}

Quantity sum(const QuantityNames& names, const Statement& s) {
  const bool subtracts = s.op == Op::subtract;
  // 1 - 2 sin^2.
  if (const Statement* b = names.statement(s.b); b && subtracts && names.is_number(s.a, 1.0) && b->op == Op::multiply) {
    for (const auto& [number, value] : {std::pair(b->a, b->b), std::pair(b->b, b->a)})
      if (names.is_number(number, 2.0) && names.of(value).name.starts_with("s2_"))
        return {"c_2" + names.of(value).name.substr(3), false};
  }
  if (const Quantity turned = component_of_turned(names, s); !turned.name.empty()) return turned;
  const Quantity a = names.of(s.a);
  Quantity b = names.of(s.b);
  b.negative = b.negative != subtracts;
  if (const Quantity moved = moved_value(names, s, a, b); !moved.name.empty()) return moved;
  if (a.name.empty() || b.name.empty()) return {};
  if (const auto u = element_of_U(a, b)) return *u;
  const NameParts x = parts_of(a.name), y = parts_of(b.name);
  if (x.subject.empty() || x.subject != y.subject) return {};
  // The positive term comes first.
  const bool swaps = a.negative && !b.negative;
  const bool differ = a.negative != b.negative;
  const std::string& first = swaps ? b.name : a.name;
  const std::string& second = swaps ? a.name : b.name;
  return {joined(first, differ ? "_minus_" : "_plus_", second), a.negative && b.negative};
}

// The name that the lanes have in common; numbers have no name.
Quantity gathered(const QuantityNames& names, const Statement& s) {
  std::vector<std::string> lanes;
  bool negative = true;
  for (const Operand& o : s.lanes) {
    const Quantity lane = names.of(o);
    if (lane.name.empty()) return {};
    lanes.push_back(lane.name);
    negative = negative && lane.negative;
  }
  const std::string name = common_name(lanes);
  return name.starts_with("lanes") ? Quantity() : Quantity{name, negative};
}

// The name of a statement that follows from the names of its operands.
Quantity composed(const QuantityNames& names, const Statement& s) {
  Quantity result;
  switch (s.op) {
    case Op::sine:
    case Op::cosine:
      result = angle(names, s);
      break;
    case Op::multiply:
      result = product(names, s);
      break;
    case Op::add:
    case Op::subtract:
      result = sum(names, s);
      break;
    case Op::divide:
      if (names.is_number(s.a, 1.0) && !s.a.negative)
        result = names.of(s.b), result.name += result.name.empty() ? "" : "_inv";
      break;
    case Op::square_root:
      result = {names.of(s.a).name, false};
      if (!result.name.empty()) result.name += "_root";
      break;
    case Op::arc_tangent:
      break;
    case Op::sum_lanes:
      result = names.of(s.a);
      if (!result.name.empty()) result.name += "_sum";
      break;
    case Op::gather:
      result = gathered(names, s);
      break;
  }
  return result.name.size() > kLongestQuantityName ? Quantity() : result;
}

}  // namespace

std::string text(const Quantity& quantity) {
  return quantity.name + (quantity.negative ? "_neg" : "");
}

NameParts parts_of(const std::string& name) {
  const std::size_t border = name.rfind('_');
  if (border == std::string::npos) return {"", name};
  return {name.substr(0, border), name.substr(border + 1)};
}

QuantityNames::QuantityNames(const Program& program) : program_(program), statements_(program.statements.size()) {
  for (const InputArray& array : program.inputs)
    for (const std::string& label : array.elements) inputs_.push_back(prefix_of(array) + label);
  UniqueNames given;
  for (const Statement& s : program.statements)
    if (has_meaning(s)) given.reserve(s.name);
  for (std::size_t i = 0; i < statements_.size(); ++i) {
    const Statement& s = program.statements[i];
    statements_[i] = has_meaning(s) ? quantity_called(s.name) : composed(*this, s);
    if (!has_meaning(s) && given.contains(text(statements_[i]))) statements_[i] = {};  // another value has this name
  }
}

Quantity QuantityNames::of(const Operand& o) const {
  Quantity result;
  if (o.kind == Operand::Kind::input) result.name = inputs_[at(o.index)];
  if (is_statement(o)) result = statements_[at(o.index)];
  if (o.lane >= 0 && !result.name.empty()) result.name += "_" + std::to_string(o.lane);
  result.negative = result.negative != o.negative;
  return result;
}

}  // namespace robcogen::symbolic
