#include "symbolic/derived_quantities.h"

#include <array>
#include <optional>
#include <utility>

#include "support/unique_names.h"

namespace robcogen::symbolic {
namespace {

using Form = Quantity::Form;

constexpr const char* kAxes = "xyz";

QuantityRef ref(Quantity quantity) {
  return std::make_shared<const Quantity>(std::move(quantity));
}

// The quantity of an element of an input.
Quantity input_quantity(const InputArray& array, std::size_t k) {
  if (!array.quantities.empty()) return *array.quantities[k];
  const std::string& label = array.elements[k];
  switch (array.role) {
    case Role::parameters:
    case Role::variables:
      return {label};
    case Role::joint_sine:
    case Role::joint_cosine: {
      constexpr std::size_t kPrefix = 2;  // s_, c_
      const Form form = array.role == Role::joint_sine ? Form::sine : Form::cosine;
      return made(form, ref({label.substr(std::min(kPrefix, label.size()))}));
    }
    case Role::base_velocity:
      return {"base", k < 3 ? "w" : "v", std::string(1, kAxes[k % 3])};
    default: {
      Quantity result{label, array.name};
      result.of_coordinates = true;
      return result;
    }
  }
}

Signed value(Form form, const Signed& a, bool negative) {
  return {ref(made(form, a.quantity)), negative};
}

// An element, with this symbol, of a vector of a link: `w` of the hip, for one axis. The axis, or -1.
int axis_of(const Quantity& q, const char* symbol) {
  if (q.form != Form::value || q.of_coordinates || q.symbol != symbol || q.element.size() != 1) return -1;
  const std::size_t axis = std::string(kAxes).find(q.element.front());
  return axis == std::string::npos ? -1 : static_cast<int>(axis);
}

std::string name_of(const QuantityRef& q) {
  return unsigned_text(*q);
}

bool share_stem(const QuantityRef& a, const QuantityRef& b) {
  const std::string stem = parts_of(*a).stem;
  return !stem.empty() && stem == parts_of(*b).stem;
}

Signed angle(const Quantities& known, const Statement& s) {
  const Signed argument = known.of(s.a);
  if (!argument.quantity) return {};
  const bool is_sine = s.op == Op::sine;
  return value(is_sine ? Form::sine : Form::cosine, argument, is_sine && argument.negative);
}

Signed product_of(const Quantities& known, const Statement& s) {
  Signed a = known.of(s.a), b = known.of(s.b);
  // 2 sin cos.
  for (const auto& [number, value] : {std::pair(s.a, b), std::pair(s.b, a)})
    if (known.is_number(number, 2.0) && value.quantity && value.quantity->form == Form::sine_cosine)
      return {ref(made(Form::double_sine, value.quantity->a)), value.negative != number.negative};
  if (!a.quantity || !b.quantity) return {};
  const bool negative = a.negative != b.negative;
  if (name_of(a.quantity) == name_of(b.quantity)) return value(Form::square, a, negative);
  if (is_cosine(*a.quantity) && is_sine(*b.quantity)) std::swap(a, b);
  const bool has_both = is_sine(*a.quantity) && is_cosine(*b.quantity);
  if (has_both && a.quantity->form == Form::sine && b.quantity->form == Form::cosine &&
      angle_of(*a.quantity) == angle_of(*b.quantity))
    return value(Form::sine_cosine, {a.quantity->a}, negative);
  return {ref(made(Form::product, a.quantity, b.quantity)), negative};
}

// The factor that a term multiplies by a sine or cosine, which `angle` receives.
Operand beside_angle(const Quantities& known, const Operand& term, QuantityRef& angle) {
  const Statement* product = known.statement(term);
  if (!product || product->op != Op::multiply || term.lane >= 0) return {};
  for (const auto& [function, value] : {std::pair(product->a, product->b), std::pair(product->b, product->a)}) {
    const QuantityRef quantity = known.of(function).quantity;
    if (!quantity || (!is_sine(*quantity) && !is_cosine(*quantity))) continue;
    angle = quantity;
    Operand result = value;
    result.negative = (result.negative != function.negative) != term.negative;
    return result;
  }
  return {};
}

// c x - s y, s x + c y: a component of a vector rotated by an angle, named after the component that the cosine
// multiplies.
Signed component_of_rotated(const Quantities& known, const Statement& s) {
  QuantityRef of_a, of_b;
  Operand a = beside_angle(known, s.a, of_a), b = beside_angle(known, s.b, of_b);
  if (!of_a || !of_b || angle_of(*of_a) != angle_of(*of_b) || is_cosine(*of_a) == is_cosine(*of_b)) return {};
  b.negative = b.negative != (s.op == Op::subtract);
  const Signed along = known.of(is_cosine(*of_a) ? a : b);
  if (!along.quantity) return {};
  return {ref(made(Form::rotated, along.quantity, of_a)), along.negative};
}

// A quantity plus a multiple of another one of the same link: the same quantity about another point.
Signed moved_value(const Quantities& known, const Statement& s, const Signed& a, const Signed& b) {
  for (const auto& [kept, other] : {std::pair(a, s.b), std::pair(b, s.a)}) {
    const Statement* product = known.statement(other);
    if (!kept.quantity || kept.quantity->form == Form::moved || !product || product->op != Op::multiply ||
        has_meaning(*product))
      continue;
    for (const auto& [number, value] : {std::pair(product->a, product->b), std::pair(product->b, product->a)}) {
      const QuantityRef added = known.of(value).quantity;
      if (is_constant(number) && added && share_stem(kept.quantity, added))
        return symbolic::value(Form::moved, kept, kept.negative);
    }
  }
  return {};
}

// An element of U = [wd]x + [w]x [w]x: w_r w_c -+ wd, or minus the squares of two components.
Signed element_of_U(const Signed& a, const Signed& b) {
  const auto element = [&](const std::string& link, int row, int column, bool negative) {
    return Signed{ref({link, "U", {kAxes[row], kAxes[column]}}), negative};
  };
  for (const auto& [rate, product] : {std::pair(a, b), std::pair(b, a)}) {
    const int axis = axis_of(*rate.quantity, "wd");
    if (axis < 0 || product.quantity->form != Form::product) continue;
    const Quantity &x = *product.quantity->a, &y = *product.quantity->b;
    const int i = axis_of(x, "w"), j = axis_of(y, "w");
    if (i < 0 || j < 0 || i + j + axis != 3 || i == axis || j == axis) continue;
    if (x.subject != rate.quantity->subject || y.subject != x.subject) continue;
    const int row = (axis + 1) % 3, column = (axis + 2) % 3;
    const bool same = rate.negative == product.negative;
    return same ? element(x.subject, column, row, product.negative) : element(x.subject, row, column, product.negative);
  }
  if (a.quantity->form != Form::square || b.quantity->form != Form::square || a.negative != b.negative) return {};
  const Quantity &x = *a.quantity->a, &y = *b.quantity->a;
  const int i = axis_of(x, "w"), j = axis_of(y, "w");
  if (i < 0 || j < 0 || i == j || x.subject != y.subject) return {};
  return element(x.subject, 3 - i - j, 3 - i - j, !a.negative);
}

Signed sum(const Quantities& known, const Statement& s) {
  const bool subtracts = s.op == Op::subtract;
  // 1 - 2 sin^2.
  if (const Statement* b = known.statement(s.b); b && subtracts && known.is_number(s.a, 1.0) && b->op == Op::multiply) {
    for (const auto& [number, value] : {std::pair(b->a, b->b), std::pair(b->b, b->a)}) {
      const QuantityRef square = known.of(value).quantity;
      if (known.is_number(number, 2.0) && square && square->form == Form::square && square->a->form == Form::sine)
        return {ref(made(Form::double_cosine, square->a->a)), false};
    }
  }
  if (const Signed rotated = component_of_rotated(known, s); rotated.quantity) return rotated;
  const Signed a = known.of(s.a);
  Signed b = known.of(s.b);
  b.negative = b.negative != subtracts;
  if (const Signed moved = moved_value(known, s, a, b); moved.quantity) return moved;
  if (!a.quantity || !b.quantity) return {};
  if (const Signed u = element_of_U(a, b); u.quantity) return u;
  if (!share_stem(a.quantity, b.quantity)) return {};
  // The positive term comes first.
  const bool swaps = a.negative && !b.negative;
  const Form form = a.negative != b.negative ? Form::difference : Form::sum;
  const QuantityRef &first = swaps ? b.quantity : a.quantity, &second = swaps ? a.quantity : b.quantity;
  return {ref(made(form, first, second)), a.negative && b.negative};
}

// The quantity that the lanes have in common; numbers have none.
Signed gathered(const Quantities& known, const Statement& s) {
  std::vector<QuantityRef> lanes;
  bool negative = true;
  for (const Operand& o : s.lanes) {
    const Signed lane = known.of(o);
    if (!lane.quantity) return {};
    lanes.push_back(lane.quantity);
    negative = negative && lane.negative;
  }
  std::optional<Quantity> shared = common_quantity(lanes);
  return shared ? Signed{ref(*std::move(shared)), negative} : Signed();
}

// What follows for a statement from its operands.
Signed derived(const Quantities& known, const Statement& s) {
  switch (s.op) {
    case Op::sine:
    case Op::cosine:
      return angle(known, s);
    case Op::multiply:
      return product_of(known, s);
    case Op::add:
    case Op::subtract:
      return sum(known, s);
    case Op::divide: {
      const Signed divisor = known.of(s.b);
      const bool is_inverse = known.is_number(s.a, 1.0) && !s.a.negative && divisor.quantity;
      return is_inverse ? value(Form::inverse, divisor, divisor.negative) : Signed();
    }
    case Op::square_root: {
      const Signed square = known.of(s.a);
      return square.quantity ? value(Form::root, square, false) : Signed();
    }
    case Op::arc_tangent:
      return {};
    case Op::sum_lanes: {
      const Signed lanes = known.of(s.a);
      return lanes.quantity ? value(Form::sum_of_lanes, lanes, lanes.negative) : Signed();
    }
    case Op::gather:
      return gathered(known, s);
  }
  return {};
}

}  // namespace

std::string text(const Signed& value) {
  return unsigned_text(*value.quantity) + (value.negative ? "_neg" : "");
}

Quantities::Quantities(const Program& program) : program_(program), statements_(program.statements.size()) {
  for (const InputArray& array : program.inputs)
    for (std::size_t k = 0; k < array.elements.size(); ++k) inputs_.push_back(ref(input_quantity(array, k)));
  UniqueNames given;
  for (const Statement& s : program.statements)
    if (has_meaning(s)) given.reserve(text(*s.quantity));
  for (std::size_t i = 0; i < statements_.size(); ++i) {
    const Statement& s = program.statements[i];
    if (has_meaning(s)) {
      statements_[i] = {s.quantity, s.quantity->negative};
      continue;
    }
    Signed value = derived(*this, s);
    if (!value.quantity || unsigned_text(*value.quantity).size() > kLongestQuantityName) continue;
    if (!given.contains(text(value))) statements_[i] = std::move(value);  // otherwise another value has this name
  }
}

Signed Quantities::of(const Operand& o) const {
  if (is_constant(o)) return {};
  Signed result = is_statement(o) ? statements_[at(o.index)] : Signed{inputs_[at(o.index)]};
  if (o.lane >= 0 && result.quantity) {
    Quantity lane = made(Form::lane, result.quantity);
    lane.lane = o.lane;
    result.quantity = ref(std::move(lane));
  }
  result.negative = result.negative != o.negative;
  return result;
}

}  // namespace robcogen::symbolic
