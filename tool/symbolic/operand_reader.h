// Reads operands of statements from text.
#pragma once

#include <map>
#include <string>

#include "symbolic/program.h"

namespace robcogen::symbolic {

// Knows the names of the program's inputs and of the statements that were assigned so far. Adds constants to the
// program, each spelling once. Functions return an error message, or an empty text if there is no error.
class OperandReader {
 public:
  explicit OperandReader(Program& program) : program_(program) {}

  // Gives this name to the next statement of the program.
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
