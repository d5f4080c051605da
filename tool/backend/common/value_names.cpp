#include "backend/common/value_names.h"

#include <map>

#include "support/concat.h"
#include "support/index.h"
#include "support/unique_names.h"
#include "symbolic/derived_quantities.h"

namespace robcogen::backend {
namespace {

using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;
using symbolic::Quantities;
using symbolic::Quantity;
using symbolic::QuantityRef;
using symbolic::Statement;

// The name of a quantity within its link; of products and sums, that of the last operand.
std::string name_in_link(const Quantity& q) {
  using Form = Quantity::Form;
  const bool has_two = q.form == Form::product || q.form == Form::sum || q.form == Form::difference;
  return has_two ? name_in_link(*q.b) : parts_of(q).last;
}

// The suffix of a part of a quantity: `_to_az` for the running sum up to a term with az, `_of_az` for that term.
std::string part_of_whole(const Quantities& known, const Statement& s) {
  if (s.op == Op::gather) return "_lanes";
  const auto last = [&](const Operand& o) {
    const QuantityRef quantity = known.of(o).quantity;
    return quantity ? name_in_link(*quantity) : "";
  };
  const auto of_product = [&](const Statement& product) {
    // Prefer the factor that is not a sine or cosine: the component that is rotated.
    for (const Operand& o : {product.b, product.a}) {
      const QuantityRef quantity = known.of(o).quantity;
      if (quantity && !is_sine(*quantity) && !is_cosine(*quantity)) return name_in_link(*quantity);
    }
    const std::string of_b = last(product.b);
    return of_b.empty() ? last(product.a) : of_b;
  };
  if (!is_sum(s.op)) {
    const std::string factor = s.op == Op::multiply ? of_product(s) : last(s.a);
    return factor.empty() ? "_term" : "_of_" + factor;
  }
  for (const Operand& o : {s.b, s.a}) {
    const Statement* term = known.statement(o);
    std::string added = last(o);
    if (added.empty() && term && term->op == Op::multiply) added = of_product(*term);
    if (!added.empty()) return "_to_" + added;
  }
  return "_part";
}

// Names for statements without a quantity: each is a part of the quantity that its first reader is, or is a part of.
// Empty for others.
std::vector<std::string> names_of_parts(const Quantities& known) {
  const Program& program = known.program();
  std::vector<int> reader(known.size(), -1);
  for (std::size_t i = known.size(); i-- > 0;)
    for_each_operand(program.statements[i], [&](const Operand& o) {
      if (is_statement(o)) reader[at(o.index)] = static_cast<int>(i);
    });
  std::vector<std::string> result(known.size()), whole(known.size());
  for (std::size_t i = known.size(); i-- > 0;) {
    if (known[i].quantity) {
      whole[i] = unsigned_text(*known[i].quantity);
      continue;
    }
    if (reader[i] < 0) continue;
    whole[i] = whole[at(reader[i])];
    if (whole[i].empty()) continue;
    constexpr std::size_t kLongest = symbolic::kLongestQuantityName + 4;
    const Statement& s = program.statements[i];
    std::string word = part_of_whole(known, s);
    if (whole[i].size() + word.size() > kLongest) word = is_sum(s.op) ? "_part" : "_term";
    if (whole[i].size() + word.size() <= kLongest) result[i] = whole[i] + word;
  }
  return result;
}

}  // namespace

std::vector<std::string> value_names(const Program& program, const std::vector<bool>& is_line) {
  const Quantities known(program);
  std::vector<std::string> result(known.size());
  UniqueNames used;
  // Names that the algorithm gave come first.
  for (const bool named : {true, false})
    for (std::size_t i = 0; i < known.size(); ++i)
      if (const Statement& s = program.statements[i]; has_meaning(s) && s.named == named)
        result[i] = used.add(text(*s.quantity));
  const std::vector<std::string> parts = names_of_parts(known);
  std::map<std::string, int> next_of_prefix;
  std::vector<int*> next;  // by section
  for (const symbolic::Section& section : program.sections) next.push_back(&next_of_prefix[section.prefix]);
  for (const bool lines : {true, false}) {
    for (std::size_t i = 0; i < known.size(); ++i)
      if (is_line[i] == lines && result[i].empty() && known[i].quantity)
        if (const std::string name = text(known[i]); used.reserve(name)) result[i] = name;
    for (std::size_t i = 0; i < known.size(); ++i)
      if (is_line[i] == lines && result[i].empty() && !parts[i].empty()) result[i] = used.add(parts[i]);
    for (std::size_t i = 0; i < known.size(); ++i) {
      if (is_line[i] != lines || !result[i].empty()) continue;
      const auto section = at(program.statements[i].section);
      do result[i] = concat({program.sections[section].prefix, "_t", std::to_string((*next[section])++)});
      while (!used.reserve(result[i]));
    }
  }
  return result;
}

}  // namespace robcogen::backend
