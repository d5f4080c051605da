#include "backend/common/arc_tangent_lines.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace robcogen::backend {
namespace {

// Whether a line stores nothing but an arc tangent.
bool is_arc_tangent(const Line& line) {
  return line.kind == Line::Kind::store && line.targets.size() == 1 && !line.values.empty();
}

// Whether a line stores the element behind that of the line before it.
bool follows(const Line& line, const Line& before) {
  return line.output == before.output && line.element == before.element + 1;
}

}  // namespace

Kernel with_arc_tangents_together(Kernel kernel, const Dialect& dialect) {
  if (dialect.arc_tangents_together == 0) return kernel;
  std::vector<Line> lines;
  bool is_called = false;  // for single angles
  for (std::size_t i = 0, end = 0; i < kernel.lines.size(); i = end) {
    end = i + 1;
    if (is_arc_tangent(kernel.lines[i]))
      while (end < kernel.lines.size() && is_arc_tangent(kernel.lines[end]) &&
             follows(kernel.lines[end], kernel.lines[end - 1]))
        ++end;
    Line together{Line::Kind::arc_tangents, kernel.lines[i].targets, ""};
    if (end - i < dialect.arc_tangents_together) {
      end = i + 1;
      const std::vector<std::string>& names = kernel.lines[i].names;
      is_called = is_called || std::find(names.begin(), names.end(), dialect.arc_tangent) != names.end();
      lines.push_back(std::move(kernel.lines[i]));
      continue;
    }
    for (std::size_t k = i; k < end; ++k) {
      Line& one = kernel.lines[k];
      std::move(one.values.begin(), one.values.end(), std::back_inserter(together.values));
      const auto is_other = [&](const std::string& name) { return name != dialect.arc_tangent; };
      std::copy_if(one.names.begin(), one.names.end(), std::back_inserter(together.names), is_other);
    }
    lines.push_back(std::move(together));
  }
  kernel.lines = std::move(lines);
  const auto called = std::find(kernel.functions.begin(), kernel.functions.end(), dialect.arc_tangent);
  if (!is_called && called != kernel.functions.end()) kernel.functions.erase(called);
  return kernel;
}

}  // namespace robcogen::backend
