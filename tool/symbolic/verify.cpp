#include "symbolic/verify.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "symbolic/text_names.h"

namespace robcogen::symbolic {

int width_of_result(const Program& p, const Statement& s) {
  if (s.op == Op::gather) return static_cast<int>(s.lanes.size());
  if (s.op == Op::sum_lanes) return 1;
  return std::max(width_of(p, s.a), is_binary(s.op) ? width_of(p, s.b) : 1);
}

namespace {

// Whether the numbers of lanes in a statement agree, given valid operands.
bool has_sound_lanes(const Program& p, const Statement& s) {
  const auto is_scalar = [&](const Operand& o) { return width_of(p, o) == 1; };
  if (s.width != width_of_result(p, s)) return false;
  if (s.op == Op::gather) return s.width > 1 && std::all_of(s.lanes.begin(), s.lanes.end(), is_scalar);
  if (s.op == Op::sum_lanes) return !is_scalar(s.a);
  const auto fits = [&](const Operand& o) { return is_scalar(o) || width_of(p, o) == s.width; };
  return fits(s.a) && (!is_binary(s.op) || fits(s.b));
}

bool is_identifier(const std::string& s) {
  if (s.empty() || (s[0] >= '0' && s[0] <= '9')) return false;
  for (char c : s)
    if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_')) return false;
  return true;
}

// The first fault in the names of input or output arrays.
template <class Array>
std::string fault_of_names(const std::vector<Array>& arrays) {
  std::unordered_set<std::string> names;
  for (const Array& array : arrays) {
    if (!is_identifier(array.name)) return "'" + array.name + "' is not a valid identifier";
    if (!names.insert(array.name).second) return "'" + array.name + "' names two arrays";
  }
  return "";
}

}  // namespace

std::string verify(const Program& p) {
  const int inputs = p.input_count();
  const auto sound = [&](const Operand& o, std::size_t before) {
    if (o.index < 0) return false;
    switch (o.kind) {
      case Operand::Kind::constant:
        return o.index < static_cast<int>(p.constants.size());
      case Operand::Kind::input:
        return o.index < inputs;
      case Operand::Kind::statement:
        return static_cast<std::size_t>(o.index) < before &&
               (o.lane < 0 || o.lane < p.statements[static_cast<std::size_t>(o.index)].width);
    }
    return false;
  };
  if (!is_identifier(p.name)) return "the program has no valid name";
  for (const auto& fault : {fault_of_names(p.inputs), fault_of_names(p.outputs)})
    if (!fault.empty()) return fault;
  std::unordered_set<std::string> names;
  for (std::size_t i = 0; i < p.statements.size(); ++i) {
    const Statement& s = p.statements[i];
    const std::string name = s.name.empty() ? std::to_string(i) : s.name;
    if (!s.name.empty() && !is_identifier(name)) return "'" + name + "' is not a valid identifier";
    if (std::any_of(kOps.begin(), kOps.end(), [&](const OpName& o) { return name == o.name; }))
      return "'" + name + "' is an operation";
    if (!names.insert(name).second) return "'" + name + "' is assigned twice";
    const bool gathers = s.op == Op::gather;
    if ((!gathers && !sound(s.a, i)) || (is_binary(s.op) && !sound(s.b, i)) ||
        !std::all_of(s.lanes.begin(), s.lanes.end(), [&](const Operand& o) { return sound(o, i); }))
      return "statement '" + name + "' reads an undefined value";
    if (!has_sound_lanes(p, s)) return "statement '" + name + "' reads lanes that do not fit";
    if (s.section < 0 || s.section >= static_cast<int>(p.sections.size()))
      return "statement '" + name + "' is in no section";
  }
  for (const Constant& n : p.constants)
    if (!(n.value() >= 0.0) || std::isinf(n.value())) return "a constant is negative or not a number";
  for (const OutputArray& array : p.outputs) {
    if (array.rows < 0 || array.columns < 0 ||
        array.values.size() != static_cast<std::size_t>(array.rows) * static_cast<std::size_t>(array.columns))
      return "output '" + array.name + "' has the wrong number of values";
    for (const Operand& o : array.values) {
      if (!sound(o, p.statements.size())) return "output '" + array.name + "' reads an undefined value";
      if (width_of(p, o) > 1) return "output '" + array.name + "' reads several lanes at once";
    }
  }
  return "";
}

}  // namespace robcogen::symbolic
