// The lines of a function while they are being written, one after another.
#pragma once

#include <string>
#include <vector>

#include "backend/common/arrangement.h"
#include "backend/common/lower.h"
#include "symbolic/program.h"

namespace robcogen::backend {

class KernelLines {
 public:
  KernelLines(Arrangement& arranged, const std::string& name);

  const Dialect& dialect() const { return arranged_.dialect; }
  const symbolic::Program& program() const { return arranged_.program; }
  Arrangement& arranged() { return arranged_; }
  bool empty() const { return kernel_.lines.empty(); }

  void add(Line line) { kernel_.lines.push_back(std::move(line)); }
  void add_section(const std::string& title) { add({Line::Kind::section, {}, title}); }
  // Adds the heading of the statement's section, unless the last line belongs to the same section.
  void enter_section(std::size_t statement);
  // Notes a function that the lines call.
  void need(const std::string& function);

  // The text of an operand as it stands, and the names that it refers to.
  std::string text_of(const symbolic::Operand& o) { return text(spell(arranged_, o)); }
  std::vector<std::string> names_of(const symbolic::Operand& o) const;

  // The kernel. It lists the elements of the outputs if the dialect does not store them.
  Kernel kernel();

 private:
  Arrangement& arranged_;
  Kernel kernel_;
  std::string section_;  // title of the section that the last line belongs to
};

}  // namespace robcogen::backend
