#include "backend/c/dialect.h"

#include <cmath>

#include "backend/common/layout.h"
#include "backend/cpp/names.h"
#include "support/concat.h"
#include "support/number.h"

namespace robcogen::backend::c {
namespace {

// Keywords of C and C++, since headers are for both, and macros of system headers.
bool is_reserved(const std::string& name) {
  return name == "restrict" || cpp::is_reserved(name);
}

std::vector<std::string> values(const std::vector<std::string>& labels) {
  std::vector<std::string> elements;
  for (std::size_t k = 0; k < labels.size(); ++k) elements.push_back(subscripted("values", k));
  return elements;
}

template <const Precision& precision>
std::string line(const Line& l) {
  if (l.kind == Line::Kind::store) return joined(l.targets, " = ") + " = " + l.expression + ";";
  return "const " + precision.scalar + " " + l.targets.front() + " = " + l.expression + ";";
}

template <const Precision& precision>
Dialect make_dialect(bool reads_cache) {
  Dialect d;
  d.is_reserved = is_reserved;
  for (std::string* function : {&d.sine, &d.cosine, &d.square_root, &d.arc_tangent}) *function += precision.suffix;
  d.used_names = {d.sine, d.cosine, d.square_root, d.arc_tangent, "kept"};
  d.line_limit = cpp::kColumns - d.indentation;
  d.pairs_angles = false;
  d.binds_parameters = true;
  d.literal = [](const Number& value, Texts& texts) { return literal(number(value.value(), precision), texts); };
  d.element = subscripted;
  d.members = reads_cache ? values : members;
  d.member_access = "->";
  d.text = line<precision>;
  d.section = [](const std::string& text) { return comment(text, 2); };
  return d;
}

}  // namespace

const Dialect& dialect(const Precision& precision, bool reads_cache) {
  static const Dialect all[2][2] = {
      {make_dialect<kDouble>(false), make_dialect<kDouble>(true)},
      {make_dialect<kFloat>(false), make_dialect<kFloat>(true)}};
  return all[precision.is_float][reads_cache];
}

std::vector<std::string> members(const std::vector<std::string>& parameters) {
  NameScope scope(is_reserved);
  return claim_all(scope, parameters);
}

std::string number(double value, const Precision& precision) {
  if (!precision.is_float) return backend::number(value, "(double)NAN", "(double)INFINITY");
  const auto rounded = static_cast<float>(value);
  return std::isfinite(rounded) ? print_float(rounded) + "f" : backend::number(rounded, "(float)NAN", "HUGE_VALF");
}

std::string wrapped(const std::string& head, const std::vector<std::string>& items, const std::string& tail) {
  return backend::wrapped({.columns = cpp::kColumns, .openers = "({ ", .follows_head = false}, head, items, tail);
}

}  // namespace robcogen::backend::c
