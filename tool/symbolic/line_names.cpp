#include "symbolic/line_names.h"

#include <algorithm>
#include <map>

#include "support/concat.h"
#include "support/index.h"
#include "support/unique_names.h"

namespace robcogen::symbolic {
namespace {

// The suffix of a part of a quantity: `_to_az` for the running sum up to a term with az, `_of_az` for that term.
std::string part_of_whole(const QuantityNames& known, const Statement& s) {
  if (s.op == Op::gather) return "_lanes";
  const auto quantity = [&](const Operand& o) {
    std::string name = known.of(o).name;
    return name.empty() ? name : parts_of(name).quantity;
  };
  const auto of_product = [&](const Statement& product) {
    // Prefer the factor that is not a sine or cosine: the component that is rotated.
    for (const Operand& o : {product.b, product.a}) {
      const std::string name = known.of(o).name;
      if (!name.empty() && !name.starts_with("s_") && !name.starts_with("c_")) return quantity(o);
    }
    const std::string last = quantity(product.b);
    return last.empty() ? quantity(product.a) : last;
  };
  if (!is_sum(s.op)) {
    const std::string factor = s.op == Op::multiply ? of_product(s) : quantity(s.a);
    return factor.empty() ? "_term" : "_of_" + factor;
  }
  for (const Operand& o : {s.b, s.a}) {
    const Statement* term = known.statement(o);
    std::string added = quantity(o);
    if (added.empty() && term && term->op == Op::multiply) added = of_product(*term);
    if (!added.empty()) return "_to_" + added;
  }
  return "_part";
}

// Names for statements that have none yet: each is a part of the quantity that its first reader is, or is a part of.
std::map<std::size_t, std::string> names_of_parts(const QuantityNames& known, const std::vector<bool>& is_line) {
  const Program& program = known.program();
  std::map<std::size_t, std::string> result;
  if (std::find(is_line.begin(), is_line.end(), true) == is_line.end()) return result;
  std::vector<int> reader(known.size(), -1);
  for (std::size_t i = known.size(); i-- > 0;)
    for_each_operand(program.statements[i], [&](const Operand& o) {
      if (is_statement(o)) reader[at(o.index)] = static_cast<int>(i);
    });
  std::vector<std::string> whole(known.size());
  for (std::size_t i = known.size(); i-- > 0;) {
    if (!known[i].name.empty()) {
      whole[i] = known[i].name;
      continue;
    }
    if (reader[i] < 0) continue;
    whole[i] = whole[at(reader[i])];
    if (whole[i].empty() || !is_line[i]) continue;
    const std::string word = part_of_whole(known, program.statements[i]);
    if (whole[i].size() + word.size() <= kLongestQuantityName + 4) result.insert({i, whole[i] + word});
  }
  return result;
}

std::vector<std::string> distinct(
    const QuantityNames& known,
    const std::map<std::size_t, std::string>& parts,
    const std::vector<bool>& is_line) {
  const Program& program = known.program();
  std::vector<std::string> result(known.size());
  UniqueNames used;
  const auto take = [&](std::size_t i, const std::string& name) { result[i] = used.add(name); };
  // Names given by the algorithm come first and are kept.
  for (std::size_t i = 0; i < known.size(); ++i)
    if (program.statements[i].named) take(i, program.statements[i].name);
  for (std::size_t i = 0; i < known.size(); ++i)
    if (is_line[i] && result[i].empty() && !known[i].name.empty() && !used.contains(text(known[i])))
      take(i, text(known[i]));
  for (const auto& [i, name] : parts)
    if (result[i].empty()) take(i, name);
  std::map<std::string, int> next_of_prefix;
  std::vector<int*> next;  // by section
  for (const Section& section : program.sections) next.push_back(&next_of_prefix[section.prefix]);
  for (const bool lines : {true, false}) {
    for (std::size_t i = 0; i < known.size(); ++i) {
      if (is_line[i] != lines || !result[i].empty()) continue;
      const auto section = at(program.statements[i].section);
      const std::string& prefix = program.sections[section].prefix;
      do result[i] = concat({prefix, "_t", std::to_string((*next[section])++)});
      while (!used.reserve(result[i]));
    }
  }
  return result;
}

}  // namespace

std::vector<std::string> line_names(const QuantityNames& known, const std::vector<bool>& is_line) {
  return distinct(known, names_of_parts(known, is_line), is_line);
}

}  // namespace robcogen::symbolic
