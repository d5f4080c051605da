#include "symbolic/text.h"

#include <map>

#include "support/index.h"
#include "support/unique_names.h"
#include "symbolic/text_names.h"

namespace robcogen::symbolic {
namespace {

std::string name_of(Role role) {
  for (const RoleName& r : kRoles)
    if (r.role == role) return r.name;
  return "value";
}

std::string name_of(Op op) {
  for (const OpName& o : kOps)
    if (o.op == op) return o.name;
  return "?";
}

std::string print_constant(const Number& n) {
  if (!n.is_pi_multiple()) return print_double(n.value());
  return "pi:" + std::to_string(n.ratio()->num) + ":" + std::to_string(n.ratio()->den);
}

}  // namespace

std::vector<std::string> statement_names(const Program& p) {
  UniqueNames used;
  std::vector<std::string> names;
  for (const Statement& s : p.statements) {
    names.push_back(s.name);
    if (!s.name.empty()) used.reserve(s.name);
  }
  for (const bool named : {true, false})
    for (std::size_t i = 0; i < names.size(); ++i)
      if (const Statement& s = p.statements[i]; names[i].empty() && has_meaning(s) && s.named == named)
        names[i] = used.add(text(*s.quantity));
  std::map<std::string, int> next_number;  // by prefix
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!names[i].empty()) continue;
    const std::string& prefix = p.sections[at(p.statements[i].section)].prefix;
    names[i] = used.add(prefix + "_t" + std::to_string(next_number[prefix]++));
  }
  return names;
}

std::string print(const Program& p) {
  const std::vector<std::string> names = statement_names(p);
  std::vector<std::string> inputs;
  for (const InputArray& array : p.inputs)
    for (std::size_t i = 0; i < array.elements.size(); ++i)
      inputs.push_back(array.name + "[" + std::to_string(i) + "]");
  const auto text = [&](const Operand& o) {
    const auto i = static_cast<std::size_t>(o.index);
    const std::string value = is_constant(o)                   ? print_constant(p.constants[i].number())
                              : o.kind == Operand::Kind::input ? inputs[i]
                                                               : names[i];
    return (o.negative ? "-" : "") + value + (o.lane >= 0 ? "@" + std::to_string(o.lane) : "");
  };

  std::string out = "program " + p.name + "\n";
  for (const InputArray& array : p.inputs) {
    out += "input " + array.name + " " + name_of(array.role);
    for (const std::string& element : array.elements) out += " " + element;
    out += "\n";
  }
  for (const OutputArray& array : p.outputs)
    out += "output " + array.name + " " + name_of(array.role) + " " + std::to_string(array.rows) + " " +
           std::to_string(array.columns) + "\n";
  for (const Section& s : p.sections) out += "section " + s.prefix + " " + s.title + "\n";
  int section = -1;
  for (std::size_t i = 0; i < p.statements.size(); ++i) {
    const Statement& s = p.statements[i];
    if (s.section != section) out += "in " + std::to_string(section = s.section) + "\n";
    out += (s.named ? "let " : "tmp ") + names[i] + " = ";
    if (s.op == Op::gather) {
      out += name_of(s.op);
      for (const Operand& o : s.lanes) out += " " + text(o);
    } else {
      out += is_binary(s.op) ? text(s.a) + " " + name_of(s.op) + " " + text(s.b) : name_of(s.op) + " " + text(s.a);
    }
    out += "\n";
  }
  for (const OutputArray& array : p.outputs) {
    out += "return " + array.name;
    for (const Operand& o : array.values) out += " " + text(o);
    out += "\n";
  }
  return out;
}

}  // namespace robcogen::symbolic
