// What an arrangement says of single statements and operands.
#include "backend/common/arrangement.h"
#include "support/index.h"

namespace robcogen::backend {

using symbolic::Op;
using symbolic::Operand;
using symbolic::Statement;

Spelling expression(Arrangement& arranged, std::size_t i) {
  const Statement& s = arranged.program.statements[i];
  if (s.op == Op::square_root) return call("sqrt", spell(arranged, s.a), arranged.texts);
  if (arranged.places[i] == Place::sums) {
    const Operand& next = arranged.program.statements[i + 1].a;
    return call("sum_lanes", spell(arranged, s.a), spell(arranged, next), arranged.texts);
  }
  if (s.op == Op::sum_lanes) return call("sum_lanes", spell(arranged, s.a), arranged.texts);
  if (s.op == Op::gather) {
    std::string list;
    for (const Operand& o : s.lanes) list += (list.empty() ? "" : ", ") + text(spell(arranged, o));
    Spelling gathered;
    gathered.text = arranged.texts.add({arranged.dialect.type(s.width), "::of(", list, ")"});
    return gathered;
  }
  return binary(s.op, spell(arranged, s.a, s.width), spell(arranged, s.b, s.width), arranged.texts);
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
    return result;
  }
  const Operand positive = {o.kind, o.index, false, o.lane};
  result = call(arranged.dialect.type(lanes), spell(arranged, positive), arranged.texts);
  result.negative = o.negative;
  return result;
}

Spelling lane_of(Arrangement& arranged, Spelling value, int lane) {
  value.text = arranged.texts.add({arranged.dialect.element(std::string(value.text), at(lane))});
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
  for (const Store& store : arranged.stores[i]) result.targets.push_back(store.target);
  return result;
}

const Parameter& output_parameter(const Arrangement& arranged, std::size_t output) {
  return arranged.parameters[arranged.program.inputs.size() + output];
}

bool is_in_block(const Arrangement& arranged, std::size_t output, std::size_t element) {
  return arranged.dialect.stores && arranged.blocks.is_stored[output][element];
}

bool is_angle_function(Op op) {
  return op == Op::sine || op == Op::cosine;
}

}  // namespace robcogen::backend
