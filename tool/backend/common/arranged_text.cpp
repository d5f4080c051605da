// The text of single statements and operands of an arrangement.
#include <stdexcept>

#include "backend/common/arrangement.h"
#include "support/concat.h"
#include "support/index.h"

namespace robcogen::backend {

using symbolic::Op;
using symbolic::Operand;
using symbolic::Statement;

namespace {

// Without this check, a mismatch would fail to compile, or would take one lane for another.
void require_lanes(const Arrangement& arranged, const Spelling& value, int lanes) {
  if (value.width == lanes) return;
  throw std::logic_error(concat(
      {arranged.program.name, ": a statement reads ", std::to_string(value.width), " lanes where it takes ",
       std::to_string(lanes), ": ", value.text}));
}

// Spells an operand as it is, and checks that it has `lanes` lanes.
Spelling spell_checked(Arrangement& arranged, const Operand& o, int lanes) {
  Spelling result = spell(arranged, o);
  require_lanes(arranged, result, lanes);
  return result;
}

Spelling gathered(Arrangement& arranged, const Statement& s) {
  std::string list;
  for (const Operand& o : s.lanes) list += (list.empty() ? "" : ", ") + text(spell_checked(arranged, o, 1));
  Spelling result;
  result.text = arranged.texts.add({arranged.dialect.type(s.width), "::of(", list, ")"});
  return result;
}

Spelling sum_of_lanes(Arrangement& arranged, std::size_t i) {
  const Statement& s = arranged.program.statements[i];
  const int lanes = width_of(arranged.program, s.a);
  const Spelling first = spell_checked(arranged, s.a, lanes);
  if (arranged.places[i] != Place::sums) return call("sum_lanes", first, arranged.texts);
  const Statement& next = arranged.program.statements[i + 1];
  return call("sum_lanes", first, spell_checked(arranged, next.a, lanes), arranged.texts);
}

void add_names_of_expression(const Arrangement& arranged, std::size_t i, std::vector<std::string>& names) {
  const Statement& s = arranged.program.statements[i];
  if (s.op == Op::square_root)
    names.push_back(square_of_magnitude(arranged, i) ? arranged.dialect.magnitude : arranged.dialect.square_root);
  if (s.op == Op::arc_tangent) names.push_back(arranged.dialect.arc_tangent);
  if (s.op == Op::gather) names.push_back(arranged.dialect.type(s.width));
  for_each_operand(s, [&](const Operand& o) {
    const bool is_apart = s.op == Op::gather || s.op == Op::sum_lanes;
    add_names(arranged, o, is_apart ? width_of(arranged.program, o) : s.width, names);
  });
}

}  // namespace

const Statement* square_of_magnitude(const Arrangement& arranged, std::size_t i) {
  const Statement& root = arranged.program.statements[i];
  if (root.op != Op::square_root || arranged.dialect.magnitude.empty()) return nullptr;
  if (root.a.kind != Operand::Kind::statement || root.a.negative || root.a.lane >= 0) return nullptr;
  if (arranged.places[at(root.a.index)] != Place::inside) return nullptr;  // it has a line
  const Statement& square = arranged.program.statements[at(root.a.index)];
  return square.op == Op::multiply && square.a == square.b && square.width == root.width ? &square : nullptr;
}

Spelling expression(Arrangement& arranged, std::size_t i) {
  const Statement& s = arranged.program.statements[i];
  Spelling result;
  if (const Statement* square = square_of_magnitude(arranged, i)) {
    Operand x = square->a;
    x.negative = false;
    result = call(arranged.dialect.magnitude, spell_checked(arranged, x, s.width), arranged.texts);
  } else if (s.op == Op::square_root) {
    result = call(arranged.dialect.square_root, spell_checked(arranged, s.a, s.width), arranged.texts);
  } else if (s.op == Op::arc_tangent || (s.op == Op::divide && !arranged.dialect.quotient.empty())) {
    const Dialect& d = arranged.dialect;
    const Spelling first = spell(arranged, s.a, s.width), second = spell(arranged, s.b, s.width);
    require_lanes(arranged, first, s.width);
    require_lanes(arranged, second, s.width);
    result = call(s.op == Op::divide ? d.quotient : d.arc_tangent, first, second, arranged.texts);
  } else if (s.op == Op::sum_lanes) {
    result = sum_of_lanes(arranged, i);
  } else if (s.op == Op::gather) {
    result = gathered(arranged, s);
  } else {
    const Spelling a = spell(arranged, s.a, s.width), b = spell(arranged, s.b, s.width);
    require_lanes(arranged, a, s.width);
    require_lanes(arranged, b, s.width);
    result = binary(s.op, a, b, arranged.texts);
  }
  result.width = s.width;
  return result;
}

Spelling spell(Arrangement& arranged, const Operand& o, int lanes) {
  if (lanes == 1 || width_of(arranged.program, o) == lanes) return spell(arranged, o);
  Spelling result;
  if (is_constant(o)) {
    const Spelling& number = arranged.constants[at(o.index)];
    const std::string type = arranged.dialect.type(lanes);
    result = literal(
        arranged.texts.add({type, "(", number.text, ")"}), arranged.texts.add({type, "(", number.opposite, ")"}));
    result.negative = o.negative;
    result.width = lanes;
    return result;
  }
  const Operand positive = {o.kind, o.index, false, o.lane};
  result = call(arranged.dialect.type(lanes), spell(arranged, positive), arranged.texts);
  result.negative = o.negative;
  result.width = lanes;
  return result;
}

Spelling lane_of(Arrangement& arranged, Spelling value, int lane) {
  value.text = arranged.texts.add({arranged.dialect.element(std::string(value.text), at(lane))});
  value.width = 1;
  return value;
}

Spelling spell(Arrangement& arranged, const Operand& o) {
  Spelling result;
  if (is_constant(o)) {
    result = arranged.constants[at(o.index)];
    if (arranged.program.constants[at(o.index)].is_zero()) return result;
  } else if (o.kind == Operand::Kind::input) {
    result.text = arranged.input_names[at(o.index)];
  } else {
    const bool inside = arranged.places[at(o.index)] == Place::inside;
    result = (inside ? arranged.expressions : arranged.spellings)[at(o.index)];
    if (o.lane >= 0) result = lane_of(arranged, result, o.lane);
  }
  result.negative = result.negative != o.negative;
  return result;
}

Line line(const Arrangement& arranged, std::size_t i) {
  const Spelling& expression = arranged.expressions[i];
  if (arranged.places[i] == Place::sums)
    return {Line::Kind::pick, {arranged.names[i], arranged.names[i + 1]}, text(expression)};
  if (arranged.places[i] != Place::output) {
    Line result{Line::Kind::definition, {}, text(expression), 0, arranged.program.statements[i].width};
    result.targets.push_back(arranged.names[i]);
    return result;
  }
  Spelling value = expression;
  value.negative = value.negative != arranged.stores[i].front().negative;
  Line result{Line::Kind::store, {}, text(value)};
  for (const Store& store : arranged.stores[i]) result.targets.push_back(target(arranged, store.output, store.element));
  return result;
}

void add_names(const Arrangement& arranged, const Operand& o, int lanes, std::vector<std::string>& names) {
  if (width_of(arranged.program, o) != lanes) names.push_back(arranged.dialect.type(lanes));
  if (is_constant(o)) return;
  if (o.kind == Operand::Kind::input) {
    names.push_back(arranged.input_sources[at(o.index)]);
    return;
  }
  const std::size_t i = at(o.index);
  const Statement& s = arranged.program.statements[i];
  if (arranged.places[i] == Place::inside) {
    add_names_of_expression(arranged, i, names);
  } else if (arranged.places[i] == Place::loaded) {
    names.push_back(arranged.load_names[arranged.blocks.loaded.at(i).first]);
  } else if (is_angle_function(s.op)) {
    const Angle& angle = arranged.angles.at(supplier(arranged, s.a));
    names.push_back(s.op == Op::sine ? angle.sine_name : angle.cosine_name);
  } else {
    names.push_back(arranged.names[i]);
  }
}

std::vector<std::string> names_in_line(const Arrangement& arranged, std::size_t i) {
  std::vector<std::string> names;
  add_names_of_expression(arranged, i, names);
  if (arranged.places[i] == Place::sums) add_names_of_expression(arranged, i + 1, names);
  if (arranged.places[i] != Place::output) return names;
  for (const Store& store : arranged.stores[i]) names.push_back(output_parameter(arranged, store.output).name);
  return names;
}

const KernelArray& output_parameter(const Arrangement& arranged, std::size_t output) {
  return arranged.parameters[arranged.program.inputs.size() + output];
}

std::string target(const Arrangement& arranged, std::size_t output, std::size_t element) {
  return arranged.dialect.element(output_parameter(arranged, output).name, element);
}

AngleKey supplier(const Arrangement& arranged, const Operand& argument) {
  const AngleKey whole = {argument.kind, argument.index};
  return arranged.angles.count(whole) > 0 ? whole : key_of(argument);
}

}  // namespace robcogen::backend
