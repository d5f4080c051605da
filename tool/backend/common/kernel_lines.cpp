#include "backend/common/kernel_lines.h"

#include <algorithm>
#include <utility>

#include "support/index.h"

namespace robcogen::backend {

using symbolic::Operand;

KernelLines::KernelLines(Arrangement& arranged, const std::string& name) : arranged_(arranged) {
  kernel_.name = name;
  kernel_.parameters = arranged.parameters;
  kernel_.widths = arranged.widths;
  kernel_.lines = arranged.bindings;
}

void KernelLines::enter_section(std::size_t statement) {
  const std::string& title = program().sections[at(program().statements[statement].section)].title;
  if (title == section_) return;
  section_ = title;
  if (!title.empty()) add_section(title);
}

void KernelLines::need(const std::string& function) {
  std::vector<std::string>& list = kernel_.functions;
  const auto place = std::lower_bound(list.begin(), list.end(), function);
  if (place == list.end() || *place != function) list.insert(place, function);
}

std::vector<std::string> KernelLines::names_of(const Operand& o) const {
  std::vector<std::string> names;
  add_names(arranged_, o, width_of(program(), o), names);
  return names;
}

Kernel KernelLines::kernel() {
  if (!dialect().stores) {
    for (const symbolic::OutputArray& output : program().outputs) {
      std::vector<std::string>& elements = kernel_.results.emplace_back();
      for (const Operand& o : output.values) elements.push_back(text_of(o));
    }
  }
  return std::move(kernel_);
}

}  // namespace robcogen::backend
