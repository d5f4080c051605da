// Operands of statements, from their text.
#pragma once

#include <map>
#include <string>

#include "symbolic/program.h"

namespace robcogen::symbolic {

// Knows what has a name: the inputs of the program, and the statements that were assigned so far. Adds constants to the
// program, each spelling once. Functions return what is wrong; an empty text when nothing is.
class OperandReader {
 public:
  explicit OperandReader(Program& program) : program_(program) {}

  // The next statement of the program gets this name.
  std::string assign(const std::string& name);

  // `-x`, `x@2` (a lane), `q[0]`, `0.25`, `pi:1:2`.
  std::string read(std::string word, Operand& operand);

 private:
  Program& program_;
  std::map<std::string, int> statement_of_;
  std::map<std::string, int> constant_of_;

  std::string read_input(const std::string& word, Operand& operand) const;
  std::string read_constant(const std::string& word, Operand& operand);
};

}  // namespace robcogen::symbolic
