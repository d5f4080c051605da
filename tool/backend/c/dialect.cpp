#include "backend/c/dialect.h"

#include <charconv>
#include <cmath>
#include <stdexcept>

#include "backend/common/layout.h"
#include "backend/cpp/layout.h"
#include "backend/cpp/names.h"
#include "support/concat.h"

namespace robcogen::backend::c {
namespace {

// A question mark behind another one begins a trigraph.
std::string without_trigraphs(std::string text, const char* between) {
  for (std::size_t at = text.find("??"); at != std::string::npos; at = text.find("??", at + 1))
    text.insert(at + 1, between);
  return text;
}

template <bool is_float>
std::string line(const Line& l) {
  switch (l.kind) {
    case Line::Kind::section: {
      const std::string text = comment(l.expression);
      return text.substr(0, text.find('\n'));
    }
    case Line::Kind::binding:
    case Line::Kind::definition:
      return "const " + (is_float ? kFloat : kDouble).scalar + " " + l.targets.front() + " = " + l.expression + ";";
    case Line::Kind::store:
      return joined(l.targets, " = ") + " = " + l.expression + ";";
    default:
      throw std::logic_error("C has no lanes: " + l.expression);
  }
}

template <bool is_float>
Spelling literal(const Number& value, Texts& texts) {
  const std::string text = number(value.value(), is_float ? kFloat : kDouble);
  return backend::literal(texts.add({text}), texts.add({"-", text}));
}

std::vector<std::string> values(const std::vector<std::string>& labels) {
  std::vector<std::string> elements;
  for (std::size_t k = 0; k < labels.size(); ++k) elements.push_back(subscripted("values", k));
  return elements;
}

template <bool is_float>
Dialect make_dialect(bool reads_cache) {
  const std::string& suffix = (is_float ? kFloat : kDouble).suffix;
  Dialect d;
  d.is_reserved = is_reserved;
  d.sine = "sin" + suffix;
  d.cosine = "cos" + suffix;
  d.square_root = "sqrt" + suffix;
  d.arc_tangent = "atan2" + suffix;
  d.used_names = {d.sine, d.cosine, d.square_root, d.arc_tangent, "kept"};
  d.line_limit = cpp::kColumns - 2;
  d.pairs_angles = false;
  d.binds_parameters = true;
  d.literal = literal<is_float>;
  d.type = [](int) { return kDouble.scalar; };
  d.element = subscripted;
  d.members = reads_cache ? values : members;
  d.member_access = "->";
  d.text = line<is_float>;
  return d;
}

}  // namespace

const Dialect& dialect(const Precision& precision, bool reads_cache) {
  static const Dialect all[] = {
      make_dialect<false>(false), make_dialect<false>(true), make_dialect<true>(false), make_dialect<true>(true)};
  return all[(precision.suffix.empty() ? 0 : 2) + (reads_cache ? 1 : 0)];
}

std::vector<std::string> members(const std::vector<std::string>& parameters) {
  NameScope scope(is_reserved);
  return claim_all(scope, parameters);
}

bool is_reserved(const std::string& name) {
  return name == "restrict" || cpp::is_reserved(name);
}

std::string number(double value, const Precision& precision) {
  if (precision.suffix.empty()) return backend::number(value, "(double)NAN", "(double)INFINITY");
  const auto rounded = static_cast<float>(value);
  if (!std::isfinite(rounded)) return backend::number(rounded, "(float)NAN", "HUGE_VALF");
  char buffer[40];
  std::string text(buffer, std::to_chars(buffer, buffer + sizeof buffer, rounded).ptr);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text + "f";
}

std::string comment(const std::string& text, std::size_t indent) {
  return cpp::comment(without_trigraphs(text, " "), indent);
}

std::string quoted(const std::string& text) {
  return without_trigraphs(cpp::quoted(text), "\\");
}

std::string wrapped(const std::string& head, const std::vector<std::string>& items, const std::string& tail) {
  return backend::wrapped({.columns = cpp::kColumns, .openers = "({ ", .follows_head = false}, head, items, tail);
}

}  // namespace robcogen::backend::c
