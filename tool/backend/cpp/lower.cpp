#include "backend/cpp/lower.h"

#include "backend/cpp/names.h"
#include "support/number.h"

namespace robcogen::backend::cpp {
namespace {

std::string element(const std::string& array, std::size_t k) {
  return array + "[" + std::to_string(k) + "]";
}

// A call whose arguments do not fit in one line has them in several.
std::string wrapped(const std::string& line, std::size_t limit) {
  if (line.size() <= limit) return line;
  const std::size_t open = line.find("::of(");
  if (open == std::string::npos) return line;
  const std::string margin = "\n      ";
  const std::size_t equals = line.find(" = ");
  if (line.size() - equals - 3 + 4 <= limit) return line.substr(0, equals + 2) + margin + line.substr(equals + 3);
  std::string result = line.substr(0, open + 5), rest = line.substr(open + 5);
  for (std::size_t column = limit; !rest.empty();) {
    const std::size_t comma = std::min(rest.find(", "), rest.size());
    const std::string part = rest.substr(0, std::min(comma + 1, rest.size()));
    if (column + part.size() + 1 > limit) {
      result += margin;
      column = margin.size();
    } else {
      result += ' ';
    }
    result += part;
    column += part.size() + 1;
    rest.erase(0, std::min(comma + 2, rest.size()));
  }
  return result;
}

}  // namespace

std::string type(int width) {
  return "Lanes" + std::to_string(width);
}

const Dialect& dialect() {
  static const Dialect cpp = [] {
    Dialect d;
    d.is_reserved = is_reserved;
    d.used_names = {"Lanes2", "Lanes4", "Lanes8", "Scalar", "cos",      "robcogen",
                    "sin",    "sincos", "sqrt",   "std",    "sum_lanes"};
    d.line_limit = 118;  // 120 columns less the indentation
    d.name_limit = 30;   // three such operands and their operators fit in one line
    d.angles_together = 4;
    d.binds_parameters = true;
    d.literal = [](const Number& value) { return literal(value.value()); };
    d.type = type;
    d.element = element;
    d.text = text;
    return d;
  }();
  return cpp;
}

std::vector<Parameter> parameters(const symbolic::Program& program) {
  return backend::parameters(program, dialect());
}

Kernel lower(const symbolic::Program& program, const std::string& name) {
  return backend::lower(program, name, dialect());
}

Kernel lower_values(const symbolic::Program& program) {
  Dialect values = dialect();
  values.stores = false;
  return backend::lower(program, program.name, values);
}

Spelling literal(double value) {
  const std::string number = print_double(value);
  return backend::literal("Scalar(" + number + ")", "Scalar(-" + number + ")");
}

std::string text(const Line& line) {
  switch (line.kind) {
    case Line::Kind::section:
      return "// " + line.expression;
    // A reference: read where it is used, and no register is spent on it before.
    case Line::Kind::binding:
      return "const Scalar& " + line.targets[0] + " = " + line.expression + ";";
    case Line::Kind::sincos:
      return "const auto [" + line.targets[0] + ", " + line.targets[1] + "] = robcogen::sincos(" + line.expression +
             ");";
    case Line::Kind::sincos_of:
      return "const robcogen::SinCosOf<Scalar, " + std::to_string(line.count) + "> " + line.targets[0] + "(&" +
             line.expression + ");";
    case Line::Kind::pick:
      return "const auto [" + line.targets[0] + ", " + line.targets[1] + "] = " + line.expression + ";";
    case Line::Kind::definition:
      return wrapped(
          "const " + (line.width > 1 ? type(line.width) : "Scalar") + " " + line.targets[0] + " = " + line.expression +
              ";",
          dialect().line_limit);
    case Line::Kind::store:
      break;
  }
  std::string result;
  for (const std::string& target : line.targets) result += target + " = ";
  return result + line.expression + ";";
}

}  // namespace robcogen::backend::cpp
