#include <cmath>
#include <set>

#include "backend/c/printers.h"
#include "backend/common/c_names.h"
#include "backend/common/layout.h"
#include "backend/common/split_kernel.h"
#include "support/concat.h"
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

// Names of OpenCL C and of the header of macros.
bool is_reserved_by_macros(const std::string& name) {
  static const std::set<std::string> of_opencl = {
#include "backend/c/opencl.inc"
  };
  return is_reserved(name) || of_opencl.contains(name) || name == "REAL" || name == "RC" || name.starts_with("RC_") ||
         name.starts_with("rc_") || name.starts_with("robcogen_");
}

std::string macro_line(const Line& line) {
  if (line.kind == Line::Kind::sincos)
    return "RC_SINCOS(" + line.expression + ", " + line.targets[0] + ", " + line.targets[1] + ");";
  const std::string head = line.kind == Line::Kind::store ? "" : "const REAL ";
  return head + joined(line.targets, " = ") + " = " + line.expression + ";";
}

// Long functions stay whole: compilers inline parts, or lose a quarter of the speed at calls.
Dialect macros() {
  Dialect d;
  d.is_reserved = is_reserved_by_macros;
  d.sine = "RC_SIN";
  d.cosine = "RC_COS";
  d.square_root = "RC_SQRT";
  d.arc_tangent = "RC_ATAN2";
  d.quotient = "RC_QUOTIENT";
  d.line_limit = kColumns - d.indentation;
  d.lengths.longest = static_cast<std::size_t>(-1);
  d.binds_parameters = true;
  d.literal = literal<kMacros>;
  d.element = [](const std::string& array, std::size_t k) {
    return is_kept(array) ? subscripted(array, k) : "RC_AT(" + array + ", " + std::to_string(k) + ")";
  };
  d.text = macro_line;
  d.section = [](const std::string& text) { return comment(text, 2); };
  return d;
}

std::string type_with_lanes(int width) {
  return "Lanes" + std::to_string(width);
}

// The array from this element on: the text of an element with another macro.
std::string from(const std::string& element) {
  return replaced(element, "RC_AT(", "RC_FROM(");
}

// A call as a line without indentation.
std::string called(const std::string& function, const std::vector<std::string>& arguments) {
  const std::string text = wrapped("  " + function + "(", arguments, ");");
  return text.substr(2, text.size() - 3);
}

std::string line_with_lanes(const Line& line) {
  const std::string width = std::to_string(line.width), count = std::to_string(line.count);
  const std::string stride = std::to_string(line.stride);
  const std::string& target = line.targets.empty() ? line.expression : line.targets.front();
  switch (line.kind) {
    case Line::Kind::sincos:
      if (line.width == 1) break;
      return called("RC_SINCOS_IN_LANES", {width, line.expression, target, line.targets[1]});
    case Line::Kind::pick:
      return "const auto [" + target + ", " + line.targets[1] + "] = " + line.expression + ";";
    case Line::Kind::binding:
    case Line::Kind::definition:
      if (line.width == 1) break;
      return "const " + type_with_lanes(line.width) + " " + target + " = " + line.expression + ";";
    case Line::Kind::load_block:
      return "const auto " + target + " = robcogen::gpu::load_lanes<REAL, " + width + ", " + count + ", " + stride +
             ">(" + from(line.expression) + ");";
    case Line::Kind::store_block: {
      std::vector<std::string> arguments = line.values;
      arguments.insert(arguments.begin(), from(target));
      return called("robcogen::gpu::store_lanes<" + stride + ">", arguments);
    }
    case Line::Kind::fill:
      return called("robcogen::gpu::fill<" + count + ">", {from(target), line.expression});
    default:
      break;
  }
  return macro_line(line);
}

}  // namespace

Dialect dialect_with_lanes() {
  Dialect d = macros();
  d.used_names.insert(d.used_names.end(), {"Lanes2", "Lanes4", "Lanes8", "sum_lanes"});
  d.type = type_with_lanes;
  d.text = line_with_lanes;
  return d;
}

bool is_kept(const std::string& array) {
  return array.starts_with("kept");
}

Dialect dialect(const Precision& precision, bool reads_cache) {
  if (precision.is_macro) return macros();
  Dialect d;
  d.is_reserved = is_reserved;
  d.magnitude = "fabs";
  for (std::string* function : {&d.sine, &d.cosine, &d.square_root, &d.magnitude, &d.arc_tangent})
    *function += precision.suffix;
  d.used_names = {d.sine, d.cosine, d.square_root, d.magnitude, d.arc_tangent, "kept"};
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
  if (precision.is_macro)
    return std::isfinite(value) ? "RC(" + print_double(value) + ")" : backend::number(value, "RC_NAN", "RC_INFINITY");
  if (!precision.is_float) return backend::number(value, "(double)NAN", "(double)INFINITY");
  const auto rounded = static_cast<float>(value);
  return std::isfinite(rounded) ? print_float(rounded) + "f" : backend::number(rounded, "(float)NAN", "HUGE_VALF");
}

std::string wrapped(const std::string& head, const std::vector<std::string>& items, const std::string& tail) {
  return backend::wrapped({.columns = kColumns, .openers = "({ ", .follows_head = false}, head, items, tail);
}

}  // namespace robcogen::backend::c
