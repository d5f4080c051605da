#include "backend/common/fit_lines.h"

#include <algorithm>
#include <string>
#include <utility>

#include "support/index.h"

namespace robcogen::backend {
namespace {

using symbolic::Op;
using symbolic::Operand;
using symbolic::Statement;

bool has_expression(Place place) {
  return place == Place::inside || place == Place::own || place == Place::output || place == Place::sums;
}

struct Part {
  int statement = -1;
  bool fused = false;  // a product inside a sum
  std::size_t width = 0;
};

// Finds the part of statement i's expression to take out first: the widest, with products inside sums last.
void consider_parts(const Arrangement& arranged, std::size_t i, Part& best) {
  if (arranged.places[i] == Place::sums) consider_parts(arranged, i + 1, best);
  const Statement& s = arranged.program.statements[i];
  for_each_operand(s, [&](const Operand& o) {
    if (!is_statement(o) || arranged.places[at(o.index)] != Place::inside) return;
    const Part part{
        o.index, arranged.program.statements[at(o.index)].op == Op::multiply && is_sum(s.op),
        arranged.expressions[at(o.index)].text.size()};
    if (best.statement < 0 || std::pair(!part.fused, part.width) > std::pair(!best.fused, best.width)) best = part;
    consider_parts(arranged, at(o.index), best);
  });
}

// Two sums of lanes whose common line is too long get a line each.
void part_sums(Arrangement& arranged, std::size_t i) {
  arranged.places[i] = arranged.places[i + 1] = Place::own;
  arranged.expressions[i] = expression(arranged, i);
}

// The line is written out and measured only if it may be too long.
bool fits(const Arrangement& arranged, std::size_t i) {
  const std::size_t inner = arranged.spellings[i].text.size() + arranged.expressions[i].text.size();
  const bool is_definition = arranged.places[i] == Place::own || arranged.places[i] == Place::inside;
  if (is_definition && inner + arranged.dialect.around <= arranged.dialect.line_limit) return true;
  const std::string written = text(line(arranged, i), arranged.dialect);
  const std::size_t first = std::min(written.find('\n'), written.size());
  const std::size_t rest = written.size() - std::min(first + 1, written.size());
  return first <= arranged.dialect.line_limit && rest <= arranged.dialect.line_limit + arranged.dialect.indentation;
}

// Spells all statements again that the part stood inside of, up to i.
void spell_users(Arrangement& arranged, std::size_t part, std::size_t i) {
  while (part != i) {
    part = at(arranged.users[part]);
    arranged.expressions[part] = expression(arranged, part);
  }
}

// Statements are visited in order, so everything that stands inside this one is already spelled and fits.
void fit(Arrangement& arranged, std::size_t i) {
  arranged.expressions[i] = expression(arranged, i);
  while (!fits(arranged, i)) {
    Part part;
    consider_parts(arranged, i, part);
    if (part.statement < 0) {
      if (arranged.places[i] != Place::sums) return;
      part_sums(arranged, i);
      continue;
    }
    arranged.places[at(part.statement)] = Place::own;
    spell_users(arranged, at(part.statement), i);
  }
}

}  // namespace

void fit_lines(Arrangement& arranged) {
  for (std::size_t i = 0; i < arranged.places.size(); ++i)
    if (has_expression(arranged.places[i])) fit(arranged, i);
}

}  // namespace robcogen::backend
