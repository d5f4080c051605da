#include "backend/cpp/lower.h"

#include "backend/cpp/names.h"
#include "support/number.h"

namespace robcogen::backend::cpp {
namespace {

std::string element(const std::string& array, std::size_t k) {
  return array + "[" + std::to_string(k) + "]";
}

}  // namespace

const Dialect& dialect() {
  static const Dialect cpp = [] {
    Dialect d;
    d.is_reserved = is_reserved;
    d.used_names = {"Scalar", "cos", "robcogen", "sin", "sincos", "sqrt", "std"};
    d.line_limit = 118;  // 120 columns less the indentation
    d.name_limit = 30;   // three such operands and their operators fit in one line
    d.angles_together = 4;
    d.binds_parameters = true;
    d.literal = [](const Number& value) { return literal(value.value()); };
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
      return "const Scalar " + line.targets[0] + " = " + line.expression + ";";
    case Line::Kind::store:
      break;
  }
  std::string result;
  for (const std::string& target : line.targets) result += target + " = ";
  return result + line.expression + ";";
}

}  // namespace robcogen::backend::cpp
