#include "backend/c/dialect.h"

#include <charconv>
#include <cmath>
#include <stdexcept>

#include "backend/cpp/layout.h"
#include "backend/cpp/names.h"
#include "support/number.h"

namespace robcogen::backend::c {
namespace {

// A question mark behind another one begins a trigraph.
std::string without_trigraphs(std::string text, const char* between) {
  for (std::size_t at = text.find("??"); at != std::string::npos; at = text.find("??", at + 1))
    text.insert(at + 1, between);
  return text;
}

std::string line(const Line& l, Precision precision) {
  switch (l.kind) {
    case Line::Kind::section: {
      const std::string text = comment(l.expression);
      return text.substr(0, text.find('\n'));
    }
    case Line::Kind::binding:
    case Line::Kind::definition:
      return "const " + scalar(precision) + " " + l.targets.front() + " = " + l.expression + ";";
    case Line::Kind::store: {
      std::string text;
      for (const std::string& target : l.targets) text += target + " = ";
      return text + l.expression + ";";
    }
    default:
      throw std::logic_error("C has no lanes: " + l.expression);
  }
}

template <Precision precision>
Dialect make_dialect() {
  const std::string suffix = precision == Precision::in_float ? "f" : "";
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
  d.literal = [](const Number& value, Texts& texts) {
    const std::string text = number(value.value(), precision);
    return backend::literal(texts.add({text}), texts.add({"-", text}));
  };
  d.type = [](int) { return std::string("double"); };
  d.element = [](const std::string& array, std::size_t k) { return array + "[" + std::to_string(k) + "]"; };
  d.text = [](const Line& l) { return line(l, precision); };
  return d;
}

}  // namespace

const Dialect& dialect(Precision precision) {
  static const Dialect in_double = make_dialect<Precision::in_double>();
  static const Dialect in_float = make_dialect<Precision::in_float>();
  return precision == Precision::in_float ? in_float : in_double;
}

std::string scalar(Precision precision) {
  return precision == Precision::in_float ? "float" : "double";
}

bool is_reserved(const std::string& name) {
  return name == "restrict" || cpp::is_reserved(name);
}

std::string number(double value, Precision precision) {
  if (precision == Precision::in_double) return print_double(value);
  const float rounded = static_cast<float>(value);
  if (std::isinf(rounded)) return rounded < 0 ? "-HUGE_VALF" : "HUGE_VALF";
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
  std::string result, row = head;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string item = items[i] + (i + 1 < items.size() ? "," : tail);
    if (i > 0 && row.size() + 1 + item.size() > cpp::kColumns) {
      result += row + "\n";
      row = "    " + item;
    } else {
      row += (i > 0 ? " " : "") + item;
    }
  }
  return result + row + (items.empty() ? tail : "") + "\n";
}

}  // namespace robcogen::backend::c
