#include <cmath>

#include "backend/c/printers.h"
#include "backend/common/c_names.h"
#include "backend/common/layout.h"
#include "backend/common/split_kernel.h"
#include "support/number.h"

namespace robcogen::backend::c {
namespace {

// The keywords of C and C++, because headers are for both, and the macros of system headers.
bool is_reserved(const std::string& name) {
  return name == "restrict" || c_family::is_reserved(name);
}

template <const Precision& precision>
Spelling literal(const Number& value, Texts& texts) {
  return backend::literal(number(value.value(), precision), texts);
}

}  // namespace

Dialect dialect(const Precision& precision, bool reads_cache) {
  Dialect d;
  d.is_reserved = is_reserved;
  for (std::string* function : {&d.sine, &d.cosine, &d.square_root, &d.arc_tangent}) *function += precision.suffix;
  d.used_names = {d.sine, d.cosine, d.square_root, d.arc_tangent, "kept"};
  d.line_limit = kColumns - d.indentation;
  d.pairs_angles = false;
  d.lengths = kLengths;
  d.binds_parameters = true;
  d.literal = precision.is_float ? literal<kFloat> : literal<kDouble>;
  d.element = subscripted;
  if (!reads_cache) d.members = [](const auto& parameters) { return claim_all(parameters, is_reserved); };
  d.member_access = "->";
  d.member_array = "->values";
  d.definition = "const " + precision.scalar + " ";
  d.section = [](const std::string& text) { return comment(text, 2); };
  return d;
}

std::string number(double value, const Precision& precision) {
  if (!precision.is_float) return backend::number(value, "(double)NAN", "(double)INFINITY");
  const auto rounded = static_cast<float>(value);
  return std::isfinite(rounded) ? print_float(rounded) + "f" : backend::number(rounded, "(float)NAN", "HUGE_VALF");
}

std::string wrapped(const std::string& head, const std::vector<std::string>& items, const std::string& tail) {
  return backend::wrapped({.columns = kColumns, .openers = "({ ", .follows_head = false}, head, items, tail);
}

}  // namespace robcogen::backend::c
