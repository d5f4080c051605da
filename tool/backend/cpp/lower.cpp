#include "backend/cpp/lower.h"

#include <utility>

#include "backend/cpp/layout.h"
#include "backend/cpp/names.h"
#include "support/concat.h"
#include "support/number.h"

namespace robcogen::backend::cpp {
namespace {

std::string element(const std::string& array, std::size_t k) {
  return array + "[" + std::to_string(k) + "]";
}

constexpr std::size_t kIndentation = 2;

// Whether no parenthesis is closed before it is opened, as between the parentheses of a single call.
bool is_balanced(const std::string& text) {
  int depth = 0;
  for (const char c : text) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (depth < 0) return false;
  }
  return depth == 0;
}

// The indentation of a statement's second line.
const std::string kMargin = "\n      ";

// A definition that does not fit on one line has its value on the next one; a long call has its arguments on several.
std::string wrapped(std::string line, std::size_t limit) {
  if (line.size() <= limit) return line;
  const std::size_t equals = line.find(" = "), of = line.find("::of(");
  const bool is_definition = equals != std::string::npos;
  if (is_definition && line.size() - equals - 3 + 4 <= limit)
    return line.substr(0, equals + 2) + kMargin + line.substr(equals + 3);
  // The value consists of this call alone.
  const bool is_call = of != std::string::npos && line.find_first_of(" (", equals + 3) == of + 4;
  if (is_definition && !(is_call && is_balanced(line.substr(of + 5, line.size() - of - 7)))) return line;
  const std::size_t begin = (is_definition ? line.find('(', of) : line.find('(')) + 1;
  std::string result = line.substr(0, begin), rest = line.substr(begin);
  for (std::size_t column = limit; !rest.empty();) {
    const std::size_t comma = std::min(rest.find(", "), rest.size());
    const std::string part = rest.substr(0, std::min(comma + 1, rest.size()));
    if (column + 1 + part.size() > limit + kIndentation) {
      result += kMargin + part;
      column = kMargin.size() - 1 + part.size();
    } else {
      result += ' ' + part;
      column += 1 + part.size();
    }
    rest.erase(0, std::min(comma + 2, rest.size()));
  }
  return result;
}

std::string type_of_line(const Line& line) {
  return line.width > 1 ? type(line.width) : "Scalar";
}

}  // namespace

std::string type(int width) {
  return "Lanes" + std::to_string(width);
}

const Dialect& dialect() {
  static const Dialect cpp = [] {
    Dialect d;
    d.is_reserved = is_reserved;
    d.used_names = {"Lanes2", "Lanes4",   "Lanes8",   "Scalar", kArcTangent, "cos",  "kept", "kept_2",   "kept_4",
                    "kept_8", kMagnitude, "robcogen", "sin",    "sincos",    "sqrt", "std",  "sum_lanes"};
    d.magnitude = kMagnitude;
    d.arc_tangent = kArcTangent;
    d.line_limit = kColumns - kIndentation;
    d.name_limit = 30;  // three such operands and their operators fit in one line
    d.angles_together = 4;
    d.arc_tangents_together = 4;
    d.lengths = kLengthsOfTemplates;
    d.binds_parameters = true;
    d.literal = [](const Number& value, Texts& texts) { return literal(value.value(), texts); };
    d.type = type;
    d.element = element;
    d.text = text;
    d.section = [](const std::string& text) { return comment(text, 2); };
    return d;
  }();
  return cpp;
}

std::vector<KernelArray> parameters(const symbolic::Program& program) {
  return backend::parameters(program, dialect());
}

Kernel lower(const symbolic::Program& program, const std::string& name) {
  return backend::lower(program, name, dialect());
}

std::optional<Kernel> of_small_angles(Kernel kernel) {
  bool is_marked = false;
  for (Line& line : kernel.lines) {
    if (line.width > 1 && line.kind == Line::Kind::sincos_of) return std::nullopt;
    line.is_small = line.width > 1 && line.kind == Line::Kind::sincos;
    is_marked = is_marked || line.is_small;
  }
  return is_marked ? std::optional(std::move(kernel)) : std::nullopt;
}

Kernel lower_values(const symbolic::Program& program) {
  Dialect values = dialect();
  values.stores = false;
  return backend::lower(program, program.name, values);
}

Spelling literal(double value, Texts& texts) {
  const std::string number = print_double(value);
  return backend::literal(texts.add({"Scalar(", number, ")"}), texts.add({"Scalar(-", number, ")"}));
}

std::string text(const Line& line) {
  const auto& [kind, targets, expression, count, width, stride, values, output, element, is_small, is_reference, names] =
      line;
  const auto number = [](auto n) { return std::to_string(n); };
  switch (kind) {
    case Line::Kind::section:
      return "// " + expression;
    // A reference is read where it is used, so that it takes no register before.
    case Line::Kind::binding:
      return concat({"const ", type_of_line(line), "& ", targets[0], " = ", expression, ";"});
    case Line::Kind::sincos:
      // A call would take the registers of a long chain of operations.
      if (is_reference)
        return concat(
            {"const auto [", targets[0], ", ", targets[1], "] = robcogen::SinCosOf<", type_of_line(line), ", 1>(&",
             expression, ")[0];"});
      return concat(
          {"const auto [", targets[0], ", ", targets[1], "] = robcogen::", is_small ? "sincos_of_small" : "sincos", "(",
           expression, ");"});
    case Line::Kind::sincos_of:
      return concat(
          {"const robcogen::SinCosOf<", type_of_line(line), ", ", number(count), "> ", targets[0], "(&", expression,
           ");"});
    case Line::Kind::pick:
      return concat({"const auto [", targets[0], ", ", targets[1], "] = ", expression, ";"});
    case Line::Kind::definition:
      return wrapped(
          concat({"const ", type_of_line(line), " ", targets[0], " = ", expression, ";"}), dialect().line_limit);
    case Line::Kind::load_block:
      return concat(
          {"const auto ", targets[0], " = robcogen::load_lanes<", number(width), ", ", number(count), ", ",
           number(stride), ">(&", expression, ");"});
    case Line::Kind::store_block: {
      std::string result = concat({"robcogen::store_lanes<", number(stride), ">(&", targets[0]});
      for (const std::string& value : values) result += ", " + value;
      return wrapped(result + ");", dialect().line_limit);
    }
    case Line::Kind::fill:
      return concat({"robcogen::fill<", number(count), ">(&", targets[0], ", ", expression, ");"});
    case Line::Kind::arc_tangents: {
      std::string result = concat({kArcTangents, "(&", targets[0]});
      for (const std::string& value : values) result += ", " + value;
      return wrapped(result + ");", dialect().line_limit);
    }
    case Line::Kind::store:
      break;
  }
  std::string head;
  for (const std::string& target : targets) head += (head.empty() ? "" : " ") + target + " =";
  const bool fits = targets.size() == 1 || head.size() + expression.size() + 2 <= dialect().line_limit;
  return head + (fits ? " " : kMargin) + expression + ";";
}

}  // namespace robcogen::backend::cpp
